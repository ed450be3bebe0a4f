// Requirements of every stepper, whatever its method: known answers, both directions, moving ends, dense output,
// quadratures, a right-hand side that fails.
#include "ode_problems.h"
#include <stdlib.h>

// Methods with options of like quality: about `tolerance` on a smooth problem.
static YkOdeOptions options_of(int k, double tolerance)
{
    static const YkOdeMethod method[] = {YK_ODE_DOP853, YK_ODE_SDIRK4, YK_ODE_RK4};
    YkOdeOptions options = with_tolerance(method[k], tolerance);
    options.fixed_step = 0.7 * sqrt(sqrt(tolerance));
    return options;
}
enum { METHODS = 3 };

static void closed_forms_are_met(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(2, options_of(k, 1e-8), oscillator, NULL);
        assert_int_equal(run(ode, 0, (double[]){1, 0}, 10), YK_ODE_OK);
        CHECK_NEAR(yk_ode_time(ode), 10, 0);
        CHECK_NEAR(yk_ode_state(ode)[0], cos(10), 1e-6);
        CHECK_NEAR(yk_ode_state(ode)[1], -sin(10), 1e-6);
        yk_ode_free(ode);

        Growth decay = {1, -1.5};
        ode = new_ode(1, options_of(k, 1e-8), growth, &decay);
        assert_int_equal(run(ode, 2, (double[]){3}, 4), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], 3 * exp(-3), 1e-6);
        yk_ode_free(ode);

        ode = new_ode(1, options_of(k, 1e-8), logistic, NULL);
        assert_int_equal(run(ode, 0, (double[]){0.1}, 5), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], logistic_answer(0.1, 5), 1e-6);
        yk_ode_free(ode);

        ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        assert_int_equal(run(ode, 0, (double[]){1}, 7), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(7)), 1e-6);
        yk_ode_free(ode);
    }
}

static void time_runs_backward_as_well(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        assert_int_equal(run(ode, 3, (double[]){exp(sin(3))}, -4), YK_ODE_OK);
        CHECK_NEAR(yk_ode_time(ode), -4, 0);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(-4)), 1e-6);
        assert_true(yk_ode_previous(ode) > -4);
        yk_ode_free(ode);
    }
}

static void forward_and_back_comes_home(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(4, options_of(k, 1e-9), kepler, NULL);
        double y[4];
        kepler_start(0.2, y);
        assert_int_equal(run(ode, 0, y, 5), YK_ODE_OK);
        double away[4];
        memcpy(away, yk_ode_state(ode), sizeof away);
        assert_true(fabs(away[0] - y[0]) > 0.1);
        assert_int_equal(run(ode, 5, away, 0), YK_ODE_OK);
        for (int j = 0; j < 4; j++) CHECK_NEAR(yk_ode_state(ode)[j], y[j], 2e-6);
        yk_ode_free(ode);
    }
}

static void the_rate_is_f_at_the_state_and_fresh(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-6), swinging, NULL);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){1}, 5, false), YK_ODE_OK);
        while (yk_ode_time(ode) < 5) {
            double expected;
            swinging(NULL, yk_ode_time(ode), yk_ode_state(ode), &expected);
            CHECK_NEAR(yk_ode_rate(ode)[0], expected, 0);
            assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        }
        yk_ode_free(ode);
    }
}

static void each_step_begins_where_the_last_one_ended(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(2, options_of(k, 1e-6), oscillator, NULL);
        yk_ode_start(ode, 1, (double[]){1, 0}, 6, false);
        CHECK_NEAR(yk_ode_previous(ode), 1, 0);
        double t = 1;
        size_t steps = 0;
        for (; t < 6; steps++) {
            assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
            CHECK_NEAR(yk_ode_previous(ode), t, 0);
            assert_true(yk_ode_time(ode) > t && yk_ode_time(ode) <= 6);
            t = yk_ode_time(ode);
        }
        assert_int_equal(yk_ode_counts(ode).steps, steps);
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK); // at the end there is nothing to do
        assert_int_equal(yk_ode_counts(ode).steps, steps);
        CHECK_NEAR(yk_ode_time(ode), 6, 0);
        yk_ode_free(ode);
    }
}

