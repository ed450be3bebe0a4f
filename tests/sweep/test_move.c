// Moving to a pose: on the branch and circuit in which the machine was assembled, against closed forms; limits at their
// places; turns counted; detours; and no jump on any example.
#include <dirent.h>
#include "solve/four_bar.h"

static YkStatus move_one(YkState *state, size_t input, double to, YkMove *move)
{
    YkMotion goal[8];
    size_t count = yk_input_count(yk_state_mechanism(state));
    assert_true(count <= 8);
    for (size_t i = 0; i < count; i++) goal[i] = yk_state_input(state, i);
    goal[input].position = to;
    return yk_state_move_to(state, goal, NULL, move);
}

// --- random four-bars, against where two circles meet
// ----------------------------------------------------------------------------------------------------------------

// The crank angles at which the loop closes: |theta| between low and high.
static void closing_angles(FourBar f, double *low, double *high)
{
    double inner = fabs(f.b - f.c), outer = f.b + f.c;
    *low = acos(fmax(-1, fmin(1, (f.a * f.a + f.d * f.d - inner * inner) / (2 * f.a * f.d))));
    *high = acos(fmax(-1, fmin(1, (f.a * f.a + f.d * f.d - outer * outer) / (2 * f.a * f.d))));
}

// The limit that a move from theta (closing, |theta| in [low, high]) meets on its way to `to`; NAN: none.
static double limit_between(double low, double high, double theta, double to)
{
    double least = NAN, way = to > theta ? 1 : -1;
    for (int turn = -4; turn <= 4; turn++) {
        const double ends[] = {low, high, -low, -high};
        for (size_t k = 0; k < 4; k++) {
            bool is_none = k % 2 == 0 ? low == 0 : high == YK_PI;
            double at = ends[k] + 2 * YK_PI * turn, off = way * (at - theta);
            if (!is_none && off > 0 && off < way * (to - theta) && !(off >= way * (least - theta))) least = at;
        }
    }
    return least;
}

static void check_four_bar(FourBar f, double theta, double to, int branch, size_t *limits)
{
    double low, high;
    closing_angles(f, &low, &high);
    double limit = limit_between(low, high, theta, to);
    if (fabs(limit - to) < 1e-6) return; // which side of it cannot be told by these closed forms
    Machine m = four_bar_machine(f, theta, branch);
    YkMove move;
    YkStatus status = move_one(m.state, 0, to, &move);
    bool arrives = isnan(limit);
    if ((status >= 0) != arrives)
        print_error("%.17g %.17g %.17g %.17g from %.17g to %.17g: %s, limit %.17g\n", f.a, f.b, f.c, f.d, theta, to,
                    yk_status_name(status), limit);
    assert_true((status >= 0) == arrives);
    double here = yk_state_coordinate(m.state, 0).position;
    if (arrives) {
        FourBarPose pose = four_bar_pose(f, to, branch);
        assert_true(here == to); // exactly, turns and all
        CHECK_NEAR(angle_between(machine_ask(&m, "theta4"), pose.rocker), 0, 1e-9);
        CHECK_NEAR(angle_between(machine_ask(&m, "coupler.angle"), pose.coupler), 0, 1e-9);
        CHECK_NEAR(move.part, 1, 0);
    } else {
        CHECK_NEAR(here, limit, 1e-8);
        assert_int_equal(move.block, 0);
        assert_int_equal(status, YK_LIMIT);
        ++*limits;
    }
    machine_free(&m);
}

static void test_random_four_bars_keep_their_circuit(void **unused)
{
    (void)unused;
    uint64_t seed = 20261122;
    size_t limits = 0;
    for (uint64_t k = 0; k < check_cases(3000);) {
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1),
                     check_uniform(&seed, 0.1, 1)};
        double theta = check_uniform(&seed, -YK_PI, YK_PI), to = check_uniform(&seed, -3 * YK_PI, 3 * YK_PI);
        int branch = check_random(&seed) & 1 ? 1 : -1;
        if (!four_bar_pose(f, theta, branch).closes || fabs(grashof_excess(f)) < 1e-3) continue;
        check_four_bar(f, theta, to, branch, &limits);
        k++;
    }
    assert_in_range(limits, check_cases(500), check_cases(2500));
}

