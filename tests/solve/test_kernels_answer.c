// Angles, differences and masks.
#include "lanes_check.h"

static void measures(uint64_t seed, bool has_a, bool has_b)
{
    static Pool pool;
    pool.used = 0;
    YkTurn a = has_a ? pool_turn(&pool) : (YkTurn){0}, b = has_b ? pool_turn(&pool) : (YkTurn){0};
    static long double difference[LANES];
    for (size_t i = 0; i < LANES; i++) {
        Motion one = has_a ? random_angle(&seed) : motion_constant(0),
               two = has_b ? random_angle(&seed) : motion_constant(0);
        if (has_a) put_turn(a, i, one);
        if (has_b) put_turn(b, i, two);
        difference[i] = creall(two.value - one.value);
    }
    double *out = pool_row(&pool), offset = check_uniform(&seed, -7, 7), reference = check_uniform(&seed, -30, 30);
    yk_lanes_angle(out, a, b, offset, reference, LANES);
    const long double turn = 6.283185307179586476925286766559L;
    for (size_t i = 0; i < LANES; i++) {
        long double exact = difference[i] + offset;
        exact -= turn * roundl((exact - reference) / turn);
        if (fabsl(fabsl(exact - reference) - turn / 2) < 1e-9L) continue; // half a turn away: either will do
        CHECK_NEAR(out[i], (double)exact, 1e-15 * fmax(1, fabs(reference) + 7));
        assert_true(fabs(out[i] - reference) <= 3.1415926535897936 + 1e-14);
    }
}

static void angle_is_nearest_to_its_reference(void **state)
{
    (void)state;
    for_all_choices(measures, 40);
}

static void angle_round_the_circle_is_exact_to_rounding(void **state)
{
    (void)state;
    static Pool pool;
    YkTurn b = pool_turn(&pool), ground = {0};
    double *out = pool_row(&pool), worst = 0;
    uint64_t seed = 8;
    for (int k = 0; k < 1000; k++) {
        double angle[LANES];
        for (size_t i = 0; i < LANES; i++) {
            angle[i] = check_uniform(&seed, -3.141592653589793, 3.141592653589793);
            if (i % 4 == 1) angle[i] = ldexp(angle[i], -(int)(check_random(&seed) % 60)); // relatively so near zero
            put_turn(b, i, motion_constant(angle[i]));
        }
        yk_lanes_angle(out, ground, b, 0, 0, LANES);
        for (size_t i = 0; i < LANES; i++) worst = fmax(worst, fabs(out[i] - angle[i]) / fabs(angle[i]));
    }
    CHECK_NEAR(worst, 0, 4.5e-16); // two units in the last place
}

static void angle_on_the_axes_and_diagonals(void **state)
{
    (void)state;
    static Pool pool;
    YkTurn b = pool_turn(&pool), ground = {0};
    double *out = pool_row(&pool), half = 0.70710678118654752;
    const double c[] = {1, half, 0, -half, -1, -half, 0, half}, s[] = {0, half, 1, half, 0, -half, -1, -half};
    for (size_t i = 0; i < 8; i++) b.c[i] = c[i], b.s[i] = s[i];
    yk_lanes_angle(out, ground, b, 0, 2.9, 8);
    for (size_t i = 0; i < 8; i++) CHECK_NEAR(out[i], (double)i * 0.78539816339744831, 1e-15);
}

static void difference_takes_absent_rows_for_zero(void **state)
{
    (void)state;
    static Pool pool;
    uint64_t seed = 4;
    double *a = pool_row(&pool), *b = pool_row(&pool), *out = pool_row(&pool);
    for (size_t i = 0; i < LANES; i++) a[i] = check_uniform(&seed, -1, 1), b[i] = check_uniform(&seed, -1, 1);
    yk_lanes_difference(out, b, a, LANES);
    for (size_t i = 0; i < LANES; i++) CHECK_NEAR(out[i], b[i] - a[i], 0);
    yk_lanes_difference(out, b, NULL, LANES);
    assert_memory_equal(out, b, sizeof pool.rows[0]);
    yk_lanes_difference(out, NULL, a, LANES);
    for (size_t i = 0; i < LANES; i++) CHECK_NEAR(out[i], -a[i], 0);
    yk_lanes_difference(out, NULL, NULL, LANES);
    for (size_t i = 0; i < LANES; i++) CHECK_NEAR(out[i], 0, 0);
}

static void mask_lets_only_good_lanes_pass(void **state)
{
    (void)state;
    for (size_t n = 1; n <= 24; n++) {
        double value[24], margin[24];
        const double margins[] = {0.5, 1e-12, 0.99e-12, 0, -1, (double)NAN, -(double)INFINITY, (double)INFINITY};
        const double values[] = {3, (double)NAN, (double)INFINITY, -2};
        for (size_t i = 0; i < n; i++) margin[i] = margins[i % 8], value[i] = i % 8 < 2 ? 3 : values[i % 4];
        yk_lanes_mask(value, margin, 1e-12, n);
        for (size_t i = 0; i < n; i++) {
            if (i % 8 == 7)
                CHECK_NEAR(value[i], -2, 0);
            else
                CHECK_NEAR(value[i], i % 8 < 2 ? 3 : 0, 0);
        }
    }
}

static void one_bad_lane_is_enough_to_be_unwell(void **state)
{
    (void)state;
    for (size_t n = 1; n <= 40; n++) {
        double margin[40], gap[40];
        for (size_t i = 0; i < n; i++) margin[i] = 0.5, gap[i] = 1e-13;
        bool well = false;
        yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
        assert_true(well);
        const double bad[] = {1e-14, -1, (double)NAN};
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < 3; k++) {
                margin[i] = bad[k];
                yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
                assert_false(well);
                margin[i] = 0.5;
                gap[i] = k == 2 ? bad[k] : 1.1e-12;
                yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
                assert_false(well);
                gap[i] = 1e-12; // the tolerance itself is well
            }
        yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
        assert_true(well);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angle_is_nearest_to_its_reference),
        cmocka_unit_test(angle_round_the_circle_is_exact_to_rounding),
        cmocka_unit_test(angle_on_the_axes_and_diagonals),
        cmocka_unit_test(difference_takes_absent_rows_for_zero),
        cmocka_unit_test(mask_lets_only_good_lanes_pass),
        cmocka_unit_test(one_bad_lane_is_enough_to_be_unwell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