static void every_evaluation_is_counted(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(2, options_of(k, 1e-6), oscillator, NULL);
        yk_ode_start(ode, 0, (double[]){1, 0}, 6, false);
        assert_int_equal(yk_ode_counts(ode).evaluations, 1);
        run_on(ode, 6);
        YkOdeCounts counts = yk_ode_counts(ode);
        if (k == 0) // one for the starting step; 12 a step, 11 where the error says no
            assert_int_equal(counts.evaluations, 2 + 12 * counts.steps + 11 * counts.rejected);
        if (k == 2) assert_int_equal(counts.evaluations, 1 + 4 * counts.steps);
        assert_int_equal(counts.jacobians > 0, k == 1);
        yk_ode_free(ode);
    }
}

static void the_end_moves_nearer_and_farther(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){1}, 100, false), YK_ODE_OK);
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        yk_ode_set_end(ode, 2);
        assert_int_equal(run_on(ode, 2), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(2)), 1e-6);
        yk_ode_set_end(ode, 3.5);
        assert_int_equal(run_on(ode, 3.5), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(3.5)), 1e-6);
        yk_ode_free(ode);
    }
}

static void an_end_in_the_past_is_now(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (int back = 0; back < 2; back++) {
            double sign = back ? -1 : 1;
            YkOde *ode = new_ode(1, options_of(k, 1e-6), swinging, NULL);
            yk_ode_start(ode, 0, (double[]){1}, 9 * sign, false);
            assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
            double t = yk_ode_time(ode);
            assert_true(t * sign > 0);
            yk_ode_set_end(ode, t / 2);
            assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
            CHECK_NEAR(yk_ode_time(ode), t, 0);
            yk_ode_set_end(ode, (double)NAN); // no end at all: not taken
            yk_ode_set_end(ode, 5 * sign);
            assert_int_equal(run_on(ode, 5 * sign), YK_ODE_OK);
            CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(5 * sign)), 1e-4);
            yk_ode_free(ode);
        }
}

static void a_start_at_its_end_waits_for_another_end(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        assert_int_equal(yk_ode_start(ode, 1, (double[]){exp(sin(1))}, 1, false), YK_ODE_OK);
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        CHECK_NEAR(yk_ode_time(ode), 1, 0);
        yk_ode_set_end(ode, 0);
        assert_int_equal(run_on(ode, 0), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-6);
        yk_ode_free(ode);
    }
}

static void many_small_ends_do_not_spoil_the_answer(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        yk_ode_start(ode, 0, (double[]){1}, 0.01, false);
        for (int i = 1; i <= 300; i++) {
            yk_ode_set_end(ode, 0.01 * i);
            assert_int_equal(run_on(ode, 0.01 * i), YK_ODE_OK);
        }
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(3)), 1e-6);
        if (k < 2) assert_in_range(yk_ode_counts(ode).steps, 300, 330); // the length in use outlives the short ones
        yk_ode_free(ode);
    }
}

static void dense_output_agrees_between_the_ends_and_is_exact_at_them(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (int back = 0; back < 2; back++) {
            double sign = back ? -1 : 1, y[1], previous = 1;
            YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
            yk_ode_start(ode, 0, (double[]){1}, 6 * sign, false);
            assert_int_equal(yk_ode_dense(ode, 0, y), YK_ODE_OK); // before any step
            CHECK_NEAR(y[0], 1, 0);
            while (yk_ode_time(ode) != 6 * sign) {
                assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
                double a = yk_ode_previous(ode), b = yk_ode_time(ode);
                for (int i = 1; i < 8; i++) {
                    double t = a + (b - a) * i / 8;
                    assert_int_equal(yk_ode_dense(ode, t, y), YK_ODE_OK);
                    CHECK_NEAR(y[0], exp(sin(t)), 2e-6);
                }
                assert_int_equal(yk_ode_dense(ode, a, y), YK_ODE_OK);
                CHECK_NEAR(y[0], previous, 0);
                assert_int_equal(yk_ode_dense(ode, b, y), YK_ODE_OK);
                CHECK_NEAR(y[0], yk_ode_state(ode)[0], 0);
                previous = y[0];
            }
            yk_ode_free(ode);
        }
}

