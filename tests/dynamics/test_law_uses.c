// Laws whose range is left: which poses of a machine are outside, against closed forms.
#include "rig.h"

static const double r = 0.05, l = 0.18, PI = 3.14159265358979323846;

// A slider-crank whose ram works against a table from 150 mm to 200 mm.
static Rig press(const char *law)
{
    char text[1200];
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground: {points: {O: [0, 0]}}\n"
             "  crank:  {points: {O: [0, 0], A: [50 mm, 0]}}\n"
             "  rod:    {points: {A: [0, 0], B: [180 mm, 0]}}\n"
             "  ram:    {points: {B: [0, 0]}, mass: 2 kg}\n"
             "joints:\n"
             "  O: {pin: [ground, crank], angle: theta}\n"
             "  A: {pin: [crank, rod], angle: phi}\n"
             "  B: {pin: [rod, ram]}\n"
             "  S: {slide: [ground, ram], along: x, distance: s}\n"
             "drives: {theta: 60 deg + 10 rad/s * t}\n"
             "laws: {cutting: %s}\n"
             "efforts: {s: {law: cutting, of: s}}\n"
             "start: {phi: -75 deg, s: 200 mm}\n",
             law);
    return rig_of_text(text);
}

static void put(Rig *rig, double theta)
{
    yk_state_set_input(rig->state, 0, (YkMotion){theta, 10, 0});
    assert_true(yk_state_solve(rig->state) >= 0);
}

static void poses_outside_are_those_of_the_closed_form(void **unused)
{
    (void)unused;
    Rig rig = press("{between: linear, table: [[150 mm, 100 N], [200 mm, 500 N]]}");
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    size_t outside = 0;
    assert_non_null(watch);
    for (int k = 0; k < 360; k++) {
        double theta = k * PI / 180, s = r * cos(theta) + sqrt(l * l - r * r * sin(theta) * sin(theta));
        bool is_outside = s < 0.15 || s > 0.2;
        put(&rig, theta);
        assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, theta), is_outside);
        outside += is_outside;
        YkStatus status = yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED); // what the law keeps is used
        size_t c = yk_coordinate_find(rig.mech, "s");
        double effort = 100 + 400 * (fmin(fmax(s, 0.15), 0.2) - 0.15) / 0.05;
        if (status == YK_OK) CHECK_NEAR(yk_dynamics_effort(rig.dynamics, c), effort, 1e-9);
    }
    YkLawLeft left = yk_law_watch_get(watch, 0);
    assert_true(outside > 100 && outside < 300);
    assert_int_equal(yk_law_watch_count(watch), 1);
    assert_int_equal(left.poses, outside);
    assert_string_equal(left.law, "cutting");
    assert_string_equal(left.name, "s");
    assert_int_equal(left.user, YK_LAW_USER_EFFORT);
    assert_int_equal(left.place.line, 13);
    assert_true(left.at == 0); // the first pose, which stands at 230 mm
    CHECK_NEAR(left.argument, r + l, 1e-12);
    CHECK_NEAR(left.value, 500, 1e-9);
    CHECK_NEAR(left.from, 0.15, 1e-15);
    CHECK_NEAR(left.to, 0.2, 1e-15);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

// The ends themselves belong to the range, also after rounding.
static void an_end_is_not_left(void **unused)
{
    (void)unused;
    Rig rig = press("{between: linear, table: [[130 mm, 100 N], [230 mm, 500 N]]}");
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    for (int k = 0; k < 720; k++) {
        put(&rig, k * PI / 360);
        assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), 0);
    }
    assert_int_equal(yk_law_watch_count(watch), 0);
    assert_null(yk_law_watch_get(watch, 0).law);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

static void a_law_with_a_period_is_never_left(void **unused)
{
    (void)unused;
    Rig rig = press("{period: 50 mm, table: [[150 mm, 100 N], [170 mm, 500 N], [200 mm, 100 N]]}");
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    for (int k = 0; k < 36; k++) {
        put(&rig, k * PI / 18);
        assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), 0);
    }
    yk_law_watch_free(watch);
    rig_free(&rig);
}

