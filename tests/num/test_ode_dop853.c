// DOP853: its numbers by the conditions they must satisfy, its orders by halving the step, its cost by counting.
#include "ode_problems.h"
#include "num/ode/ode_dop853_tableau.h"
#include <stdlib.h>

static double node_of(size_t stage)
{
    if (stage == 0) return 0;
    if (stage <= 11) return yk_dop853_a[stage - 1].node;
    return stage == 12 ? 1 : yk_dop853_extra[stage - 13].node;
}

static void every_row_sums_to_its_node(void **state)
{
    (void)state;
    for (size_t i = 1; i < 16; i++) {
        const YkDop853Row *row = i <= 11 ? &yk_dop853_a[i - 1] : i == 12 ? &yk_dop853_b : &yk_dop853_extra[i - 13];
        double sum = 0;
        for (size_t m = 0; m < row->terms; m++) {
            assert_true(row->stage[m] < i); // explicit
            sum += row->weight[m];
        }
        CHECK_NEAR(sum, row->node, 2e-14);
    }
}

// Sum over b_i c_i^p = 1 / (p + 1): polynomials in t are integrated exactly, up to degree 7 and no further.
static void the_weights_integrate_polynomials(void **state)
{
    (void)state;
    for (int p = 0; p < 9; p++) {
        double b = 0, e5 = 0, b3 = 0;
        for (size_t m = 0; m < 8; m++) {
            double power = pow(node_of(yk_dop853_b.stage[m]), p);
            b += yk_dop853_b.weight[m] * power;
            e5 += yk_dop853_e5[m] * power;
            b3 += yk_dop853_b3[m] * power;
        }
        if (p < 8)
            CHECK_NEAR(b, 1.0 / (p + 1), 1e-14);
        else
            assert_true(fabs(b - 1.0 / 9) > 1e-6);
        if (p < 5)
            CHECK_NEAR(e5, 0, 1e-14);
        else
            assert_true(fabs(e5) > 1e-4);
        if (p < 3)
            CHECK_NEAR(b3, 1.0 / (p + 1), 1e-14);
        else
            assert_true(fabs(b3 - 1.0 / (p + 1)) > 1e-2);
    }
}

// y' = t^p, one step from 0 to 1 of the dense output, all powers it holds, between the ends.
typedef struct Power {
    int p;
} Power;
static int power_of_time(void *context, double t, const double *y, double *dydt)
{
    (void)y;
    dydt[0] = pow(t, ((const Power *)context)->p);
    return 0;
}
static void dense_output_holds_polynomials(void **state)
{
    (void)state;
    for (int p = 0; p < 8; p++) {
        Power power = {p};
        YkOdeOptions options = {.method = YK_ODE_DOP853, .absolute = 1e9, .first_step = 1};
        YkOde *ode = new_ode(1, options, power_of_time, &power);
        yk_ode_start(ode, 0, (double[]){0}, 1, false);
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        CHECK_NEAR(yk_ode_time(ode), 1, 0);
        CHECK_NEAR(yk_ode_state(ode)[0], 1.0 / (p + 1), 1e-14);
        double worst = 0;
        for (int i = 1; i < 20; i++) {
            double t = i / 20.0, y;
            assert_int_equal(yk_ode_dense(ode, t, &y), YK_ODE_OK);
            worst = fmax(worst, fabs(y - pow(t, p + 1) / (p + 1)));
        }
        if (p < 7)
            CHECK_NEAR(worst, 0, 2e-14);
        else
            assert_true(worst > 1e-7);
        yk_ode_free(ode);
    }
}

// Error at the end and the worst of the dense output for equal steps: a huge tolerance, and the length held by its
// bound.
static void run_evenly(int steps, double *end, double *between)
{
    double h = 2.0 / steps;
    YkOdeOptions options = {.method = YK_ODE_DOP853, .absolute = 1e9, .first_step = h, .largest_step = h};
    YkOde *ode = new_ode(1, options, logistic, NULL);
    yk_ode_start(ode, 0, (double[]){0.1}, 2, false);
    *between = 0;
    while (yk_ode_time(ode) < 2) {
        assert_int_equal(yk_ode_step(ode), YK_ODE_OK);
        for (int i = 1; i < 10; i++) {
            double t = yk_ode_previous(ode) + (yk_ode_time(ode) - yk_ode_previous(ode)) * i / 10, y;
            assert_int_equal(yk_ode_dense(ode, t, &y), YK_ODE_OK);
            *between = fmax(*between, fabs(y - logistic_answer(0.1, t)));
        }
    }
    *end = fabs(yk_ode_state(ode)[0] - logistic_answer(0.1, 2));
    yk_ode_free(ode);
}
static void halving_the_step_shows_order_eight_and_seven_between(void **state)
{
    (void)state;
    double end[3], between[3];
    for (int i = 0; i < 3; i++) run_evenly(2 << i, &end[i], &between[i]);
    for (int i = 0; i < 2; i++) {
        double order = log2(end[i] / end[i + 1]), order_between = log2(between[i] / between[i + 1]);
        if (!(order > 7.3 && order < 10.5)) print_error("order %g\n", order);
        assert_true(order > 7.3 && order < 10.5);
        if (!(order_between > 6.8 && order_between < 10)) print_error("order between %g\n", order_between);
        assert_true(order_between > 6.8 && order_between < 10);
    }
}

