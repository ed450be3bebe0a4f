// Poses so near to a change point that rounding shows in the solution of J q' = 0: their rates and accelerations are as
// good as elsewhere, in rows of sweeps and at the ends of moves, on both sides, whatever the change point's two
// branches are.
#include "../solve/machine.h"
#include <yoke/dynamics.h>
#include <yoke/move.h>

// A value and its first two derivatives by the crank's angle.
typedef struct Jet {
    double v, d, dd;
} Jet;

static Jet jet_add(Jet a, double s, Jet b)
{
    return (Jet){a.v + s * b.v, a.d + s * b.d, a.dd + s * b.dd};
}

static Jet jet_mul(Jet a, Jet b)
{
    return (Jet){a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}

static Jet jet_of(Jet x, double f, double f1, double f2)
{
    return (Jet){f, f1 * x.d, f2 * x.d * x.d + f1 * x.dd};
}

static Jet jet_sqrt(Jet x)
{
    double r = sqrt(x.v);
    return jet_of(x, r, 0.5 / r, -0.25 / (r * x.v));
}

static Jet jet_over(Jet a, Jet b)
{
    return jet_mul(a, jet_of(b, 1 / b.v, -1 / (b.v * b.v), 2 / (b.v * b.v * b.v)));
}

static Jet jet_atan2(Jet y, Jet x)
{
    Jet rate = jet_over(jet_add(jet_mul(x, (Jet){y.d, y.dd, 0}), -1, jet_mul(y, (Jet){x.d, x.dd, 0})),
                        jet_add(jet_mul(x, x), 1, jet_mul(y, y)));
    return (Jet){atan2(y.v, x.v), rate.v, rate.d};
}

// The rocker of a four-bar whose ground and crank are as long as coupler and rocker: with the crank at 180 deg all are
// in line. The height of the coupler's pin over the diagonal, 2 d h, is then a smooth function with cos(theta / 2) in
// it:
//     (b + c)^2 - d^2 = 4 a g cos^2(theta / 2).
static double rocker(double g, double a, double b, double c, double side, double theta, Jet *rate)
{
    Jet t = {theta, 1, 0}, half = {0.5 * theta, 0.5, 0};
    Jet C = jet_of(t, cos(theta), -sin(theta), -cos(theta)), S = jet_of(t, sin(theta), cos(theta), -sin(theta));
    Jet H = jet_of(half, cos(half.v), -sin(half.v), -cos(half.v));
    Jet dd = jet_add((Jet){a * a + g * g, 0, 0}, -2 * a * g, C), zero = {0, 0, 0};
    Jet along = jet_add((Jet){c * c - b * b, 0, 0}, 1, dd); // of the rocker along the diagonal, times 2 d
    Jet up = jet_mul(H, jet_sqrt(jet_add(dd, -1, (Jet){(b - c) * (b - c), 0, 0})));
    up = jet_add(zero, side * 2 * sqrt(a * g), up);
    Jet x = jet_add((Jet){-g, 0, 0}, a, C), y = jet_add(zero, a, S); // from the rocker's pivot to the crank's pin
    Jet px = jet_add(jet_mul(along, x), -1, jet_mul(up, y)), py = jet_add(jet_mul(along, y), 1, jet_mul(up, x));
    *rate = jet_atan2(py, px);
    return rate->v;
}

static const double lengths[][4] = {{4, 1, 3, 2}, {4, 1, 2, 3}, {4.1, 1.3, 4.1, 1.3}, {3, 2, 1, 4}, {5, 0.5, 2.5, 3}};
enum { FOUR_BARS = sizeof lengths / sizeof *lengths };

// The crank's angle is 180 deg + 0.3 T + 0.1 T^2, where T = t/s - 1.
static Machine four_bar(const double *l, double side)
{
    char text[1200];
    double theta = YK_PI - 0.2;
    Jet jet;
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground:  {points: {O2: [0, 0], O4: [%.17g, 0]}}\n"
             "  crank:   {points: {O2: [0, 0], A: [%.17g, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  rocker:  {points: {O4: [0, 0], B: [%.17g, 0]}}\n"
             "joints:\n"
             "  O2: {pin: [ground, crank], angle: theta2}\n"
             "  O4: {pin: [ground, rocker], angle: theta4}\n"
             "  A: {pin: [crank, coupler], angle: alpha}\n"
             "  B: {pin: [coupler, rocker]}\n"
             "drives: {theta2: '180 deg + 0.3 rad*(t/(1 s) - 1) + 0.1 rad*(t/(1 s) - 1)^2'}\n"
             "start: {theta4: %.17g}\n",
             l[0], l[1], l[2], l[3], rocker(l[0], l[1], l[2], l[3], side, theta, &jet));
    return machine_parse(text, true);
}

typedef struct Answer {
    double position, rate, accel;
} Answer;

static Answer truth(const double *l, double side, double time)
{
    double T = time - 1, w = 0.3 + 0.2 * T;
    Jet jet;
    rocker(l[0], l[1], l[2], l[3], side, YK_PI + 0.3 * T + 0.1 * T * T, &jet);
    return (Answer){jet.v, jet.d * w, jet.dd * w * w + jet.d * 0.2};
}