// All but at a change point: the crank turns through, or is stopped in a gap that is as narrow as 1e-4 rad.
static void test_narrow_gaps_are_not_jumped(void **unused)
{
    (void)unused;
    uint64_t seed = 20261123;
    size_t limits = 0;
    for (uint64_t k = 0; k < check_cases(2000);) {
        double off = pow(10, check_uniform(&seed, -8, -3));
        if (check_random(&seed) % 2 == 0) off = -off;
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), 0};
        f.d = (check_random(&seed) & 1 ? f.b + f.c - f.a : fabs(f.b - f.c) + f.a) + off;
        double theta = check_uniform(&seed, -YK_PI, YK_PI), to = check_uniform(&seed, -3 * YK_PI, 3 * YK_PI);
        int branch = check_random(&seed) & 1 ? 1 : -1;
        if (!(f.d > 0.05) || !four_bar_pose(f, theta, branch).closes) continue;
        check_four_bar(f, theta, to, branch, &limits);
        k++;
    }
    assert_in_range(limits, check_cases(300), check_cases(1900));
}

// The rocker of a crank-rocker as the input: two ranges with the same labels, and no way from one to the other.
static void test_a_range_of_the_same_labels_is_out_of_reach(void **unused)
{
    (void)unused;
    FourBar f = {4, 3, 2, 4.5}; // its input link is a rocker
    double low, high;
    closing_angles(f, &low, &high);
    assert_true(low > 0 && high < YK_PI);
    Machine m = four_bar_machine(f, 0.5 * (low + high), 1);
    char label[2][32];
    yk_state_label(m.state, label[0], sizeof label[0]);
    assert_int_equal(move_one(m.state, 0, -0.5 * (low + high), NULL), YK_LIMIT);
    CHECK_NEAR(yk_state_coordinate(m.state, 0).position, low, 1e-8);
    yk_state_set_input(m.state, 0, (YkMotion){-0.5 * (low + high), 0, 0});
    assert_true(yk_state_solve(m.state) >= 0); // what the labels alone would have said
    yk_state_label(m.state, label[1], sizeof label[1]);
    assert_string_equal(label[0], label[1]);
    machine_free(&m);
}

// At the limit that ends a move the input has the rates that were asked for, not rates per part of the way.
static void test_rates_at_a_limit_are_those_of_the_motion(void **unused)
{
    (void)unused;
    FourBar f = {4, 3, 2, 4.5};
    double low, high;
    closing_angles(f, &low, &high);
    Machine m = four_bar_machine(f, 0.5 * (low + high), 1);
    YkMotion goal = {high + 1, 0.25, -0.5};
    assert_int_equal(yk_state_move_to(m.state, &goal, NULL, NULL), YK_LIMIT);
    CHECK_NEAR(yk_state_input(m.state, 0).position, high, 1e-8);
    CHECK_NEAR(yk_state_coordinate(m.state, 0).velocity, 0.25, 0);
    CHECK_NEAR(yk_state_coordinate(m.state, 0).acceleration, -0.5, 0);
    machine_free(&m);
}

// --- turns
// ------------------------------------------------------------------------------------------------------------------

static bool count_call(void *context, double part)
{
    assert_true(part >= 0 && part <= 1);
    ++*(size_t *)context;
    return true;
}

static void check_turns(Machine one, Machine many, double turns, size_t most)
{
    double from = yk_state_input(one.state, 0).position;
    YkMoveOptions options = yk_default_move_options();
    size_t calls = 0;
    options.goes_on = count_call;
    options.context = &calls;
    YkMotion goal = yk_state_input(one.state, 0);
    goal.position = from + 1;
    assert_true(yk_state_move_to(one.state, &goal, NULL, NULL) >= 0);
    goal.position = from + 1 + 2 * YK_PI * turns;
    assert_true(yk_state_move_to(many.state, &goal, &options, NULL) >= 0);
    assert_in_range(calls, 1, most);
    for (size_t c = 0; c < yk_coordinate_count(one.mech); c++) {
        double a = yk_state_coordinate(one.state, c).position, b = yk_state_coordinate(many.state, c).position;
        double whole = 2 * YK_PI * rint((b - a) / (2 * YK_PI)), allowed = 1e-15 * fabs(b) + 1e-15 * 2 * YK_PI * turns;
        if (yk_coordinate_info(one.mech, c).is_distance) whole = 0;
        CHECK_NEAR(b - a, whole, 10 * allowed + 1e-12);
    }
    machine_free(&one);
    machine_free(&many);
}

