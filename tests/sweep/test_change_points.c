// Change points: the motion continues in its kind, the event is reported, and nothing is ever NaN - whether or not rows
// fall on the change point.
#include "solve/four_bar.h"

static const char *const four_bar_names[] = {"coupler.angle",    "theta4",           "coupler.angle.rate",
                                             "theta4.rate",      "theta4.accel",     "coupler.B.speed",
                                             "coupler.B.x.rate", "coupler.B.y.rate", "theta2"};
static const size_t step_counts[] = {1, 2, 3, 4, 5, 7, 8, 11, 12, 24, 36, 72, 100, 360, 720, 1001};
enum { COUNTS = sizeof step_counts / sizeof step_counts[0], NAMES = 9 };

static void check_no_nan(const YkSweep *sweep)
{
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++)
        for (size_t c = 0; c < NAMES; c++) assert_true(isfinite(yk_sweep_value(sweep, row, c)));
}

// At an event every angle is the motion's, and the rocker, which never turns round, has no extreme.
static void check_events(const YkSweep *sweep, void (*motion)(double, double *, double *, double *),
                         const double *turns)
{
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent e = yk_sweep_event(sweep, k);
        double coupler, rocker, rocker_rate;
        motion(e.at, &coupler, &rocker, &rocker_rate);
        CHECK_NEAR(yk_sweep_event_value(sweep, k, 0), coupler + turns[0], 1e-6);
        CHECK_NEAR(yk_sweep_event_value(sweep, k, 1), rocker + turns[1], 1e-6);
        assert_false(e.kind == YK_EVENT_EXTREME && e.channel == 1);
    }
}

// What a motion must be: coupler and rocker at a crank angle (continuous), and the rocker's rate per crank rate.
typedef void (*Motion)(double theta, double *coupler, double *rocker, double *rocker_rate);

static void parallel(double theta, double *coupler, double *rocker, double *rocker_rate)
{
    *coupler = 0;
    *rocker = theta;
    *rocker_rate = 1;
}

// Crank 2, coupler 4, rocker 2 on 4: the antiparallelogram; the rocker's half angle by tan(theta/2) tan(theta4/2) =
// const.
static void antiparallel(double theta, double *coupler, double *rocker, double *rocker_rate)
{
    double k = -(4.0 + 2.0) / (4.0 - 2.0); // tan(theta4/2) = -(b + a)/(b - a) tan(theta/2): theta4 turns the other way
    double turns = rint(theta / (2 * YK_PI)), half = 0.5 * (theta - 2 * YK_PI * turns);
    *rocker = 2 * atan2(k * sin(half), cos(half)) - 2 * YK_PI * turns;
    double bx = 4 + 2 * cos(*rocker) - 2 * cos(theta), by = 2 * sin(*rocker) - 2 * sin(theta);
    *coupler = atan2(by, bx);
    double c = cos(half), s = k * sin(half);
    *rocker_rate = k / (c * c + s * s);
}

// The kite whose rocker rests: B stays on O2, the coupler lies on the crank.
static void resting(double theta, double *coupler, double *rocker, double *rocker_rate)
{
    *coupler = theta + YK_PI;
    *rocker = YK_PI;
    *rocker_rate = 0;
}