static void check_answer(const double *l, double side, double time, Answer is)
{
    Answer should = truth(l, side, time);
    double off = remainder(is.position - should.position, 2 * YK_PI), beside = fmax(fabs(time - 1), 1e-7);
    bool is_good =
        fabs(off) < 1e-9 + 5e-15 / beside && fabs(is.rate - should.rate) < 1e-7 && fabs(is.accel - should.accel) < 3e-7;
    if (!is_good)
        print_error("four-bar %g %g %g %g, %g at %.17g s: off by %g, %g, %g\n", l[0], l[1], l[2], l[3], side, time, off,
                    is.rate - should.rate, is.accel - should.accel);
    assert_true(is_good);
}

// Times before and behind the change point at 1 s.
static double time_of(size_t k)
{
    static const double beside[] = {1e-6, 3e-6, 1e-5, 4e-5, 1e-4, 3.3e-4, 1e-3, 2e-3, 5e-3, 0.02, 0.1};
    enum { COUNT = sizeof beside / sizeof *beside };
    return k == COUNT ? 1 : k < COUNT ? 1 - beside[COUNT - 1 - k] : 1 + beside[k - COUNT - 1];
}
enum { TIMES = 23 };

static void moves_have_clear_rates(void **unused)
{
    (void)unused;
    for (size_t n = 0; n < FOUR_BARS; n++)
        for (int side = 1; side >= -1; side -= 2) {
            Machine m = four_bar(lengths[n], side);
            for (size_t k = 0; k < 3 * TIMES; k++) { // forward, in leaps, and back
                double time = time_of(k < TIMES ? k : k < 2 * TIMES ? 7 * k % TIMES : 3 * TIMES - 1 - k);
                assert_true(yk_state_move_time(m.state, time, NULL, NULL, m.problems) >= 0);
                if (!yk_state_has_rates(m.state)) print_error("no rates at %.17g s\n", time);
                assert_true(yk_state_has_rates(m.state));
                YkMotion c = yk_state_coordinate(m.state, yk_coordinate_find(m.mech, "theta4"));
                check_answer(lengths[n], side, time, (Answer){c.position, c.velocity, c.acceleration});
            }
            machine_free(&m);
        }
}

static void rows_have_clear_rates(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta4", "theta4.rate", "theta4.accel"};
    static const double ends[][2] = {{0.99999, 1.00003}, {1.0004, 0.9991}, {1.00002, 1.2}, {0.99, 1.013}, {0.2, 1.9}};
    for (size_t n = 0; n < FOUR_BARS; n++)
        for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
            Machine m = four_bar(lengths[n], 1);
            YkSweep *sweep = machine_sweep(&m, NULL, ends[k][0], ends[k][1], 20, of, 3);
            assert_int_equal(yk_sweep_status(sweep), YK_OK);
            for (size_t row = 0; row <= 20; row++) {
                const double *value = yk_sweep_rows(sweep) + 4 * row;
                check_answer(lengths[n], 1, value[0], (Answer){value[1], value[2], value[3]});
            }
            assert_int_equal(count_events(sweep, YK_EVENT_SINGULAR), 0);
            assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), ends[k][0]<1 == ends[k][1]> 1);
            yk_sweep_free(sweep);
            machine_free(&m);
        }
}

// The coupler of a parallelogram moves on a circle without turning: each of its pins carries half of its 2 kg.
static void forces_are_clear(void **unused)
{
    (void)unused;
    static const char *const of[] = {"B.force.x", "B.force.y", "A.force.x", "theta2.effort"};
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O2: [0, 0], O4: [4, 0]}}\n"
                              "  crank: {points: {O2: [0, 0], A: [2, 0]}, mass: 1}\n"
                              "  coupler: {points: {A: [0, 0], B: [4, 0]}, mass: 2, rod: [A, B]}\n"
                              "  rocker: {points: {O4: [0, 0], B: [2, 0]}, mass: 1, rod: [O4, B]}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, crank], angle: theta2}\n"
                              "  O4: {pin: [ground, rocker], angle: theta4}\n"
                              "  A: {pin: [crank, coupler], angle: alpha}\n"
                              "  B: {pin: [coupler, rocker]}\n"
                              "drives: {theta2: 3 + 2 rad/s * t}\n"
                              "start: {alpha: -3, theta4: 3}\n",
                              true);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    assert_non_null(d);
    YkChannel channel[4];
    for (size_t k = 0; k < 4; k++) channel[k] = machine_channel(&m, of[k]);
    for (size_t k = 0; k < 2 * TIMES; k++) {
        double off = time_of(k / 2) - 1, theta = YK_PI + 2 * off;
        if (off == 0) continue; // there, only a sweep past the pose tells the forces
        assert_true(yk_state_move_time(m.state, (theta - 3) / 2, NULL, NULL, m.problems) >= 0);
        assert_int_equal(yk_dynamics_solve(d, m.state, k % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED), YK_OK);
        double allowed = 1e-4 + 5e-9 / fabs(off); // errors of accelerations over the sine
        CHECK_NEAR(yk_dynamics_channel(d, m.state, channel[0]), 8 * cos(theta), allowed);
        CHECK_NEAR(yk_dynamics_channel(d, m.state, channel[1]), 8 * sin(theta), allowed);
        CHECK_NEAR(yk_dynamics_channel(d, m.state, channel[2]), -8 * cos(theta), allowed);
        CHECK_NEAR(yk_dynamics_channel(d, m.state, channel[3]), 0, allowed);
    }
    yk_dynamics_free(d);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moves_have_clear_rates),
        cmocka_unit_test(rows_have_clear_rates),
        cmocka_unit_test(forces_are_clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