// A belt from a wheel to the coupler turns the crank of a crank-rocker, three times for each turn of the wheel: loop
// and belt are solved together, and its angles count their turns.
static const char belted[] = "bodies:\n"
                             "  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
                             "  wheel: {points: {O: [0, 0]}}\n"
                             "  crank: {points: {O: [0, 0], A: [0.25, 0]}}\n"
                             "  coupler: {points: {A: [0, 0], B: [2, 0]}}\n"
                             "  rocker: {points: {Q: [0, 0], B: [1.5, 0]}}\n"
                             "joints:\n"
                             "  W: {pin: [ground, wheel], at: O, angle: q}\n"
                             "  O: {pin: [ground, crank], angle: th}\n"
                             "  A: {pin: [crank, coupler], angle: u}\n"
                             "  Q: {pin: [ground, rocker], angle: v}\n"
                             "  B: {pin: [coupler, rocker]}\n"
                             "belts: {g: {between: [wheel, coupler], radii: [0.3, 0.2], carrier: crank}}\n"
                             "drives: {q: 0.4}\n"
                             "start: {th: 1, u: -0.4, v: 1.7}\n";

static void test_many_turns_cost_one(void **unused)
{
    (void)unused;
    static const struct {
        const char *file;
        double turns;
        size_t most;
    } cases[] = {{"four-bar", 180000, 1000},
                 {"slider-crank", 180000, 1000},
                 {"jansen", 1000, 1000},
                 {"geared-five-bar", 5000, 4000}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        check_turns(machine_load(cases[k].file), machine_load(cases[k].file), cases[k].turns, cases[k].most);
    check_turns(machine_parse(belted, true), machine_parse(belted, true), 700, 4000);
}

// An hour at 3000 rpm along the drives.
static void test_time_counts_turns(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O: [0, 0], C: [4, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [1, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [3.5, 0]}}\n"
                              "  rocker: {points: {C: [0, 0], B: [2.5, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, coupler], angle: phi}\n"
                              "  C: {pin: [ground, rocker], angle: psi}\n"
                              "  B: {pin: [coupler, rocker]}\n"
                              "drives: {theta: 0.3 + 3000 rpm * t}\n"
                              "start: {phi: 0.8, psi: 1.5}\n",
                              true);
    char before[32], after[32];
    yk_state_label(m.state, before, sizeof before);
    double psi = machine_ask(&m, "psi");
    YkMoveOptions options = yk_default_move_options();
    size_t calls = 0;
    options.goes_on = count_call;
    options.context = &calls;
    assert_true(yk_state_move_time(m.state, 3600, &options, NULL, m.problems) >= 0);
    yk_state_label(m.state, after, sizeof after);
    assert_string_equal(before, after);
    assert_in_range(calls, 1, 600);
    CHECK_NEAR(machine_ask(&m, "psi"), psi, 1e-8); // whole turns of the crank; 1e9 deg are known to 1e-7
    CHECK_NEAR(machine_ask(&m, "theta"), 0.3 + 3600 * 100 * YK_PI, 0);
    CHECK_NEAR(yk_state_time(m.state), 3600, 0);
    machine_free(&m);
}

// --- several inputs
// ---------------------------------------------------------------------------------------------------------

static const char five_bar[] = "bodies:\n"
                               "  ground: {points: {A: [0, 0], E: [3, 0]}}\n"
                               "  left: {points: {A: [0, 0], B: [1, 0]}}\n"
                               "  right: {points: {E: [0, 0], D: [1, 0]}}\n"
                               "  lower: {points: {B: [0, 0], C: [1.85, 0]}}\n"
                               "  upper: {points: {D: [0, 0], C: [1.85, 0]}}\n"
                               "joints:\n"
                               "  A: {pin: [ground, left], angle: alpha}\n"
                               "  E: {pin: [ground, right], angle: delta}\n"
                               "  B: {pin: [left, lower], angle: beta}\n"
                               "  D: {pin: [right, upper], angle: epsilon}\n"
                               "  C: {pin: [lower, upper]}\n"
                               "start: {alpha: 90 deg, delta: 90 deg, beta: -60 deg, epsilon: 60 deg}\n";

