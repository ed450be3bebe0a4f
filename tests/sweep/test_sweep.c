// Sweeps: the contents of a row, the place of a limit, extremes between rows, and that nothing is jumped - over a
// coordinate or over time, however far apart the rows.
#include "solve/four_bar.h"

static const char *const names[] = {"coupler.angle", "theta4", "theta4.rate", "theta4.accel"};

// --- limits
// -------------------------------------------------------------------------------------------------------------

// Finds the crank angles in [0, pi] between which a four-bar whose crank cannot turn through closes, by the triangle
// inequality for the distance: |b - c| <= |A O4| <= b + c.
static void closing_angles(FourBar f, double *low, double *high)
{
    double inner = fabs(f.b - f.c), outer = f.b + f.c;
    double c_low = (f.a * f.a + f.d * f.d - inner * inner) / (2 * f.a * f.d);
    double c_high = (f.a * f.a + f.d * f.d - outer * outer) / (2 * f.a * f.d);
    *low = acos(fmax(-1, fmin(1, c_low)));
    *high = acos(fmax(-1, fmin(1, c_high)));
}

static void check_limit(FourBar f, double theta, int branch, double to, double limit, size_t steps)
{
    Machine m = four_bar_machine(f, theta, branch);
    YkSweep *sweep = machine_sweep(&m, "theta2", theta, to, steps, names, 4);
    if (yk_sweep_status(sweep) != YK_LIMIT)
        print_error("%.17g %.17g %.17g %.17g from %.17g to %.17g in %zu steps\n", f.a, f.b, f.c, f.d, theta, to, steps);
    assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
    YkEvent last = yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1);
    assert_int_equal(last.kind, YK_EVENT_LIMIT);
    assert_int_equal(last.block, 0);
    if (fabs(last.at - limit) > 1e-8)
        print_error("%.17g %.17g %.17g %.17g from %.17g to %.17g in %zu steps\n", f.a, f.b, f.c, f.d, theta, to, steps);
    CHECK_NEAR(last.at, limit, 1e-8);
    // the rows before are there, on their branch
    size_t rows = yk_sweep_row_count(sweep),
           due = (size_t)floor(fabs(limit - theta) / fabs(to - theta) * (double)steps * (1 - 1e-9));
    assert_int_equal(rows, due + 1);
    for (size_t row = 0; row < rows; row++) {
        FourBarPose p = four_bar_pose(f, yk_sweep_at(sweep, row), branch);
        CHECK_NEAR(angle_between(yk_sweep_value(sweep, row, 1), p.rocker), 0, 1e-7);
    }
    // the state stands at the limit, and comes back on its branch
    CHECK_NEAR(yk_state_coordinate(m.state, 0).position, limit, 1e-8);
    CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
    assert_true(machine_solve(&m, theta, 1, 0) >= 0);
    CHECK_NEAR(angle_between(machine_ask(&m, "theta4"), four_bar_pose(f, theta, branch).rocker), 0, 1e-12);
    yk_sweep_free(sweep);
    machine_free(&m);
}

