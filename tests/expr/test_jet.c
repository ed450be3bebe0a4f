// Taylor arithmetic: ring laws, and the inverse of every function undone again, for random series.
#include "check.h"
#include <stdbool.h>
#include "expr/jet.h"

enum { TRIALS = 500, N = YK_JET_ORDER };

static YkSeries random_series(uint64_t *seed, double low, double high)
{
    YkSeries series = {{check_uniform(seed, low, high)}};
    for (int k = 1; k <= N; k++) series.c[k] = check_uniform(seed, -1, 1);
    return series;
}

static void check_same(const YkSeries *a, const YkSeries *b, double tolerance)
{
    for (int k = 0; k <= N; k++) CHECK_NEAR(a->c[k], b->c[k], tolerance * (1 + fabs(b->c[k])));
}

static YkSeries apply(YkFunction function, const YkSeries *x)
{
    YkSeries result;
    assert_null(yk_series_function(function, x, NULL, &result));
    return result;
}

static void sums_and_products_are_those_of_polynomials(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int i = 0; i < TRIALS; i++) {
        YkSeries a = random_series(&seed, -2, 2), b = random_series(&seed, -2, 2), c = random_series(&seed, 0.5, 2);
        YkSeries ab = yk_series_product(&a, &b), ba = yk_series_product(&b, &a);
        check_same(&ab, &ba, 1e-15);
        YkSeries sum = yk_series_sum(&a, &b, 1), left = yk_series_product(&sum, &c);
        YkSeries ac = yk_series_product(&a, &c), bc = yk_series_product(&b, &c), right = yk_series_sum(&ac, &bc, 1);
        check_same(&left, &right, 1e-14);
        YkSeries quotient = yk_series_quotient(&ac, &c);
        check_same(&quotient, &a, 1e-10);
    }
}

static void a_jet_is_its_series_times_factorials(void **state)
{
    (void)state;
    YkJet jet = {{1, 2, 3, 4, 5}};
    YkSeries series = yk_series_of_jet(&jet);
    const double expected[] = {1, 2, 3.0 / 2, 4.0 / 6, 5.0 / 24};
    for (int k = 0; k <= N; k++) CHECK_NEAR(series.c[k], expected[k], 1e-16);
    YkJet back = yk_jet_of_series(&series);
    for (int k = 0; k <= N; k++) CHECK_NEAR(back.d[k], jet.d[k], 1e-15);
}

static void an_inverse_function_undoes_its_function(void **state)
{
    (void)state;
    static const struct {
        YkFunction inner, outer;
        double low, high;
    } pairs[] = {{YK_SIN, YK_ASIN, -1.2, 1.2}, {YK_COS, YK_ACOS, 0.3, 2.8}, {YK_TAN, YK_ATAN, -1.2, 1.2},
                 {YK_EXP, YK_LOG, -2, 2},      {YK_LOG, YK_EXP, 0.5, 3},    {YK_ATAN, YK_TAN, -3, 3},
                 {YK_ASIN, YK_SIN, -0.8, 0.8}, {YK_ACOS, YK_COS, -0.8, 0.8}};
    uint64_t seed = 2;
    for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++)
        for (int i = 0; i < TRIALS; i++) {
            YkSeries x = random_series(&seed, pairs[p].low, pairs[p].high);
            YkSeries y = apply(pairs[p].inner, &x), back = apply(pairs[p].outer, &y);
            check_same(&back, &x, 1e-9);
        }
}

static void squares_of_sine_and_cosine_add_up_to_one(void **state)
{
    (void)state;
    uint64_t seed = 3;
    YkSeries one = yk_series_constant(1);
    for (int i = 0; i < TRIALS; i++) {
        YkSeries x = random_series(&seed, -10, 10), s = apply(YK_SIN, &x), c = apply(YK_COS, &x), t = apply(YK_TAN, &x);
        YkSeries ss = yk_series_product(&s, &s), cc = yk_series_product(&c, &c), sum = yk_series_sum(&ss, &cc, 1);
        check_same(&sum, &one, 1e-13);
        if (fabs(c.c[0]) < 0.1) continue;
        YkSeries ratio = yk_series_quotient(&s, &c);
        check_same(&t, &ratio, 1e-9);
    }
}

