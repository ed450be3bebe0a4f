// Angles, differences and masks.
#include "elementary/kernel.h"
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
                yk_lanes_well(&well, margin, YK_KNOWS_BLOCKS ? NULL : gap, 1e-14, 1e-12, n);
                assert_false(well);
                margin[i] = 0.5;
                gap[i] = k == 2 ? bad[k] : 1.1e-12;
                yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
                assert_false(well);
                gap[i] = 1e-12; // the tolerance itself is well
            }
        yk_lanes_well(&well, margin, gap, 1e-14, 1e-12, n);
        assert_true(well);
        yk_lanes_well(&well, margin, YK_KNOWS_BLOCKS ? NULL : gap, 1e-14, 1e-12, n); // nothing gapes
        assert_true(well);
    }
}

// Margins that stay well above their own change do not dip, until three of them do, wherever these stand.
static void a_dip_is_seen_wherever_it_is(void **state)
{
    (void)state;
    const double falls[][3] = {
        {0.1, 0.1, 1e-15}, {0.1, 1e-15, 0.1}, {1e-15, 0.1, 0.1}, // as good as singular
        {0.1, 0.5, 0.5},   {0.5, 0.1, 0.5},   {0.5, 0.5, 0.1},   // change by more than `most`
        {0.02, 0.2, 0.2},  {0.2, 0.02, 0.2},  {0.2, 0.2, 0.02},  // small beside their change
    };
    for (size_t n = 1; n <= 20; n++)
        for (size_t k = 0; k < sizeof falls / sizeof *falls; k++)
            for (size_t at = 0; at < n; at++) {
                double margin[22];
                bool dips = true;
                for (size_t i = 0; i < n + 2; i++) margin[i] = 0.3 + 0.01 * (double)(i % 3);
                yk_lanes_dip(&dips, margin, 1e-12, 0.3, n);
                assert_false(dips);
                memcpy(margin + at, falls[k], sizeof falls[k]);
                yk_lanes_dip(&dips, margin, 1e-12, 0.3, n);
                assert_true(dips);
            }
    const double even[] = {0.06, 0.2, 0.31}; // differ by 0.25 of `most` 0.3, and the least is 0.24 of that
    bool dips = true;
    yk_lanes_dip(&dips, even, 1e-12, 0.3, 1);
    assert_false(dips);
}

// Unit vectors that turn by equal steps: they swing where the step is longer than the angle of the least cosine.
static void a_swing_is_a_step_beyond_the_angle(void **state)
{
    (void)state;
    const double limit = 0.5;
    for (size_t n = 1; n <= 20; n++)
        for (size_t at = 0; at <= n; at++)
            for (int way = -1; way <= 1; way += 2) {
                double c[21], s[21], angle = 2.9 * way;
                for (size_t i = 0; i <= n; i++) {
                    c[i] = cos(angle), s[i] = sin(angle);
                    angle += way * (i == at ? limit + 0.01 : limit - 0.01);
                }
                bool swings = false;
                yk_lanes_swing(&swings, c, s, cos(limit), n);
                assert_int_equal(swings, at < n);
            }
}

static void one_number_that_is_not_finite_is_enough(void **state)
{
    (void)state;
    enum { ROWS = 11 };
    static double data[ROWS][20];
    double *rows[ROWS];
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (size_t k = 0; k < ROWS; k++) rows[k] = data[k];
    for (size_t k = 0; k < ROWS; k++)
        for (size_t i = 0; i < 20; i++) data[k][i] = k == 0 ? 1e300 : (double)k - (double)i;
    for (size_t count = 0; count <= ROWS; count++)
        for (size_t n = 1; n <= 20; n += count % 3 + 1)
            for (size_t i = 0; i < 20; i++)
                for (size_t k = 0; k < ROWS; k++) {
                    double kept = data[k][i];
                    bool finite;
                    data[k][i] = bad[(k + i) % 3];
                    yk_lanes_finite(&finite, rows, count, n);
                    assert_int_equal(finite, i >= n || k >= count);
                    data[k][i] = kept;
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
        cmocka_unit_test(a_dip_is_seen_wherever_it_is),
        cmocka_unit_test(a_swing_is_a_step_beyond_the_angle),
        cmocka_unit_test(one_number_that_is_not_finite_is_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