// A row just at the limit, to rounding, may be there or not; the sweep ends there all the same.
static void check_row_at_limit(FourBar f, double theta, int branch, double limit)
{
    Machine m = four_bar_machine(f, theta, branch);
    YkSweep *sweep = machine_sweep(&m, "theta2", theta, theta + 2 * (limit - theta), 2, names, 4);
    assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
    assert_true(yk_sweep_row_count(sweep) == 1 || yk_sweep_row_count(sweep) == 2);
    CHECK_NEAR(yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1).at, limit, 1e-8);
    assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), 0);
    CHECK_NEAR(yk_state_coordinate(m.state, 0).position, limit, 1e-8);
    CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
    CHECK_NEAR(angle_between(machine_ask(&m, "theta4"), four_bar_pose(f, limit, branch).rocker), 0, 1e-6);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_a_limit_is_found_to_1e_8_rad_both_ways(void **unused)
{
    (void)unused;
    uint64_t seed = 42;
    static const size_t steps[] = {1, 2, 7, 36, 100};
    for (uint64_t k = 0; k < check_cases(2000);) {
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1),
                     check_uniform(&seed, 0.1, 1)};
        double low, high;
        closing_angles(f, &low, &high);
        if (high - low < 0.05 || (low < 1e-3 && high > YK_PI - 1e-3) || (low > 0 && low < 1e-3) ||
            (high < YK_PI && high > YK_PI - 1e-3))
            continue;
        k++;
        double theta = 0.5 * (low + high);
        int branch = check_random(&seed) & 1 ? 1 : -1;
        // where the crank passes 0 or pi, the range goes on to the mirrored limit
        double top = high < YK_PI - 1e-3 ? high : 2 * YK_PI - low, bottom = low > 1e-3 ? low : -high;
        check_limit(f, theta, branch, theta + 2 * YK_PI, top, steps[k % 5]);
        check_limit(f, theta, branch, theta - 2 * YK_PI, bottom, steps[k % 5]);
        if (k % 10 != 1) continue;
        check_row_at_limit(f, theta, branch, top);
        check_row_at_limit(f, theta, branch, bottom);
    }
}

// Crank and frame alike: the dyad's base all but vanishes where it does not close any more. The last pose still has
// links of their own length.
static void test_links_keep_their_length_at_a_limit_with_a_short_base(void **unused)
{
    (void)unused;
    for (double difference = 0.1; difference > 1e-9; difference *= 0.1) {
        FourBar f = {1, 0.5 + difference, 0.5, 1};
        double limit = 2 * asin(0.5 * (f.b - f.c));
        Machine m = four_bar_machine(f, 0.5, 1);
        YkSweep *sweep = machine_sweep(&m, "theta2", 0.5, -0.5, 10, NULL, 0);
        assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
        CHECK_NEAR(yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1).at, limit, 1e-10);
        for (double beyond = 0; beyond < 1e-9; beyond = 10 * beyond + 1e-17) {
            machine_solve(&m, limit - beyond, 1, 0);
            double x = machine_ask(&m, "coupler.B.x") - machine_ask(&m, "coupler.A.x");
            double y = machine_ask(&m, "coupler.B.y") - machine_ask(&m, "coupler.A.y");
            CHECK_NEAR(hypot(x, y), f.b, 1e-12);
        }
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

static void test_the_quick_return_stops_where_its_coupler_is_stretched(void **unused)
{
    (void)unused;
    // The ram's height over B is 2 - 7/4 sin(theta2); it closes for sin(theta2) >= (2 - 2/3) / (7/4).
    double lever = asin((2 - 2.0 / 3) / 1.75), limit;
    // theta1: the crank pin (3/4 cos, 1 + 3/4 sin) in direction `lever` from the origin
    double phase = acos(cos(lever) / 0.75); // cross((0.75 c, 1 + 0.75 s), e) = 0: 0.75 sin(lever - theta1) = cos(lever)
    limit = lever - (YK_PI / 2 - phase);
    Machine m = machine_load("quick-return");
    YkSweep *sweep = machine_sweep(&m, "theta1", YK_PI / 6, -1, 10, NULL, 0);
    assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
    YkEvent e = yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1);
    CHECK_NEAR(e.at, limit, 1e-8);
    CHECK_NEAR(e.at * 180 / YK_PI, -10.09, 5e-3); // as published
    assert_string_equal(yk_block_info(m.mech, (size_t)e.block).label, "C");
    yk_sweep_free(sweep);
    machine_free(&m);
}

// --- nothing is jumped
// ----------------------------------------------------------------------------------------------------

