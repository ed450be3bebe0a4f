// Motions for which no step is small enough: the status is below 0, and the report says what the pose shows.
#include "run.h"

#define SLIDER_CRANK                                                                                                   \
    "parameters: {r: 0.1, l: 0.3}\n"                                                                                   \
    "joints:\n"                                                                                                        \
    "  O: {pin: [ground, crank], angle: q}\n"                                                                          \
    "  A: {pin: [crank, rod], angle: p}\n"                                                                             \
    "  B: {pin: [rod, ram]}\n"                                                                                         \
    "  R: {slide: [ground, ram], along: x, distance: x}\n"

// The ram is driven to where crank and rod lie in line, so gently that it would stop there, with the crank on either
// side.
static void check_dead_point(double side)
{
    char text[2000];
    snprintf(text, sizeof text, "%sstart: {q: %g deg, p: %g deg, e.rate: 1}\n",
             SLIDER_CRANK "  E: {pin: [ground, arm], angle: e}\n"
                          "bodies:\n"
                          "  ground: {points: {O: [0, 0], E: [1, 1]}}\n"
                          "  crank: {points: {O: [0, 0], A: [r, 0]}, mass: 1, inertia: 0.01, center: [0, 0]}\n"
                          "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                          "  ram: {points: {B: [0, 0]}, mass: 2, center: [0, 0]}\n"
                          "  arm: {points: {E: [0, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"
                          "drives: {x: 0.4 m - 0.05 m*(1 - t/(1 s))^4}\n",
             side * 60, side * -80);
    Run run = run_of_text(text, run_options(1e-9));
    YkStatus status = yk_simulation_advance(run.sim, 2);
    const YkReport *report = yk_simulation_report(run.sim);
    assert_true(status == YK_NOT_CONVERGED && status < 0);
    assert_int_equal(report->status, YK_SINGULAR);
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run.sim));
    assert_string_equal(yk_block_info(mech, (size_t)report->block).label, "B");
    assert_non_null(strstr(report->message, "dead point: joint `B` has a transmission angle of "));
    double q = run_value(&run, "q"), p = run_value(&run, "p"); // the angle at B's dyad, by hand
    assert_true(fabs(sin(q)) < 0.02 && fabs(0.1 * sin(q) + 0.3 * sin(q + p)) < 1e-12);
    assert_true(yk_simulation_time(run.sim) > 0.85 && yk_simulation_time(run.sim) < 1);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-5);       // what was told until there holds
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_NOT_CONVERGED); // and stays there
    assert_true(q * side > 0);
    run_free(&run);
}

static void a_dead_point_that_stops_the_motion_is_named(void **unused)
{
    (void)unused;
    check_dead_point(1);
    check_dead_point(-1);
}

// A ram pushes a crank without mass to its dead point. Its speed is constant; the angle from there on would be
// imaginary.
static void without_a_dead_point_the_fastest_coordinate_is_named(void **unused)
{
    (void)unused;
    Run run = run_of_text(SLIDER_CRANK "bodies:\n"
                                       "  ground: {points: {O: [0, 0]}}\n"
                                       "  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
                                       "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                                       "  ram: {points: {B: [0, 0]}, mass: 2, center: [0, 0]}\n"
                                       "start: {q: 90 deg, q.rate: -2, p: -110 deg}\n",
                          run_options(1e-9));
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_NOT_CONVERGED);
    assert_non_null(strstr(yk_simulation_report(run.sim)->message, "changes too fast (`"));
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run.sim));
    assert_int_equal(yk_simulation_report(run.sim)->block, -1);
    const char *fastest = NULL;
    double most = 0;
    for (size_t c = 0; c < yk_coordinate_count(mech); c++) {
        double rate = fabs(yk_state_coordinate(yk_simulation_state(run.sim), c).velocity);
        if (yk_coordinate_info(mech, c).is_distance) rate /= yk_mechanism_size(mech);
        if (rate > most) fastest = yk_coordinate_info(mech, c).name, most = rate;
    }
    char words[100];
    snprintf(words, sizeof words, "(`%s` moves at ", fastest);
    assert_non_null(strstr(yk_simulation_report(run.sim)->message, words));
    double x = sqrt(0.08), speed = 0.2; // at the start; the crank stands across
    CHECK_NEAR(yk_simulation_time(run.sim), (0.4 - x) / speed, 1e-6);
    CHECK_NEAR(run_value(&run, "x.rate"), speed, 1e-6);
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_dead_point_that_stops_the_motion_is_named),
                                       cmocka_unit_test(without_a_dead_point_the_fastest_coordinate_is_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
