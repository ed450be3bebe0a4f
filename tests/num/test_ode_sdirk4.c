// SDIRK4: order on smooth and on stiff problems, the classics of stiffness without stalls, few Jacobians.
#include "ode_problems.h"

// Equal steps: the tolerance is just loose enough for them and the bound on the length holds them. Newton, whose goal
// falls with both tolerances, goes on far enough not to be seen.
static void run_evenly(int steps, double *at_ends, double *between)
{
    double h = 3.0 / steps;
    YkOdeOptions options = {
        .method = YK_ODE_SDIRK4, .absolute = 4 * pow(h / 3, 4), .relative = 1e-9, .first_step = h, .largest_step = h};
    YkOde *ode = new_ode(1, options, swinging, NULL);
    yk_ode_start(ode, 0, (double[]){1}, 3, false);
    *at_ends = *between = 0;
    while (yk_ode_time(ode) < 3) {
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        for (int i = 1; i < 8; i++) {
            double t = yk_ode_previous(ode) + (yk_ode_time(ode) - yk_ode_previous(ode)) * i / 8, z;
            assert_int_equal(yk_ode_dense(ode, t, &z), YK_ODE_OK);
            *between = fmax(*between, fabs(z - exp(sin(t))));
        }
        *at_ends = fmax(*at_ends, fabs(yk_ode_state(ode)[0] - exp(sin(yk_ode_time(ode)))));
    }
    assert_int_equal(yk_ode_counts(ode).steps, steps);
    yk_ode_free(ode);
}
static void halving_the_step_shows_order_four_also_between(void **state)
{
    (void)state;
    double error[2], between[2];
    for (int i = 0; i < 2; i++) run_evenly(40 << i, &error[i], &between[i]);
    CHECK_NEAR(log2(error[0] / error[1]), 4, 0.5);
    CHECK_NEAR(log2(between[0] / between[1]), 4, 0.5);
}

// The stability function by one step of y' = lambda y: R(z) has a pole at 1/gamma and goes to 0 far out. Hairer &
// Wanner 1996, IV.3: R(z) = P(z) / (1 - z/4)^5, and R(z) = e^z + O(z^5).
static double amplification(double z)
{
    Growth stiff = {1, z};
    YkOdeOptions options = {.method = YK_ODE_SDIRK4, .absolute = 1e9, .relative = 1e-13, .first_step = 1};
    YkOde *ode = new_ode(1, options, growth, &stiff);
    yk_ode_start(ode, 0, (double[]){1e9}, 1, false);
    assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
    CHECK_NEAR(yk_ode_time(ode), 1, 0);
    double R = yk_ode_state(ode)[0] / 1e9;
    yk_ode_free(ode);
    return R;
}
static void far_out_everything_is_damped(void **state)
{
    (void)state;
    CHECK_NEAR(amplification(-0.05), exp(-0.05), 1e-8);
    CHECK_NEAR(amplification(-0.1), exp(-0.1), 1e-7);
    for (double z = -0.1; z > -1e12; z *= 3) assert_true(fabs(amplification(z)) < 1); // A-stable on the axis
    for (double z = -1e3; z > -1e12; z *= 10)
        CHECK_NEAR(amplification(z), 0, 20 / -z + 2e-8); // L-stable, but for where Newton stops
}

// Prothero & Robinson 1974: y' = lambda (y - phi) + phi', y = phi whatever lambda.
static int prothero_robinson(void *context, double t, const double *y, double *dydt)
{
    dydt[0] = *(const double *)context * (y[0] - sin(t + PI / 4)) + cos(t + PI / 4);
    return 0;
}
static void prothero_robinson_is_followed_at_any_stiffness(void **state)
{
    (void)state;
    for (double lambda = -1; lambda >= -1e10; lambda *= 100) {
        YkOde *ode = new_ode(1, with_tolerance(YK_ODE_SDIRK4, 1e-7), prothero_robinson, &lambda);
        assert_int_equal(run(ode, 0, (double[]){sin(PI / 4)}, 10), YK_ODE_OK);
        CHECK_NEAR(yk_ode_state(ode)[0], sin(10 + PI / 4), 2e-5);
        YkOdeCounts counts = yk_ode_counts(ode);
        assert_in_range(counts.steps, 5, 4000); // most of all in between: order reduction
        assert_true(counts.rejected < counts.steps / 3 + 5);
        yk_ode_free(ode);
    }
}
// Off the smooth solution: a transient, gone at once.
static void a_transient_dies(void **state)
{
    (void)state;
    double lambda = -1e6;
    YkOde *ode = new_ode(1, with_tolerance(YK_ODE_SDIRK4, 1e-6), prothero_robinson, &lambda);
    assert_int_equal(run(ode, 0, (double[]){100}, 10), YK_ODE_OK);
    CHECK_NEAR(yk_ode_state(ode)[0], sin(10 + PI / 4), 1e-4);
    assert_in_range(yk_ode_counts(ode).steps, 20, 1000);
    yk_ode_free(ode);
}