static void dense_output_is_continuous_at_the_ends(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-6), swinging, NULL);
        yk_ode_start(ode, 0, (double[]){1}, 6, false);
        for (int i = 0; i < 3; i++) yk_ode_step(ode);
        double a = yk_ode_previous(ode), b = yk_ode_time(ode), d = 1e-9 * (b - a), first, near, y;
        yk_ode_dense(ode, a, &first);
        yk_ode_dense(ode, a + d, &near);
        CHECK_NEAR(near, first, 1e-8);
        assert_true(near != first);
        yk_ode_dense(ode, b - d, &y);
        CHECK_NEAR(y, yk_ode_state(ode)[0], 1e-8);
        assert_true(y != yk_ode_state(ode)[0]);
        yk_ode_free(ode);
    }
}

static void dense_output_refuses_times_outside_the_step(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-6), swinging, NULL);
        double y = 17;
        yk_ode_start(ode, 0, (double[]){1}, 6, false);
        assert_int_equal(yk_ode_dense(ode, 0.5, &y), YK_ODE_FAILED);
        for (int i = 0; i < 3; i++) yk_ode_step(ode);
        double a = yk_ode_previous(ode), b = yk_ode_time(ode);
        const double outside[] = {a - 0.1 * (b - a), b + 0.1 * (b - a), -1, 100, (double)NAN, (double)INFINITY};
        for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
            assert_int_equal(yk_ode_dense(ode, outside[i], &y), YK_ODE_FAILED);
            CHECK_NEAR(y, 17, 0);
        }
        assert_int_equal(yk_ode_dense(ode, nextafter(b, 100), &y), YK_ODE_OK); // rounding is forgiven
        CHECK_NEAR(y, yk_ode_state(ode)[0], 0);
        yk_ode_free(ode);
    }
}

static void dense_output_does_not_disturb_the_run(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        double end[2], scratch[2];
        for (int look = 0; look < 2; look++) {
            YkOde *ode = new_ode(2, options_of(k, 1e-6), oscillator, NULL);
            yk_ode_start(ode, 0, (double[]){1, 0}, 6, false);
            while (yk_ode_time(ode) < 6) {
                assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
                for (int i = 1; look && i < 4; i++)
                    yk_ode_dense(ode, yk_ode_previous(ode) + (yk_ode_time(ode) - yk_ode_previous(ode)) * i / 4,
                                 scratch);
            }
            if (look) assert_memory_equal(end, yk_ode_state(ode), sizeof end);
            memcpy(end, yk_ode_state(ode), sizeof end);
            yk_ode_free(ode);
        }
    }
}