// The left crank alone, through 180 deg: blocked there while the right one stands upright (their pins would be 4.12
// apart, and the links reach 3.7), so that one has to lean over (3 apart) and come back.
static void test_another_input_makes_room(void **unused)
{
    (void)unused;
    Machine m = machine_parse(five_bar, true);
    YkMotion goal[2] = {{1.5 * YK_PI, 0, 0}, {0.5 * YK_PI, 0, 0}};
    YkMoveOptions straight = yk_default_move_options();
    straight.detours = 0;
    YkState *blocked = yk_state_new(m.mech);
    YkMove move;
    assert_int_equal(yk_state_copy(blocked, m.state), YK_OK);
    assert_int_equal(yk_state_move_to(blocked, goal, &straight, &move), YK_LIMIT);
    // where cos and sin of the left crank put its pin 3.7 from (3, 1)
    double alpha = yk_state_coordinate(blocked, 0).position, x = 3 - cos(alpha), y = 1 - sin(alpha);
    CHECK_NEAR(x * x + y * y, 3.7 * 3.7, 1e-7);
    assert_true(yk_state_move_to(m.state, goal, NULL, &move) >= 0);
    assert_true(move.is_detour);
    for (size_t i = 0; i < 2; i++)
        assert_true(yk_state_coordinate(m.state, yk_input_coordinate(m.mech, i)).position == goal[i].position);
    CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
    yk_state_free(blocked);
    machine_free(&m);
}

// While one of two inputs is held, with rates of its own, time moves the other alone, as its drive says; and so it does
// in a sweep.
static void test_time_moves_what_is_not_held(void **unused)
{
    (void)unused;
    char text[2000];
    snprintf(text, sizeof text,
             "%sdrives: {alpha: '90 deg + 10 deg * sin(2*t/(1 s))', delta: '90 deg + 20 deg * sin(3*t/(1 s))'}\n",
             five_bar);
    for (size_t input = 0; input < 2; input++) {
        static const char *const of[] = {"alpha", "delta", "beta", "epsilon"};
        Machine m = machine_parse(text, true), still = machine_parse(five_bar, true);
        YkInputHold holds[] = {{input, 0, 1.65}, {input, 1, 0.4}, {input, 2, -0.3}};
        assert_int_equal(yk_state_reach(m.state, holds, 3, 0, NULL, NULL, m.problems), YK_OK);
        YkSweep *sweep = machine_sweep(&m, NULL, 0, 1.5, 7, of, 4);
        assert_int_equal(yk_sweep_status(sweep), YK_OK);
        for (int k = 0; k <= 7; k++) {
            double t = 1.5 * k / 7, law = input ? 10 * sin(2 * t) : 20 * sin(3 * t), moved = (90 + law) * YK_PI / 180;
            YkMotion goal[2] = {{1.65, 0, 0}, {1.65, 0, 0}};
            goal[1 - input].position = moved;
            assert_int_equal(yk_state_move_to(still.state, goal, NULL, NULL), YK_OK);
            assert_int_equal(yk_state_move_time(m.state, t, NULL, NULL, m.problems), YK_OK);
            for (size_t c = 0; c < 4; c++) {
                CHECK_NEAR(machine_ask(&m, of[c]), machine_ask(&still, of[c]), 1e-12);
                CHECK_NEAR(yk_sweep_value(sweep, (size_t)k, c), machine_ask(&still, of[c]), 1e-12);
            }
            YkMotion held = yk_state_input(m.state, input), free = yk_state_input(m.state, 1 - input);
            CHECK_NEAR(held.position, 1.65, 0);
            CHECK_NEAR(held.velocity, 0.4, 0);
            CHECK_NEAR(held.acceleration, -0.3, 0);
            CHECK_NEAR(free.velocity, (input ? 20 * cos(2 * t) : 60 * cos(3 * t)) * YK_PI / 180, 1e-12);
        }
        yk_sweep_free(sweep);
        machine_free(&m);
        machine_free(&still);
    }
}

// Nothing closes where both pins stand outwards, 5 apart: no way round comes there, and the state stands where the
// straight way ended.
static void test_a_pose_where_nothing_closes_is_out_of_reach(void **unused)
{
    (void)unused;
    Machine m = machine_parse(five_bar, true);
    YkMotion goal[2] = {{YK_PI, 0, 0}, {0, 0, 0}};
    YkMove move;
    assert_int_equal(yk_state_move_to(m.state, goal, NULL, &move), YK_LIMIT);
    assert_false(move.is_detour);
    assert_int_equal(move.block, 0);
    double alpha = yk_state_coordinate(m.state, 0).position;
    CHECK_NEAR(3 - 2 * cos(alpha), 3.7, 1e-7);
    CHECK_NEAR(alpha, 0.5 * YK_PI * (1 + move.part), 1e-12);
    machine_free(&m);
}

