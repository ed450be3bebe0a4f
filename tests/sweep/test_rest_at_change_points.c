// Drives that come to rest exactly at a change point, dwell there, go on or turn back: the motion is decided by where
// the inputs go, never by the steps in time. A parallelogram stays one, theta4 = theta2.
#include "../solve/machine.h"
#include "parallelogram.h"
#include <yoke/move.h>

typedef struct Drive {
    const char *law; // of T = t/s
    double start;    // its value at t = 0
    size_t passes;   // of the change point, up to T = 3
    double turns[2]; // T between which it turns back there, which may be told too; 0: it does not
} Drive;

// In units of 60 deg around the change point at 180 deg; the other one, 180 deg away, is never reached.
static const Drive drives[] = {
    {"(t/(1 s) - 1)^3/4", -0.25, 1, {0}},
    {"(t/(1 s) - 1)^5/32", -0.03125, 1, {0}},
    {"(t/(1 s) - 1)", -1, 1, {0}},
    {"0.001*(t/(1 s) - 1)^3", -0.001, 1, {0}},
    {"(t/(1 s) - 1)^2/3", 1.0 / 3, 0, {0.5, 1.5}},
    {"(t/(1 s) - 1)^4/17", 1.0 / 17, 0, {0.5, 1.5}},
    {"(t/(1 s) - 1)^3*(t/(1 s) - 2)^3/8", 1, 2, {0}},
    {"(t/(1 s) - 1)^2*(t/(1 s) - 2)/2", -1, 1, {0.5, 1.5}},
    {"max(0, t/(1 s) - 2)^3 - max(0, 1 - t/(1 s))^3", -1, 1, {0}}, // a dwell of one second, passed
    {"max(0, t/(1 s) - 1.7) - max(0, 1.1 - t/(1 s))", -1.1, 1, {0}},
    {"max(0, 1 - t/(1 s))^2 + max(0, t/(1 s) - 2)^3", 1, 0, {0.9, 2.1}}, // the same, turned back
    {"max(0, 1 - t/(1 s))^2", 1, 0, {0.9, 3}},                           // it stays there
};
enum { DRIVES = sizeof drives / sizeof *drives };

// With every other drive there is a second one, which rests all the time.
static Machine parallelogram(const Drive *d)
{
    char text[1400];
    bool has_idle = (d - drives) % 2;
    double start = 180 + 60 * d->start;
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground:  {points: {O2: [0, 0], O4: [4, 0]}}\n"
             "  crank:   {points: {O2: [0, 0], A: [2, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [4, 0]}}\n"
             "  rocker:  {points: {O4: [0, 0], B: [2, 0]}}\n%s" PARALLELOGRAM_JOINTS
             "%sdrives: {theta2: '180 deg + 60 deg*(%s)'%s}\nstart: {theta3: %.17g deg, theta4: %.17g deg}\n",
             has_idle ? "  idle: {}\n" : "", has_idle ? "  I: {slide: [ground, idle], along: x, distance: i}\n" : "",
             d->law, has_idle ? ", i: 2" : "", -start, start);
    return machine_parse(text, true);
}

// The rocker does what the crank does, at the change point too, wherever the row has rates. Beside the change point the
// pose determines the ratio of the rates to rounding over the square of the distance.
static void check_row(const YkSweep *sweep, size_t row, const char *law)
{
    CHECK_NEAR(yk_sweep_value(sweep, row, 1), yk_sweep_value(sweep, row, 0), 1e-6);
    if (yk_sweep_row_status(sweep, row) == YK_SINGULAR) return;
    double rate = yk_sweep_value(sweep, row, 3) - yk_sweep_value(sweep, row, 2);
    double accel = yk_sweep_value(sweep, row, 5) - yk_sweep_value(sweep, row, 4);
    double off = fabs(yk_sweep_value(sweep, row, 0) - YK_PI), blur = off > 1e-7 ? 2e-15 / (off * off) : 0;
    bool is_good = fabs(rate) <= 1e-6 + blur * fabs(yk_sweep_value(sweep, row, 2)) &&
                   fabs(accel) <= 1e-5 + blur * fabs(yk_sweep_value(sweep, row, 4));
    if (!is_good) print_error("%s: row %zu at %g s: %g, %g\n", law, row, yk_sweep_at(sweep, row), rate, accel);
    assert_true(is_good);
}

