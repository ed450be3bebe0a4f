// Three wheels with a side rod and a piston, beside a group that Newton's method solves: along a path the wheels pass
// the poses in which two of them could fold either way, as all loops together say, and stay alike; whether steps end on
// such a pose or not.
#include "machine.h"

// The group as it is, or its mirror image, whose determinant has the other sign.
#define WHEELS(sign)                                                                                                   \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, " sign                                                        \
    "2.5], O: [0, -5], Q: [3, -5], P: [1, -4], Z: [0, -7]}}\n"                                                         \
    "  crank: {points: {O2: [0, 0], A: [1, 0]}}\n"                                                                     \
    "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, " sign "1.5]}}\n"                                             \
    "  rocker: {points: {O4: [0, 0], B: [3, 0]}}\n"                                                                    \
    "  link: {points: {C: [0, 0], D: [4.5, 0]}}\n"                                                                     \
    "  output: {points: {O6: [0, 0], D: [2.5, 0]}}\n"                                                                  \
    "  a: {points: {O: [0, 0], U: [0.8, 0]}}\n"                                                                        \
    "  b: {points: {U: [0, 0], V: [3, 0], W: [1, 1]}}\n"                                                               \
    "  c: {points: {Q: [0, 0], V: [0.8, 0]}}\n"                                                                        \
    "  d: {points: {P: [0, 0], W: [0.8, 0]}}\n"                                                                        \
    "  rod: {points: {U: [0, 0], K: [4, 0]}}\n"                                                                        \
    "  piston: {points: {K: [0, 0]}}\n"                                                                                \
    "joints:\n"                                                                                                        \
    "  O6: {pin: [ground, output], angle: theta6}\n"                                                                   \
    "  D: {pin: [output, link], angle: theta5}\n"                                                                      \
    "  O2: {pin: [ground, crank], angle: theta2}\n"                                                                    \
    "  A: {pin: [crank, coupler], angle: theta3}\n"                                                                    \
    "  O4: {pin: [ground, rocker], angle: theta4}\n"                                                                   \
    "  B: {pin: [coupler, rocker]}\n"                                                                                  \
    "  C: {pin: [coupler, link]}\n"                                                                                    \
    "  O: {pin: [ground, a], angle: th}\n"                                                                             \
    "  Q: {pin: [ground, c], angle: ps}\n"                                                                             \
    "  P: {pin: [ground, d], angle: ph}\n"                                                                             \
    "  U: {pin: [a, b], angle: u}\n"                                                                                   \
    "  V: {pin: [b, c]}\n"                                                                                             \
    "  W: {pin: [b, d]}\n"                                                                                             \
    "  X: {pin: [a, rod], at: U}\n"                                                                                    \
    "  K: {pin: [rod, piston]}\n"                                                                                      \
    "  Z: {slide: [ground, piston], along: x, from: Z, to: K, distance: x}\n"                                          \
    "drives: {theta6: " sign "120 deg, th: 0.5}\n"                                                                     \
    "start: {theta2: " sign "120 deg, theta3: -1*(" sign "90 deg), theta4: " sign "119 deg, theta5: -1*(" sign         \
    "101 deg), ps: 0.5, ph: 0.5, u: -0.5, x: 4}\n"

static const char *const texts[] = {WHEELS(""), WHEELS("-")};

static void check_alike(const Machine *m, double th, double w)
{
    static const char *const names[] = {"ps", "ph"};
    for (int k = 0; k < 2; k++) {
        char rate[20];
        snprintf(rate, sizeof rate, "%s.rate", names[k]);
        CHECK_NEAR(angle_between(machine_ask(m, names[k]), th), 0, 1e-9);
        CHECK_NEAR(machine_ask(m, rate), w, 1e-7);
    }
    CHECK_NEAR(angle_between(machine_ask(m, "b.angle"), 0), 0, 1e-9);
    double height = 2 + 0.8 * sin(th); // of the rod's upper end over the piston
    CHECK_NEAR(machine_ask(m, "x"), 0.8 * cos(th) + sqrt(16 - height * height), 1e-9);
    CHECK_NEAR(yk_state_residuals(m->state).position, 0, 1e-12);
}

static void wheels_beside_a_group_pass_their_folds(void **unused)
{
    (void)unused;
    static const double steps[] = {0.3, -0.3, 0.7, -1.1, 2.3, -2.9};
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        Machine m = machine_parse(texts[k % 2], true);
        size_t th = (size_t)yk_coordinate_info(m.mech, yk_coordinate_find(m.mech, "th")).input;
        double six = machine_ask(&m, "theta6");
        for (int n = 1; fabs(steps[k]) * n < 14; n++) {
            yk_state_set_input(m.state, th, (YkMotion){0.5 + steps[k] * n, 1.3, 0.2});
            assert_int_equal(yk_state_solve(m.state), YK_REDUNDANT);
            check_alike(&m, 0.5 + steps[k] * n, 1.3);
            CHECK_NEAR(machine_ask(&m, "theta6"), six, 0);
        }
        machine_free(&m);
    }
}

// To the fold itself, and on, either way.
static void a_path_may_end_on_a_fold(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        int way = k ? 1 : -1;
        Machine m = machine_parse(texts[k % 2], true);
        size_t th = (size_t)yk_coordinate_info(m.mech, yk_coordinate_find(m.mech, "th")).input;
        double fold = way > 0 ? YK_PI : 0;
        const double places[] = {fold, fold + 0.4 * way, fold, fold - 0.3 * way};
        for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
            yk_state_set_input(m.state, th, (YkMotion){places[i], 1, 0});
            assert_int_equal(yk_state_solve(m.state), YK_REDUNDANT);
            check_alike(&m, places[i], 1);
        }
        machine_free(&m);
    }
}

// A little beyond the fold, and back: the rest of the path is shorter than the step over the fold.
static void a_path_may_end_just_beyond_a_fold(void **unused)
{
    (void)unused;
    static const double beyond[] = {2e-5, 1e-4, 5e-4, 2e-3, 0.01};
    for (size_t k = 0; k < sizeof beyond / sizeof *beyond; k++)
        for (int way = -1; way <= 1; way += 2) {
            Machine m = machine_parse(texts[k % 2], true);
            size_t th = (size_t)yk_coordinate_info(m.mech, yk_coordinate_find(m.mech, "th")).input;
            double fold = way > 0 ? YK_PI : 0;
            const double places[] = {fold - 0.2 * way, fold + beyond[k] * way, fold - beyond[k] * way,
                                     fold - 0.3 * way};
            for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
                yk_state_set_input(m.state, th, (YkMotion){places[i], 1, 0});
                assert_int_equal(yk_state_solve(m.state), YK_REDUNDANT);
                check_alike(&m, places[i], 1);
            }
            machine_free(&m);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wheels_beside_a_group_pass_their_folds),
        cmocka_unit_test(a_path_may_end_on_a_fold),
        cmocka_unit_test(a_path_may_end_just_beyond_a_fold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