// Without the dynamics the loads do not enter the answer.
static void loads_matter_only_for_forces(void **unused)
{
    (void)unused;
    Rig rig = press("{table: [[150 mm, 100 N], [200 mm, 500 N]]}");
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    put(&rig, 0);
    assert_int_equal(yk_law_watch_look(watch, rig.state, NULL, 0), 0);
    assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), 1);
    yk_dynamics_set_effort(rig.dynamics, yk_coordinate_find(rig.mech, "s"), 7); // the law is no longer in use
    assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), 0);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

static const char driven[] = "bodies: {ram: {mass: 2 kg}, arm: {inertia: 1 kg*m^2}}\n"
                             "joints:\n"
                             "  S: {slide: [ground, ram], along: x, distance: s}\n"
                             "  P: {pin: [ground, arm], angle: theta}\n"
                             "laws:\n"
                             "  lift: {table: [[0 s, 0 mm], [1 s, 30 mm], [2 s, 35 mm]]}\n"
                             "  follow: {table: [[0 mm, 0 deg], [20 mm, 30 deg]]}\n"
                             "drives: {s: {law: lift, of: 2*t}, theta: {law: follow, of: s}}\n";

static void drives_are_left_in_time_and_along_others(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(driven);
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    for (int k = -4; k <= 20; k++) {
        double t = 0.1 * k, lift[5];
        assert_int_equal(yk_state_set_time(rig.state, t, rig.problems), YK_OK);
        assert_true(yk_state_solve(rig.state) >= 0);
        yk_law_eval(rig.model->laws[0].law, 2 * t, lift);
        size_t outside = (2 * t < 0 || 2 * t > 2) + (lift[0] > 0.02);
        assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, t), outside);
    }
    assert_int_equal(yk_law_watch_count(watch), 2);
    assert_string_equal(yk_law_watch_get(watch, 0).name, "s");
    assert_true(yk_law_watch_get(watch, 0).argument < 0); // the first pose
    assert_string_equal(yk_law_watch_get(watch, 1).name, "theta");
    assert_int_equal(yk_law_watch_get(watch, 1).user, YK_LAW_USER_DRIVE);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

static void a_drive_that_is_replaced_is_not_left(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(driven);
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    assert_int_equal(yk_state_set_time(rig.state, 3, rig.problems), YK_OK);
    yk_state_set_input(rig.state, 0, (YkMotion){0.01, 0, 0});
    assert_true(yk_state_solve(rig.state) >= 0);
    assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 3), 0);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

// A spring's own length and rate, and the components of a force.
static void springs_and_forces_are_seen(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("bodies: {ground: {points: {O: [0, 0.3]}}, ram: {points: {B: [0, 0]}, mass: 2 kg}}\n"
                          "joints: {S: {slide: [ground, ram], along: x, distance: s}}\n"
                          "laws:\n"
                          "  pull: {table: [[0.3 m, 0 N], [0.5 m, 20 N]]}\n"
                          "  brake: {table: [[-1 m/s, -5 N], [1 m/s, 5 N]]}\n"
                          "springs: {coil: {between: [ground.O, ram.B], force: {law: pull, of: length}}}\n"
                          "forces: {wind: {body: ram, at: B, value: [{law: brake, of: s.rate}, 1 N]}}\n"
                          "start: {s: 0, s.rate: 0}\n");
    const double cases[][2] = {{0.1, 0.5}, {0.39, -1}, {0.41, 0}, {-0.41, 1.1}, {0.2, -3}};
    for (size_t k = 0; k < 5; k++) {
        YkLawWatch *watch = yk_law_watch_new(rig.model);
        double s = cases[k][0], rate = cases[k][1], length = sqrt(s * s + 0.09);
        yk_state_set_input(rig.state, 0, (YkMotion){s, rate, 0});
        assert_true(yk_state_solve(rig.state) >= 0);
        size_t outside = (size_t)(length > 0.5) + (fabs(rate) > 1);
        assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), outside);
        if (length > 0.5) CHECK_NEAR(yk_law_watch_get(watch, outside - 1).argument, length, 1e-14);
        if (fabs(rate) > 1) CHECK_NEAR(yk_law_watch_get(watch, 0).argument, rate, 1e-14);
        yk_law_watch_free(watch);
    }
    rig_free(&rig);
}