// --- change points, stopping, wrong calls
// ---------------------------------------------------------------------------------------

static void test_a_parallelogram_passes_its_change_points(void **unused)
{
    (void)unused;
    FourBar f = {2, 4, 2, 4};
    for (int k = 1; k <= 12; k++) {
        Machine m = four_bar_machine(
            f, 1, four_bar_pose(f, 1, 1).coupler < 1e-9 && four_bar_pose(f, 1, 1).coupler > -1e-9 ? 1 : -1);
        YkMove move;
        double to = 1 + 0.7 * k;
        assert_true(move_one(m.state, 0, to, &move) >= 0);
        CHECK_NEAR(machine_ask(&m, "theta4"), to, 1e-7);
        CHECK_NEAR(machine_ask(&m, "coupler.angle"), 0, 1e-7);
        assert_int_equal(move.pass_count, (size_t)(floor(to / YK_PI)));
        for (size_t p = 0; p < move.pass_count; p++)
            CHECK_NEAR(1 + move.passes[p].part * 0.7 * k, (double)(p + 1) * YK_PI, 1e-7);
        machine_free(&m);
    }
}

static void test_change_points_of_turns_that_are_left_out_are_counted(void **unused)
{
    (void)unused;
    static const double goals[] = {50, 1000, -77, 1e6, -4e9};
    for (size_t k = 0; k < sizeof goals / sizeof *goals; k++) {
        Machine m = four_bar_machine((FourBar){2, 4, 2, 4}, 1, -1);
        YkMove move;
        assert_true(move_one(m.state, 0, goals[k], &move) >= 0);
        assert_true((double)move.pass_count == fabs(floor(goals[k] / YK_PI)));
        machine_free(&m);
    }
}