// Van der Pol, mu = 1e3 in slow time (eps = 1e-6). Reference: Hairer & Wanner 1996, IV.10.
static int van_der_pol(void *context, double t, const double *y, double *dydt)
{
    (void)t;
    dydt[0] = y[1];
    dydt[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) / *(const double *)context;
    return 0;
}
static void stiff_van_der_pol_meets_its_reference(void **state)
{
    (void)state;
    double epsilon = 1e-6;
    YkOde *ode = new_ode(2, with_tolerance(YK_ODE_SDIRK4, 1e-8), van_der_pol, &epsilon);
    assert_int_equal(run(ode, 0, (double[]){2, -0.66}, 2), YK_ODE_OK);
    CHECK_NEAR(yk_ode_state(ode)[0], 1.706167732170469, 1e-5);
    CHECK_NEAR(yk_ode_state(ode)[1], -0.8928097010248125, 1e-5);
    YkOdeCounts counts = yk_ode_counts(ode);
    assert_true(counts.steps < 9000 && counts.evaluations < 25 * counts.steps);
    assert_true(counts.jacobians < counts.steps / 10); // one serves for many steps
    yk_ode_free(ode);
}

// Robertson 1966: three rates from 0.04 to 3e7, mass kept. Reference: Hairer & Wanner 1996, IV.10 (t = 40 and 1e11).
static int robertson(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    double a = 0.04 * y[0], b = 1e4 * y[1] * y[2], c = 3e7 * y[1] * y[1];
    dydt[0] = -a + b;
    dydt[1] = a - b - c;
    dydt[2] = c;
    return 0;
}
static void robertson_is_followed_for_ages(void **state)
{
    (void)state;
    YkOdeOptions options = {.method = YK_ODE_SDIRK4, .relative = 1e-7, .absolute = 1e-7};
    static const double scale[3] = {1, 1e-4, 1};
    options.scale = scale;
    YkOde *ode = new_ode(3, options, robertson, NULL);
    yk_ode_start(ode, 0, (double[]){1, 0, 0}, 40, false);
    assert_int_equal(run_on(ode, 40), YK_ODE_OK);
    CHECK_NEAR(yk_ode_state(ode)[0], 0.7158270687194, 2e-6);
    CHECK_NEAR(yk_ode_state(ode)[1], 0.9185534764557e-5, 1e-10);
    CHECK_NEAR(yk_ode_state(ode)[2], 0.2841637457458, 2e-6);
    yk_ode_set_end(ode, 1e7);
    assert_int_equal(run_on(ode, 1e7), YK_ODE_OK);
    double sum = yk_ode_state(ode)[0] + yk_ode_state(ode)[1] + yk_ode_state(ode)[2];
    CHECK_NEAR(sum, 1, 1e-10); // linear, so kept to rounding
    assert_true(yk_ode_state(ode)[0] < 1e-2 && yk_ode_state(ode)[0] > 0);
    assert_in_range(yk_ode_counts(ode).steps, 50, 2000);
    yk_ode_free(ode);
}

static void one_jacobian_serves_a_linear_system(void **state)
{
    (void)state;
    YkOde *ode = new_ode(2, with_tolerance(YK_ODE_SDIRK4, 1e-6), oscillator, NULL);
    assert_int_equal(run(ode, 0, (double[]){1, 0}, 20), YK_ODE_OK);
    assert_int_equal(yk_ode_counts(ode).jacobians, 1);
    // 5 stages, hardly more than one correction each, and f at the end
    assert_true(yk_ode_counts(ode).evaluations < 12 * (yk_ode_counts(ode).steps + yk_ode_counts(ode).rejected) + 10);
    yk_ode_free(ode);
}