// The same at ends on either side of zero: rounding is a part of the range's length.
static void a_range_may_lie_on_either_side_of_zero(void **unused)
{
    (void)unused;
    static const double ranges[][2] = {{-0.3, -0.1}, {-0.2, 0.2}, {0.1, 0.3}};
    for (size_t k = 0; k < 3; k++) {
        char text[600];
        double from = ranges[k][0], to = ranges[k][1];
        snprintf(text, sizeof text,
                 "bodies: {ram: {mass: 2 kg}}\njoints:\n  S: {slide: [ground, ram], along: x, distance: s}\n"
                 "laws: {cutting: {table: [[%.17g m, 100 N], [%.17g m, 500 N]]}}\n"
                 "efforts: {s: {law: cutting, of: s}}\n",
                 from, to);
        Rig rig = rig_of_text(text);
        YkLawWatch *watch = yk_law_watch_new(rig.model);
        const double cases[][2] = {{from, 0},        {to, 0},        {from - 1e-13, 0}, {to + 1e-13, 0},
                                   {from - 1e-7, 1}, {to + 1e-7, 1}, {from + 1e-7, 0},  {to - 1e-7, 0}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            yk_state_set_input(rig.state, 0, (YkMotion){cases[i][0], 0, 0});
            assert_true(yk_state_solve(rig.state) >= 0);
            assert_int_equal(yk_law_watch_look(watch, rig.state, rig.dynamics, 0), cases[i][1]);
        }
        yk_law_watch_free(watch);
        rig_free(&rig);
    }
}

// A simulation reports the end at which it left a range: the use of that name remembers it, once.
static void what_a_simulation_left_is_remembered(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(driven);
    YkLawWatch *watch = yk_law_watch_new(rig.model);
    yk_law_watch_note(watch, NULL, 2, 1);
    yk_law_watch_note(watch, "phi", 0.02, 1); // no such use
    yk_law_watch_note(watch, "s", 1.5, 1);    // within the range
    yk_law_watch_note(watch, "theta", 0.01, 1);
    assert_int_equal(yk_law_watch_count(watch), 0);
    yk_law_watch_note(watch, "theta", 0.02, 1.25);
    assert_int_equal(yk_law_watch_count(watch), 1);
    yk_law_watch_note(watch, "theta", 0, 1.75); // the first stays
    YkLawLeft left = yk_law_watch_get(watch, 0);
    assert_string_equal(left.name, "theta");
    assert_string_equal(left.law, "follow");
    assert_int_equal(left.poses, 1);
    assert_true(left.at == 1.25 && left.argument == 0.02);
    CHECK_NEAR(left.value, PI / 6, 1e-15);
    yk_law_watch_note(watch, "s", 0, -0.5);
    assert_int_equal(yk_law_watch_count(watch), 2);
    assert_string_equal(yk_law_watch_get(watch, 0).name, "s"); // in the order of the file
    assert_true(yk_law_watch_get(watch, 0).at == -0.5);
    yk_law_watch_free(watch);
    rig_free(&rig);
}

static void nothing_is_survived(void **unused)
{
    (void)unused;
    assert_null(yk_law_watch_new(NULL));
    yk_law_watch_free(NULL);
    assert_int_equal(yk_law_watch_look(NULL, NULL, NULL, 0), 0);
    assert_int_equal(yk_law_watch_count(NULL), 0);
    assert_null(yk_law_watch_get(NULL, 3).law);
    yk_law_watch_note(NULL, "x", 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(poses_outside_are_those_of_the_closed_form),
        cmocka_unit_test(an_end_is_not_left),
        cmocka_unit_test(a_law_with_a_period_is_never_left),
        cmocka_unit_test(loads_matter_only_for_forces),
        cmocka_unit_test(drives_are_left_in_time_and_along_others),
        cmocka_unit_test(a_drive_that_is_replaced_is_not_left),
        cmocka_unit_test(springs_and_forces_are_seen),
        cmocka_unit_test(a_range_may_lie_on_either_side_of_zero),
        cmocka_unit_test(what_a_simulation_left_is_remembered),
        cmocka_unit_test(nothing_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
