// Starts in singular poses: dead points of the starting coordinates, and change points.
#include "run.h"

#define FLAT(mass, start)                                                                                              \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"                                         \
    "  crank: {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}\n"                                                \
    "  coupler: {points: {A: [0, 0], B: [2, 0]}, mass: 1, rod: [A, B]}\n"                                              \
    "  rocker: {points: {Q: [0, 0], B: [1, 0]}, mass: " #mass ", rod: [Q, B]}\n"                                       \
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, coupler], angle: c}\n"                         \
    "  Q: {pin: [ground, rocker], angle: r}\n  B: {pin: [coupler, rocker]}\nstart: " start "\n"

static void check_refused(const char *text, const char *why, const char *hint)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    assert_null(yk_simulation_new(model, NULL, problems));
    assert_int_equal(yk_problems_error_count(problems), 1);
    assert_non_null(strstr(yk_problems_text(problems, 0), why));
    assert_non_null(strstr(yk_problems_text(problems, 0), hint));
    yk_model_free(model);
    yk_problems_free(problems);
}

// From rest the weights push a parallelogram of equal sides down as a parallelogram: q'' = -g (1/2 + 1 + 1/2) / (1/3 +
// 1
// + 1/3) = -12 at first, and its angle obeys the pendulum's equation q'' = -12 cos q ever after: q'^2 = -24 sin q.
static void a_flat_parallelogram_falls_as_one(void **unused)
{
    (void)unused;
    Run run = run_of_text(FLAT(1, "{q: 0, c: 0, r: 0}"), run_options(1e-10));
    for (int k = 0; k <= 60; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.05 * k), YK_OK);
        double q = run_value(&run, "q"), rate = run_value(&run, "q.rate");
        CHECK_NEAR(run_value(&run, "r"), q, 1e-8);
        CHECK_NEAR(rate * rate, -24 * sin(q), 1e-7);
        CHECK_NEAR(run_value(&run, "q.accel"), -12 * cos(q), 1e-6);
    }
    run_free(&run);
}

// The rates tell the branches apart: as parallelogram r' = q'; crossed, r' = -q' (L + a)/(L - a) = -3 q'.
static void rates_tell_the_branch(void **unused)
{
    (void)unused;
    static const char *const starts[] = {FLAT(3, "{q: 0, c: 0, r: 0, q.rate: 2, r.rate: 2}"),
                                         FLAT(3, "{q: 0, c: 0, r: 0, r.rate: -6, q.rate: 2}"),
                                         FLAT(3, "{q: 0, c: 0, r: 0, r.rate: 2, c.rate: -2}")};
    for (int k = 0; k < 3; k++) {
        Run run = run_of_text(starts[k], run_options(1e-10));
        double kinetic = 0;
        for (int row = 0; row <= 30; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.01 * row), YK_OK);
            double q = run_value(&run, "q"), r = run_value(&run, "r"), energy = run_value(&run, "energy");
            if (row == 0) kinetic = energy; // all lies on the line of height 0
            CHECK_NEAR(energy, kinetic, 1e-7);
            double crossed = tan(r / 2) + 3 * tan(q / 2); // of half angles, by the loop's equation
            CHECK_NEAR(k == 1 ? crossed : r - q, 0, 1e-7);
        }
        double own = k == 1 ? 0.5 * 4 / 3 + 0.5 * 3 * 36 / 3 : 0.5 * 4 * (1.0 / 3 + 1 + 3.0 / 3);
        if (k == 1) { // the coupler's ends rise at 2 and -6
            own += 0.5 * (4 + 36 + 2 * -6) / 3.0;
        }
        CHECK_NEAR(kinetic, own, 1e-7);
        run_free(&run);
    }
}

static void what_is_not_decided_is_refused(void **unused)
{
    (void)unused;
    check_refused(FLAT(2, "{q: 0, c: 0, r: 0}"), "joint `B` lies flat, and at rest the loads push it off both",
                  "give `r` a rate");
    check_refused(FLAT(1, "{q: 0, c: 0, r: 0, q.rate: 2}"), "the rates of `start:` fit both",
                  "-3 or 1 times that of `q`");
    check_refused(FLAT(1, "{q: 0, c: 0, r: 0, q.rate: 2, r.rate: 1}"), "fit neither", "-3 or 1 times that of `q`");
}

static void without_loads_it_stays(void **unused)
{
    (void)unused;
    const char *text = FLAT(1, "{q: 0, c: 0, r: 0}");
    Run run = run_of_text(strchr(text, '\n') + 1, run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
    CHECK_NEAR(run_value(&run, "q"), 0, 0);
    run_free(&run);
}

// A slider-crank stretched out, started by its slide: a dead point of the slide alone.
static void a_dead_point_of_the_start_is_no_obstacle(void **unused)
{
    (void)unused;
#define STRETCHED(first, second, start)                                                                                \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                    \
    "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0.02, 0]}\n"                         \
    "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"    \
    "joints:\n" first second "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\nstart: " start "\n"
#define SLIDE "  R: {slide: [ground, piston], along: x, distance: d}\n"
#define CRANK "  O: {pin: [ground, crank], angle: q}\n"
    static const char *const starts[] = {"", ", q.rate: 3", ", q.rate: -3, d.rate: 0"};
    for (int k = 0; k < 3; k++) {
        char text[2][1200];
        snprintf(text[0], sizeof text[0], STRETCHED(SLIDE, CRANK, "{d: 0.4, q: 0, p: 0%s}"), starts[k]);
        snprintf(text[1], sizeof text[1], STRETCHED(SLIDE, CRANK, "{q: 0, d: 0.4, p: 0%s}"), starts[k]);
        Run run = run_of_text(text[0], run_options(1e-11)), other = run_of_text(text[1], run_options(1e-11));
        for (int row = 0; row <= 20; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.05 * row), YK_OK);
            assert_int_equal(yk_simulation_advance(other.sim, 0.05 * row), YK_OK);
            CHECK_NEAR(run_value(&run, "q"), run_value(&other, "q"), 1e-7);
            CHECK_NEAR(run_value(&run, "d"), run_value(&other, "d"), 1e-8);
        }
        assert_true(yk_simulation_summary(run.sim).energy_error < 1e-9);
        run_free(&run);
        run_free(&other);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flat_parallelogram_falls_as_one),        cmocka_unit_test(rates_tell_the_branch),
        cmocka_unit_test(what_is_not_decided_is_refused),           cmocka_unit_test(without_loads_it_stays),
        cmocka_unit_test(a_dead_point_of_the_start_is_no_obstacle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
