// An assembly carried to other dimensions: the loop equation of a four-bar, written here, holds there with its rates,
// on the side from which it came; the way back ends where it began, for groups too; and what comes apart says so.
#include "solve/machine.h"
#include "compile/variant.h"
#include "solve/state.h"

static const char *const names[] = {"a", "b", "c", "d", "e"};
enum { LENGTHS = 5 };

static const char *const four_bar =
    "parameters: {a: 1, b: 3, c: 2.5, d: 3.2, e: 1}\n"
    "bodies:\n  ground: {points: {O: [0, 0], Q: [d, 0]}}\n  crank: {points: {O: [0, 0], A: [a, 0]}}\n"
    "  coupler: {points: {A: [0, 0], B: [b, 0], P: [e, e]}}\n  rocker: {points: {Q: [0, 0], B: [c, 0]}}\n"
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, coupler], angle: u}\n"
    "  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, rocker]}\nstart: {q: 1, ";

// Driven at its last link, so that all of it is one group.
static const char *const group =
    "parameters: {a: 1, b: 3.5, c: 3, d: 4, e: 2.5}\n"
    "bodies:\n  ground: {points: {P: [0, 0], Q: [d, 0], O: [6, e]}}\n  crank: {points: {P: [0, 0], A: [a, 0]}}\n"
    "  coupler: {points: {A: [0, 0], B: [b, 0], C: [2, 1.5]}}\n  rocker: {points: {Q: [0, 0], B: [c, 0]}}\n"
    "  link: {points: {C: [0, 0], D: [4.5, 0]}}\n  output: {points: {O: [0, 0], D: [2.5, 0]}}\n"
    "joints:\n  O: {pin: [ground, output], angle: q}\n  D: {pin: [output, link], angle: v}\n"
    "  P: {pin: [ground, crank], angle: p}\n  A: {pin: [crank, coupler], angle: u}\n"
    "  Q: {pin: [ground, rocker], angle: r}\n  B: {pin: [coupler, rocker]}\n  C: {pin: [coupler, link]}\n"
    "start: {q: 120 deg, p: 120 deg, u: -90 deg, r: 119 deg, v: -101 deg}\n";

typedef struct Carried {
    Machine own;
    YkVariant *variant;
    YkState *state;
    double at[LENGTHS];
} Carried;

static Carried start(const char *text)
{
    Carried c = {.own = machine_parse(text, true)};
    c.variant = yk_variant_new(c.own.mech, names, LENGTHS, c.own.problems);
    assert_non_null(c.variant);
    c.state = yk_state_new(yk_variant_mechanism(c.variant));
    assert_non_null(c.state);
    assert_int_equal(yk_state_assemble(c.state), YK_OK);
    for (int k = 0; k < LENGTHS; k++) c.at[k] = yk_model_parameter(c.own.model, names[k]);
    return c;
}

static void end(Carried *c)
{
    yk_state_free(c->state);
    yk_variant_free(c->variant);
    machine_free(&c->own);
}

static YkMotion motion_of(const Carried *c, const char *name)
{
    return yk_state_coordinate(c->state, yk_coordinate_find(c->own.mech, name));
}

// r e^(i angle) and its first and second rates.
static void add_arm(YkVec sum[3], double r, YkMotion angle)
{
    YkVec e = yk_scale(r, yk_unit(angle.position)), ie = yk_quarter(e);
    sum[0] = yk_add(sum[0], e);
    sum[1] = yk_add(sum[1], yk_scale(angle.velocity, ie));
    sum[2] = yk_add(sum[2], yk_sub(yk_scale(angle.acceleration, ie), yk_scale(angle.velocity * angle.velocity, e)));
}

// Which side of the coupler the rocker lies on.
static double side_of(const Carried *c)
{
    return sin(motion_of(c, "v").position - motion_of(c, "q").position - motion_of(c, "u").position);
}

static void check_loop(const Carried *c)
{
    YkMotion q = motion_of(c, "q"), u = motion_of(c, "u");
    YkVec sum[3] = {{-c->at[3], 0}, {0, 0}, {0, 0}};
    add_arm(sum, c->at[0], q);
    add_arm(sum, c->at[1],
            (YkMotion){q.position + u.position, q.velocity + u.velocity, q.acceleration + u.acceleration});
    add_arm(sum, -c->at[2], motion_of(c, "v"));
    for (int k = 0; k < 3; k++) CHECK_NEAR(yk_norm(sum[k]), 0, 1e-11);
}

static YkStatus carry(Carried *c, const double *to, YkMotion goal)
{
    YkStatus status = yk_state_carry(c->state, c->variant, c->at, to, LENGTHS, &goal);
    memcpy(c->at, to, sizeof c->at);
    return status;
}

static void draw(uint64_t *seed, const double *at, double *to, double part)
{
    for (int k = 0; k < LENGTHS; k++) to[k] = at[k] * check_uniform(seed, 1 - part, 1 + part);
}

