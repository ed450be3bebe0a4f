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

// Of the piston's acceleration the part that turns with the crank is that of a very long rod: a counterweight on the crank
// makes the mean square of the force least where it balances half of the piston.
static void a_crank_alone_balances_half_of_the_piston(void **state)
{
    (void)state;
    Machine m = open_text("bodies:\n  ground: {points: {O: [0, 0]}}\n"
                          "  crank: {points: {O: [0, 0], A: [.1, 0]}, mass: 1, center: [.04, 0], inertia: 0}\n"
                          "  rod: {points: {A: [0, 0], B: [.25, 0]}}\n  piston: {points: {B: [0, 0]}, mass: 3}\n"
                          "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
                          "  S: {slide: [ground, piston], along: x, distance: s}\n  B: {pin: [rod, piston]}\n"
                          "drives: {theta: 10 rad/s * t}\nstart: {phi: 0, s: .3}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.weight[0] = 1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    assert_int_equal(yk_balancing_count(b), 1);
    YkCounterweight w = yk_balancing_at(b, 0);
    CHECK_NEAR(w.product, 1 * .04 + .5 * 3 * .1, 1e-12);
    CHECK_NEAR(fabs(yk_remainder(w.angle, 2 * YK_PI)), YK_PI, 1e-9);
    yk_balancing_free(b);
    close_machine(&m);
}

// The mean squares of force, moment and effort of a four-bar with point masses at (x, y) and (u, v) of crank and rocker, as
// the engine has them.
static void mean_squares(const double p[4], double radius[2], double mean[3])
{
    char text[2000];
    double mass[2] = {yk_hypot(p[0], p[1]) / radius[0] + 1e-12, yk_hypot(p[2], p[3]) / radius[1] + 1e-12};
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A0: [0, 0], B0: [.55, 0]}}\n"
             "  crank: {points: {A0: [0, 0], A: [.2, 0]}, mass: %.17g, center: [%.17g, %.17g], inertia: 0}\n"
             "  rod: {points: {A: [0, 0], B: [.6, 0]}, mass: 2, center: [.3, .05], inertia: .03}\n"
             "  rocker: {points: {B0: [0, 0], B: [.3, 0]}, mass: %.17g, center: [%.17g, %.17g], inertia: 0}\n"
             "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
             "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
             "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n",
             mass[0], p[0] / mass[0], p[1] / mass[0], mass[1], p[2] / mass[1], p[3] / mass[1]);
    Machine m = open_text(text);
    YkDynamics *dynamics = yk_dynamics_new(m.mech, NULL);
    mean[0] = mean[1] = mean[2] = 0;
    for (int k = 0; k < 90; k++) {
        yk_state_set_time(m.state, k * YK_PI / 90, NULL);
        assert_true(yk_state_solve(m.state) >= 0);
        assert_true(yk_dynamics_solve(dynamics, m.state, YK_METHOD_NEWTON_EULER) >= 0);
        YkWrench shaking = yk_dynamics_shaking(dynamics); // about the origin, which is the input's pivot
        double effort = yk_dynamics_effort(dynamics, yk_input_coordinate(m.mech, 0));
        mean[0] += (shaking.force[0] * shaking.force[0] + shaking.force[1] * shaking.force[1]) / 90;
        mean[1] += shaking.moment * shaking.moment / 90;
        mean[2] += effort * effort / 90;
    }
    yk_dynamics_free(dynamics);
    close_machine(&m);
}

// No neighbour of the counterweights has a smaller weighted sum. The moment of the drive acts on the frame as well.
static void a_compromise_is_the_least_in_its_neighbourhood(void **state)
{
    (void)state;
    static const char text[] =
        "bodies:\n  ground: {points: {A0: [0, 0], B0: [.55, 0]}}\n  crank: {points: {A0: [0, 0], A: [.2, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [.6, 0]}, mass: 2, center: [.3, .05], inertia: .03}\n"
        "  rocker: {points: {B0: [0, 0], B: [.3, 0]}}\n"
        "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
        "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n";
    static const double weights[][3] = {{1, 1, 0}, {1, 0, 1}, {0.5, 0.3, 2}};
    for (size_t c = 0; c < 3; c++) {
        Machine m = open_text(text);
        YkBalancingOptions options = yk_default_balancing_options();
        options.steps = 90;
        memcpy(options.weight, weights[c], sizeof options.weight);
        YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
        assert_int_equal(yk_balancing_count(b), c == 0 ? 2 : 1); // where the effort counts, none on the rocker
        double p[4] = {0}, radius[2] = {0.1, 0.15}, before[3], mean[3], least = 0;
        mean_squares(p, radius, before);
        for (size_t k = 0; k < yk_balancing_count(b); k++) {
            YkCounterweight w = yk_balancing_at(b, k);
            size_t side = w.body == 1 ? 0 : 1;
            radius[side] = w.radius;
            p[2 * side] = w.product * yk_cos(w.angle);
            p[2 * side + 1] = w.product * yk_sin(w.angle);
        }
        mean_squares(p, radius, mean);
        for (size_t i = 0; i < 3; i++) least += weights[c][i] * mean[i] / before[i];
        assert_true(least < weights[c][0] + weights[c][1] + weights[c][2]);
        for (size_t k = 0; k < 8; k++) {
            double q[4], sum = 0;
            memcpy(q, p, sizeof q);
            q[k / 2] += (k % 2 ? 1e-3 : -1e-3) * yk_hypot(yk_hypot(p[0], p[1]), yk_hypot(p[2], p[3]));
            mean_squares(q, radius, mean);
            for (size_t i = 0; i < 3; i++) sum += weights[c][i] * mean[i] / before[i];
            assert_true(sum > least);
        }
        yk_balancing_free(b);
        close_machine(&m);
    }
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

// Khurmi & Gupta 16.13: T = 5000 + 1500 sin(3 theta) N m at 300 rpm swings the energy by 2 * 1500/3 = 1000 J. The extremes lie
// between the poses.
static void a_flywheel_for_a_given_torque_has_six_digits(void **state)
{
    (void)state;
    static const double starts[] = {0, 0.0031, 0.4};
    for (size_t k = 0; k < 3; k++) {
        char text[512];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {O: [0, 0]}}, shaft: {points: {O: [0, 0]}, mass: 1, inertia: 1000}}\n"
                 "joints: {O: {pin: [ground, shaft], angle: q}}\nefforts: {q: -5000 N*m - 1500 N*m * sin(3*q)}\n"
                 "drives: {q: %g rad + 300 rpm * t}\n",
                 starts[k]);
        Machine m = open_text(text);
        YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
        CHECK_NEAR(yk_balancing_flywheel(b) * .05 * 100 * YK_PI * YK_PI, 1000, 1e-3);
        yk_balancing_free(b);
        close_machine(&m);
    }
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
    CHECK_NEAR(yk_balancing_flywheel(b), 2 * 2 * 10 * .5 / (.1 * 9), 1e-6);
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
        cmocka_unit_test(a_crank_alone_balances_half_of_the_piston),
        cmocka_unit_test(a_compromise_is_the_least_in_its_neighbourhood),
        cmocka_unit_test(a_four_bar_gets_the_counterweights_of_berkof_and_lowen),
        cmocka_unit_test(a_six_bar_is_balanced_with_counterweights_on_three_bodies_or_more),
        cmocka_unit_test(a_slider_crank_is_balanced_by_its_rod_and_its_crank),
        cmocka_unit_test(a_flywheel_takes_up_the_torques_energy),
        cmocka_unit_test(a_flywheel_for_a_given_torque_has_six_digits),
        cmocka_unit_test(machines_without_masses_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
