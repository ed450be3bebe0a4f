// Motions that begin exactly at a change point: whoever goes on passes it, whoever turns back keeps the signs.
#include "../solve/machine.h"
#include <yoke/move.h>

// At 0 and 180 deg all links of the parallelogram lie in one line, and the crossed linkage meets it.
static void check_parallel(const Machine *m)
{
    double theta2 = machine_ask(m, "theta2");
    CHECK_NEAR(machine_ask(m, "theta4"), theta2, 1e-7);
    CHECK_NEAR(machine_ask(m, "theta3"), -theta2, 1e-7);
}

static void go_to(Machine *m, double to)
{
    YkMotion goal = {to, 1, 0};
    assert_true(yk_state_move_to(m->state, &goal, NULL, NULL) >= 0);
    check_parallel(m);
}

static void test_moves_that_stop_at_change_points(void **unused)
{
    (void)unused;
    static const double ways[][6] = {
        {0, -1, 0, 1, 0, -2},
        {0.3, 0, -0.3, 0, 0.2, 0}, // less than a unit of the input
        {0.4, 0, 0.2, 0, -0.1, 0},
        {YK_PI, 4, YK_PI, 2, YK_PI, 5},
        {0, -YK_PI, -2 * YK_PI, -YK_PI, 0, YK_PI},
        {YK_PI, YK_PI, 4, 2 * YK_PI, 5, 2 * YK_PI},
        {2, 0, 2, YK_PI, 1, -1},
    };
    for (size_t k = 0; k < sizeof ways / sizeof *ways; k++) {
        Machine m = machine_load("parallelogram");
        for (size_t i = 0; i < 6; i++) go_to(&m, ways[k][i]);
        machine_free(&m);
    }
}

static void test_a_copy_knows_where_it_came_from(void **unused)
{
    (void)unused;
    Machine m = machine_load("parallelogram");
    YkState *own = m.state, *copy = yk_state_new(m.mech);
    go_to(&m, 0);
    assert_int_equal(yk_state_copy(copy, own), YK_OK);
    m.state = copy;
    go_to(&m, -1);
    m.state = own;
    go_to(&m, 1);
    yk_state_free(copy);
    machine_free(&m);
}

// Rates at the change points are the limits of the motion that led there: on the parallelogram those of the crank; on
// the crossed linkage tan(theta4/2) = -3 tan(theta2/2), where 3 = (4 + 2)/(4 - 2).
static void go_on(Machine *m, double to, int branch)
{
    YkMotion goal = {to, 1, 0};
    assert_int_equal(yk_state_move_to(m->state, &goal, NULL, NULL), YK_OK);
    double half = machine_ask(m, "theta4") / 2, crank = to / 2;
    CHECK_NEAR(yk_sin(half) * yk_cos(crank), (branch > 0 ? 1 : -3) * yk_cos(half) * yk_sin(crank), 1e-9);
}

static void check_rates(int branch, double from, double to, double ratio)
{
    Machine m = machine_load("parallelogram");
    YkMotion middle = {1, 0, 0}, first = {from, 1, 0}, goal = {to, 3, -2};
    assert_int_equal(yk_state_move_to(m.state, &middle, NULL, NULL), YK_OK);
    yk_state_set_branch(m.state, 0, branch * yk_state_branch(m.state, 0));
    assert_int_equal(yk_state_solve(m.state), YK_OK);
    assert_true(yk_state_move_to(m.state, &first, NULL, NULL) >= 0);
    assert_int_equal(yk_state_move_to(m.state, &goal, NULL, NULL), YK_CHANGE_POINT);
    CHECK_NEAR(machine_ask(&m, "theta4.rate"), 3 * ratio, 1e-9);
    CHECK_NEAR(machine_ask(&m, "theta4.accel"), -2 * ratio, 1e-8);
    CHECK_NEAR(machine_ask(&m, "rocker.rate"), 3 * ratio, 1e-9);
    assert_int_equal(yk_state_report(m.state)->block, 0);
    go_on(&m, to + 0.3 * (to > from ? 1 : -1), branch);
    machine_free(&m);
}

