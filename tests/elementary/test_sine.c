// sin, cos and atan2 against long double, in units of the last place of the exact value; lanes against one at a time.
#include <float.h>
#include <stdlib.h>
#include "check.h"
#include "elementary/elementary.h"

// How many units in the last place `got` is off.
static double units_off(double got, long double exact)
{
    if (exact == 0) return got == 0 ? 0 : INFINITY;
    int exponent;
    frexpl(exact, &exponent);
    return (double)(fabsl(got - exact) / ldexpl(1, exponent < -1021 ? -1074 : exponent - 53));
}

static double worst_of_sincos(double x)
{
    double s, c;
    yk_sincos(x, &s, &c);
    return fmax(units_off(s, sinl(x)), units_off(c, cosl(x)));
}

static void sincos_is_within_one_unit(void **state)
{
    (void)state;
    const double ranges[] = {0.1, 1, 3.2, 100, 1e4, 1e5};
    uint64_t seed = 11;
    double worst = 0;
    for (size_t r = 0; r < 6; r++)
        for (int i = 0; i < 170000; i++)
            worst = fmax(worst, worst_of_sincos(check_uniform(&seed, -ranges[r], ranges[r])));
    CHECK_NEAR(worst, 0, 1);
}

// There the difference to the multiple has few bits left: the reduction must have more of pi than a double.
static void sincos_is_within_one_unit_at_multiples_of_a_quarter_turn(void **state)
{
    (void)state;
    double worst = 0;
    for (int k = -63600; k <= 63600; k++) {
        double x = (double)(k * 1.57079632679489661923132169163975144L);
        for (int step = -2; step <= 2; step++) {
            worst = fmax(worst, worst_of_sincos(x));
            x = nextafter(x, step < 0 ? -INFINITY : INFINITY);
        }
        worst = fmax(worst, worst_of_sincos((double)((k + 0.5L) * 1.57079632679489661923132169163975144L)));
    }
    CHECK_NEAR(worst, 0, 1);
}

static void sincos_of_tiny_and_huge_arguments(void **state)
{
    (void)state;
    const double x[] = {DBL_TRUE_MIN, DBL_MIN, 1e-300, 1e-20, 1e-8, 99999.9, 100000.1,
                        102943.7,     102945,  2e5,    1e10,  1e22, DBL_MAX};
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) {
        CHECK_NEAR(worst_of_sincos(x[i]), 0, 1);
        CHECK_NEAR(worst_of_sincos(-x[i]), 0, 1);
    }
    double s, c;
    yk_sincos(INFINITY, &s, &c);
    assert_true(isnan(s) && isnan(c));
    yk_sincos(NAN, &s, &c);
    assert_true(isnan(s) && isnan(c));
}

static void sine_keeps_the_sign_of_zero(void **state)
{
    (void)state;
    double s, c;
    yk_sincos(-0.0, &s, &c);
    assert_true(s == 0 && signbit(s) && c == 1);
    yk_sincos(0.0, &s, &c);
    assert_true(s == 0 && !signbit(s) && c == 1);
}

// Draws a number in [-1, 1], times 2 to a power drawn from `powers` of them, from 2^-down on. It draws the power first.
static double scaled(uint64_t *seed, int powers, int down)
{
    int power = powers ? (int)(check_random(seed) % (unsigned)powers) - down : 0;
    return ldexp(check_uniform(seed, -1, 1), power);
}

static void lanes_have_the_bits_of_one_at_a_time(void **state)
{
    (void)state;
    enum { N = 1003 };
    static double x[N], s[N], c[N];
    uint64_t seed = 12;
    for (int far = 0; far < 2; far++)
        for (size_t n = 1; n <= N; n = n < 20 ? n + 1 : n * 3 / 2) {
            for (size_t i = 0; i < n; i++) x[i] = scaled(&seed, 40, 24);
            if (far) x[n / 2] = n % 2 ? 1e7 : INFINITY;
            yk_sincos_lanes(x, s, c, n);
            for (size_t i = 0; i < n; i++) {
                double one[2];
                yk_sincos(x[i], &one[0], &one[1]);
                assert_true(memcmp(&one[0], &s[i], sizeof s[i]) == 0 || (isnan(s[i]) && isnan(one[0])));
                assert_true(memcmp(&one[1], &c[i], sizeof c[i]) == 0 || (isnan(c[i]) && isnan(one[1])));
            }
        }
}

static void atan2_is_within_one_unit(void **state)
{
    (void)state;
    uint64_t seed = 13;
    double worst = 0;
    for (int i = 0; i < 1000000; i++) {
        int spread = i % 3 == 0 ? 0 : i % 3 == 1 ? 8 : 900; // both alike, and with any ratio
        double y = scaled(&seed, spread, spread / 2), x = scaled(&seed, spread, spread / 2);
        worst = fmax(worst, units_off(yk_atan2(y, x), atan2l(y, x)));
    }
    CHECK_NEAR(worst, 0, 1);
}

// Zeros of both signs, both axes, diagonals, subnormal, huge and infinite: as the C standard has them.
static void atan2_at_its_corners(void **state)
{
    (void)state;
    const double at[] = {0.0,    -0.0,    1,        -1,       DBL_TRUE_MIN, -DBL_TRUE_MIN,       DBL_MIN,  1e300,
                         -1e300, DBL_MAX, -DBL_MAX, INFINITY, -INFINITY,    0.41421356237309503, 0x1p1000, 0x1p-1000};
    const size_t count = sizeof at / sizeof *at;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < count; j++) {
            double got = yk_atan2(at[i], at[j]), expected = atan2(at[i], at[j]);
            CHECK_NEAR(units_off(got, atan2l(at[i], at[j])), 0, 1);
            assert_int_equal(signbit(got) != 0, signbit(expected) != 0);
        }
    assert_true(isnan(yk_atan2(NAN, 1)) && isnan(yk_atan2(1, NAN)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sincos_is_within_one_unit),
        cmocka_unit_test(sincos_is_within_one_unit_at_multiples_of_a_quarter_turn),
        cmocka_unit_test(sincos_of_tiny_and_huge_arguments),
        cmocka_unit_test(sine_keeps_the_sign_of_zero),
        cmocka_unit_test(lanes_have_the_bits_of_one_at_a_time),
        cmocka_unit_test(atan2_is_within_one_unit),
        cmocka_unit_test(atan2_at_its_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
