// The classical method at a fixed step: order four, an even grid, an exact end.
#include "ode_problems.h"

static double error_with(int steps, double *between)
{
    YkOde *ode = new_ode(1, with_step(3.0 / steps), swinging, NULL);
    yk_ode_start(ode, 0, (double[]){1}, 3, false);
    *between = 0;
    while (yk_ode_time(ode) < 3) {
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        for (int i = 1; i < 8; i++) {
            double t = yk_ode_previous(ode) + (yk_ode_time(ode) - yk_ode_previous(ode)) * i / 8, y;
            yk_ode_dense(ode, t, &y);
            *between = fmax(*between, fabs(y - exp(sin(t))));
        }
    }
    assert_int_equal(yk_ode_counts(ode).steps, steps);
    double error = fabs(yk_ode_state(ode)[0] - exp(sin(3)));
    yk_ode_free(ode);
    return error;
}

static void halving_the_step_shows_order_four_also_between(void **state)
{
    (void)state;
    double between[2], a = error_with(100, &between[0]), b = error_with(200, &between[1]);
    CHECK_NEAR(log2(a / b), 4, 0.15);
    CHECK_NEAR(log2(between[0] / between[1]), 4, 0.15);
}

// Written out by hand for y' = y: the first terms of e^h.
static void one_step_is_taylor_to_the_fourth(void **state)
{
    (void)state;
    double h = 0.3;
    Growth grow = {1, 1};
    YkOde *ode = new_ode(1, with_step(h), growth, &grow);
    yk_ode_start(ode, 0, (double[]){1}, 5, false);
    yk_ode_step(ode);
    CHECK_NEAR(yk_ode_state(ode)[0], 1 + h + h * h / 2 + h * h * h / 6 + h * h * h * h / 24, 1e-15);
    CHECK_NEAR(yk_ode_time(ode), h, 0);
    yk_ode_free(ode);
}

static void the_last_step_is_cut_at_the_end(void **state)
{
    (void)state;
    for (int back = 0; back < 2; back++) {
        double sign = back ? -1 : 1;
        YkOde *ode = new_ode(1, with_step(0.3), swinging, NULL);
        run(ode, 0, (double[]){1}, sign);
        assert_int_equal(yk_ode_counts(ode).steps, 4);
        CHECK_NEAR(yk_ode_time(ode), sign, 0);
        CHECK_NEAR(fabs(yk_ode_time(ode) - yk_ode_previous(ode)), 0.1, 1e-15);
        yk_ode_set_end(ode, 2 * sign); // the grid goes on from there
        yk_ode_step(ode);
        CHECK_NEAR(yk_ode_time(ode), 1.3 * sign, 1e-15);
        yk_ode_free(ode);
    }
}

static void a_step_that_divides_the_span_leaves_no_crumbs(void **state)
{
    (void)state;
    for (int steps = 1; steps < 2000; steps = steps * 3 / 2 + 1)
        for (double start = 0; start < 2000; start += 777.7) {
            YkOde *ode = new_ode(1, with_step(10.0 / steps), swinging, NULL);
            run(ode, start, (double[]){1}, start + 10);
            assert_int_equal(yk_ode_counts(ode).steps, steps);
            yk_ode_free(ode);
        }
}

static void the_grid_does_not_drift(void **state)
{
    (void)state;
    YkOde *ode = new_ode(1, with_step(0.001), swinging, NULL);
    yk_ode_start(ode, 0, (double[]){1}, 100, false);
    for (int i = 1; i < 99999; i++) {
        yk_ode_step(ode);
        if (yk_ode_time(ode) != 0.001 * i) CHECK_NEAR(yk_ode_time(ode), 0.001 * i, 0);
    }
    yk_ode_free(ode);
}

static void a_step_of_nothing_is_refused(void **state)
{
    (void)state;
    YkOde *ode = new_ode(1, with_step(1e-20), swinging, NULL);
    assert_int_equal(run(ode, 0, (double[]){1}, 1), YK_ODE_STEP_TOO_SMALL);
    CHECK_NEAR(yk_ode_time(ode), 0, 0);
    yk_ode_free(ode);
}

static void an_overflow_fails_and_leaves_the_last_numbers(void **state)
{
    (void)state;
    Growth explode = {1, 1e5};
    YkOde *ode = new_ode(1, with_step(1), growth, &explode);
    assert_int_equal(run(ode, 0, (double[]){1}, 100), YK_ODE_FAILED);
    assert_true(isfinite(yk_ode_state(ode)[0]) && isfinite(yk_ode_rate(ode)[0]));
    assert_true(yk_ode_time(ode) > 5);
    yk_ode_free(ode);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(halving_the_step_shows_order_four_also_between),
        cmocka_unit_test(one_step_is_taylor_to_the_fourth),
        cmocka_unit_test(the_last_step_is_cut_at_the_end),
        cmocka_unit_test(a_step_that_divides_the_span_leaves_no_crumbs),
        cmocka_unit_test(the_grid_does_not_drift),
        cmocka_unit_test(a_step_of_nothing_is_refused),
        cmocka_unit_test(an_overflow_fails_and_leaves_the_last_numbers),
    };
    return cmocka_run_group_tests_name("num/ode_rk4", tests, NULL, NULL);
}
