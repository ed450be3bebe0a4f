// Stops and dry friction against closed forms.
#include "run.h"
#include "simulate/simulation.h"

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
    assert_int_equal(n, 1); // the turns in between are not rests
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
    CHECK_NEAR(first.time, slip, 1e-10);
    // the table goes A sin(w t); the block, slowed by mu g from the slip on
    double table = 0.05 * sin(10 * t), x0 = 0.05 * sin(10 * slip), v0 = 0.5 * cos(10 * slip);
    CHECK_NEAR(run_value(&run, "x"), x0 + v0 * u - 0.5 * 3 * u * u - table, 1e-10);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-9);
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

// --- the times at which contacts let go, meet and stick, as roots -----------------------------------

// The k-th happening is of this kind and name, at this time.
static void check_happening(const Run *run, size_t k, YkHappeningKind kind, const char *name, double time, double near)
{
    assert_true(k < yk_simulation_happening_count(run->sim));
    YkHappening h = yk_simulation_happening(run->sim, k);
    assert_int_equal(h.kind, kind);
    assert_string_equal(h.name, name);
    CHECK_NEAR(h.time, time, near);
}

static YkSimulationOptions far(double tolerance, double horizon)
{
    YkSimulationOptions options = run_options(tolerance);
    options.horizon = horizon; // steps as long as the motion lets them be
    return options;
}

#define BLOCK "bodies:\n  ground: {points: {O: [0, 0]}}\n  b: {points: {P: [0, 0]}, mass: 2}\n"

// A belt at v carries a block on a spring along until k x = mu m g, at t = mu m g / (k v); then the block swings about
// that place with amplitude v / w, and the belt slips below it.
static void a_belt_carries_a_block_until_the_spring_holds_it(void **unused)
{
    (void)unused;
    static const YkIntegrator steppers[] = {YK_INTEGRATOR_DOP853, YK_INTEGRATOR_SDIRK4, YK_INTEGRATOR_RK4};
    for (int k = 0; k < 3; k++) {
        YkSimulationOptions options = far(1e-9, 2);
        options.integrator = steppers[k];
        Run run =
            run_of_text("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  belt: {points: {O: [0, 0]}, "
                        "mass: 1}\n  b: {points: {P: [0, 0]}, mass: 2}\njoints:\n  B: {slide: [ground, belt], along: "
                        "x, distance: s}\n  S: {slide: [belt, b], along: x, distance: d, friction: {coulomb: 0.4}}\n"
                        "springs: {k: {between: [ground.O, b.P], stiffness: 50, length: 0}}\n"
                        "drives: {s: 0.25 m/s * t}\n",
                        options);
        double v = 0.25, w = 5, x = 0.4 * 2 * 10 / 50, slip = x / v;
        assert_int_equal(yk_simulation_advance(run.sim, slip + 0.9), YK_OK);
        check_happening(&run, 0, YK_HAPPENING_SLIP, "S", slip, 1e-10);
        assert_int_equal(yk_simulation_happening_count(run.sim), 1);
        CHECK_NEAR(run_value(&run, "b.P.x"), x + v / w * sin(w * 0.9), k == 0 ? 1e-9 : 1e-7);
        run_free(&run);
    }
}

// On an incline a force that grows in proportion to time pulls a block up once F = m g (sin a + mu cos a), and lets it
// slide down once F = m g (sin a - mu cos a).
static void a_block_on_an_incline_slips_either_way(void **unused)
{
    (void)unused;
    double a = 0.5, mu = 0.3, m = 2, g = 10;
    static const int sense[] = {1, -1};
    for (int k = 0; k < 2; k++) {
        char text[700];
        double mean = m * g * sin(a), rate = 3, slip = mu * m * g * cos(a) / rate, at = slip + 0.5;
        snprintf(text, sizeof text,
                 "gravity: [0, -10]\n" BLOCK
                 "joints:\n  S: {slide: [ground, b], along: 0.5 rad, distance: d, friction: "
                 "{coulomb: 0.3}}\nefforts: {d: %.17g N + %d N/s * t}\n",
                 mean, sense[k] * 3);
        Run run = run_of_text(text, far(1e-9, 100));
        assert_int_equal(yk_simulation_advance(run.sim, at), YK_OK);
        check_happening(&run, 0, YK_HAPPENING_SLIP, "S", slip, 1e-10);
        CHECK_NEAR(run_value(&run, "d"), sense[k] * rate * pow(0.5, 3) / 6 / m, 1e-10);
        run_free(&run);
    }
}

