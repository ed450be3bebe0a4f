// Distributions: moments, ends, the normal quantile against its distribution function; the same value for the same
// seed.
#include "check.h"
#include "study/sample.h"

enum { DRAWS = 200000 };

static void test_the_normal_quantile_inverts_the_distribution_function(void **unused)
{
    (void)unused;
    for (double x = -8; x <= 8; x += 0.01) {
        double p = yk_normal_below(x);
        if (x < 5) CHECK_NEAR(yk_normal_quantile(p), x, 1e-13 * (1 + fabs(x)) + 3e-16 / exp(-x * x / 2));
    }
    CHECK_NEAR(yk_normal_quantile(0.5), 0, 0);
    CHECK_NEAR(yk_normal_quantile(0.975), 1.9599639845400542355, 1e-15);
    CHECK_NEAR(yk_normal_quantile(1e-300), -37.0471, 1e-4);
}

// Mean, deviation and skew of many draws against theory: within five standard errors.
static void check_moments(YkDistribution d, double skew)
{
    double sum = 0, square = 0, cube = 0, mean = yk_distribution_mean(&d), s = yk_distribution_deviation(&d);
    assert_true(yk_distribution_is_valid(&d));
    for (uint64_t k = 0; k < DRAWS; k++) {
        double x = yk_distribution_draw(&d, 77, k, 3);
        assert_true(x >= d.low && x <= d.high);
        double u = (x - mean) / s;
        sum += u, square += u * u, cube += u * u * u;
    }
    double error = 1 / sqrt((double)DRAWS);
    CHECK_NEAR(sum / DRAWS, 0, 5 * error);
    CHECK_NEAR(square / DRAWS, 1, 5 * 2 * error);
    CHECK_NEAR(cube / DRAWS, skew, 5 * 4 * error);
}

static void test_moments_are_those_of_theory(void **unused)
{
    (void)unused;
    check_moments((YkDistribution){YK_DISTRIBUTION_UNIFORM, 2, 5, 0, 0}, 0);
    check_moments((YkDistribution){YK_DISTRIBUTION_NORMAL, -INFINITY, INFINITY, 3, 0.5}, 0);
    check_moments((YkDistribution){YK_DISTRIBUTION_NORMAL, 2, 4, 3, 0.5}, 0);
    check_moments((YkDistribution){YK_DISTRIBUTION_TRIANGULAR, 1, 4, 1, 0}, 0.56568542494923801952); // 2 sqrt(2) / 5
    check_moments((YkDistribution){YK_DISTRIBUTION_TRIANGULAR, 1, 3, 2, 0}, 0);
    check_moments((YkDistribution){YK_DISTRIBUTION_NORMAL, 0, INFINITY, 0, 1}, 0.99527174643115599); // half normal
    YkDistribution half = {YK_DISTRIBUTION_NORMAL, 0, INFINITY, 0, 1};
    CHECK_NEAR(yk_distribution_mean(&half), 0.79788456080286535588, 1e-15);
    CHECK_NEAR(yk_distribution_deviation(&half), 0.60281027498908693, 1e-12);
}

static void test_draws_are_a_function_of_seed_design_and_parameter(void **unused)
{
    (void)unused;
    YkDistribution d = {YK_DISTRIBUTION_NORMAL, -INFINITY, INFINITY, 0, 1};
    double x = yk_distribution_draw(&d, 1, 2, 3);
    assert_true(x == yk_distribution_draw(&d, 1, 2, 3));
    assert_true(x != yk_distribution_draw(&d, 2, 2, 3) && x != yk_distribution_draw(&d, 1, 3, 3) &&
                x != yk_distribution_draw(&d, 1, 2, 4));
    double same = 0, next = 0; // neighbours know nothing of each other
    for (uint64_t k = 0; k < DRAWS; k++) {
        double u = yk_distribution_draw(&d, 5, k, 0);
        same += u * yk_distribution_draw(&d, 5, k, 1);
        next += u * yk_distribution_draw(&d, 5, k + 1, 0);
    }
    CHECK_NEAR(same / DRAWS, 0, 5 / sqrt((double)DRAWS));
    CHECK_NEAR(next / DRAWS, 0, 5 / sqrt((double)DRAWS));
}

static void test_what_is_no_distribution_is_refused(void **unused)
{
    (void)unused;
    const YkDistribution bad[] = {
        {YK_DISTRIBUTION_UNIFORM, 2, 1, 0, 0},         {YK_DISTRIBUTION_UNIFORM, 1, INFINITY, 0, 0},
        {YK_DISTRIBUTION_TRIANGULAR, 1, 2, 3, 0},      {YK_DISTRIBUTION_NORMAL, -INFINITY, INFINITY, 1, 0},
        {YK_DISTRIBUTION_NORMAL, 100, 101, 0, 1},      {YK_DISTRIBUTION_NORMAL, 1, 0, 0, 1},
        {YK_DISTRIBUTION_NORMAL, NAN, INFINITY, 0, 1}, {YK_DISTRIBUTION_UNIFORM, 1, NAN, 0, 0}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) assert_false(yk_distribution_is_valid(&bad[k]));
    YkDistribution cut = {YK_DISTRIBUTION_NORMAL, 2.9, 10, 3, 0.5};
    CHECK_NEAR(yk_distribution_tolerance(&cut, 3), 1.5, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_normal_quantile_inverts_the_distribution_function),
        cmocka_unit_test(test_moments_are_those_of_theory),
        cmocka_unit_test(test_draws_are_a_function_of_seed_design_and_parameter),
        cmocka_unit_test(test_what_is_no_distribution_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