static void four_bars_keep_their_side_and_close(void **unused)
{
    (void)unused;
    uint64_t seed = 15;
    for (int k = 0; k < 40; k++) {
        char text[1200];
        snprintf(text, sizeof text, "%s%s\n", four_bar, k % 2 ? "u: -0.6, v: 1.5}" : "u: -1.8, v: -1.8}");
        Carried c = start(text);
        double side = side_of(&c);
        for (int step = 0; step < 3; step++) {
            double to[LENGTHS];
            YkMotion goal = {check_uniform(&seed, 0.3, 2.2), check_uniform(&seed, -2, 2), check_uniform(&seed, -2, 2)};
            draw(&seed, (double[]){1, 3, 2.5, 3.2, 1}, to, 0.1);
            assert_int_equal(carry(&c, to, goal), YK_OK);
            YkMotion q = motion_of(&c, "q");
            CHECK_NEAR(q.position, goal.position, 1e-15);
            CHECK_NEAR(q.velocity, goal.velocity, 0);
            CHECK_NEAR(q.acceleration, goal.acceleration, 0);
            check_loop(&c);
            assert_true(side * side_of(&c) > 0);
        }
        end(&c);
    }
}

static void a_group_comes_back_to_where_it_began(void **unused)
{
    (void)unused;
    uint64_t seed = 16;
    static const char *const coordinates[] = {"q", "p", "u", "r", "v"};
    for (int k = 0; k < 10; k++) {
        Carried c = start(group);
        double home[LENGTHS], to[LENGTHS], before[LENGTHS];
        YkMotion goal = yk_state_input(c.state, 0), away = goal;
        away.position += check_uniform(&seed, -0.1, 0.1);
        memcpy(home, c.at, sizeof home);
        draw(&seed, c.at, to, 0.03);
        for (int i = 0; i < LENGTHS; i++) before[i] = motion_of(&c, coordinates[i]).position;
        assert_int_equal(carry(&c, to, away), YK_OK);
        assert_true(yk_state_residuals(c.state).position < 1e-12);
        assert_true(fabs(motion_of(&c, "p").position - before[1]) > 1e-6);
        assert_int_equal(carry(&c, home, goal), YK_OK);
        for (int i = 0; i < LENGTHS; i++) CHECK_NEAR(motion_of(&c, coordinates[i]).position, before[i], 1e-9);
        end(&c);
    }
}

static void what_comes_apart_says_so(void **unused)
{
    (void)unused;
    char text[1200];
    snprintf(text, sizeof text, "%su: -0.6, v: 1.5}\n", four_bar);
    Carried c = start(text);
    const double apart[LENGTHS] = {1, 3, 2.5, 7, 1}, // the base is longer than all other links together
        same[LENGTHS] = {1, 3, 2.5, 3.2, 1};
    YkMotion goal = {1, 0, 0};
    assert_int_equal(yk_state_carry(c.state, c.variant, c.at, apart, LENGTHS, &goal), YK_NO_ASSEMBLY);
    assert_int_equal(yk_state_carry(c.own.state, c.variant, c.at, same, LENGTHS, &goal), YK_BAD_ARGUMENT);
    YkState *unsolved = yk_state_new(yk_variant_mechanism(c.variant));
    assert_int_equal(yk_state_carry(unsolved, c.variant, c.at, same, LENGTHS, &goal), YK_BAD_ARGUMENT);
    yk_state_free(unsolved);
    end(&c);
}

// Labels, turns and references are taken from a machine of the same build, and from no other.
static void labels_are_taken_from_the_same_build_alone(void **unused)
{
    (void)unused;
    char text[1200];
    snprintf(text, sizeof text, "%su: -0.6, v: 1.5}\n", four_bar);
    Machine from = machine_parse(text, true), to = machine_parse(text, true), other = machine_load("slider-crank");
    for (int k = 0; k < 2; k++) {
        assert_int_equal(yk_state_take_labels(to.state, from.state), YK_OK);
        assert_int_equal(yk_state_branch(to.state, 0), yk_state_branch(from.state, 0));
        assert_true(machine_solve(&to, 1 + k, 0, 0) >= 0 && machine_solve(&from, 1 + k, 0, 0) >= 0);
        CHECK_NEAR(machine_ask(&to, "v"), machine_ask(&from, "v"), 0);
        yk_state_set_branch(from.state, 0, -yk_state_branch(from.state, 0));
        assert_true(machine_solve(&from, 1, 0, 0) >= 0);
    }
    from.state->reference[yk_coordinate_find(from.mech, "v")] += 4 * YK_PI; // two turns on
    double v = machine_ask(&from, "v");
    assert_int_equal(yk_state_take_labels(to.state, from.state), YK_OK);
    assert_true(machine_solve(&to, 1, 0, 0) >= 0);
    CHECK_NEAR(machine_ask(&to, "v"), v, 1e-12);
    assert_int_equal(yk_state_take_labels(other.state, from.state), YK_BAD_ARGUMENT);
    char renamed[1200];
    snprintf(renamed, sizeof renamed, "%s", text);
    char *label = strstr(renamed, "  B: {pin");
    label[2] = 'D';
    strcpy(strstr(label, "rocker]}"), "rocker], at: B}\nstart: {q: 1, u: -0.6, v: 1.5}\n");
    Machine named = machine_parse(renamed, true);
    assert_int_equal(yk_state_take_labels(named.state, from.state), YK_BAD_ARGUMENT);
    machine_free(&named);
    machine_free(&other);
    machine_free(&to);
    machine_free(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_bars_keep_their_side_and_close),
        cmocka_unit_test(a_group_comes_back_to_where_it_began),
        cmocka_unit_test(what_comes_apart_says_so),
        cmocka_unit_test(labels_are_taken_from_the_same_build_alone),
    };
    return cmocka_run_group_tests_name("sweep/carry", tests, NULL, NULL);
}