// A pendulum with Coulomb friction at its pin, whose force is the weight while it hangs still: a growing torque turns
// it once it exceeds mu R m g + m g l sin q.
static void a_pin_slips_under_the_force_that_it_carries(void **unused)
{
    (void)unused;
    Run run =
        run_of_text("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  b: {points: {O: [0, 0]}, mass: 2, "
                    "center: [0, -0.5], inertia: 0.1}\njoints:\n  O: {pin: [ground, b], angle: q, friction: {coulomb: "
                    "0.2, radius: 0.05 m}}\nefforts: {q: 3 N*m/s * t}\nstart: {q: 0.01}\n",
                    far(1e-9, 50));
    assert_int_equal(yk_simulation_advance(run.sim, 0.2), YK_OK);
    check_happening(&run, 0, YK_HAPPENING_SLIP, "O", (0.2 * 0.05 * 20 + 20 * 0.5 * sin(0.01)) / 3, 1e-10);
    run_free(&run);
}

// The impulse of F = 6.1 N sin^2(2 pi t) less a friction of 6 N, from 0 to t.
static double pulled(double t)
{
    double w = 2 * acos(-1);
    return 6.1 * (t / 2 - sin(2 * w * t) / (4 * w)) - 6 * t;
}

// At rest nothing makes steps short; a load that exceeds the friction for a twentieth of a second is not stepped over.
static void a_short_pull_is_not_overlooked(void **unused)
{
    (void)unused;
    Run run = run_of_text("gravity: [0, -10]\n" BLOCK
                          "joints:\n  S: {slide: [ground, b], along: x, distance: d, friction: {coulomb: 0.3}}\n"
                          "efforts: {d: 6.1 N * sin(2*pi*1 rad/s * t)^2}\n",
                          far(1e-11, 100));
    assert_int_equal(yk_simulation_advance(run.sim, 10), YK_OK);
    double slip = asin(sqrt(6 / 6.1)) / (2 * acos(-1)), low = 0.5 - slip, high = 0.5;
    for (int k = 0; k < 60; k++) { // it slows from low on, and stands once the impulse is used up
        double t = 0.5 * (low + high);
        *(pulled(t) > pulled(slip) ? &low : &high) = t;
    }
    assert_int_equal(yk_simulation_happening_count(run.sim), 40);
    for (size_t k = 0; k < 20; k++) {
        check_happening(&run, 2 * k, YK_HAPPENING_SLIP, "S", 0.5 * (double)k + slip, 1e-9);
        check_happening(&run, 2 * k + 1, YK_HAPPENING_STICK, "S", 0.5 * (double)k + low, 1e-9);
    }
    run_free(&run);
}

// A mass swings against a stop: hit at asin(gap/amplitude)/w. A growing pull lifts a weight off its stop at F = m g.
static void stops_are_met_and_left_when_they_must(void **unused)
{
    (void)unused;
    Run swing = run_of_text(BLOCK "joints:\n  S: {slide: [ground, b], along: x, distance: d}\nsprings: {k: {along: d, "
                                  "stiffness: 50, length: 0}}\nstart: {d.rate: 1}\nstops: {d: {between: [-1, 0.15], "
                                  "restitution: 1}}\n",
                            far(1e-11, 10));
    assert_int_equal(yk_simulation_advance(swing.sim, 3), YK_OK);
    double hit = asin(0.15 * 5) / 5,
           between = (acos(-1) + 2 * asin(0.15 * 5)) / 5; // half a period is left out each time
    for (size_t k = 0; k < 3; k++) check_happening(&swing, k, YK_HAPPENING_STOP, "d", hit + (double)k * between, 1e-10);
    run_free(&swing);
    Run lift =
        run_of_text("gravity: [0, -10]\n" BLOCK "joints:\n  S: {slide: [ground, b], along: y, distance: d}\nstops: {d: "
                    "[0, 5]}\nefforts: {d: 8 N/s * t}\n",
                    far(1e-9, 100));
    assert_int_equal(yk_simulation_advance(lift.sim, 3.5), YK_OK);
    check_happening(&lift, 0, YK_HAPPENING_RELEASE, "d", 2.5, 1e-11);
    CHECK_NEAR(run_value(&lift, "d"), 8 * 1 / 6.0 / 2, 1e-10);
    run_free(&lift);
}