// A request sets inputs and then lets time pass; change points of both ways are told, in their order.
static void test_a_request_is_two_ways(void **unused)
{
    (void)unused;
    Machine m = machine_load("parallelogram"); // theta2 = 60 deg + 1 turn/s * t
    YkMove move;
    YkInputHold rate = {0, 1, 7.0}, hold = {0, 0, YK_PI + 0.5};
    assert_int_equal(yk_state_reach(m.state, NULL, 0, 0.25, NULL, &move, NULL), YK_OK); // 150 deg
    CHECK_NEAR(machine_ask(&m, "theta4"), YK_PI * 5 / 6, 1e-9);
    assert_int_equal(move.pass_count, 0);
    assert_int_equal(yk_state_reach(m.state, NULL, 0, 1.0, NULL, &move, NULL), YK_OK); // past 180 and 360 deg
    CHECK_NEAR(machine_ask(&m, "theta4"), YK_PI * 7 / 3, 1e-9);
    assert_int_equal(move.pass_count, 2);
    assert_int_equal(yk_state_reach(m.state, &hold, 1, 1.0, NULL, &move, NULL), YK_OK); // back over 360 deg
    CHECK_NEAR(machine_ask(&m, "theta4"), YK_PI + 0.5, 1e-9);
    assert_int_equal(move.pass_count, 1);
    assert_int_equal(yk_state_reach(m.state, &rate, 1, 2.0, NULL, &move, NULL), YK_OK); // held: time moves nothing
    CHECK_NEAR(machine_ask(&m, "theta4"), YK_PI + 0.5, 1e-9);
    CHECK_NEAR(machine_ask(&m, "theta4.rate"), 7, 1e-9);
    machine_free(&m);

    m = machine_load("five-bar"); // one input is set, past its change points none; the other goes with time
    size_t inputs = yk_input_count(m.mech);
    YkMotion first = yk_state_input(m.state, 0);
    YkInputHold both[] = {{0, 0, first.position + 0.1}, {0, 1, 0}};
    assert_true(inputs == 2);
    assert_true(yk_state_reach(m.state, both, 2, 0.01, NULL, &move, NULL) >= 0);
    assert_true(yk_state_input(m.state, 0).position == first.position + 0.1);
    assert_true(yk_state_time(m.state) == 0.01);
    assert_int_equal(yk_state_reach(NULL, NULL, 0, 0, NULL, NULL, NULL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_state_reach(m.state, NULL, 1, 0, NULL, NULL, NULL), YK_BAD_ARGUMENT);
    machine_free(&m);
}

// The events of the way through the inputs stand before those of the way in time.
static void test_events_of_both_ways_are_in_order(void **unused)
{
    (void)unused;
    FourBar f = {2, 4, 2, 4};
    Machine m = four_bar_machine(f, 1, four_bar_pose(f, 1, 1).coupler < 1e-9 ? 1 : -1);
    YkInputHold hold = {0, 0, 1 + 2 * YK_PI};
    YkMove move;
    assert_true(yk_state_reach(m.state, &hold, 1, 3.0, NULL, &move, NULL) >= 0);
    assert_int_equal(move.pass_count, 2);
    CHECK_NEAR(1 + move.passes[0].part * 2 * YK_PI, YK_PI, 1e-7);
    CHECK_NEAR(1 + move.passes[1].part * 2 * YK_PI, 2 * YK_PI, 1e-7);
    machine_free(&m);
}

// Where a base vanishes the pose a little before stands for the one that was asked; the input is the one asked, to the
// last bit.
static void test_an_input_ends_exactly_where_a_base_vanishes(void **unused)
{
    (void)unused;
    for (int turn = -2; turn <= 2; turn++) {
        Machine m = machine_load("n-four-bar");
        double to = 2 * YK_PI * turn;
        assert_true(move_one(m.state, 0, to, NULL) >= 0);
        assert_true(machine_ask(&m, "theta0") == to);
        CHECK_NEAR(machine_ask(&m, "theta1"), to, 1e-9);
        machine_free(&m);
    }
}

// A way over time, with rates that change and at steady ones, is told in parts of its time from its start; up to the
// limit, where the crank pin is as far from the other pivot as coupler and rocker reach.
typedef struct Told {
    const YkState *state;
    double from, to, last;
    bool is_in_time; // the state tells how far it is
    size_t count;
} Told;

static bool check_part(void *context, double part)
{
    Told *told = context;
    if (told->is_in_time) CHECK_NEAR(part, (yk_state_time(told->state) - told->from) / (told->to - told->from), 1e-12);
    assert_true(part >= told->last && part <= 1);
    told->last = part;
    told->count++;
    return true;
}

static void test_parts_of_a_way_over_time(void **unused)
{
    (void)unused;
    static const char *const laws[] = {"0.2 rad + 0.05 rad * (t/(1 s))^2", "0.2 rad + 0.2 rad/s * t"};
    const double limit = acos(-0.44);
    for (int k = 0; k < 8; k++) {
        char text[1000];
        bool is_steady = k % 2, arrives = k % 4 < 2, is_back = k >= 4;
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O2: [0, 0], O4: [10, 0]}}\n  crank: {points: {O2: [0, 0], A: [5, 0]}}\n"
                 "  coupler: {points: {A: [0, 0], B: [6, 0]}}\n  rocker: {points: {O4: [0, 0], B: [7, 0]}}\n"
                 "joints:\n  O2: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, coupler], angle: u}\n"
                 "  O4: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, rocker]}\n"
                 "drives: {th: \"%s\"}\nstart: {u: 1, v: 2}\n",
                 laws[is_steady]);
        Machine m = machine_parse(text, true);
        double ends = is_steady ? (limit - 0.2) / 0.2 : sqrt((limit - 0.2) / 0.05), from = 2.5, to = arrives ? 5 : 12;
        if (is_back) to = arrives ? -0.5 : is_steady ? -30 : -12, ends = is_steady ? (-limit - 0.2) / 0.2 : -ends;
        assert_true(yk_state_move_time(m.state, from, NULL, NULL, m.problems) >= 0);
        Told told = {m.state, from, to, 0, !is_steady, 0};
        YkMoveOptions options = yk_default_move_options();
        YkMove move;
        options.goes_on = check_part;
        options.context = &told;
        YkStatus status = yk_state_move_time(m.state, to, &options, &move, m.problems);
        assert_true(arrives ? status >= 0 : status == YK_LIMIT);
        assert_true(told.count >= 3);
        CHECK_NEAR(move.part, arrives ? 1 : (ends - from) / (to - from), 1e-7);
        CHECK_NEAR(yk_state_time(m.state), arrives ? to : ends, 1e-6);
        machine_free(&m);
    }
}