static void test_rates_at_change_points(void **unused)
{
    (void)unused;
    check_rates(1, 1, 0, 1);
    check_rates(1, 1, YK_PI, 1);
    check_rates(1, -1, 2 * YK_PI, 1);
    check_rates(-1, 1, 0, -3);
    check_rates(-1, 1, YK_PI, -1.0 / 3);
    check_rates(-1, -1, YK_PI, -1.0 / 3);
    check_rates(-1, 5, 0, -3);
}

// Rows of theta4 and its rate, from a pose to which the machine has moved; theta2 turns at 1 rad/s.
static void check_sweep(double from, double to, size_t expected_events)
{
    enum { STEPS = 12 };
    Machine m = machine_load("parallelogram");
    static const char *const of[] = {"theta4", "theta4.rate"};
    go_to(&m, from);
    YkSweep *sweep = machine_sweep(&m, "theta2", from, to, STEPS, of, 2);
    assert_int_equal(yk_sweep_status(sweep), YK_OK);
    for (size_t k = 0; k <= STEPS; k++) {
        CHECK_NEAR(yk_sweep_value(sweep, k, 0), yk_sweep_at(sweep, k), 1e-7);
        CHECK_NEAR(yk_sweep_value(sweep, k, 1), 1, 1e-6);
    }
    size_t events = 0;
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent e = yk_sweep_event(sweep, k);
        assert_true(e.kind == YK_EVENT_CHANGE_POINT);
        assert_true(fabs(yk_sin(e.at)) < 1e-8);
        events++;
    }
    assert_int_equal(events, expected_events);
    assert_int_equal(yk_sweep_row_status(sweep, 0), YK_CHANGE_POINT);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_sweeps_from_change_points(void **unused)
{
    (void)unused;
    check_sweep(0, -2, 1);
    check_sweep(0, 2, 1);
    check_sweep(0, -YK_PI, 2);
    check_sweep(YK_PI, 2 * YK_PI, 2);
    check_sweep(YK_PI, 0, 2);
    check_sweep(-YK_PI, 2 * YK_PI, 4);
}

// At a limit the two branches meet as at a change point, but the motion ends there: asked to go on, the machine keeps
// its branch, and turns back on it. The piston's reach, 3, is a number without rounding.
static void test_a_limit_is_not_passed(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [1, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [2, 0]}}\n"
                              "  piston: {points: {B: [0, 0]}}\n"
                              "joints:\n"
                              "  S: {slide: [ground, piston], along: x, distance: x}\n"
                              "  B: {pin: [piston, rod], angle: phi}\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, rod]}\n"
                              "drives: {x: 2.5 m + 1 m/s * t}\nstart: {theta: 40 deg, phi: -20 deg}\n",
                              true);
    double theta = machine_ask(&m, "theta");
    for (int k = 0; k < 3; k++) {
        YkMotion to = {3, 1, 0}, beyond = {3.1, 1, 0}, back = {2.5, 1, 0};
        assert_int_equal(yk_state_move_to(m.state, &to, NULL, NULL), YK_SINGULAR);
        assert_int_equal(yk_state_move_to(m.state, &beyond, NULL, NULL), YK_LIMIT);
        assert_true(yk_state_move_to(m.state, &back, NULL, NULL) >= 0);
        CHECK_NEAR(machine_ask(&m, "theta"), theta, 1e-9);
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moves_that_stop_at_change_points),
        cmocka_unit_test(test_a_copy_knows_where_it_came_from),
        cmocka_unit_test(test_rates_at_change_points),
        cmocka_unit_test(test_sweeps_from_change_points),
        cmocka_unit_test(test_a_limit_is_not_passed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