static void test_a_narrow_gap_is_not_jumped(void **unused)
{
    (void)unused;
    // b - c > d - a by `gap`: does not close about 0, over an angle of the order of the root of the gap
    for (double gap = 0.1; gap > 1e-9; gap *= 0.3) {
        FourBar f = {0.6, 0.9 + gap, 0.5, 1};
        double low, high;
        closing_angles(f, &low, &high);
        for (size_t steps = 1; steps <= 3; steps++) {
            check_limit(f, 1, 1, -1, low, steps);
            check_limit(f, -0.77, -1, 1, -low, steps);
        }
    }
}

static const char driven_by_time[] = "parameters: {w: 1 rad/s, a: 2, b: 4, c: 2, d: 4}\n"
                                     "bodies:\n"
                                     "  ground:  {points: {O2: [0, 0], O4: [d, 0]}}\n"
                                     "  crank:   {points: {O2: [0, 0], A: [a, 0]}}\n"
                                     "  coupler: {points: {A: [0, 0], B: [b, 0]}}\n"
                                     "  rocker:  {points: {O4: [0, 0], B: [c, 0]}}\n"
                                     "joints:\n"
                                     "  O2: {pin: [ground, crank], angle: theta2}\n"
                                     "  A:  {pin: [crank, coupler], angle: gamma}\n"
                                     "  O4: {pin: [ground, rocker], angle: theta4}\n"
                                     "  B:  {pin: [coupler, rocker]}\n"
                                     "drives: {theta2: 1 + w * t}\n"
                                     "start: {gamma: -1, theta4: 1}\n";

// At w rad/s; with the lengths of the file (a parallelogram), or those of the non-Grashof example.
static Machine drive_by_time(double w, bool stops)
{
    char value[64];
    snprintf(value, sizeof value, "%.17g rad/s", w);
    YkOverride changes[] = {{"w", value}, {"a", "5"}, {"b", "6"}, {"c", "7"}, {"d", "10"}};
    Machine m = machine_parse_with(driven_by_time, changes, stops ? 5 : 1);
    assert_true(yk_state_assemble(m.state) >= 0);
    return m;
}

static void check_parallel_over_time(double w, size_t steps)
{
    Machine m = drive_by_time(w, false);
    YkSweep *sweep = machine_sweep(&m, NULL, 0, 3.3 * 2 * YK_PI / w, steps, names, 4);
    assert_true(yk_sweep_status(sweep) >= 0);
    for (size_t row = 0; row <= steps; row++) {
        CHECK_NEAR(yk_sweep_value(sweep, row, 0), 0, 1e-6);
        CHECK_NEAR(yk_sweep_value(sweep, row, 1), 1 + w * yk_sweep_at(sweep, row), 1e-6);
    }
    assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), 6);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_a_fast_drive_over_time_jumps_neither_limit_nor_change_point(void **unused)
{
    (void)unused;
    static const double rpm[] = {1, 60, 3000, 30000};
    for (size_t k = 0; k < 4; k++) {
        double w = rpm[k] * YK_PI / 30;
        for (size_t steps = 1; steps <= 4; steps++) check_parallel_over_time(w, steps);
        Machine m = drive_by_time(w, true);
        YkSweep *sweep = machine_sweep(&m, NULL, 0, 2 * YK_PI / w, 1, names, 4);
        assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
        CHECK_NEAR(yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1).at * w + 1, acos(-0.44), 1e-8);
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

static void test_a_drive_without_a_value_ends_a_sweep_over_time(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  link: {points: {O: [0, 0], P: [1, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, link], angle: theta}\n"
                              "drives: {theta: sqrt(1 - t/(1 s))}\n",
                              true);
    static const char *const of[] = {"theta"};
    YkSweep *sweep = machine_sweep(&m, NULL, 0, 2, 10, of, 1);
    assert_int_equal(yk_sweep_status(sweep), YK_BAD_MODEL);
    assert_true(yk_sweep_row_count(sweep) >= 5 && yk_sweep_row_count(sweep) <= 6);
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++)
        CHECK_NEAR(yk_sweep_value(sweep, row, 0), sqrt(fmax(0, 1 - yk_sweep_at(sweep, row))), 1e-12);
    yk_sweep_free(sweep);
    machine_free(&m);
}

