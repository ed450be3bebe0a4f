// Counterweights: those of Berkof and Lowen for a four-bar, a centre of mass that stands still, and the flywheel.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "loads/loads.h"

typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

static Machine open_text(const char *text)
{
    YkProblems *problems = yk_problems_new();
    Machine m = {.model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems)};
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, problems) : NULL;
    if (!m.mech) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_non_null(m.mech);
    m.state = yk_state_new(m.mech);
    assert_int_equal(yk_state_set_time(m.state, 0, NULL), YK_OK);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_problems_free(problems);
    return m;
}
static void close_machine(Machine *m)
{
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
}

// Moves the input by a turn (or less, as told) and returns how far the centre of mass moves, m.
static double wandering(const char *text, double turn)
{
    Machine m = open_text(text);
    YkVec first = {0, 0};
    double worst = 0, start = yk_state_input(m.state, 0).position;
    for (int k = 0; k < 97; k++) {
        YkMotion goal = {.position = start + k * turn / 96};
        assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
        YkVec sum = {0, 0};
        double mass = 0;
        for (size_t b = 1; b < m.model->body_count; b++) {
            YkBodyMotion motion = yk_body_motion(m.mech, &m.state->space, b);
            if (!m.model->bodies[b].has_mass) continue;
            mass += m.model->bodies[b].mass;
            sum = yk_add(sum, yk_scale(m.model->bodies[b].mass, motion.at));
        }
        sum = yk_scale(1 / mass, sum);
        if (k == 0) first = sum;
        worst = fmax(worst, yk_norm(yk_sub(sum, first)));
    }
    close_machine(&m);
    return worst;
}

static const char berkof[] =
    "bodies:\n  ground: {points: {A0: [0, 0], B0: [5.5, 0]}}\n  crank: {points: {A0: [0, 0], A: [2, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [6, 0]}, mass: 0.02, center: [3*cos(15 deg), 3*sin(15 deg)], inertia: 0.01}\n"
    "  rocker: {points: {B0: [0, 0], B: [3, 0]}}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
    "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n";

static void a_four_bar_gets_the_counterweights_of_berkof_and_lowen(void **state)
{
    (void)state;
    Machine m = open_text(berkof);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_true(yk_balancing_is_full(b));
    assert_int_equal(yk_balancing_count(b), 2);
    // r2 = r e^(i 15 deg) in the coupler: m2 a2 - m l |..|: crank: -m (l - r2) a / l, rocker: -m r2 c / l.
    YkVec r = yk_scale(3, yk_unit(15 * YK_PI / 180));
    YkVec crank = yk_scale(-.02 * 2 / 6, yk_sub(yk_vec(6, 0), r)), rocker = yk_scale(-.02 * 3 / 6, r);
    for (size_t k = 0; k < 2; k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        YkVec expected = w.body == 1 ? crank : rocker, own = yk_scale(w.product, yk_unit(w.angle));
        CHECK_NEAR(own.x, expected.x, 1e-14);
        CHECK_NEAR(own.y, expected.y, 1e-14);
        CHECK_NEAR(w.mass * w.radius, w.product, 1e-16);
    }
    assert_true(wandering(berkof, 2 * YK_PI) > 1);
    CHECK_NEAR(wandering(yk_balancing_model(b), 2 * YK_PI), 0, 1e-13);
    assert_true(yk_balancing_before(b).force > .1);
    CHECK_NEAR(yk_balancing_after(b).force, 0, 1e-12);
    yk_balancing_free(b);
    close_machine(&m);
}

static char *read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = calloc(1, 100000);
    assert_true(fread(text, 1, 99999, file) > 0);
    fclose(file);
    return text;
}

