// The pose at a time, however late.
#include "machine.h"

#define FOUR_BAR(drive)                                                                                                \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n  crank: {points: {O: [0, 0], A: [1, 0]}}\n"                 \
    "  coupler: {points: {A: [0, 0], B: [3, 0]}}\n  rocker: {points: {Q: [0, 0], B: [3, 0]}}\n"                        \
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, coupler], angle: c}\n"                         \
    "  Q: {pin: [ground, rocker], angle: r}\n  B: {pin: [coupler, rocker]}\n"                                          \
    "drives: {q: " drive "}\nstart: {c: 0, r: 120 deg}\n"

static double rocker_at(Machine *m, double time)
{
    assert_int_equal(yk_state_set_time(m->state, time, m->problems), YK_OK);
    assert_int_equal(yk_state_solve(m->state), YK_OK);
    return yk_state_coordinate(m->state, yk_coordinate_find(m->mech, "r")).position;
}

static void a_pose_is_known_after_any_number_of_turns(void **unused)
{
    (void)unused;
    Machine m = machine_parse(FOUR_BAR("60 deg + 60 rpm * t"), true);
    double first = rocker_at(&m, 0);
    for (double t = 1; t < 1e60; t *= 10) CHECK_NEAR(rocker_at(&m, t), first, 1e-12);
    rocker_at(&m, 1e15);
    Machine other = machine_parse(FOUR_BAR("60 deg + 60 rpm * t"), true);
    assert_int_equal(yk_state_copy(m.state, m.state), YK_OK);
    yk_state_set_input(m.state, 0, (YkMotion){2, 0, 0}); // what was set last holds
    yk_state_set_input(other.state, 0, (YkMotion){2, 0, 0});
    assert_int_equal(yk_state_solve(m.state), YK_OK);
    assert_int_equal(yk_state_solve(other.state), YK_OK);
    CHECK_NEAR(yk_state_coordinate(m.state, 2).position, yk_state_coordinate(other.state, 2).position, 1e-15);
    machine_free(&m);
    machine_free(&other);
}

// A held position, velocity or acceleration replaces the drive's; the other two remain the drive's own.
static void what_is_held_replaces_the_drive(void **unused)
{
    (void)unused;
    for (int order = 0; order < 3; order++) {
        Machine m = machine_parse(FOUR_BAR("1 + 2 rad/s * t + 3 rad/s^2 * t^2"), true);
        double expected[] = {1 + 2 * 0.1 + 3 * 0.01, 2 + 6 * 0.1, 6};
        yk_state_hold_input(m.state, 0, order, 0.875);
        expected[order] = 0.875;
        assert_int_equal(yk_state_set_time(m.state, 0.1, m.problems), YK_OK);
        assert_int_equal(yk_state_solve(m.state), YK_OK);
        YkMotion q = yk_state_coordinate(m.state, yk_coordinate_find(m.mech, "q"));
        CHECK_NEAR(q.position, expected[0], 1e-15);
        CHECK_NEAR(q.velocity, expected[1], 1e-15);
        CHECK_NEAR(q.acceleration, expected[2], 1e-14);
        machine_free(&m);
    }
}

// Rates up to 1e100 have an answer, larger ones a status: nothing overflows without a word.
static void rates_that_overflow_are_refused(void **unused)
{
    (void)unused;
    Machine m = machine_parse(FOUR_BAR("60 deg + 60 rpm * t"), true);
    const double rates[] = {1e90, 1e150, 1e300, -1e300};
    for (size_t k = 0; k < 4; k++) {
        yk_state_set_input(m.state, 0, (YkMotion){1, rates[k], 0});
        YkStatus status = yk_state_solve(m.state);
        assert_int_equal(status, k == 0 ? YK_OK : YK_BAD_ARGUMENT);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++) {
            YkMotion motion = yk_state_coordinate(m.state, c);
            assert_true(isfinite(motion.velocity) && isfinite(motion.acceleration));
        }
    }
    yk_state_set_input(m.state, 0, (YkMotion){1, 0, 1e300});
    assert_int_equal(yk_state_solve(m.state), YK_BAD_ARGUMENT);
    machine_free(&m);
}

// The text of the first problem after setting the time; NULL where there is none.
static YkStatus set_late(const char *text, double time, int *code)
{
    Machine m = machine_parse(text, true);
    YkStatus status = yk_state_set_time(m.state, time, m.problems);
    size_t count = yk_problems_count(m.problems);
    *code = count > 0 ? yk_problems_get(m.problems, count - 1)->code : 0;
    machine_free(&m);
    return status;
}

static void digits_that_are_lost_are_told(void **unused)
{
    (void)unused;
    const char *sine = FOUR_BAR("sin(1e9 rad/s * t)");
    int code;
    assert_int_equal(set_late(sine, 1e-3, &code), YK_OK);
    assert_int_equal(code, 0);
    assert_int_equal(set_late(sine, 1e3, &code), YK_OK);
    assert_int_equal(code, YK_CODE_DRIVE_UNSURE);
    assert_true(set_late(sine, 1e9, &code) < 0);
    assert_int_equal(code, YK_CODE_DRIVE_UNKNOWN);
}

// `start:` gives rates to what nothing else moves: a drive's rate is its own, and what follows has the motion's.
static void rates_at_the_start_are_of_free_inputs(void **unused)
{
    (void)unused;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0], Q: [3, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}}\n"
        "  b: {points: {A: [0, 0], B: [3, 0]}}\n  c: {points: {Q: [0, 0], B: [1, 0]}}\n"
        "  d: {points: {B: [0, 0]}}\njoints:\n  O: {pin: [ground, a], angle: th}\n"
        "  A: {pin: [a, b], angle: u}\n  Q: {pin: [ground, c], angle: ps}\n"
        "  B: {pin: [b, c]}\n  D: {pin: [c, d], at: B, angle: de}\n"
        "%sstart: {th: 1, th.rate: 5, ps: 1, ps.rate: 7, u: -1, de: 0.2, de.rate: 0.7}\n";
    for (int is_driven = 0; is_driven < 2; is_driven++) {
        char whole[1000];
        snprintf(whole, sizeof whole, text, is_driven ? "drives: {th: 1 + 2*t/(1 s)}\n" : "");
        Machine m = machine_parse(whole, false);
        assert_int_equal(yk_state_set_time(m.state, 0, m.problems), YK_OK);
        assert_true(yk_state_assemble(m.state) >= 0);
        CHECK_NEAR(machine_ask(&m, "th.rate"), is_driven ? 2 : 5, 0);
        CHECK_NEAR(machine_ask(&m, "ps.rate"), is_driven ? 2 : 5, 1e-14); // a parallelogram
        CHECK_NEAR(machine_ask(&m, "de.rate"), 0.7, 0);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pose_is_known_after_any_number_of_turns),
        cmocka_unit_test(what_is_held_replaces_the_drive),
        cmocka_unit_test(rates_that_overflow_are_refused),
        cmocka_unit_test(rates_at_the_start_are_of_free_inputs),
        cmocka_unit_test(digits_that_are_lost_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