static void check_motion(FourBar f, Motion motion, double start, double to, size_t steps, double rate)
{
    double coupler, rocker, rocker_rate;
    motion(start, &coupler, &rocker, &rocker_rate);
    FourBarPose plus = four_bar_pose(f, start, 1);
    int branch = fabs(angle_between(plus.rocker, rocker)) < 1e-9 ? 1 : -1;
    Machine m = four_bar_machine(f, start, branch);
    yk_state_set_input(m.state, 0, (YkMotion){start, rate, 0});
    YkSweep *sweep = machine_sweep(&m, "theta2", start, to, steps, four_bar_names, NAMES);
    if (yk_sweep_status(sweep) < 0)
        print_error("from %.17g to %.17g in %zu steps: stopped after %zu\n", start, to, steps,
                    yk_sweep_row_count(sweep));
    assert_true(yk_sweep_status(sweep) >= 0);
    assert_int_equal(yk_sweep_row_count(sweep), steps + 1);
    check_no_nan(sweep);
    double turns[2] = {yk_sweep_value(sweep, 0, 0) - coupler, yk_sweep_value(sweep, 0, 1) - rocker}; // whole ones
    CHECK_NEAR(angle_between(turns[0], 0), 0, 1e-9);
    CHECK_NEAR(angle_between(turns[1], 0), 0, 1e-9);
    for (size_t row = 0; row <= steps; row++) {
        motion(yk_sweep_at(sweep, row), &coupler, &rocker, &rocker_rate);
        double off = fmax(fabs(yk_sweep_value(sweep, row, 0) - coupler - turns[0]),
                          fabs(yk_sweep_value(sweep, row, 1) - rocker - turns[1]));
        if (!(off <= 1e-7))
            print_error("%zu steps, row %zu at %.17g: coupler %g for %g, rocker %g for %g\n", steps, row,
                        yk_sweep_at(sweep, row), yk_sweep_value(sweep, row, 0), coupler, yk_sweep_value(sweep, row, 1),
                        rocker);
        CHECK_NEAR(off, 0, 1e-7);
        if (yk_sweep_row_status(sweep, row) != YK_SINGULAR)
            CHECK_NEAR(yk_sweep_value(sweep, row, 3), rocker_rate * rate, 1e-6);
        CHECK_NEAR(yk_sweep_value(sweep, row, 8), yk_sweep_at(sweep, row), 0);
        double speed = hypot(yk_sweep_value(sweep, row, 6), yk_sweep_value(sweep, row, 7));
        CHECK_NEAR(yk_sweep_value(sweep, row, 5), speed, 1e-9);
    }
    check_events(sweep, motion, turns);
    // every multiple of pi strictly inside the sweep is told
    double low = fmin(start, to), high = fmax(start, to);
    for (double at = YK_PI * ceil(low / YK_PI + 1e-9); at < high - 1e-9; at += YK_PI) {
        bool told = false;
        for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
            YkEvent e = yk_sweep_event(sweep, k);
            told |= e.kind == YK_EVENT_CHANGE_POINT && e.block == 0 && fabs(e.at - at) <= 1e-8;
        }
        if (!told) print_error("%zu steps from %g to %g: nothing told of %g\n", steps, start, to, at);
        assert_true(told);
    }
    yk_sweep_free(sweep);
    machine_free(&m);
}

static const FourBar parallelogram = {2, 4, 2, 4}, kite = {1, 1, 2, 2}, rhombus = {1, 1, 1, 1};

static void check_in_all_steps(FourBar f, Motion motion)
{
    static const double starts[] = {1, 0.5 * YK_PI, -2.5, 0.01};
    for (size_t s = 0; s < sizeof starts / sizeof starts[0]; s++)
        for (size_t k = 0; k < COUNTS; k++)
            for (int way = -1; way <= 1; way += 2) {
                check_motion(f, motion, starts[s], starts[s] + way * 2 * YK_PI, step_counts[k], 1);
                check_motion(f, motion, starts[s], way * 4 * YK_PI, step_counts[k], -2); // ends on a change point
            }
}

static void test_a_parallelogram_stays_parallel(void **unused)
{
    (void)unused;
    check_in_all_steps(parallelogram, parallel);
}

static void test_an_antiparallelogram_stays_antiparallel(void **unused)
{
    (void)unused;
    check_in_all_steps(parallelogram, antiparallel);
}

static void test_the_rocker_of_a_folded_kite_rests(void **unused)
{
    (void)unused;
    check_in_all_steps(kite, resting);
}

// A rhombus passes 0 with its dyad's base vanishing: any angle would close there.
static void test_a_rhombus_stays_a_rhombus(void **unused)
{
    (void)unused;
    check_in_all_steps(rhombus, parallel);
}