// Quadratures ride along: the same steps with and without, though the integral would need shorter ones.
static int with_rough_integral(void *context, double t, const double *y, double *dydt)
{
    dydt[2] = 1e6 * sin(40 * t);
    return oscillator(context, t, y, dydt);
}
static void quadratures_have_no_say_in_the_steps(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOdeOptions options = options_of(k, 1e-6);
        YkOde *alone = new_ode(2, options, oscillator, NULL);
        options.controlled = 2;
        YkOde *rough = new_ode(3, options, with_rough_integral, NULL);
        YkOde *smooth = new_ode(3, options, oscillator_with_integral, NULL);
        run(alone, 0, (double[]){1, 0}, 6);
        run(rough, 0, (double[]){1, 0, 0}, 6);
        run(smooth, 0, (double[]){1, 0, 0}, 6);
        assert_int_equal(yk_ode_counts(smooth).steps, yk_ode_counts(rough).steps);
        assert_int_equal(yk_ode_counts(smooth).evaluations, yk_ode_counts(rough).evaluations);
        if (k != 1) assert_int_equal(yk_ode_counts(smooth).evaluations, yk_ode_counts(alone).evaluations);
        for (int j = 0; j < 2; j++) {
            CHECK_NEAR(yk_ode_state(smooth)[j], yk_ode_state(rough)[j], 0);
            CHECK_NEAR(yk_ode_state(smooth)[j], yk_ode_state(alone)[j], k == 1 ? 1e-7 : 0); // Newton goes on for them
        }
        CHECK_NEAR(yk_ode_state(smooth)[2], sin(6), 2e-4);
        // By the rule of the method the integral follows the oscillator's own error.
        CHECK_NEAR(yk_ode_state(smooth)[2] + yk_ode_state(smooth)[1], 0, 2e-5);
        yk_ode_free(alone);
        yk_ode_free(rough);
        yk_ode_free(smooth);
    }
}

static void a_wall_is_reached_and_reported(void **state)
{
    (void)state;
    const YkOdeFunction walls[] = {hard_wall, silent_wall};
    for (int k = 0; k < 2; k++)
        for (int w = 0; w < 2; w++) {
            YkOde *ode = new_ode(1, options_of(k, 1e-8), walls[w], NULL);
            assert_int_equal(run(ode, 0, (double[]){0}, 10), YK_ODE_FAILED);
            assert_true(yk_ode_state(ode)[0] <= 1 && yk_ode_time(ode) <= 1 + 1e-12);
            CHECK_NEAR(yk_ode_time(ode), 1, 1e-11);
            CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-11);
            CHECK_NEAR(yk_ode_previous(ode), yk_ode_time(ode), 0); // no last step to look into
            double y = 0;
            assert_int_equal(yk_ode_dense(ode, yk_ode_time(ode), &y), YK_ODE_OK);
            CHECK_NEAR(y, yk_ode_state(ode)[0], 0);
            assert_in_range(yk_ode_counts(ode).evaluations, 1, 3000);
            assert_int_equal(run_on(ode, 10), YK_ODE_FAILED); // and again
            CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-11);
            assert_int_equal(run(ode, 0, (double[]){-3}, 3), YK_ODE_OK); // the stepper is none the worse
            CHECK_NEAR(yk_ode_state(ode)[0], 0, 1e-9);
            yk_ode_free(ode);
        }
}

static void a_soft_wall_is_met_at_the_right_time(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-10), wall, NULL);
        assert_int_equal(run(ode, 0, (double[]){0}, 1.9), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], 1.9 - 1.9 * 1.9 / 4, 1e-7);
        YkOdeStatus status = run(ode, 0, (double[]){0}, 10);
        assert_true(yk_ode_state(ode)[0] <= 1);
        CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-6);
        if (status != YK_ODE_OK) CHECK_NEAR(yk_ode_time(ode), 2, 1e-3);
        yk_ode_free(ode);
    }
}

static void a_fixed_step_does_not_look_for_a_way_round(void **state)
{
    (void)state;
    const YkOdeFunction walls[] = {hard_wall, silent_wall};
    for (int w = 0; w < 2; w++) {
        YkOde *ode = new_ode(1, with_step(0.3), walls[w], NULL);
        assert_int_equal(run(ode, 0, (double[]){0}, 10), YK_ODE_FAILED);
        CHECK_NEAR(yk_ode_time(ode), 0.9, 1e-12);
        CHECK_NEAR(yk_ode_state(ode)[0], 0.9, 1e-12);
        yk_ode_free(ode);
    }
}