static void a_six_bar_is_balanced_with_counterweights_on_three_bodies_or_more(void **state)
{
    (void)state;
    char *text = read_file(YOKE_ROOT "/examples/watt-with-masses.yaml");
    Machine m = open_text(text);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_true(yk_balancing_is_full(b));
    assert_true(yk_balancing_count(b) >= 3); // half of the six bodies
    CHECK_NEAR(wandering(yk_balancing_model(b), .08), 0, 1e-11 * yk_mechanism_size(m.mech));
    yk_balancing_free(b);
    close_machine(&m);
    free(text);
}

static const char slider[] =
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [.1, 0]}, mass: 1, center: [.04, 0], "
    "inertia: 0}\n"
    "  rod: {points: {A: [0, 0], B: [.4, 0]}, mass: 2, center: [.15, 0], inertia: .02}\n  piston: {points: {B: [0, "
    "0]}, mass: 3}\n"
    "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  S: {slide: [ground, piston], along: x, distance: s}\n  B: {pin: [rod, piston]}\n"
    "drives: {theta: 10 rad/s * t}\nstart: {phi: 0, s: .5}\n";

// The rod's counterweight brings the masses of rod and piston to A; that of the crank the whole to O.
static void a_slider_crank_is_balanced_by_its_rod_and_its_crank(void **state)
{
    (void)state;
    Machine m = open_text(slider);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_true(yk_balancing_is_full(b));
    assert_int_equal(yk_balancing_count(b), 2);
    double rod = 2 * .15 + 3 * .4, weight = 0, crank = 0;
    for (size_t k = 0; k < 2; k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        CHECK_NEAR(fabs(yk_remainder(w.angle, 2 * YK_PI)), YK_PI, 1e-9);
        if (w.body == 2) {
            CHECK_NEAR(w.product, rod, 1e-12);
            weight = w.mass;
        } else {
            crank = w.product;
        }
    }
    CHECK_NEAR(crank, 1 * .04 + (2 + 3 + weight) * .1, 1e-12);
    CHECK_NEAR(wandering(yk_balancing_model(b), 2 * YK_PI), 0, 1e-13);
    yk_balancing_free(b);
    close_machine(&m);
}

// A crank alone that lifts a weight: T = m g r cos(theta), which swings the energy by 2 m g r.
static void a_flywheel_takes_up_the_torques_energy(void **state)
{
    (void)state;
    Machine m = open_text(
        "gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [.5, 0]}, mass: 2, "
        "center: "
        "[.5, 0], inertia: 0}}\njoints: {O: {pin: [ground, crank], angle: theta}}\ndrives: {theta: 3 rad/s * t}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.fluctuation = .1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    CHECK_NEAR(yk_balancing_flywheel(b), 2 * 2 * 10 * .5 / (.1 * 9), 2e-3);
    CHECK_NEAR(yk_balancing_before(b).torque, 10, 1e-12);
    CHECK_NEAR(yk_balancing_before(b).force, 2 * .5 * 9, 1e-12);
    assert_int_equal(yk_balancing_count(b), 1);
    CHECK_NEAR(yk_balancing_at(b, 0).product, 1, 1e-14);
    CHECK_NEAR(yk_balancing_after(b).torque, 0, 1e-12);
    yk_balancing_free(b);
    close_machine(&m);
}

static void machines_without_masses_are_refused(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    Machine m = open_text("bodies: {crank: {}}\njoints: {O: {pin: [ground, crank], angle: theta}}\n");
    assert_null(yk_balancing_new(m.state, NULL, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, 849);
    assert_null(yk_balancing_new(NULL, NULL, problems));
    assert_int_equal(yk_balancing_count(NULL), 0);
    assert_null(yk_balancing_model(NULL));
    yk_balancing_free(NULL);
    close_machine(&m);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_four_bar_gets_the_counterweights_of_berkof_and_lowen),
        cmocka_unit_test(a_six_bar_is_balanced_with_counterweights_on_three_bodies_or_more),
        cmocka_unit_test(a_slider_crank_is_balanced_by_its_rod_and_its_crank),
        cmocka_unit_test(a_flywheel_takes_up_the_torques_energy),
        cmocka_unit_test(machines_without_masses_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