// Over time, from a time that is not 0: a parallelogram passes its change points where its crank does.
static void test_passes_over_time_are_told_by_their_parts(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [2, 0]}}\n  rod: {points: {A: [0, 0], B: [4, 0]}}\n"
                              "  rocker: {points: {Q: [0, 0], B: [2, 0]}}\njoints:\n"
                              "  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, rod], angle: u}\n"
                              "  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [rod, rocker]}\n"
                              "drives: {th: '1 rad + 0.1 rad * (t/(1 s))^2'}\nstart: {u: -1, v: 1}\n",
                              true);
    for (double from = 1; from < 3; from += 0.5) {
        YkMove move;
        const double to = 8;
        assert_int_equal(yk_state_move_time(m.state, from, NULL, NULL, m.problems), YK_OK);
        assert_int_equal(yk_state_move_time(m.state, to, NULL, &move, m.problems), YK_OK);
        assert_int_equal(move.pass_count, 2);
        for (int k = 1; k <= 2; k++)
            CHECK_NEAR(move.passes[k - 1].part, (sqrt((k * YK_PI - 1) / 0.1) - from) / (to - from), 1e-8);
        CHECK_NEAR(machine_ask(&m, "v"), 1 + 0.1 * to * to, 1e-6);
    }
    machine_free(&m);
}

static bool stop_half_way(void *context, double part)
{
    (void)context;
    return part < 0.5;
}

static void test_a_way_that_is_too_long_tells_nothing_of_an_earlier_failure(void **unused)
{
    (void)unused;
    Machine m = machine_load("excavator");
    size_t n = yk_input_count(m.mech);
    YkMotion goal[8];
    assert_true(n <= 8);
    for (size_t i = 0; i < n; i++) goal[i] = (YkMotion){yk_state_input(m.state, i).position, 0, 0};
    yk_state_set_input(m.state, 0, (YkMotion){50, 0, 0});
    assert_int_equal(yk_state_solve(m.state), YK_LIMIT);
    assert_true(yk_state_report(m.state)->block >= 0);
    goal[0].position = 1e9;
    assert_int_equal(yk_state_move_to(m.state, goal, NULL, NULL), YK_STOPPED);
    const YkReport *report = yk_state_report(m.state);
    assert_non_null(strstr(report->message, "too long"));
    assert_int_equal(report->block, -1);
    assert_int_equal(report->joint, -1);
    assert_true(report->gap == 0 && report->determinant == 0);
    machine_free(&m);
    m = machine_parse(
        "bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n  crank: {points: {O: [0, 0], A: [0.3, 0]}}\n"
        "  coupler: {points: {A: [0, 0], B: [2, 0]}}\n  rocker: {points: {Q: [0, 0], B: [1.5, 0]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, coupler], angle: u}\n"
        "  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, rocker]}\n"
        "drives: {th: 1 rad/s * t + 0.5 rad * sin(1e3 rad/s * t)}\nstart: {u: -0.4, v: 1.7}\n",
        true);
    assert_int_equal(yk_state_move_time(m.state, 1e8, NULL, NULL, m.problems), YK_STOPPED); // over time, too
    assert_non_null(strstr(yk_state_report(m.state)->message, "too long"));
    assert_true(yk_state_time(m.state) == 0);
    machine_free(&m);
}