// f that fails now and then: steps get shorter for a while, and the answer is as good.
static int moody(void *context, double t, const double *y, double *dydt)
{
    size_t *calls = context;
    swinging(NULL, t, y, dydt);
    return ++*calls % 50 == 0 ? 3 : 0;
}
static void an_occasional_failure_costs_a_step(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        size_t calls = 0;
        YkOde *ode = new_ode(1, options_of(k, 1e-9), moody, &calls);
        assert_int_equal(run(ode, 0, (double[]){1}, 7), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(7)), 1e-7);
        assert_true(calls > 100);
        assert_int_equal(yk_ode_counts(ode).evaluations, calls);
        assert_true(yk_ode_counts(ode).rejected >= 1);
        yk_ode_free(ode);
    }
}

static void a_start_that_cannot_be_is_refused(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-6), hard_wall, NULL);
        assert_int_equal(yk_ode_step(ode), YK_ODE_FAILED); // not started
        assert_int_equal(yk_ode_start(ode, 0, (double[]){2}, 1, false), YK_ODE_FAILED);
        assert_int_equal(yk_ode_step(ode), YK_ODE_FAILED);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){(double)NAN}, 1, false), YK_ODE_FAILED);
        assert_int_equal(yk_ode_start(ode, (double)NAN, (double[]){0}, 1, false), YK_ODE_FAILED);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){0}, (double)INFINITY, false), YK_ODE_FAILED);
        assert_false(isnan(yk_ode_state(ode)[0]) || isnan(yk_ode_time(ode)));
        yk_ode_free(ode);
        ode = new_ode(1, options_of(k, 1e-6), silent_wall, NULL);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){2}, 1, false), YK_ODE_FAILED);
        yk_ode_free(ode);
    }
}

// y' = y^2 from 1 is infinite at t = 1.
static int blow_up(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    dydt[0] = y[0] * y[0];
    return 0;
}
static void a_pole_ends_the_run_just_before_it(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-9), blow_up, NULL);
        assert_true(run(ode, 0, (double[]){1}, 2) < 0);
        CHECK_NEAR(yk_ode_time(ode), 1, 1e-6);
        assert_true(isfinite(yk_ode_state(ode)[0]) && yk_ode_state(ode)[0] > 1e6);
        yk_ode_free(ode);
    }
}

// A right side that jumps without end cannot be followed to any tolerance, but f never fails.
static int noise(void *context, double t, const double *y, double *dydt)
{
    (void)t;
    (void)y;
    uint64_t *seed = context;
    dydt[0] = check_uniform(seed, -1e15, 1e15);
    return 0;
}
static void what_cannot_be_followed_is_a_step_too_small(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        uint64_t seed = 5;
        YkOde *ode = new_ode(1, options_of(k, 1e-6), noise, &seed);
        assert_int_equal(run(ode, 0, (double[]){1}, 1), YK_ODE_STEP_TOO_SMALL);
        assert_true(isfinite(yk_ode_state(ode)[0]));
        yk_ode_free(ode);
    }
}

static void keeping_the_step_saves_the_start(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        YkOde *ode = new_ode(2, options_of(k, 1e-8), oscillator, NULL);
        run(ode, 0, (double[]){1, 0}, 5);
        double length = yk_ode_time(ode) - yk_ode_previous(ode), y[2] = {cos(5), -sin(5)};
        yk_ode_start(ode, 5, y, 100, true);
        size_t before = yk_ode_counts(ode).evaluations;
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        assert_true(yk_ode_time(ode) - 5 > 0.5 * length);
        if (k == 0) assert_int_equal(yk_ode_counts(ode).evaluations - before, 12);
        yk_ode_start(ode, 5, y, 100, false);
        before = yk_ode_counts(ode).evaluations;
        yk_ode_step(ode);
        if (k == 0) assert_int_equal(yk_ode_counts(ode).evaluations - before, 13);
        yk_ode_free(ode);
    }
}