// Two parallelograms side by side: all bars come to lie in one line, and both dyads have their change points at once.
static void test_parallelograms_side_by_side_stay_parallel(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta1", "theta2"};
    for (size_t k = 0; k < COUNTS; k++)
        for (int way = -1; way <= 1; way += 2) {
            Machine m = machine_load("n-four-bar");
            double from = 0.5 * YK_PI;
            YkSweep *sweep = machine_sweep(&m, "theta0", from, from + way * 6 * YK_PI, step_counts[k], of, 2);
            assert_int_equal(yk_sweep_row_count(sweep), step_counts[k] + 1);
            for (size_t row = 0; row < yk_sweep_row_count(sweep); row++)
                for (size_t c = 0; c < 2; c++)
                    CHECK_NEAR(yk_sweep_value(sweep, row, c), yk_sweep_at(sweep, row),
                               yk_sweep_row_status(sweep, row) == YK_OK
                                   ? 1e-7
                                   : 1e-4); // the direction of a base that vanishes
            yk_sweep_free(sweep);
            machine_free(&m);
        }
}

// A slotted lever whose pivot lies on the crank pin's circle: beta = 90 deg + theta/2, s = 2 sin(theta/2) through 0,
// where the pin stands in the pivot and the lever's line is any.
static void test_a_slotted_lever_passes_its_own_pivot(void **unused)
{
    (void)unused;
    static const char model[] = "bodies:\n"
                                "  ground: {points: {O: [0, 0], Q: [1, 0]}}\n"
                                "  crank: {points: {O: [0, 0], A: [1, 0]}}\n"
                                "  lever: {points: {Q: [0, 0]}}\n"
                                "  block: {points: {A: [0, 0]}}\n"
                                "joints:\n"
                                "  O: {pin: [ground, crank], angle: theta}\n"
                                "  Q: {pin: [ground, lever], angle: beta}\n"
                                "  S: {slide: [lever, block], along: x, distance: s}\n"
                                "  A: {pin: [crank, block]}\n"
                                "start: {theta: 1, beta: 2, s: 1}\n";
    static const char *const of[] = {"beta", "s", "beta.rate", "s.rate"};
    for (size_t k = 0; k < COUNTS; k++)
        for (int way = -1; way <= 1; way += 2) {
            Machine m = machine_parse(model, true);
            yk_state_set_input(m.state, 0, (YkMotion){1, 2, 0});
            double to = way < 0 ? -2 : 8;
            YkSweep *sweep = machine_sweep(&m, "theta", 1, to, step_counts[k], of, 4);
            assert_int_equal(yk_sweep_row_count(sweep), step_counts[k] + 1);
            for (size_t row = 0; row <= step_counts[k]; row++) {
                double theta = yk_sweep_at(sweep, row);
                CHECK_NEAR(yk_sweep_value(sweep, row, 0), 0.5 * YK_PI + 0.5 * theta, 1e-7);
                CHECK_NEAR(yk_sweep_value(sweep, row, 1), 2 * sin(0.5 * theta), 1e-7);
                CHECK_NEAR(yk_sweep_value(sweep, row, 2), 1, 1e-6);
                CHECK_NEAR(yk_sweep_value(sweep, row, 3), 2 * cos(0.5 * theta), 1e-6);
            }
            assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), 1);
            for (size_t e = 0; e < yk_sweep_event_count(sweep); e++) {
                YkEvent event = yk_sweep_event(sweep, e);
                CHECK_NEAR(yk_sweep_event_value(sweep, e, 0), 0.5 * YK_PI + 0.5 * event.at, 1e-7);
                CHECK_NEAR(yk_sweep_event_value(sweep, e, 1), 2 * sin(0.5 * event.at), 1e-7);
                if (event.kind == YK_EVENT_EXTREME) CHECK_NEAR(fabs(cos(0.5 * event.at)), 0, 1e-6); // of s alone
            }
            yk_sweep_free(sweep);
            machine_free(&m);
        }
}