// All trees of order 8 at once: random systems of coupled cubic equations, against ten times as many steps.
typedef struct Cubic {
    double a[3], b[9], c[27];
} Cubic;
static int cubic(void *context, double t, const double *y, double *dydt)
{
    (void)t;
    const Cubic *q = context;
    for (int i = 0; i < 3; i++) {
        dydt[i] = q->a[i];
        for (int j = 0; j < 3; j++) {
            dydt[i] += q->b[3 * i + j] * y[j];
            for (int k = 0; k < 3; k++) dydt[i] += q->c[9 * i + 3 * j + k] * y[j] * y[k] * (1 - y[i]);
        }
    }
    return 0;
}
static void solve_cubic(Cubic *q, int steps, double *y)
{
    double h = 1.0 / steps;
    YkOdeOptions options = {.method = YK_ODE_DOP853, .absolute = 1e9, .first_step = h, .largest_step = h};
    YkOde *ode = new_ode(3, options, cubic, q);
    assert_int_equal(run(ode, 0, (double[]){0.1, -0.2, 0.3}, 1), YK_ODE_OK);
    memcpy(y, yk_ode_state(ode), 3 * sizeof *y);
    yk_ode_free(ode);
}
static void random_coupled_systems_show_order_eight(void **state)
{
    (void)state;
    uint64_t seed = 11;
    double sum = 0;
    for (int trial = 0; trial < 20; trial++) {
        Cubic q;
        for (int i = 0; i < 3; i++) q.a[i] = check_uniform(&seed, -1, 1);
        for (int i = 0; i < 9; i++) q.b[i] = check_uniform(&seed, -1, 1);
        for (int i = 0; i < 27; i++) q.c[i] = check_uniform(&seed, -0.5, 0.5);
        double y[3][3], error[2] = {0};
        solve_cubic(&q, 4, y[0]);
        solve_cubic(&q, 8, y[1]);
        solve_cubic(&q, 80, y[2]);
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 3; j++) error[i] = fmax(error[i], fabs(y[i][j] - y[2][j]));
        sum += log2(error[0] / error[1]);
    }
    CHECK_NEAR(sum / 20, 8.3, 0.7);
}

static void kepler_keeps_its_ellipse_over_many_periods(void **state)
{
    (void)state;
    for (int periods = 10; periods <= 100; periods *= 10) {
        double y[4];
        kepler_start(0.6, y);
        YkOde *ode = new_ode(4, with_tolerance(YK_ODE_DOP853, 1e-12), kepler, NULL);
        assert_int_equal(run(ode, 0, y, 2 * PI * periods), YK_ODE_OK);
        for (int j = 0; j < 4; j++) CHECK_NEAR(yk_ode_state(ode)[j], y[j], 2e-10 * periods * periods);
        CHECK_NEAR(kepler_energy(yk_ode_state(ode)), kepler_energy(y), 1e-11 * periods);
        yk_ode_free(ode);
    }
}

static void smooth_motion_costs_few_evaluations(void **state)
{
    (void)state;
    YkOde *ode = new_ode(2, with_tolerance(YK_ODE_DOP853, 1e-10), oscillator, NULL);
    run(ode, 0, (double[]){1, 0}, 2 * PI);
    YkOdeCounts counts = yk_ode_counts(ode);
    assert_in_range(counts.evaluations, 50, 320);
    CHECK_NEAR(yk_ode_state(ode)[0], 1, 1e-9);
    yk_ode_free(ode);
}

