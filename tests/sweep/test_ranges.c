// Where a configuration closes: every range, to 1e-10, against closed forms.
#include "solve/four_bar.h"

enum { CAPACITY = 16 };

static void closing_angles(FourBar f, double *low, double *high)
{
    double inner = fabs(f.b - f.c), outer = f.b + f.c;
    double c_low = (f.a * f.a + f.d * f.d - inner * inner) / (2 * f.a * f.d);
    double c_high = (f.a * f.a + f.d * f.d - outer * outer) / (2 * f.a * f.d);
    *low = acos(fmax(-1, fmin(1, c_low)));
    *high = acos(fmax(-1, fmin(1, c_high)));
}

// A range that equals [from, to] modulo a turn must be among those found.
static bool is_among(const YkRange *ranges, size_t count, double from, double to, double tolerance)
{
    for (size_t k = 0; k < count; k++) {
        double length = ranges[k].to - ranges[k].from;
        if (fabs(length - (to - from)) <= 2 * tolerance && fabs(angle_between(ranges[k].from, from)) <= tolerance)
            return true;
    }
    return false;
}

static void check_ranges(FourBar f, double theta, int branch)
{
    double low, high;
    closing_angles(f, &low, &high);
    YkRange due[2] = {{low, high}, {-high, -low}}, found[CAPACITY];
    size_t due_count = 2;
    if (low == 0) due[0].from = -high;
    if (high == YK_PI) due[0].to = 2 * YK_PI - low;
    if (low == 0 || high == YK_PI) due_count = 1;
    Machine m = four_bar_machine(f, theta, branch);
    size_t count = yk_closing_ranges(m.state, 0, found, CAPACITY);
    if (count != due_count)
        print_error("%.17g %.17g %.17g %.17g at %.17g: %zu ranges\n", f.a, f.b, f.c, f.d, theta, count);
    assert_int_equal(count, due_count);
    if (low == 0 && high == YK_PI)
        CHECK_NEAR(found[0].to - found[0].from, 2 * YK_PI, 1e-15);
    else
        for (size_t k = 0; k < due_count; k++) {
            if (!is_among(found, count, due[k].from, due[k].to, 1e-10))
                print_error("%.17g %.17g %.17g %.17g at %.17g: no [%.17g, %.17g]; [%.17g, %.17g]\n", f.a, f.b, f.c, f.d,
                            theta, due[k].from, due[k].to, found[0].from, found[0].to);
            assert_true(is_among(found, count, due[k].from, due[k].to, 1e-10));
        }
    CHECK_NEAR(yk_state_coordinate(m.state, 0).position, theta, 0); // the state is as it was
    machine_free(&m);
}

static void test_ranges_of_random_four_bars(void **unused)
{
    (void)unused;
    uint64_t seed = 4711;
    for (uint64_t k = 0; k < check_cases(400);) {
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1),
                     check_uniform(&seed, 0.1, 1)};
        double low, high;
        closing_angles(f, &low, &high);
        if (high - low < 0.02) continue;
        if ((low > 0 && low < 1e-3) || (high < YK_PI && high > YK_PI - 1e-3)) continue; // see the narrow gaps
        k++;
        check_ranges(f, 0.5 * (low + high), check_random(&seed) & 1 ? 1 : -1);
    }
}

static void test_a_narrow_gap_is_found(void **unused)
{
    (void)unused;
    for (double gap = 0.1; gap > 1e-9; gap *= 0.3) {
        check_ranges((FourBar){0.6, 0.9 + gap, 0.5, 1}, 1, 1);
        check_ranges((FourBar){0.6, 0.9 + gap, 0.5, 1}, -1.3, -1);
        check_ranges((FourBar){0.6, 1, 0.6 - gap, 1}, 1, 1); // about pi
    }
}

// Closes within +-width of 0 only, far from the state: between two samples when narrow.
static void test_a_narrow_range_is_found(void **unused)
{
    (void)unused;
    for (double width = 0.1; width > 1e-4; width *= 0.5) {
        // B of a rocker r on (0, 0) ... the crank pin (cos, sin) must come within `reach` of (1 - offset, 0) on both
        // sides
        FourBar f = {1, 0.5 * width, 0.5 * width, 1}; // |A O4| = 2 sin(theta/2) <= width
        double low, high;
        closing_angles(f, &low, &high);
        YkRange found[CAPACITY];
        Machine m = four_bar_machine(f, 0.5 * high, 1);
        size_t count = yk_closing_ranges(m.state, 0, found, CAPACITY);
        assert_int_equal(count, 1);
        CHECK_NEAR(found[0].from, -high, 1e-10);
        CHECK_NEAR(found[0].to, high, 1e-10);
        machine_free(&m);
    }
}