static void the_state_itself_may_be_started_from(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOde *ode = new_ode(1, options_of(k, 1e-8), swinging, NULL);
        run(ode, 0, (double[]){1}, 2);
        assert_int_equal(yk_ode_start(ode, 2, yk_ode_state(ode), 4, true), YK_ODE_OK);
        assert_int_equal(run_on(ode, 4), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], exp(sin(4)), 1e-6);
        yk_ode_free(ode);
    }
}

static void steps_obey_their_bounds(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        YkOdeOptions options = options_of(k, 1e-3);
        options.largest_step = 0.05;
        options.first_step = 0.001;
        YkOde *ode = new_ode(2, options, oscillator, NULL);
        yk_ode_start(ode, 0, (double[]){1, 0}, 3, false);
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        CHECK_NEAR(yk_ode_time(ode), 0.001, 1e-15);
        while (yk_ode_time(ode) < 3) {
            assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
            assert_true(yk_ode_time(ode) - yk_ode_previous(ode) <= 0.05 + 1e-12);
        }
        assert_in_range(yk_ode_counts(ode).steps, 60, 70);
        yk_ode_free(ode);
    }
}

// The unit of the unknowns and the unit of time mean nothing: the same steps, as long as `scale` goes along.
static void the_unit_of_a_component_changes_nothing(void **state)
{
    (void)state;
    static const double unit[2] = {0x1p30, 0x1p30};
    for (int k = 0; k < 2; k++) {
        YkOdeOptions options = options_of(k, 1e-7);
        YkOde *plain = new_ode(2, options, oscillator, NULL);
        options.scale = unit;
        YkOde *scaled = new_ode(2, options, oscillator, NULL);
        run(plain, 0, (double[]){1, 0}, 7);
        run(scaled, 0, (double[]){unit[0], 0}, 7);
        assert_int_equal(yk_ode_counts(plain).steps, yk_ode_counts(scaled).steps);
        for (int j = 0; j < 2; j++)
            CHECK_NEAR(yk_ode_state(plain)[j] * unit[j], yk_ode_state(scaled)[j], unit[j] * 1e-12);
        yk_ode_free(plain);
        yk_ode_free(scaled);
    }
}

static void tighter_tolerances_give_better_answers(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        double last = 1;
        for (double tolerance = 1e-3; tolerance > 1e-10; tolerance *= 1e-2) {
            YkOde *ode = new_ode(2, options_of(k, tolerance), oscillator, NULL);
            run(ode, 0, (double[]){1, 0}, 20);
            double error = hypot(yk_ode_state(ode)[0] - cos(20), yk_ode_state(ode)[1] + sin(20));
            assert_true(error < 300 * tolerance);
            assert_true(error < last);
            last = error;
            yk_ode_free(ode);
        }
    }
}

static void nothing_happens_to_a_system_at_rest(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        YkOdeOptions options = options_of(k, 1e-6);
        options.absolute = 0; // nothing but a relative tolerance, of nothing
        YkOde *ode = new_ode(2, options, oscillator, NULL);
        assert_int_equal(run(ode, 0, (double[]){0, 0}, 5), YK_ODE_OK);
        for (int j = 0; j < 2; j++) CHECK_NEAR(yk_ode_state(ode)[j], 0, 0);
        yk_ode_free(ode);
    }
}

static void late_times_leave_no_room_for_steps(void **state)
{
    (void)state;
    Growth fast = {1, -1e17};
    YkOde *ode = new_ode(1, with_tolerance(YK_ODE_DOP853, 1e-6), growth, &fast);
    assert_int_equal(run(ode, 1e3, (double[]){1}, 1001), YK_ODE_STEP_TOO_SMALL);
    CHECK_NEAR(yk_ode_time(ode), 1e3, 1e-6);
    yk_ode_free(ode);
}