static void hyperbolic_functions_are_made_of_exponentials(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int i = 0; i < TRIALS; i++) {
        YkSeries x = random_series(&seed, -3, 3), minus = yk_series_scaled(&x, -1);
        YkSeries up = apply(YK_EXP, &x), down = apply(YK_EXP, &minus);
        YkSeries s = yk_series_sum(&up, &down, -1), c = yk_series_sum(&up, &down, 1);
        YkSeries sinh_x = apply(YK_SINH, &x), cosh_x = apply(YK_COSH, &x), tanh_x = apply(YK_TANH, &x);
        YkSeries half_s = yk_series_scaled(&s, 0.5), half_c = yk_series_scaled(&c, 0.5),
                 ratio = yk_series_quotient(&s, &c);
        check_same(&sinh_x, &half_s, 1e-12);
        check_same(&cosh_x, &half_c, 1e-12);
        check_same(&tanh_x, &ratio, 1e-11);
    }
    YkSeries far = {{800, 1}}, tanh_far = apply(YK_TANH, &far);
    CHECK_NEAR(tanh_far.c[0], 1, 0);
    CHECK_NEAR(tanh_far.c[1], 0, 0);
}

static void atan2_finds_the_angle_of_a_turned_vector_in_every_quadrant(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int i = 0; i < TRIALS; i++) {
        YkSeries x = random_series(&seed, -3.1, 3.1), size = random_series(&seed, 0.5, 2);
        double far = i % 2 ? 1e200 : 1e-200; // no overflow on the way
        size = yk_series_scaled(&size, far);
        YkSeries s = apply(YK_SIN, &x), c = apply(YK_COS, &x), angle;
        s = yk_series_product(&s, &size);
        c = yk_series_product(&c, &size);
        assert_null(yk_series_function(YK_ATAN2, &s, &c, &angle));
        check_same(&angle, &x, 1e-11);
    }
}

static void powers_agree_with_products_and_roots(void **state)
{
    (void)state;
    uint64_t seed = 6;
    for (int i = 0; i < TRIALS; i++) {
        YkSeries x = random_series(&seed, 0.5, 2), root = apply(YK_SQRT, &x), result;
        YkSeries square = yk_series_product(&x, &x), cube = yk_series_product(&square, &x);
        YkSeries n = yk_series_constant(3);
        assert_null(yk_series_power(&x, &n, &result));
        check_same(&result, &cube, 1e-14);
        n = yk_series_constant(2.5);
        assert_null(yk_series_power(&x, &n, &result));
        YkSeries expected = yk_series_product(&square, &root);
        check_same(&result, &expected, 1e-11);
        n = yk_series_constant(-2);
        assert_null(yk_series_power(&x, &n, &result));
        YkSeries one = yk_series_product(&result, &square), unit = yk_series_constant(1);
        check_same(&one, &unit, 1e-9);
        YkSeries back = yk_series_product(&root, &root);
        check_same(&back, &x, 1e-12);
        YkSeries y = random_series(&seed, -2, 2), power, log_x = apply(YK_LOG, &x);
        assert_null(yk_series_power(&x, &y, &power));
        YkSeries log_power = apply(YK_LOG, &power), product = yk_series_product(&y, &log_x);
        check_same(&log_power, &product, 1e-10);
    }
}