// --- rows
// ---------------------------------------------------------------------------------------------------------------

static void test_rows_are_what_solving_pose_by_pose_gives(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta2",       "gamma",       "theta4",         "gamma.rate",
                                     "theta4.accel", "coupler.P.x", "coupler.P.speed"};
    Machine m = machine_load("four-bar"), n = machine_load("four-bar");
    yk_state_set_input(m.state, 0, (YkMotion){1, 2.5, -3});
    YkSweep *sweep = machine_sweep(&m, "theta2", 1, 7, 50, of, 7);
    for (size_t row = 0; row <= 50; row++) {
        assert_true(machine_solve(&n, yk_sweep_at(sweep, row), 2.5, -3) >= 0);
        CHECK_NEAR(yk_sweep_at(sweep, row), row == 50 ? 7 : 1 + 6.0 * (double)row / 50, 0);
        for (size_t c = 0; c < 7; c++) {
            double off = yk_sweep_value(sweep, row, c) - machine_ask(&n, of[c]);
            CHECK_NEAR(c == 1 || c == 2 ? angle_between(off, 0) : off, 0, 0);
        }
    }
    yk_sweep_free(sweep);
    machine_free(&m);
    machine_free(&n);
}

static void test_a_second_sweep_gives_the_rates_of_the_first(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    yk_state_set_input(m.state, 0, (YkMotion){1, 2.5, -3});
    YkSweep *first = machine_sweep(&m, "theta2", 1, 2, 10, names, 4);
    YkMotion after = yk_state_input(m.state, 0);
    CHECK_NEAR(after.position, 2, 0);
    CHECK_NEAR(after.velocity, 2.5, 0);
    CHECK_NEAR(after.acceleration, -3, 0);
    CHECK_NEAR(machine_ask(&m, "theta4.rate"), yk_sweep_value(first, 10, 2), 0);
    YkSweep *second = machine_sweep(&m, "theta2", 1, 2, 10, names, 4);
    for (size_t row = 0; row <= 10; row++)
        for (size_t c = 0; c < 4; c++) CHECK_NEAR(yk_sweep_value(second, row, c), yk_sweep_value(first, row, c), 0);
    yk_sweep_free(first);
    yk_sweep_free(second);
    machine_free(&m);
}