// A sweep that ends just before the change point, one that creeps over it, and one that goes on. Within 1e-7 rad of it
// a pose is singular and belongs to both kinds: there the only promise is that it is told.
static void creep_over(double width, size_t steps, bool promised)
{
    Machine m = machine_load("parallelogram");
    double before = YK_PI - width, after = YK_PI + width;
    YkSweep *near = machine_sweep(&m, "theta2", 1, before, 3, four_bar_names, NAMES);
    YkSweep *creep = machine_sweep(&m, "theta2", before, after, steps, four_bar_names, NAMES);
    YkSweep *far = machine_sweep(&m, "theta2", after, 6, 5, four_bar_names, NAMES);
    assert_int_equal(yk_sweep_row_count(far), 6);
    check_no_nan(near);
    check_no_nan(creep);
    check_no_nan(far);
    double off = fabs(angle_between(yk_sweep_value(far, 5, 0), 0));
    if (promised && off > 1e-7) print_error("crept over %g in %zu steps\n", width, steps);
    if (promised) CHECK_NEAR(off, 0, 1e-7);
    assert_true(yk_sweep_event_count(creep) + yk_sweep_event_count(near) > 0);
    yk_sweep_free(near);
    yk_sweep_free(creep);
    yk_sweep_free(far);
    machine_free(&m);
}

static void test_a_creep_through_a_change_point_keeps_the_kind(void **unused)
{
    (void)unused;
    static const double widths[] = {1e-1, 1e-3, 1e-4, 3e-5, 1e-5, 1e-6, 3e-7};
    for (size_t steps = 1; steps < 60; steps += 7)
        for (size_t k = 0; k < sizeof widths / sizeof widths[0]; k++) creep_over(widths[k], steps, true);
}

static void test_a_creep_within_rounding_of_a_change_point_is_told(void **unused)
{
    (void)unused;
    static const double widths[] = {9e-8, 1e-8, 1e-10, 1e-13};
    for (size_t steps = 1; steps < 60; steps += 7)
        for (size_t k = 0; k < sizeof widths / sizeof widths[0]; k++) creep_over(widths[k], steps, false);
}

// Of three cranks in line the third repeats what two say. The false branch closes up to rounding for 1e-5 rad beyond
// the change point, which is told where it is all the same.
static void test_three_cranks_in_line_tell_where_they_pass(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O1: [0, 0], O2: [1.5, 0], O3: [4, 0]}}\n"
                              "  crank1: {points: {O1: [0, 0], A1: [0.5, 0]}}\n"
                              "  crank2: {points: {O2: [0, 0], A2: [0.5, 0]}}\n"
                              "  crank3: {points: {O3: [0, 0], A3: [0.5, 0]}}\n"
                              "  rod:    {points: {A1: [0, 0], A2: [1.5, 0], A3: [4, 0]}}\n"
                              "joints:\n"
                              "  O1: {pin: [ground, crank1], angle: theta1}\n"
                              "  A1: {pin: [crank1, rod], angle: phi}\n"
                              "  O2: {pin: [ground, crank2], angle: theta2}\n"
                              "  O3: {pin: [ground, crank3], angle: theta3}\n"
                              "  A2: {pin: [rod, crank2]}\n"
                              "  A3: {pin: [rod, crank3]}\n"
                              "drives: {theta1: 50 deg}\n"
                              "start: {phi: -50 deg, theta2: 50 deg, theta3: 50 deg}\n",
                              true);
    static const char *const of[] = {"theta1", "theta2", "theta3"};
    for (size_t steps = 1; steps < 40; steps += 3) {
        YkSweep *sweep = machine_sweep(&m, "theta1", 0.2, steps % 2 ? 22.1 : -9.3, steps, of, 3);
        assert_int_equal(yk_sweep_status(sweep), YK_OK);
        for (size_t row = 0; row <= steps; row++)
            for (size_t c = 1; c < 3; c++)
                CHECK_NEAR(yk_sweep_value(sweep, row, c), yk_sweep_value(sweep, row, 0), 1e-7);
        assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), steps % 2 ? 7 : 3);
        for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
            YkEvent e = yk_sweep_event(sweep, k);
            if (e.kind == YK_EVENT_CHANGE_POINT) CHECK_NEAR(e.at, YK_PI * rint(e.at / YK_PI), 1e-11);
        }
        yk_sweep_free(sweep);
    }
    machine_free(&m);
}