// Two ranges about as wide as the way from sample to sample, mirror images: one has the state in it, and the other a
// sample or two.
static void test_ranges_as_narrow_as_a_step_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 77;
    const double step = 2 * YK_PI / 1440;
    for (int k = 0; k < 20; k++) {
        double a = check_uniform(&seed, 0.3, 1), d = check_uniform(&seed, 0.3, 1), at = check_uniform(&seed, 0.5, 2.5);
        double width = step * check_uniform(&seed, 1.01, 2.5), way[2]; // of the crank's pin from the rocker's pivot
        for (int e = 0; e < 2; e++) way[e] = sqrt(a * a + d * d - 2 * a * d * cos(at + (e - 0.5) * width));
        check_ranges((FourBar){a, 0.5 * (way[0] + way[1]), 0.5 * (way[1] - way[0]), d}, k % 4 < 2 ? at : -at,
                     k % 2 ? 1 : -1);
    }
}

static void test_the_quick_return_has_its_two_published_ranges(void **unused)
{
    (void)unused;
    Machine m = machine_load("quick-return");
    YkRange found[CAPACITY];
    size_t count = yk_closing_ranges(m.state, yk_coordinate_find(m.mech, "theta1"), found, CAPACITY);
    assert_int_equal(count, 2);
    double degree = YK_PI / 180;
    assert_true(is_among(found, count, -10.09 * degree, 190.09 * degree, 0.006 * degree));
    assert_true(is_among(found, count, -109.35 * degree, -70.65 * degree, 0.006 * degree));
    machine_free(&m);
}

static void test_a_cylinder_closes_between_its_triangles_limits(void **unused)
{
    (void)unused;
    Machine m = machine_load("excavator");
    YkRange found[CAPACITY];
    double a = hypot(0.5, 0.4), b = hypot(1.5, 0.3);
    size_t count = yk_closing_ranges(m.state, yk_coordinate_find(m.mech, "s1"), found, CAPACITY);
    bool there = false; // and, seen from the other side, the same with a negative length
    for (size_t k = 0; k < count; k++)
        there |= fabs(found[k].from - (b - a)) <= 1e-10 && fabs(found[k].to - (b + a)) <= 1e-10;
    assert_true(there);
    assert_true(count == 1 || count == 2);
    machine_free(&m);
}

static void test_a_full_turn_is_one_range(void **unused)
{
    (void)unused;
    static const char *const files[] = {"four-bar",
                                        "slider-crank",
                                        "jansen",
                                        "parallelogram",
                                        "scotch-yoke",
                                        "double-pendulum",
                                        "three-crank-parallelogram"};
    for (size_t k = 0; k < sizeof files / sizeof files[0]; k++) {
        Machine m = machine_load(files[k]);
        YkRange found[CAPACITY];
        assert_int_equal(yk_closing_ranges(m.state, yk_input_coordinate(m.mech, 0), found, CAPACITY), 1);
        CHECK_NEAR(found[0].to - found[0].from, 2 * YK_PI, 1e-15);
        CHECK_NEAR(found[0].from, yk_state_input(m.state, 0).position - YK_PI, 1e-15);
        machine_free(&m);
    }
}

static void test_more_ranges_than_room_are_counted(void **unused)
{
    (void)unused;
    Machine m = machine_load("quick-return");
    size_t theta1 = yk_coordinate_find(m.mech, "theta1");
    YkRange found[2] = {{0, 0}, {77, 77}};
    assert_int_equal(yk_closing_ranges(m.state, theta1, found, 1), 2);
    assert_true(found[1].from == 77 && found[1].to == 77);
    assert_int_equal(yk_closing_ranges(m.state, theta1, NULL, 0), 2);
    assert_int_equal(yk_closing_ranges(m.state, yk_coordinate_find(m.mech, "theta2"), found, 2), 0); // no input
    machine_free(&m);
}

// Beside the five-bar stands a crank-rocker, so that the machine has two dyads.
static const char five_bar_with_rocker[] =
    "units: {length: mm}\n"
    "bodies:\n"
    "  ground: {points: {L: [-60, 0], R: [60, 0], Q: [-310, 0]}}\n"
    "  left:   {points: {L: [0, 0], A: [200, 0], E: [200, 0]}}\n"
    "  right:  {points: {R: [0, 0], B: [200, 0]}}\n"
    "  reachL: {points: {A: [0, 0], P: [150, 0]}}\n"
    "  reachR: {points: {B: [0, 0], P: [150, 0]}}\n"
    "  rod:    {points: {E: [0, 0], D: [300, 0]}}\n"
    "  rocker: {points: {Q: [0, 0], D: [300, 0]}}\n"
    "joints:\n"
    "  L: {pin: [ground, left], angle: theta1}\n"
    "  R: {pin: [ground, right], angle: theta2}\n"
    "  Q: {pin: [ground, rocker], angle: phi3}\n"
    "  A: {pin: [left, reachL], angle: phi1}\n"
    "  E: {pin: [left, rod]}\n"
    "  B: {pin: [right, reachR], angle: phi2}\n"
    "  P: {pin: [reachL, reachR]}\n"
    "  D: {pin: [rod, rocker]}\n"
    "start: {theta1: 120 deg, theta2: 100 deg, phi1: -70 deg, phi2: 70 deg, phi3: 60 deg}\n";