static void test_angles_are_continuous_over_many_turns(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta4", "coupler.angle", "output.angle"};
    Machine m = machine_load("drag-link");
    YkSweep *sweep = machine_sweep(&m, "theta2", YK_PI / 2, YK_PI / 2 + 20 * YK_PI, 7, of, 3);
    for (size_t c = 0; c < 3; c++) // whole turns, as the input makes
        CHECK_NEAR(yk_sweep_value(sweep, 7, c) - yk_sweep_value(sweep, 0, c), c == 1 ? 20 * YK_PI : 20 * YK_PI, 1e-11);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_a_bad_range_is_refused(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    YkSweepOptions good = yk_default_sweep_options();
    good.coordinate = (int)yk_coordinate_find(m.mech, "theta2");
    YkSweepOptions bad[6] = {good, good, good, good, good, good};
    bad[0].from = NAN;
    bad[1].to = INFINITY;
    bad[2].steps = 0;
    bad[3].turn_max = 0;
    bad[4].coordinate = (int)yk_coordinate_find(m.mech, "theta4"); // not an input
    bad[5].coordinate = 99;
    for (size_t k = 0; k < 6; k++) {
        size_t before = yk_problems_error_count(m.problems);
        assert_null(yk_sweep_run(m.state, &bad[k], NULL, 0, m.problems));
        assert_int_equal(yk_problems_error_count(m.problems), before + 1);
    }
    machine_free(&m);
}

// --- extremes
// -------------------------------------------------------------------------------------------------------------

static void test_extremes_of_the_slider_crank_are_its_dead_centres(void **unused)
{
    (void)unused;
    static const char *const of[] = {"x"};
    for (size_t steps = 1; steps < 100; steps = 3 * steps + 1) {
        Machine m = machine_load("slider-crank");
        YkSweep *sweep = machine_sweep(&m, "theta", 1, 1 + 2 * YK_PI, steps, of, 1);
        assert_int_equal(yk_sweep_event_count(sweep), 2);
        YkEvent low = yk_sweep_event(sweep, 0), high = yk_sweep_event(sweep, 1);
        CHECK_NEAR(low.at, YK_PI, 1e-9);
        CHECK_NEAR(low.value, 0.45, 1e-12);
        CHECK_NEAR(high.at, 2 * YK_PI, 1e-9);
        CHECK_NEAR(high.value, 0.75, 1e-12);
        assert_true(high.is_maximum && !low.is_maximum);
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

// The coupler's point P of the parallelogram is farthest right at 0 and left at pi: at its change points.
static void test_extremes_at_a_change_point_are_those_of_the_motion(void **unused)
{
    (void)unused;
    static const char *const of[] = {"coupler.P.x"};
    for (size_t steps = 1; steps < 400; steps = 2 * steps + 1) {
        for (int way = -1; way <= 1; way += 2) {
            Machine m = machine_load("parallelogram");
            YkSweep *sweep = machine_sweep(&m, "theta2", way * 1.01, way * (1.01 + 2 * YK_PI), steps, of, 1);
            assert_int_equal(count_events(sweep, YK_EVENT_EXTREME), 2);
            for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
                YkEvent e = yk_sweep_event(sweep, k);
                if (e.kind != YK_EVENT_EXTREME) continue;
                CHECK_NEAR(e.at, e.is_maximum ? way * 2 * YK_PI : way * YK_PI, 1e-7);
                CHECK_NEAR(e.value, e.is_maximum ? 4 : 0, 1e-12);
            }
            yk_sweep_free(sweep);
            machine_free(&m);
        }
    }
}

static void test_all_rows_at_once_are_the_rows_one_by_one(void **unused)
{
    (void)unused;
    FourBar f = {0.1, 0.25, 0.3, 0.28};
    Machine m = four_bar_machine(f, 1, 1);
    YkSweep *sweep = machine_sweep(&m, "theta2", 1, 4, 7, names, 4);
    const double *rows = yk_sweep_rows(sweep);
    assert_int_equal(yk_sweep_row_count(sweep), 8);
    for (size_t row = 0; row < 8; row++) {
        assert_true(rows[row * 5] == yk_sweep_at(sweep, row));
        for (size_t c = 0; c < 4; c++) assert_true(rows[row * 5 + 1 + c] == yk_sweep_value(sweep, row, c));
    }
    assert_true(rows[7 * 5] == 4 && rows[5] != rows[1]);
    yk_sweep_free(sweep);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_rows_at_once_are_the_rows_one_by_one),
        cmocka_unit_test(test_a_limit_is_found_to_1e_8_rad_both_ways),
        cmocka_unit_test(test_links_keep_their_length_at_a_limit_with_a_short_base),
        cmocka_unit_test(test_the_quick_return_stops_where_its_coupler_is_stretched),
        cmocka_unit_test(test_a_narrow_gap_is_not_jumped),
        cmocka_unit_test(test_a_fast_drive_over_time_jumps_neither_limit_nor_change_point),
        cmocka_unit_test(test_a_drive_without_a_value_ends_a_sweep_over_time),
        cmocka_unit_test(test_rows_are_what_solving_pose_by_pose_gives),
        cmocka_unit_test(test_a_second_sweep_gives_the_rates_of_the_first),
        cmocka_unit_test(test_angles_are_continuous_over_many_turns),
        cmocka_unit_test(test_a_bad_range_is_refused),
        cmocka_unit_test(test_extremes_of_the_slider_crank_are_its_dead_centres),
        cmocka_unit_test(test_extremes_at_a_change_point_are_those_of_the_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