// Wheels with a side rod that start at 0, where all cranks are in line with it: branches meet there already at the
// start.
static void test_wheels_with_a_side_rod_start_in_line(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0], P: [4, 0]}}\n"
                              "  a: {points: {O: [0, 0], A: [0.5, 0]}}\n  c: {points: {Q: [0, 0], B: [0.5, 0]}}\n"
                              "  d: {points: {P: [0, 0], D: [0.5, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [2, 0], D: [4, 0]}}\njoints:\n"
                              "  O: {pin: [ground, a], angle: th}\n  Q: {pin: [ground, c], angle: ps}\n"
                              "  P: {pin: [ground, d], angle: ph}\n  A: {pin: [a, rod]}\n  B: {pin: [c, rod]}\n"
                              "  D: {pin: [d, rod]}\ndrives: {th: 1 rad/s * t}\nstart: {ps: 0, ph: 0}\n",
                              true);
    static const char *const of[] = {"th", "ps", "ph", "ps.rate"};
    YkSweep *sweep = machine_sweep(&m, "th", 0, 4 * YK_PI, 90, of, 4);
    assert_int_equal(yk_sweep_status(sweep), YK_OK);
    for (size_t row = 0; row <= 90; row++)
        for (size_t c = 1; c < 4; c++)
            CHECK_NEAR(yk_sweep_value(sweep, row, c), c == 3 ? 1 : yk_sweep_value(sweep, row, 0), 1e-7);
    yk_sweep_free(sweep);
    machine_free(&m);
}

// Pins bear what they like where all links are in line, but the effort is that of a body that moves in a circle: the
// links turn alike, and the coupler goes with them.
static void test_the_effort_of_a_parallelogram_in_line_is_that_of_one_crank(void **unused)
{
    (void)unused;
    Machine m = machine_parse("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [2, 0]}, mass: 3, center: [0.5, 0], inertia: 1}\n"
                              "  coupler: {points: {A: [0, 0], B: [4, 0]}, mass: 2, center: [1, 0.3]}\n"
                              "  rocker: {points: {Q: [0, 0], B: [2, 0]}, mass: 1, center: [1, 0.2]}\njoints:\n"
                              "  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, coupler], angle: u}\n"
                              "  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, rocker]}\n"
                              "drives: {th: 1}\nstart: {u: -1, v: 1}\n",
                              true);
    static const char *const of[] = {"th.effort", "v.rate"};
    YkChannel channels[] = {machine_channel(&m, of[0]), machine_channel(&m, of[1])};
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = (int)yk_coordinate_find(m.mech, "th");
    options.from = -YK_PI / 2, options.to = 1.5 * YK_PI, options.steps = 8; // the third and the seventh row are in line
    options.dynamics = dynamics;
    const double rate = 1.5, accel = -2, inertia = 1 + 3 * 0.25 + 2 * 4 + 1 * 1.04;
    yk_state_set_input(m.state, 0, (YkMotion){1, rate, accel});
    YkSweep *sweep = yk_sweep_run(m.state, &options, channels, 2, m.problems);
    assert_true(sweep && yk_sweep_status(sweep) == YK_OK);
    for (size_t row = 2; row <= 6; row += 4) assert_int_equal(yk_sweep_row_status(sweep, row), YK_CHANGE_POINT);
    for (size_t row = 0; row <= 8; row++) {
        double th = yk_sweep_at(sweep, row), weight = 10 * ((1.5 + 4 + 1) * cos(th) - 0.2 * sin(th));
        CHECK_NEAR(yk_sweep_value(sweep, row, 0), inertia * accel + weight, 1e-6);
        CHECK_NEAR(yk_sweep_value(sweep, row, 1), rate, 1e-8);
    }
    yk_sweep_free(sweep);
    yk_dynamics_free(dynamics);
    machine_free(&m);
}