// Stiff, with the integral of y^2 along. It follows the steps that y needs, few where y is stiff: a bound holds them.
static int stiff_with_integral(void *context, double t, const double *y, double *dydt)
{
    dydt[1] = y[0] * y[0];
    return prothero_robinson(context, t, y, dydt);
}
static void quadratures_of_stiff_components_are_good(void **state)
{
    (void)state;
    for (double lambda = -10; lambda > -1e9; lambda *= 1000) {
        YkOdeOptions options = with_tolerance(YK_ODE_SDIRK4, 1e-7);
        options.controlled = 1;
        options.largest_step = 0.02;
        YkOde *ode = new_ode(2, options, stiff_with_integral, &lambda);
        assert_int_equal(run(ode, 0, (double[]){sin(PI / 4), 0}, 3), YK_ODE_OK);
        double a = PI / 4, b = 3 + PI / 4; // integral of sin^2
        CHECK_NEAR(yk_ode_state(ode)[1], (b - a) / 2 - (sin(2 * b) - sin(2 * a)) / 4, 1e-5);
        yk_ode_free(ode);
    }
}

// Heat in a rod, n cells: eigenvalues to -4 n^2; the slowest mode falls like e^(-lambda t) with lambda known.
enum { CELLS = 60 };
static int heat(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    for (int j = 0; j < CELLS; j++) {
        double left = j > 0 ? y[j - 1] : 0, right = j + 1 < CELLS ? y[j + 1] : 0;
        dydt[j] = (left - 2 * y[j] + right) * (CELLS + 1) * (CELLS + 1);
    }
    return 0;
}
static void heat_flows_as_its_modes_say(void **state)
{
    (void)state;
    double y[CELLS], lambda = 4.0 * (CELLS + 1) * (CELLS + 1) * pow(sin(PI / 2 / (CELLS + 1)), 2);
    for (int j = 0; j < CELLS; j++) y[j] = sin(PI * (j + 1) / (CELLS + 1)) + (j % 2 ? 0.5 : -0.5);
    YkOde *ode = new_ode(CELLS, with_tolerance(YK_ODE_SDIRK4, 1e-7), heat, NULL);
    assert_int_equal(run(ode, 0, y, 0.3), YK_ODE_OK);
    double first = 0, start = 0, mode;
    for (int j = 0; j < CELLS; j++) { // its part in the first mode
        mode = sin(PI * (j + 1) / (CELLS + 1));
        first += yk_ode_state(ode)[j] * mode;
        start += y[j] * mode;
    }
    CHECK_NEAR(first, start * exp(-lambda * 0.3), 1e-5);
    assert_true(yk_ode_counts(ode).steps < 400);
    yk_ode_free(ode);
}

static void the_jacobian_is_taken_on_the_safe_side_of_a_wall(void **state)
{
    (void)state;
    YkOde *ode = new_ode(1, with_tolerance(YK_ODE_SDIRK4, 1e-6), wall, NULL);
    // At the wall itself f is 0 and y - delta is the only side there is.
    assert_int_equal(run(ode, 0, (double[]){1}, 5), YK_ODE_OK);
    CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-6);
    yk_ode_free(ode);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(halving_the_step_shows_order_four_also_between),
        cmocka_unit_test(far_out_everything_is_damped),
        cmocka_unit_test(prothero_robinson_is_followed_at_any_stiffness),
        cmocka_unit_test(a_transient_dies),
        cmocka_unit_test(stiff_van_der_pol_meets_its_reference),
        cmocka_unit_test(robertson_is_followed_for_ages),
        cmocka_unit_test(one_jacobian_serves_a_linear_system),
        cmocka_unit_test(quadratures_of_stiff_components_are_good),
        cmocka_unit_test(heat_flows_as_its_modes_say),
        cmocka_unit_test(the_jacobian_is_taken_on_the_safe_side_of_a_wall),
    };
    return cmocka_run_group_tests_name("num/ode_sdirk4", tests, NULL, NULL);
}