// A bar falls flat on two supports, held by none: both give their blow at once, so it rises flat. One after the other
// they would turn it.
static void a_bar_meets_two_stops_at_once(void **unused)
{
    (void)unused;
    static const double restitution[] = {1, 0.5, 0};
    for (int k = 0; k < 3; k++) {
        char text[1200];
        double e = restitution[k], T = sqrt(2 * 0.5 / 10), up = 0.5 * T, v = 10 * T;
        snprintf(
            text, sizeof text,
            "gravity: [0, -10]\nbodies:\n  ground: {points: {A: [0, 0], B: [1, 0]}}\n  a: {points: {A: [0, 0]}}\n"
            "  b: {points: {B: [0, 0]}}\n  bar: {points: {A: [0, 0], C: [0.5, 0]}, mass: 3, center: [0.5, 0], inertia: "
            "0.25}\njoints:\n  SA: {slide: [ground, a], along: y, from: A, distance: y}\n"
            "  SB: {slide: [ground, b], along: y, from: B, distance: z}\n  A: {pin: [a, bar]}\n"
            "  B: {pin-slot: [bar, b], at: B, from: A, along: x}\nstart: {y: 0.5, z: 0.5}\n"
            "stops: {y: {between: [0, 5], restitution: %g}, z: {between: [0, 5], restitution: %g}}\n",
            e, e);
        Run run = run_of_text(text, far(1e-11, 10));
        assert_int_equal(yk_simulation_advance(run.sim, T + up), YK_OK);
        check_happening(&run, 0, YK_HAPPENING_STOP, "y", T, 1e-11);
        check_happening(&run, 1, YK_HAPPENING_STOP, "z", T, 1e-11);
        double height = e > 0 ? e * v * up - 5 * up * up : 0;
        CHECK_NEAR(run_value(&run, "y"), height, 1e-10);
        CHECK_NEAR(run_value(&run, "z"), height, 1e-10);
        CHECK_NEAR(run_value(&run, "bar.rate"), 0, 1e-10);
        CHECK_NEAR(run_value(&run, "energy"), 15 * e * e, 1e-9);
        run_free(&run);
    }
}

// If the iteration over the contacts does not converge, it stops instead of answering.
static void an_exhausted_iteration_is_told(void **unused)
{
    (void)unused;
    Run run = run_of_text("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                          "  a: {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}\n"
                          "  b: {points: {A: [0, 0], B: [1, 0]}, mass: 1, rod: [A, B]}\n"
                          "joints:\n  O: {pin: [ground, a], angle: q}\n  A: {pin: [a, b], angle: p}\n"
                          "stops: {q: [0, 2], p: [0, 2]}\n",
                          run_options(1e-9));
    run.sim->sweeps_max = 1;
    assert_int_equal(yk_simulation_advance(run.sim, 1), YK_NOT_CONVERGED);
    assert_non_null(strstr(yk_simulation_report(run.sim)->message, "did not settle"));
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bouncing_block_lands_when_it_must),
        cmocka_unit_test(bouncing_ends_at_rest),
        cmocka_unit_test(a_block_on_a_rough_floor_comes_to_rest),
        cmocka_unit_test(a_block_slips_on_a_shaking_table),
        cmocka_unit_test(a_blow_passes_through_the_loops),
        cmocka_unit_test(a_belt_carries_a_block_until_the_spring_holds_it),
        cmocka_unit_test(a_block_on_an_incline_slips_either_way),
        cmocka_unit_test(a_pin_slips_under_the_force_that_it_carries),
        cmocka_unit_test(a_short_pull_is_not_overlooked),
        cmocka_unit_test(stops_are_met_and_left_when_they_must),
        cmocka_unit_test(a_bar_meets_two_stops_at_once),
        cmocka_unit_test(an_exhausted_iteration_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