// The inputs asked for do not fit the present pose: the ranges are those of the inputs asked for.
static void test_the_range_of_a_pose_that_does_not_fit_the_inputs_is_not_made_up(void **unused)
{
    (void)unused;
    Machine m = machine_parse(five_bar_with_rocker, true);
    size_t theta1 = yk_coordinate_find(m.mech, "theta1"), theta2 = yk_coordinate_find(m.mech, "theta2");
    assert_int_equal(yk_block_count(m.mech), 2);
    double right = YK_PI / 6;
    yk_state_set_input(m.state, (size_t)yk_coordinate_info(m.mech, theta2).input, (YkMotion){right, 0, 0});
    assert_int_equal(yk_state_solve(m.state), YK_LIMIT);
    YkRange found[CAPACITY];
    assert_int_equal(yk_closing_ranges(m.state, theta1, found, CAPACITY), 1);
    double x = 0.12 + 0.2 * cos(right), y = 0.2 * sin(right), r = hypot(x, y); // B seen from L
    double half = acos((0.2 * 0.2 + r * r - 0.3 * 0.3) / (2 * 0.2 * r));
    assert_true(is_among(found, 1, atan2(y, x) - half, atan2(y, x) + half, 1e-10));
    machine_free(&m);
}

// A group's configuration is what can be reached: its ends are where a sweep stops.
static void test_the_range_of_a_group_ends_where_sweeps_stop(void **unused)
{
    (void)unused;
    static const char *const files[] = {"stephenson-awkward", "double-butterfly"};
    for (size_t k = 0; k < 2; k++) {
        Machine m = machine_load(files[k]);
        size_t input = yk_input_coordinate(m.mech, 0);
        const char *name = yk_coordinate_info(m.mech, input).name;
        double at = yk_state_input(m.state, 0).position;
        YkRange found[2];
        assert_int_equal(yk_closing_ranges(m.state, input, found, 2), 1);
        for (int way = -1; way <= 1; way += 2) {
            Machine n = machine_load(files[k]);
            YkSweep *sweep = machine_sweep(&n, name, at, at + way * 3, 50, NULL, 0);
            double end = way < 0 ? found[0].from : found[0].to;
            if (yk_sweep_status(sweep) == YK_LIMIT)
                CHECK_NEAR(yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1).at, end, 1e-8);
            else
                assert_true(fabs(end - at) >= 3);
            yk_sweep_free(sweep);
            machine_free(&n);
        }
        machine_free(&m);
    }
}

// The map encloses the limits of all branches by other means.
static void check_group_range(const char *file)
{
    Machine m = machine_load(file);
    size_t coordinate = yk_input_coordinate(m.mech, 0), found[2] = {0, 0};
    YkMap *map = yk_map_new(m.state, coordinate, m.problems);
    YkRange ranges[8];
    double here = yk_state_coordinate(m.state, coordinate).position;
    size_t count = yk_closing_ranges(m.state, coordinate, ranges, 8);
    assert_true(map && yk_map_is_complete(map) && count >= 1 && count <= 8);
    for (size_t r = 0; r < count; r++) {
        if (!(ranges[r].from <= here && here <= ranges[r].to)) continue;
        for (size_t e = 0; e < yk_map_circuit(map, 0).events; e++) {
            double at = yk_map_event(map, 0, e).at;
            found[0] += fabs(at - ranges[r].from) < 1e-9;
            found[1] += fabs(at - ranges[r].to) < 1e-9;
        }
    }
    assert_true(found[0] == 1 && found[1] == 1);
    yk_map_free(map);
    machine_free(&m);
}

static void test_ranges_of_groups_end_at_limits_of_the_map(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    check_group_range("stephenson-awkward");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ranges_of_groups_end_at_limits_of_the_map),
        cmocka_unit_test(test_ranges_of_random_four_bars),
        cmocka_unit_test(test_a_narrow_gap_is_found),
        cmocka_unit_test(test_a_narrow_range_is_found),
        cmocka_unit_test(test_ranges_as_narrow_as_a_step_are_found),
        cmocka_unit_test(test_the_quick_return_has_its_two_published_ranges),
        cmocka_unit_test(test_a_cylinder_closes_between_its_triangles_limits),
        cmocka_unit_test(test_a_full_turn_is_one_range),
        cmocka_unit_test(test_more_ranges_than_room_are_counted),
        cmocka_unit_test(test_the_range_of_a_pose_that_does_not_fit_the_inputs_is_not_made_up),
        cmocka_unit_test(test_the_range_of_a_group_ends_where_sweeps_stop),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