static void dense_output_costs_three_evaluations_a_step(void **state)
{
    (void)state;
    YkOde *ode = new_ode(2, with_tolerance(YK_ODE_DOP853, 1e-8), oscillator, NULL);
    yk_ode_start(ode, 0, (double[]){1, 0}, 6, false);
    double y[2];
    for (int i = 0; i < 3; i++) {
        yk_ode_step(ode);
        double a = yk_ode_previous(ode), b = yk_ode_time(ode);
        size_t before = yk_ode_counts(ode).evaluations;
        yk_ode_dense(ode, a, y);
        yk_ode_dense(ode, b, y);
        assert_int_equal(yk_ode_counts(ode).evaluations, before); // the ends are known
        for (int k = 1; k < 5; k++) yk_ode_dense(ode, a + (b - a) * k / 5, y);
        assert_int_equal(yk_ode_counts(ode).evaluations, before + 3);
    }
    yk_ode_free(ode);
}

// f that works for the step but not for the three evaluations after it.
static int until_told(void *context, double t, const double *y, double *dydt)
{
    oscillator(NULL, t, y, dydt);
    return *(const int *)context;
}
static void dense_output_says_when_f_fails(void **state)
{
    (void)state;
    int told = 0;
    YkOde *ode = new_ode(2, with_tolerance(YK_ODE_DOP853, 1e-8), until_told, &told);
    yk_ode_start(ode, 0, (double[]){1, 0}, 6, false);
    yk_ode_step(ode);
    double y[2], t = (yk_ode_previous(ode) + yk_ode_time(ode)) / 2;
    told = 1;
    assert_int_equal(yk_ode_dense(ode, t, y), YK_ODE_FAILED);
    assert_int_equal(yk_ode_dense(ode, yk_ode_time(ode), y), YK_ODE_OK);
    told = 0;
    assert_int_equal(yk_ode_dense(ode, t, y), YK_ODE_OK); // and then it works
    CHECK_NEAR(y[0], cos(t), 1e-7);
    yk_ode_free(ode);
}

static int jump(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)y;
    dydt[0] = t < 1 ? 1 : -5;
    return 0;
}
static void a_jump_in_f_is_stepped_on_exactly(void **state)
{
    (void)state;
    YkOde *ode = new_ode(1, with_tolerance(YK_ODE_DOP853, 1e-9), jump, NULL);
    assert_int_equal(run(ode, 0, (double[]){0}, 2), YK_ODE_OK);
    CHECK_NEAR(yk_ode_state(ode)[0], 1 - 5, 1e-7);
    assert_true(yk_ode_counts(ode).rejected > 3);
    yk_ode_free(ode);
}

// However many components: each is treated alike, and the sum of squares is a mean.
static void a_hundred_thousand_alike_move_as_one(void **state)
{
    (void)state;
    const size_t n = 100003;
    Growth decay = {n, -1};
    double *y = malloc(n * sizeof *y);
    assert_non_null(y);
    for (size_t j = 0; j < n; j++) y[j] = 1;
    YkOde *many = new_ode(n, with_tolerance(YK_ODE_DOP853, 1e-8), growth, &decay);
    assert_int_equal(run(many, 0, y, 1), YK_ODE_OK);
    decay.n = 1;
    YkOde *one = new_ode(1, with_tolerance(YK_ODE_DOP853, 1e-8), growth, &decay);
    assert_int_equal(run(one, 0, y, 1), YK_ODE_OK);
    assert_int_equal(yk_ode_counts(many).steps, yk_ode_counts(one).steps);
    for (size_t j = 0; j < n; j += 1000) CHECK_NEAR(yk_ode_state(many)[j], yk_ode_state(one)[0], 1e-13);
    CHECK_NEAR(yk_ode_state(many)[n - 1], exp(-1), 1e-8);
    yk_ode_free(many);
    yk_ode_free(one);
    free(y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_sums_to_its_node),
        cmocka_unit_test(the_weights_integrate_polynomials),
        cmocka_unit_test(dense_output_holds_polynomials),
        cmocka_unit_test(halving_the_step_shows_order_eight_and_seven_between),
        cmocka_unit_test(random_coupled_systems_show_order_eight),
        cmocka_unit_test(kepler_keeps_its_ellipse_over_many_periods),
        cmocka_unit_test(smooth_motion_costs_few_evaluations),
        cmocka_unit_test(dense_output_costs_three_evaluations_a_step),
        cmocka_unit_test(dense_output_says_when_f_fails),
        cmocka_unit_test(a_jump_in_f_is_stepped_on_exactly),
        cmocka_unit_test(a_hundred_thousand_alike_move_as_one),
    };
    return cmocka_run_group_tests_name("num/ode_dop853", tests, NULL, NULL);
}
