// No pose is reported on a branch other than the one that was assembled: random Grashof four-bars, coarse and fine
// sweeps, forward and back, against the closed form. YOKE_FULL=1 in the environment runs 1e5 of them.
#include "four_bar.h"

enum { FOUR_BARS = 300, FOUR_BARS_FULL = 100000, TURN = 360, SIZES = 5 };
static const size_t step_counts[SIZES] = {8, 12, 24, 72, TURN};
static const char *const names[] = {"coupler.angle", "theta4", "gamma"};
static double finest[TURN + 1][3];

static FourBar random_grashof(uint64_t *seed)
{
    for (;;) {
        FourBar f = {check_uniform(seed, 0.1, 1), check_uniform(seed, 0.1, 1), check_uniform(seed, 0.1, 1),
                     check_uniform(seed, 0.1, 1)};
        if (crank_turns(f)) return f;
    }
}

// How much rounding can grow: 1 / (sine of the least transmission angle of a turn, at crank angle 0 or pi).
static double conditioning(FourBar f)
{
    double least = 1;
    for (int side = -1; side <= 1; side += 2) {
        double l = f.d - side * f.a, cosine = (f.b * f.b + f.c * f.c - l * l) / (2 * f.b * f.c);
        least = fmin(least, sqrt(fmax(1 - cosine * cosine, 0)));
    }
    return 1 / fmax(least, 1e-12);
}

static void say(FourBar f, double theta, int branch, size_t steps, size_t row)
{
    print_error("four-bar %.17g %.17g %.17g %.17g from %.17g on branch %d in %zu steps, row %zu\n", f.a, f.b, f.c, f.d,
                theta, branch, steps, row);
}

// Rows against the closed form, and against the finest sweep without leaving out turns.
static void check_rows(const YkSweep *sweep, FourBar f, double theta, int branch, size_t steps)
{
    double tolerance = 1e-13 * conditioning(f) + 1e-13;
    for (size_t row = 0; row <= steps; row++) {
        FourBarPose p = four_bar_pose(f, yk_sweep_at(sweep, row), branch);
        double off = fmax(fabs(angle_between(yk_sweep_value(sweep, row, 0), p.coupler)),
                          fabs(angle_between(yk_sweep_value(sweep, row, 1), p.rocker)));
        if (!(off <= tolerance)) say(f, theta, branch, steps, row);
        CHECK_NEAR(off, 0, tolerance);
        for (size_t c = 0; c < 3; c++) {
            double *fine = &finest[row * TURN / steps][c], value = yk_sweep_value(sweep, row, c);
            if (steps == TURN) *fine = value;
            if (!(fabs(value - *fine) <= 1e-10)) say(f, theta, branch, steps, row);
            CHECK_NEAR(value, *fine, 1e-10);
        }
    }
}

static void check_four_bar(FourBar f, double theta, int branch)
{
    Machine m = four_bar_machine(f, theta, branch);
    for (int way = -1; way <= 1; way += 2) {
        for (size_t k = SIZES; k-- > 0;) {
            YkState *state = m.state, *fresh = yk_state_new(m.mech);
            yk_state_copy(fresh, state);
            m.state = fresh;
            YkSweep *sweep = machine_sweep(&m, "theta2", theta, theta + way * 2 * YK_PI, step_counts[k], names, 3);
            if (yk_sweep_status(sweep) != YK_OK) say(f, theta, branch, step_counts[k], 0);
            assert_int_equal(yk_sweep_status(sweep), YK_OK);
            assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT) + count_events(sweep, YK_EVENT_SINGULAR), 0);
            check_rows(sweep, f, theta, branch, step_counts[k]);
            yk_sweep_free(sweep);
            yk_state_free(fresh);
            m.state = state;
        }
    }
    machine_free(&m);
}

static void test_random_grashof_four_bars_keep_their_branch(void **unused)
{
    (void)unused;
    long count = getenv("YOKE_FULL") ? FOUR_BARS_FULL : (long)check_cases(FOUR_BARS);
    for (long k = 0; k < count; k++) {
        uint64_t seed = 1000003u * (uint64_t)k + 17;
        FourBar f = random_grashof(&seed);
        if (grashof_excess(f) > -1e-5) continue; // a change point but for rounding: see test_change_points.c
        int side = check_random(&seed) & 1 ? 1 : -1;
        check_four_bar(f, check_uniform(&seed, -YK_PI, YK_PI), side);
    }
}

static void test_known_hard_ratios_keep_their_branch(void **unused)
{
    (void)unused;
    static const FourBar hard[] = {{0.5, 1.2, 0.8, 1},      // a published flip of warm-started Newton
                                   {1, 1.2, 0.8, 0.5},      // its drag link
                                   {0.1, 1, 1, 1},          // hardly moves
                                   {1, 2, 2.0001, 2.9999},  // stretched at pi: sine 1e-2
                                   {1, 1.01, 1.02, 0.985}}; // nearly a rhombus: the dyad's base nearly vanishes
    for (size_t k = 0; k < sizeof hard / sizeof hard[0]; k++)
        for (int branch = -1; branch <= 1; branch += 2)
            for (double theta = -3; theta < 3; theta += 0.7)
                if (crank_turns(hard[k])) check_four_bar(hard[k], theta, branch);
}

static void test_both_branches_of_the_oracle_close(void **unused)
{
    (void)unused;
    FourBar f = {40, 120, 80, 100}; // Norton, example 4-1: 20.298 and 57.325 deg; crossed -60.98, -98.00
    FourBarPose open = four_bar_pose(f, 40 * YK_PI / 180, -1), crossed = four_bar_pose(f, 40 * YK_PI / 180, 1);
    CHECK_NEAR(open.coupler * 180 / YK_PI, 20.298, 5e-4);
    CHECK_NEAR(open.rocker * 180 / YK_PI, 57.325, 5e-4);
    CHECK_NEAR(crossed.coupler * 180 / YK_PI, -60.98, 5e-3);
    CHECK_NEAR(crossed.rocker * 180 / YK_PI, -98.00, 1e-2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_both_branches_of_the_oracle_close),
        cmocka_unit_test(test_known_hard_ratios_keep_their_branch),
        cmocka_unit_test(test_random_grashof_four_bars_keep_their_branch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