// Each extreme of one is an extreme of the other, at the same pose.
static void check_extremes(const YkSweep *sweep, const char *law)
{
    int balance = 0;
    for (size_t e = 0; e < yk_sweep_event_count(sweep); e++) {
        YkEvent event = yk_sweep_event(sweep, e);
        if (event.kind != YK_EVENT_EXTREME || event.channel > 1) continue;
        balance += event.channel == 0 ? 1 : -1;
        double off = yk_sweep_event_value(sweep, e, 1) - yk_sweep_event_value(sweep, e, 0);
        if (!(fabs(off) <= 1e-7)) print_error("%s: an extreme at %.12g s is off by %g\n", law, event.at, off);
        assert_true(fabs(off) <= 1e-7);
    }
    if (balance != 0) print_error("%s: extremes of theta2 - theta4: %d\n", law, balance);
    assert_int_equal(balance, 0);
}

static void test_sweeps_over_time(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta2", "theta4", "theta2.rate", "theta4.rate", "theta2.accel", "theta4.accel"};
    static const size_t steps[] = {1, 2, 3, 4, 5, 7, 12, 30, 101};
    for (size_t k = 0; k < DRIVES; k++)
        for (size_t n = 0; n < sizeof steps / sizeof *steps; n++) {
            Machine m = parallelogram(&drives[k]);
            YkSweep *sweep = machine_sweep(&m, NULL, 0, 3, steps[n], of, 6);
            assert_int_equal(yk_sweep_status(sweep), YK_OK);
            for (size_t row = 0; row <= steps[n]; row++) check_row(sweep, row, drives[k].law);
            check_extremes(sweep, drives[k].law);
            size_t passes = 0;
            for (size_t e = 0; e < yk_sweep_event_count(sweep); e++) {
                YkEvent event = yk_sweep_event(sweep, e);
                bool turns = event.at >= drives[k].turns[0] && event.at <= drives[k].turns[1];
                if (event.kind != YK_EVENT_CHANGE_POINT || turns) continue;
                passes++;
                assert_true(event.is_passed && !event.is_turned);
            }
            if (passes != drives[k].passes) print_error("%s, %zu steps\n", drives[k].law, steps[n]);
            assert_int_equal(passes, drives[k].passes);
            yk_sweep_free(sweep);
            machine_free(&m);
        }
}

// Each move begins where the last one ended, at the change point itself too.
static void test_moves_over_time(void **unused)
{
    (void)unused;
    static const double times[][4] = {{3}, {1, 3}, {1, 1.5, 2, 3}, {0.5, 1, 2.5, 0.25}, {2, 1, 3, 0}};
    for (size_t k = 0; k < DRIVES; k++)
        for (size_t n = 0; n < sizeof times / sizeof *times; n++) {
            Machine m = parallelogram(&drives[k]);
            for (size_t i = 0; i < 4 && (i == 0 || times[n][i] > 0); i++) {
                YkStatus status = yk_state_move_time(m.state, times[n][i], NULL, NULL, m.problems);
                if (status < 0 || fabs(machine_ask(&m, "theta4") - machine_ask(&m, "theta2")) > 1e-6)
                    print_error("%s, way %zu, at %g s\n", drives[k].law, n, times[n][i]);
                assert_true(status >= 0);
                CHECK_NEAR(machine_ask(&m, "theta4"), machine_ask(&m, "theta2"), 1e-6);
                if (!yk_state_has_rates(m.state)) continue;
                CHECK_NEAR(machine_ask(&m, "theta4.rate"), machine_ask(&m, "theta2.rate"), 1e-6);
                CHECK_NEAR(machine_ask(&m, "theta4.accel"), machine_ask(&m, "theta2.accel"), 1e-5);
            }
            machine_free(&m);
        }
}

// A sweep that ends at a change point has passed it or not: whatever comes next goes on from there.
static void test_moves_after_a_sweep(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta2"};
    static const double ends[] = {1, 0.99999999, 1.00000001, 0.9, 1.1};
    for (size_t k = 0; k < DRIVES; k++)
        for (size_t n = 0; n < 20; n++) {
            Machine m = parallelogram(&drives[k]);
            yk_sweep_free(machine_sweep(&m, NULL, 0, ends[n % 5], 1 + n / 2, of, 1));
            assert_true(yk_state_move_time(m.state, n % 2 ? 0.5 : 3, NULL, NULL, m.problems) >= 0);
            CHECK_NEAR(machine_ask(&m, "theta4"), machine_ask(&m, "theta2"), 1e-6);
            machine_free(&m);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sweeps_over_time),
        cmocka_unit_test(test_moves_over_time),
        cmocka_unit_test(test_moves_after_a_sweep),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
