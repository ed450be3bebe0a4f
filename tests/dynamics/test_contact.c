// Stops and dry friction against closed forms.
#include "run.h"

// Impacts of a falling block with restitution e: the k-th at T (1 + 2 e + ... + 2 e^k), T = sqrt(2 h / g).
static void a_bouncing_block_lands_when_it_must(void **unused)
{
    (void)unused;
    Run run = run_of_example("bouncing-block", run_options(1e-11));
    assert_int_equal(yk_simulation_advance(run.sim, 3.5), YK_OK);
    double T = sqrt(2 / 9.81), at = T, e = 0.8, part = 1;
    assert_true(yk_simulation_happening_count(run.sim) >= 8);
    for (size_t k = 0; k < 8; k++) {
        YkHappening h = yk_simulation_happening(run.sim, k);
        assert_int_equal(h.kind, YK_HAPPENING_STOP);
        CHECK_NEAR(h.time, at, 1e-11);
        CHECK_NEAR(h.value, -9.81 * T * part, 1e-9);
        part *= e;
        at += 2 * T * part;
    }
    run_free(&run);
}

// After infinitely many bounces, at T (1 + e)/(1 - e), it lies still on the stop, which carries its weight.
static void bouncing_ends_at_rest(void **unused)
{
    (void)unused;
    Run run = run_of_example("bouncing-block", run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 5), YK_OK);
    CHECK_NEAR(run_value(&run, "h"), 0, 1e-9);
    CHECK_NEAR(run_value(&run, "h.rate"), 0, 1e-9);
    CHECK_NEAR(run_value(&run, "h.accel"), 0, 1e-12);
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.energy_error < 1e-9);
    run_free(&run);
}

// Coulomb 1785: each half swing takes 2 mu m g / k from the amplitude and lasts pi sqrt(m / k); then it sticks.
static void a_block_on_a_rough_floor_comes_to_rest(void **unused)
{
    (void)unused;
    Run run = run_of_example("rough-block", run_options(1e-11));
    double half = acos(-1) * sqrt(1.0 / 100), lost = 2 * 0.3 * 1 * 10 / 100;
    for (int k = 1; k <= 3; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, half * k), YK_OK);
        CHECK_NEAR(run_value(&run, "x"), (k % 2 ? -1 : 1) * (0.2 - k * lost), 1e-9);
    }
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
    CHECK_NEAR(run_value(&run, "x"), -0.02, 1e-9);
    CHECK_NEAR(run_value(&run, "x.rate"), 0, 1e-15);
    size_t n = yk_simulation_happening_count(run.sim);
    assert_int_equal(n, 1); // the turns in between are no rests
    YkHappening last = yk_simulation_happening(run.sim, n - 1);
    assert_int_equal(last.kind, YK_HAPPENING_STICK);
    CHECK_NEAR(last.time, 3 * half, 1e-9);
    run_free(&run);
}

// On a table that shakes as A sin(w t) the block slips where A w^2 |sin| passes mu g.
static void a_block_slips_on_a_shaking_table(void **unused)
{
    (void)unused;
    Run run = run_of_example("shaking-table", run_options(1e-11));
    assert_int_equal(yk_simulation_advance(run.sim, 0.3), YK_OK);
    double slip = asin(3.0 / 5) / 10, t = 0.3, u = t - slip;
    YkHappening first = yk_simulation_happening(run.sim, 0);
    assert_int_equal(first.kind, YK_HAPPENING_SLIP);
    CHECK_NEAR(first.time, slip, 1e-4);
    // the table goes A sin(w t); the block, slowed by mu g from the slip on
    double table = 0.05 * sin(10 * t), x0 = 0.05 * sin(10 * slip), v0 = 0.5 * cos(10 * slip);
    CHECK_NEAR(run_value(&run, "x"), x0 + v0 * u - 0.5 * 3 * u * u - table, 1e-8);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-7);
    run_free(&run);
}

// Two blocks in a row against a wall: the blow on one passes through the joint to both.
static void a_blow_passes_through_the_loops(void **unused)
{
    (void)unused;
    const char *text =
        "bodies:\n  ground: {points: {A: [0, 0]}}\n  arm: {points: {A: [0, 0], B: [1, 0]}, mass: 3, rod: [A, B]}\n"
        "  end: {points: {B: [0, 0]}, mass: 1, inertia: 0.5}\n"
        "joints:\n  A: {pin: [ground, arm], angle: x}\n  B: {pin: [arm, end], angle: y}\n"
        "start: {x: 0, y: 0, x.rate: 2, y.rate: -2}\nstops: {x: [-1, 1]}\n";
    Run run = run_of_text(text, run_options(1e-11));
    assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
    CHECK_NEAR(run_value(&run, "x"), 1, 1e-9);
    CHECK_NEAR(run_value(&run, "x.rate"), 0, 1e-9);
    CHECK_NEAR(run_value(&run, "end.rate"), 0, 1e-9); // its own pin gives it no moment: it did not turn and does not
    // arm: 3/3, end: 1 at radius 1; all of 1/2 (1 + 1) 2^2 is lost
    size_t stops = yk_simulation_work_count(run.sim) - 1;
    CHECK_NEAR(yk_simulation_work(run.sim, stops), -4, 1e-8);
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bouncing_block_lands_when_it_must),    cmocka_unit_test(bouncing_ends_at_rest),
        cmocka_unit_test(a_block_on_a_rough_floor_comes_to_rest), cmocka_unit_test(a_block_slips_on_a_shaking_table),
        cmocka_unit_test(a_blow_passes_through_the_loops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
