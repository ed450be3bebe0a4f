// Cams that would have to pull their followers: the times against closed forms.
#include "tappet.h"

// A harmonic lift h (1 - cos theta)/2 under a spring of stiffness c, compressed by p at the bottom, and weight. The cam
// turns at w; nothing presses the follower on it where m w^2 h/2 cos theta + c (h/2 (1 - cos theta) + p) + m g = 0.
static const double h = 0.012, c = 4000, p = 0.02, m = 0.3, g = 9.81, w = 300;

static Run run_of(const char *cam, double stiffness, const char *start)
{
    char rest[200];
    snprintf(rest, sizeof rest,
             "drives: {theta: %s + 300 rad/s * t}\n"
             "springs: {k: {along: s, stiffness: %g N/m, length: -20 mm}}\n",
             start, stiffness);
    return run_of_tappet(cam, "", rest, 1e-10);
}

static double first_angle(void)
{
    return acos(-(c * (h / 2 + p) + m * g) / (h / 2 * (m * w * w - c)));
}

// Lists the lift-offs, and returns how many there are.
static size_t lift_offs(const Run *run, YkHappening *lift)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_simulation_happening_count(run->sim); k++)
        if (yk_simulation_happening(run->sim, k).kind == YK_HAPPENING_LIFT_OFF)
            lift[count++] = yk_simulation_happening(run->sim, k);
    return count;
}

static void every_turn_has_its_lift_off(void **unused)
{
    (void)unused;
    YkHappening lift[20];
    Run run = run_of("", c, "0 rad");
    assert_int_equal(yk_simulation_advance(run.sim, 0.1), YK_OK);
    assert_int_equal(lift_offs(&run, lift), 5); // 30 rad: theta + 2 pi n for n = 0 ... 4
    for (size_t k = 0; k < 5; k++) {
        double angle = first_angle() + 2 * acos(-1) * (double)k;
        assert_string_equal(lift[k].name, "heart");
        CHECK_NEAR(lift[k].time, angle / w, 1e-10);
        CHECK_NEAR(lift[k].value, angle, 1e-8);
    }
    run_free(&run);
}

static void a_start_without_contact_is_told(void **unused)
{
    (void)unused;
    Run run = run_of("", c, "200 deg");
    assert_int_equal(yk_simulation_advance(run.sim, 0), YK_OK); // the first row shows the flight
    CHECK_NEAR(run_value(&run, "heart.force"), 0, 0);
    CHECK_NEAR(run_value(&run, "s.accel"), -g - c / m * (p + h / 2 * (1 - cos(200 * acos(-1) / 180))), 1e-9);
    assert_int_equal(yk_simulation_advance(run.sim, 0.004), YK_OK);
    assert_int_equal(yk_simulation_happening(run.sim, 0).kind, YK_HAPPENING_LIFT_OFF);
    assert_true(yk_simulation_happening(run.sim, 0).time == 0);
    run_free(&run);
}

static void what_is_held_or_pressed_stays(void **unused)
{
    (void)unused;
    Run groove = run_of(", groove: true", c, "0 rad"), strong = run_of("", 20000, "0 rad");
    assert_int_equal(yk_simulation_advance(groove.sim, 0.1), YK_OK);
    assert_int_equal(yk_simulation_advance(strong.sim, 0.1), YK_OK);
    assert_int_equal(yk_simulation_happening_count(groove.sim), 0);
    assert_int_equal(yk_simulation_happening_count(strong.sim), 0);
    run_free(&groove);
    run_free(&strong);
}

// The rows that are asked for do not matter, nor does saving in between.
static void rows_and_saving_change_nothing(void **unused)
{
    (void)unused;
    static char bytes[1 << 16];
    Run run = run_of("", c, "0 rad"), other = run_of("", c, "0 rad");
    assert_int_equal(yk_simulation_advance(run.sim, 0.02), YK_OK);
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes);
    assert_true(count > 0 && count <= sizeof bytes);
    assert_int_equal(yk_simulation_restore(other.sim, bytes, count), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.05), YK_OK);
    assert_int_equal(yk_simulation_advance(other.sim, 0.05), YK_OK);
    assert_true(yk_simulation_happening_count(run.sim) >= 2);
    assert_int_equal(yk_simulation_happening_count(other.sim), yk_simulation_happening_count(run.sim));
    for (size_t k = 0; k < yk_simulation_happening_count(run.sim); k++)
        assert_true(yk_simulation_happening(run.sim, k).time == yk_simulation_happening(other.sim, k).time);
    run_free(&run);
    run_free(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_turn_has_its_lift_off),
        cmocka_unit_test(a_start_without_contact_is_told),
        cmocka_unit_test(what_is_held_or_pressed_stays),
        cmocka_unit_test(rows_and_saving_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