// A piston on the crank of a parallelogram comes to rest just where all links are in line: limits are found there all
// the same, whatever the size of the machine.
static void test_a_slide_may_rest_at_a_change_point(void **unused)
{
    (void)unused;
    static const char *const of[] = {"th", "v", "x", "v.rate", "x.rate", "x.accel"};
    const double tilt = 0.3, rate = 1.5, accel = -2;
    for (double k = 1e-9; k < 1e10; k *= 1e3) {
        char text[1600];
        snprintf(
            text, sizeof text,
            "parameters: {k: %.17g, f: %.17g}\nbodies:\n  ground: {points: {O: [0, 0], Q: [4*k*cos(f), 4*k*sin(f)]}}\n"
            "  crank: {points: {O: [0, 0], A: [2*k, 0]}}\n  coupler: {points: {A: [0, 0], B: [4*k, 0]}}\n"
            "  rocker: {points: {Q: [0, 0], B: [2*k, 0]}}\n  rod: {points: {A: [0, 0], P: [5*k, 0]}}\n"
            "  piston: {points: {P: [0, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
            "  A: {pin: [crank, coupler], angle: u}\n  Q: {pin: [ground, rocker], angle: v}\n"
            "  B: {pin: [coupler, rocker]}\n  R: {slide: [ground, piston], along: f, from: O, to: P, distance: x}\n"
            "  C: {pin: [crank, rod], at: A, angle: w}\n  P: {pin: [rod, piston]}\ndrives: {th: 1 + f}\n"
            "start: {u: -1, v: 1 + f, x: 6*k, w: -1}\n",
            k, tilt);
        Machine m = machine_parse(text, true);
        yk_state_set_input(m.state, 0, (YkMotion){tilt + 1, rate, accel});
        YkSweep *sweep = machine_sweep(&m, "th", tilt + 1, tilt - 1, 10, of, 6); // the sixth row is in line
        assert_int_equal(yk_sweep_status(sweep), YK_OK);
        assert_int_equal(yk_sweep_row_status(sweep, 5), YK_CHANGE_POINT);
        for (size_t row = 0; row <= 10; row++) {
            double th = yk_sweep_at(sweep, row), c = 2 * k * cos(th - tilt), s = 2 * k * sin(th - tilt);
            double r = sqrt(25 * k * k - s * s), bend = -c - (c * c - s * s) / r - s * s * c * c / (r * r * r);
            CHECK_NEAR(yk_sweep_value(sweep, row, 1), th, 1e-7);
            CHECK_NEAR(yk_sweep_value(sweep, row, 2), c + r, 1e-11 * k);
            CHECK_NEAR(yk_sweep_value(sweep, row, 3), rate, 1e-7);
            CHECK_NEAR(yk_sweep_value(sweep, row, 4), -s * (1 + c / r) * rate, 1e-7 * k);
            CHECK_NEAR(yk_sweep_value(sweep, row, 5), bend * rate * rate - s * (1 + c / r) * accel, 1e-6 * k);
        }
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_parallelogram_stays_parallel),
        cmocka_unit_test(test_the_effort_of_a_parallelogram_in_line_is_that_of_one_crank),
        cmocka_unit_test(test_an_antiparallelogram_stays_antiparallel),
        cmocka_unit_test(test_the_rocker_of_a_folded_kite_rests),
        cmocka_unit_test(test_a_rhombus_stays_a_rhombus),
        cmocka_unit_test(test_parallelograms_side_by_side_stay_parallel),
        cmocka_unit_test(test_a_slotted_lever_passes_its_own_pivot),
        cmocka_unit_test(test_a_creep_through_a_change_point_keeps_the_kind),
        cmocka_unit_test(test_three_cranks_in_line_tell_where_they_pass),
        cmocka_unit_test(test_wheels_with_a_side_rod_start_in_line),
        cmocka_unit_test(test_a_creep_within_rounding_of_a_change_point_is_told),
        cmocka_unit_test(test_a_slide_may_rest_at_a_change_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