// The end may be as far as it likes: what the motion needs decides on the steps.
static void a_far_end_changes_no_step(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        YkOde *ode = new_ode(2, options_of(k, 1e-9), oscillator, NULL);
        assert_int_equal(yk_ode_start(ode, 0, (double[]){1, 0}, 1e100, false), YK_ODE_OK);
        while (yk_ode_time(ode) < 20) assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], cos(yk_ode_time(ode)), 1e-6);
        CHECK_NEAR(yk_ode_state(ode)[1], -sin(yk_ode_time(ode)), 1e-6);
        yk_ode_free(ode);
    }
}

static void options_without_sense_are_refused(void **state)
{
    (void)state;
    YkOdeOptions good = with_tolerance(YK_ODE_DOP853, 1e-6), bad[8];
    for (size_t i = 0; i < 8; i++) bad[i] = good;
    bad[0].relative = -1;
    bad[1].absolute = (double)NAN;
    bad[2].relative = bad[2].absolute = 0;
    bad[3].controlled = 3;
    bad[4].first_step = -1;
    bad[5].largest_step = (double)INFINITY;
    bad[6].method = YK_ODE_RK4; // no step
    bad[7].method = (YkOdeMethod)99;
    for (size_t i = 0; i < 8; i++) assert_null(yk_ode_new(2, &bad[i], oscillator, NULL));
    assert_null(yk_ode_new(0, &good, oscillator, NULL));
    assert_null(yk_ode_new(SIZE_MAX / 8, &good, oscillator, NULL));
    good.method = YK_ODE_SDIRK4; // n^2 overflows
    assert_null(yk_ode_new((size_t)1 << 32, &good, oscillator, NULL));
    yk_ode_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms_are_met),
        cmocka_unit_test(time_runs_backward_as_well),
        cmocka_unit_test(forward_and_back_comes_home),
        cmocka_unit_test(the_rate_is_f_at_the_state_and_fresh),
        cmocka_unit_test(each_step_begins_where_the_last_one_ended),
        cmocka_unit_test(every_evaluation_is_counted),
        cmocka_unit_test(the_end_moves_nearer_and_farther),
        cmocka_unit_test(an_end_in_the_past_is_now),
        cmocka_unit_test(a_start_at_its_end_waits_for_another_end),
        cmocka_unit_test(many_small_ends_do_not_spoil_the_answer),
        cmocka_unit_test(dense_output_agrees_between_the_ends_and_is_exact_at_them),
        cmocka_unit_test(dense_output_is_continuous_at_the_ends),
        cmocka_unit_test(dense_output_refuses_times_outside_the_step),
        cmocka_unit_test(dense_output_does_not_disturb_the_run),
        cmocka_unit_test(quadratures_have_no_say_in_the_steps),
        cmocka_unit_test(a_wall_is_reached_and_reported),
        cmocka_unit_test(a_soft_wall_is_met_at_the_right_time),
        cmocka_unit_test(a_fixed_step_does_not_look_for_a_way_round),
        cmocka_unit_test(an_occasional_failure_costs_a_step),
        cmocka_unit_test(a_start_that_cannot_be_is_refused),
        cmocka_unit_test(a_pole_ends_the_run_just_before_it),
        cmocka_unit_test(what_cannot_be_followed_is_a_step_too_small),
        cmocka_unit_test(keeping_the_step_saves_the_start),
        cmocka_unit_test(the_state_itself_may_be_started_from),
        cmocka_unit_test(steps_obey_their_bounds),
        cmocka_unit_test(the_unit_of_a_component_changes_nothing),
        cmocka_unit_test(tighter_tolerances_give_better_answers),
        cmocka_unit_test(nothing_happens_to_a_system_at_rest),
        cmocka_unit_test(late_times_leave_no_room_for_steps),
        cmocka_unit_test(a_far_end_changes_no_step),
        cmocka_unit_test(options_without_sense_are_refused),
    };
    return cmocka_run_group_tests_name("num/ode", tests, NULL, NULL);
}