static void a_whole_power_of_zero_keeps_its_derivatives(void **state)
{
    (void)state;
    YkSeries t = {{0, 1}}, n = yk_series_constant(3), result;
    assert_null(yk_series_power(&t, &n, &result));
    for (int k = 0; k <= N; k++) CHECK_NEAR(result.c[k], k == 3 ? 1 : 0, 0);
    n = yk_series_constant(0);
    assert_null(yk_series_power(&t, &n, &result));
    for (int k = 0; k <= N; k++) CHECK_NEAR(result.c[k], k == 0 ? 1 : 0, 0);
}

static void kinks_are_passed_forwards_in_time(void **state)
{
    (void)state;
    YkSeries falling = {{0, -1}}, rising = {{0, 1}}, bent = {{0, 0, -2}}, zero = {{0}};
    YkSeries a = apply(YK_ABS, &falling), b = apply(YK_ABS, &bent), c = apply(YK_ABS, &zero);
    CHECK_NEAR(a.c[1], 1, 0);
    CHECK_NEAR(b.c[2], 2, 0);
    CHECK_NEAR(c.c[0], 0, 0);
    YkSeries larger, smaller;
    assert_null(yk_series_function(YK_MAX, &falling, &rising, &larger));
    assert_null(yk_series_function(YK_MIN, &falling, &rising, &smaller));
    CHECK_NEAR(larger.c[1], 1, 0);
    CHECK_NEAR(smaller.c[1], -1, 0);
    YkSeries sign = apply(YK_SIGN, &falling);
    CHECK_NEAR(sign.c[0], 0, 0);
}

static void what_has_no_value_or_no_derivative_says_why(void **state)
{
    (void)state;
    static const struct {
        YkFunction function;
        double value;
    } bad[] = {{YK_SQRT, -1}, {YK_SQRT, 0},   {YK_LOG, 0},   {YK_LOG, -1},
               {YK_ASIN, 1},  {YK_ASIN, 1.5}, {YK_ACOS, -1}, {YK_ACOS, -2}};
    YkSeries result;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        YkSeries x = {{bad[i].value, 1}};
        assert_non_null(yk_series_function(bad[i].function, &x, NULL, &result));
    }
    YkSeries zero = {{0}}, t = {{0, 1}}, half = {{0.5}}, minus = {{-1}}, below = {{-2.0}};
    assert_non_null(yk_series_function(YK_ATAN2, &zero, &zero, &result));
    assert_non_null(yk_series_power(&t, &half, &result));
    assert_non_null(yk_series_power(&t, &minus, &result));
    assert_non_null(yk_series_power(&below, &half, &result));
    assert_non_null(yk_series_power(&below, &t, &result));
}

static void a_constant_at_the_end_of_a_range_is_fine(void **state)
{
    (void)state;
    YkSeries zero = {{0}}, one = {{1}}, half = {{0.5}}, result;
    assert_null(yk_series_function(YK_SQRT, &zero, NULL, &result));
    assert_true(result.c[0] == 0 && yk_series_is_constant(&result));
    assert_null(yk_series_function(YK_ASIN, &one, NULL, &result));
    CHECK_NEAR(result.c[0], 1.57079632679489661923, 1e-15);
    assert_null(yk_series_power(&zero, &half, &result));
    assert_true(result.c[0] == 0 && yk_series_is_constant(&result));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_products_are_those_of_polynomials),
        cmocka_unit_test(a_jet_is_its_series_times_factorials),
        cmocka_unit_test(an_inverse_function_undoes_its_function),
        cmocka_unit_test(squares_of_sine_and_cosine_add_up_to_one),
        cmocka_unit_test(hyperbolic_functions_are_made_of_exponentials),
        cmocka_unit_test(atan2_finds_the_angle_of_a_turned_vector_in_every_quadrant),
        cmocka_unit_test(powers_agree_with_products_and_roots),
        cmocka_unit_test(a_whole_power_of_zero_keeps_its_derivatives),
        cmocka_unit_test(kinks_are_passed_forwards_in_time),
        cmocka_unit_test(what_has_no_value_or_no_derivative_says_why),
        cmocka_unit_test(a_constant_at_the_end_of_a_range_is_fine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
