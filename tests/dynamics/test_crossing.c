// Through positions where two branches meet, on the one that momentum takes; and past dead points of a coordinate.
#include "base/vec.h"
#include "run.h"

// N parallelograms move as one angle: I phi'' = W sin(phi). Rows to 18 digits (validation case IFT-A2).
static void parallelograms_stay_parallelograms(void **unused)
{
    (void)unused;
    static const double rows[][3] = {{1, -0.195020301949435094, -0.980799205662173833},
                                     {5, -0.811310461005107412, -0.584615545348975548},
                                     {10, 0.328458111540815379, 0.944518538178600962},
                                     {20, 0.839746574306843547, 0.542978536352884662}};
    Run run = run_of_example("n-four-bar", run_options(1e-11));
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, rows[k][0]), YK_OK);
        CHECK_NEAR(run_value(&run, "link0.B0.x"), rows[k][1], 1e-7);
        CHECK_NEAR(run_value(&run, "link0.B0.y"), rows[k][2], 1e-7);
        CHECK_NEAR(run_value(&run, "rod2.angle"), 0, 1e-9); // no coupler ever turns
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

// A slider-crank whose first coordinate in the file is the slide: it comes to its dead points twice a turn.
static void dead_points_of_a_coordinate_are_passed(void **unused)
{
    (void)unused;
    const char *text =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, "
        "center: [0, 0]}\n"
        "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"
        "joints:\n  R: {slide: [ground, piston], along: x, distance: d}\n  O: {pin: [ground, crank], angle: q}\n"
        "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\n"
        "start: {d: 0.33, q: 60 deg, p: 160 deg, q.rate: 20 rad/s}\n";
    Run run = run_of_text(text, run_options(1e-11));
    for (int k = 1; k <= 50; k++) assert_int_equal(yk_simulation_advance(run.sim, 0.05 * k), YK_OK);
    assert_true(run_value(&run, "q") > 40); // several turns
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.recoordinations >= 1 && s.energy_error < 1e-8 && s.worst_residual < 1e-13);
    double q = run_value(&run, "q"), d = run_value(&run, "d"); // and it is the same assembly
    CHECK_NEAR(d, 0.1 * cos(q) + sqrt(0.09 - 0.01 * sin(q) * sin(q)), 1e-12);
    size_t count = yk_simulation_happening_count(run.sim); // one for each half turn of the crank
    assert_int_equal(count, (size_t)(q / YK_PI));
    Run again = run_of_text(text, run_options(1e-11));
    for (size_t k = 0; k < count; k++) { // where crank and rod are in line
        YkHappening happening = yk_simulation_happening(run.sim, k);
        assert_int_equal(happening.kind, YK_HAPPENING_DEAD_POINT);
        assert_string_equal(happening.name, "d");
        assert_int_equal(yk_simulation_advance(again.sim, happening.time), YK_OK);
        CHECK_NEAR(run_value(&again, "q"), YK_PI * (double)(k + 1), 1e-8);
    }
    run_free(&again);
    run_free(&run);
}

// A kite of equal neighbours folds flat: momentum carries it through on the branch it came by.
static void the_motion_is_smooth_through_a_change_point(void **unused)
{
    (void)unused;
    YkSimulationOptions options = run_options(1e-11);
    options.horizon = 2;
    Run run = run_of_example("n-four-bar", options);
    double last[3] = {0, 0, 0}, h = 1e-3;
    for (int k = 0; k <= 600; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, h * k), YK_OK);
        double rate = run_value(&run, "theta1.rate");
        if (k > 1) assert_true(fabs(rate - 2 * last[1] + last[0]) < 200 * h * h); // no kink
        last[0] = last[1];
        last[1] = rate;
    }
    run_free(&run);
}

// All flat where the first link lies on the line of the pivots; there each crossing is told, and angles stay continuous
// though the pose itself does not tell them.
static void change_points_are_told(void **unused)
{
    (void)unused;
    Run run = run_of_example("n-four-bar", run_options(1e-11));
    YkChannel angle = {0};
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run.sim));
    assert_int_equal(yk_channel_parse(mech, "theta0", &angle, NULL), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "flat", angle, 0, 0), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "flat", angle, -YK_PI, 0), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
    double flat[2] = {0}, passed[4] = {0};
    size_t flats = 0, passages = 0;
    for (size_t k = 0; k < yk_simulation_happening_count(run.sim); k++) {
        YkHappening happening = yk_simulation_happening(run.sim, k);
        if (happening.kind == YK_HAPPENING_CROSSING && flats < 2) flat[flats++] = happening.time;
        if (happening.kind == YK_HAPPENING_CHANGE_POINT && passages < 4) passed[passages++] = happening.time;
    }
    assert_true(flats == 2 && passages == 4); // two blocks, twice
    for (size_t k = 0; k < 4; k++) CHECK_NEAR(passed[k], flat[k / 2], 1e-6);
    CHECK_NEAR(run_value(&run, "theta2"), run_value(&run, "theta0"), 1e-9);
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelograms_stay_parallelograms),
        cmocka_unit_test(dead_points_of_a_coordinate_are_passed),
        cmocka_unit_test(change_points_are_told),
        cmocka_unit_test(the_motion_is_smooth_through_a_change_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
