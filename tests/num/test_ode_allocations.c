// Steppers allocate when they are made and never again; without memory they are not made.
#include "interposed.h"
#include "ode_problems.h"

static void *volatile sink;

static void the_counter_counts(void **state)
{
    (void)state;
    long before = requests;
    sink = malloc(10);
    free(sink);
    sink = calloc(3, 5);
    free(sink);
    assert_int_equal(requests, before + 2);
}

static void stepping_allocates_nothing(void **state)
{
    (void)state;
    static const YkOdeMethod methods[] = {YK_ODE_DOP853, YK_ODE_SDIRK4, YK_ODE_RK4};
    for (int k = 0; k < 3; k++) {
        YkOdeOptions options = with_tolerance(methods[k], 1e-8);
        options.fixed_step = 0.01;
        YkOde *ode = new_ode(2, options, oscillator, NULL), *blocked = new_ode(1, options, hard_wall, NULL);
        long before = requests;
        double y[2];
        yk_ode_start(ode, 0, (double[]){1, 0}, 5, false);
        while (yk_ode_time(ode) < 5) {
            yk_ode_step(ode);
            yk_ode_dense(ode, (yk_ode_previous(ode) + yk_ode_time(ode)) / 2, y);
        }
        yk_ode_set_end(ode, 6);
        yk_ode_step(ode);
        yk_ode_start(ode, 6, y, 7, true);
        YkOdeStatus status = run(blocked, 0, (double[]){0}, 2);
        long after = requests;
        assert_int_equal(after, before);
        assert_int_equal(status, YK_ODE_FAILED);
        yk_ode_free(ode);
        yk_ode_free(blocked);
    }
}

static void without_memory_there_is_no_stepper(void **state)
{
    (void)state;
    YkOdeOptions options = with_tolerance(YK_ODE_SDIRK4, 1e-8);
    if (!IS_INTERPOSED) { // more than any machine has
        options = with_tolerance(YK_ODE_DOP853, 1e-8);
        assert_null(yk_ode_new(SIZE_MAX / 8 / 64, &options, oscillator, NULL));
        return;
    }
    for (long k = 0;; k++) {
        has_failed = false;
        countdown = k;
        YkOde *ode = yk_ode_new(2, &options, oscillator, NULL);
        countdown = -1;
        if (!has_failed) {
            assert_non_null(ode);
            assert_true(k > 0);
            yk_ode_free(ode);
            break;
        }
        assert_null(ode);
    }
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_counter_counts),
        cmocka_unit_test(stepping_allocates_nothing),
        cmocka_unit_test(without_memory_there_is_no_stepper),
    };
    return cmocka_run_group_tests_name("num/ode_allocations", tests, NULL, NULL);
}