static void test_a_move_can_be_stopped(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    double from = yk_state_input(m.state, 0).position;
    YkMoveOptions options = yk_default_move_options();
    options.goes_on = stop_half_way;
    YkMotion goal = {from + 2, 0, 0};
    YkMove move;
    assert_int_equal(yk_state_move_to(m.state, &goal, &options, &move), YK_STOPPED);
    CHECK_NEAR(move.part, 0.5, 0.08);
    CHECK_NEAR(yk_state_coordinate(m.state, yk_input_coordinate(m.mech, 0)).position, from + 2 * move.part, 1e-12);
    goal.position = NAN;
    assert_int_equal(yk_state_move_to(m.state, &goal, NULL, NULL), YK_BAD_ARGUMENT);
    YkState *none = yk_state_new(m.mech);
    assert_int_equal(move_one(none, 0, 1, NULL), YK_BAD_ARGUMENT); // it has no pose
    assert_int_equal(yk_state_move_time(none, 1, NULL, NULL, m.problems), YK_BAD_ARGUMENT);
    assert_int_equal(yk_state_move_time(m.state, NAN, NULL, NULL, m.problems), YK_BAD_ARGUMENT);
    options.turn_max = 0;
    goal.position = from;
    assert_int_equal(yk_state_move_to(m.state, &goal, &options, NULL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_state_move_time(m.state, 1, &options, NULL, m.problems), YK_BAD_ARGUMENT);
    yk_state_free(none);
    machine_free(&m);
}

// --- every example: no jump on the way
// ------------------------------------------------------------------------------------------

// Moves in steps of a quarter of a degree; between two of them every coordinate goes as its rates at both say (to the
// third order of the step), which another branch would not.
static void check_continuity(const char *name, double way)
{
    Machine m = machine_open(name, NULL);
    if (yk_state_assemble(m.state) < 0 || yk_input_count(m.mech) == 0 || yk_input_count(m.mech) > 8) {
        machine_free(&m);
        return;
    }
    size_t count = yk_coordinate_count(m.mech), input = yk_input_coordinate(m.mech, 0);
    double unit = yk_coordinate_info(m.mech, input).is_distance ? yk_mechanism_size(m.mech) : 1;
    double h = way * unit * YK_PI / 720, *before = calloc(2 * count, sizeof *before);
    YkMotion goal[8];
    for (size_t i = 0; i < yk_input_count(m.mech); i++) goal[i] = (YkMotion){yk_state_input(m.state, i).position, 0, 0};
    goal[0].velocity = 1;
    bool has_before = false;
    for (int k = 0; k < 720; k++) {
        if (yk_state_move_to(m.state, goal, NULL, NULL) < 0) break;
        bool has_rates = yk_state_has_rates(m.state);
        for (size_t c = 0; c < count; c++) {
            YkMotion now = yk_state_coordinate(m.state, c);
            double size = yk_coordinate_info(m.mech, c).is_distance ? yk_mechanism_size(m.mech) : 1;
            double expected = before[2 * c] + 0.5 * h * (before[2 * c + 1] + now.velocity);
            double speed = fmax(fabs(before[2 * c + 1]), fabs(now.velocity)) * unit / size;
            if (has_before && has_rates && speed < 20 && fabs(now.position - expected) > 0.02 * size)
                print_error("%s: %s jumps from %g to %g\n", name, yk_coordinate_info(m.mech, c).name, before[2 * c],
                            now.position);
            if (has_before && has_rates && speed < 20) CHECK_NEAR((now.position - expected) / size, 0, 0.02);
            before[2 * c] = now.position;
            before[2 * c + 1] = now.velocity;
        }
        has_before = has_rates;
        goal[0].position += h;
    }
    free(before);
    machine_free(&m);
}

static void test_no_example_jumps(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    DIR *folder = opendir(YOKE_ROOT "/examples");
    assert_non_null(folder);
    size_t count = 0;
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[256];
        size_t length = strlen(entry->d_name);
        if (length < 6 || length > 250 || strcmp(entry->d_name + length - 5, ".yaml") != 0) continue;
        memcpy(name, entry->d_name, length - 5);
        name[length - 5] = '\0';
        check_continuity(name, 1);
        check_continuity(name, -1);
        count++;
    }
    closedir(folder);
    assert_true(count > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_four_bars_keep_their_circuit),
        cmocka_unit_test(test_narrow_gaps_are_not_jumped),
        cmocka_unit_test(test_a_range_of_the_same_labels_is_out_of_reach),
        cmocka_unit_test(test_rates_at_a_limit_are_those_of_the_motion),
        cmocka_unit_test(test_many_turns_cost_one),
        cmocka_unit_test(test_time_counts_turns),
        cmocka_unit_test(test_another_input_makes_room),
        cmocka_unit_test(test_time_moves_what_is_not_held),
        cmocka_unit_test(test_a_pose_where_nothing_closes_is_out_of_reach),
        cmocka_unit_test(test_a_parallelogram_passes_its_change_points),
        cmocka_unit_test(test_change_points_of_turns_that_are_left_out_are_counted),
        cmocka_unit_test(test_a_request_is_two_ways),
        cmocka_unit_test(test_events_of_both_ways_are_in_order),
        cmocka_unit_test(test_an_input_ends_exactly_where_a_base_vanishes),
        cmocka_unit_test(test_a_way_that_is_too_long_tells_nothing_of_an_earlier_failure),
        cmocka_unit_test(test_parts_of_a_way_over_time),
        cmocka_unit_test(test_a_move_can_be_stopped),
        cmocka_unit_test(test_passes_over_time_are_told_by_their_parts),
        cmocka_unit_test(test_no_example_jumps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
