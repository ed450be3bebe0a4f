// Extremes beside change points: each lies on the swept branch, where the closed form has it, and a channel that is
// constant but for rounding has none.
#include "solve/machine.h"

// Two or three equal cranks with a rod that keeps its direction; the whole is turned by `tilt`, so that the cranks and
// the rod lie in line a little off the places where points of the rod turn round.
static Machine tilted(double tilt, bool has_third, double base)
{
    char text[1500], third[200];
    double c = cos(tilt), s = sin(tilt);
    snprintf(third, sizeof third, "  O3: {pin: [ground, third], angle: theta3}\n  A3: {pin: [rod, third]}\n");
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground: {points: {O1: [0, 0], O2: [%.17g, %.17g], O3: [%.17g, %.17g]}}\n"
             "  crank: {points: {O1: [0, 0], A1: [0.5, 0]}}\n"
             "  second: {points: {O2: [0, 0], A2: [0.5, 0]}}\n"
             "  rod: {points: {A1: [0, 0], A2: [%.17g, 0], A3: [4, 0.5]}}\n"
             "%s"
             "joints:\n"
             "  O1: {pin: [ground, crank], angle: theta}\n"
             "  A1: {pin: [crank, rod], angle: phi}\n"
             "  O2: {pin: [ground, second], angle: theta2}\n"
             "  A2: {pin: [rod, second]}\n"
             "%s"
             "drives: {theta: 1 + 1 rad/s * t}\n"
             "start: {phi: %.17g, theta2: 1%s}\n",
             base * c, base * s, 4 * c - 0.5 * s, 4 * s + 0.5 * c, base,
             has_third ? "  third: {points: {O3: [0, 0], A3: [0.5, 0]}}\n" : "", has_third ? third : "", tilt - 1,
             has_third ? ", theta3: 1" : "");
    return machine_parse(text, true);
}

// turns: 1 or -1, the way of the sweep. Where all links are equal, as in a rhombus, no angle of a dyad is determined at
// one of the change points.
static void check_extremes(double tilt, bool has_third, bool is_rhombus, double from, double turns, size_t steps)
{
    double base = is_rhombus ? 0.5 : 1.5;
    static const char *const of[] = {"rod.angle", "rod.A3.x", "rod.A2.y", "theta2"};
    Machine m = tilted(tilt, has_third, base);
    YkSweep *sweep = machine_sweep(&m, "theta", from, from + turns * 2 * YK_PI, steps, of, 4);
    assert_int_equal(yk_sweep_status(sweep), YK_OK);
    size_t found[4] = {0};
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent e = yk_sweep_event(sweep, k);
        if (e.kind != YK_EVENT_EXTREME) continue;
        found[e.channel]++;
        double due = e.channel == 1 ? 0.5 * (e.is_maximum ? 1 : -1) + 4 * cos(tilt) - 0.5 * sin(tilt)
                                    : 0.5 * (e.is_maximum ? 1 : -1) + base * sin(tilt);
        if (!(fabs(e.value - due) < 1e-10))
            print_error("tilt %.17g, from %.17g, %zu steps: extreme %g of %s at %.17g, due %g\n", tilt, from, steps,
                        e.value, of[e.channel], e.at, due);
        CHECK_NEAR(e.value, due, 1e-10);
        CHECK_NEAR(e.channel == 1 ? sin(e.at) : cos(e.at), 0, 1e-7);
    }
    if (found[0] || found[1] != 2 || found[2] != 2 || found[3])
        print_error("tilt %.17g, from %.17g, %zu steps: %zu of an angle that stays, %zu, %zu, %zu\n", tilt, from, steps,
                    found[0], found[1], found[2], found[3]);
    assert_true(found[0] == 0 && found[1] == 2 && found[2] == 2 && found[3] == 0);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_extremes_beside_change_points_are_those_of_the_motion(void **unused)
{
    (void)unused;
    uint64_t seed = 20261128;
    for (uint64_t k = 0; k < check_cases(60); k++) {
        double tilt = check_uniform(&seed, -0.03, 0.03) + (k % 4 == 3 ? YK_PI / 2 : 0);
        double from = check_uniform(&seed, 1, 1.2);
        check_extremes(tilt, k % 2, k % 6 > 3 && k % 2 == 0, from, k % 5 < 3 ? 1 : -1, 1 + k % 3 * 60);
    }
}

// Rows so near to the change points that rates are known to few digits.
static void test_a_channel_that_stays_has_no_extremes_beside_change_points(void **unused)
{
    (void)unused;
    for (double off = 1e-2; off > 1e-6; off *= 0.3)
        for (int third = 0; third < 2; third++) {
            check_extremes(0, third, false, YK_PI / 3 + off, 1, 6);
            check_extremes(0, third, false, YK_PI / 3 - off, 1, 6);
            check_extremes(0, third, false, YK_PI / 3 + off, -1, 6);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_extremes_beside_change_points_are_those_of_the_motion),
        cmocka_unit_test(test_a_channel_that_stays_has_no_extremes_beside_change_points)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
