// Tables: lines, cubic splines, monotone cubics; with and without period.
#include "law/law_check.h"

enum { POINTS = 9 };
static const double xs[POINTS] = {-1, 0, 0.5, 0.75, 2, 3.5, 4, 6, 7};
static const double ys[POINTS] = {3, 3, 5, -2, -2.5, 8, 8, 1, 3};
static const YkTableShape shapes[] = {YK_TABLE_LINEAR, YK_TABLE_CUBIC, YK_TABLE_MONOTONE};

static const YkLaw *make(Bench *bench, const double *x, const double *y, size_t count, YkTableShape shape,
                         double period)
{
    *bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_table(bench->builder, x, y, count, shape, period), YK_LAW_OK);
    return bench_finish(bench, period);
}

static void a_table_goes_through_its_points(void **state)
{
    (void)state;
    for (int periodic = 0; periodic < 2; periodic++) {
        for (size_t count = 2; count <= POINTS; count++) {
            for (int s = 0; s < 3; s++) {
                Bench bench;
                const YkLaw *law = make(&bench, xs, ys, count, shapes[s], periodic ? 9 : 0);
                for (size_t i = 0; i < count; i++) {
                    CHECK_NEAR(law_value(law, xs[i], 0), ys[i], 1e-13);
                    CHECK_NEAR(law_before(law, xs[i], 0), ys[i], 1e-12);
                    if (periodic) CHECK_NEAR(law_value(law, xs[i] - 9, 0), ys[i], 1e-12);
                }
                bench_free(&bench);
            }
        }
    }
}

static void lines_are_straight(void **state)
{
    (void)state;
    Bench bench;
    const YkLaw *law = make(&bench, xs, ys, POINTS, YK_TABLE_LINEAR, 0);
    for (size_t i = 0; i + 1 < POINTS; i++) {
        double middle = (xs[i] + xs[i + 1]) / 2, slope = (ys[i + 1] - ys[i]) / (xs[i + 1] - xs[i]);
        CHECK_NEAR(law_value(law, middle, 0), (ys[i] + ys[i + 1]) / 2, 1e-14);
        CHECK_NEAR(law_value(law, middle, 1), slope, 1e-13);
        CHECK_NEAR(law_value(law, middle, 2), 0, 0);
    }
    bench_free(&bench);
}

// The largest jump of a derivative at the inner points, and round the period where there is one.
static double worst_jump(const YkLaw *law, int order, size_t first)
{
    double worst = 0;
    for (size_t i = first; i + 1 < POINTS; i++)
        worst = fmax(worst, fabs(law_value(law, xs[i], order) - law_before(law, xs[i], order)));
    return worst;
}

static void a_cubic_table_is_the_natural_spline(void **state)
{
    (void)state;
    Bench bench;
    const YkLaw *law = make(&bench, xs, ys, POINTS, YK_TABLE_CUBIC, 0);
    CHECK_NEAR(worst_jump(law, 1, 1), 0, 1e-12);
    CHECK_NEAR(worst_jump(law, 2, 1), 0, 1e-11);
    assert_true(worst_jump(law, 3, 1) > 1);
    CHECK_NEAR(law_value(law, -1, 2), 0, 1e-12);
    CHECK_NEAR(law_before(law, 7, 2), 0, 1e-12);
    bench_free(&bench);
}

static void a_periodic_cubic_table_is_smooth_round_its_period(void **state)
{
    (void)state;
    // the last point ends the period (8), or the first one closes it (9.5)
    for (int closes = 0; closes < 2; closes++) {
        for (size_t count = closes ? 3 : 2; count <= POINTS; count++) {
            double period = closes ? 9.5 : xs[count - 1] - xs[0], y[POINTS];
            for (size_t i = 0; i < count; i++) y[i] = ys[i];
            if (!closes) y[count - 1] = y[0];
            Bench bench;
            const YkLaw *law = make(&bench, xs, y, count, YK_TABLE_CUBIC, period);
            YkLawJump jumps[10];
            assert_int_equal(yk_law_jumps(law, jumps, 10), 0);
            double end = xs[0] + period;
            for (int m = 0; m <= 2; m++)
                CHECK_NEAR(law_before(law, end, m), law_value(law, xs[0], m),
                           1e-10 * (1 + fabs(yk_law_peak(law, m).value)));
            bench_free(&bench);
        }
    }
}

// Cubic splines converge with the fourth power of the distance of points.
static double sine_error(size_t count, YkTableShape shape)
{
    double x[200], y[200], worst = 0;
    for (size_t i = 0; i < count; i++) {
        x[i] = 2 * YK_PI * (double)i / (double)count;
        y[i] = sin(x[i]);
    }
    Bench bench;
    const YkLaw *law = make(&bench, x, y, count, shape, 2 * YK_PI);
    for (double at = 0; at < 6.2; at += 0.01) worst = fmax(worst, fabs(law_value(law, at, 0) - sin(at)));
    bench_free(&bench);
    return worst;
}

static void a_sine_is_approached_as_theory_says(void **state)
{
    (void)state;
    double cubic = sine_error(50, YK_TABLE_CUBIC) / sine_error(100, YK_TABLE_CUBIC);
    double linear = sine_error(50, YK_TABLE_LINEAR) / sine_error(100, YK_TABLE_LINEAR);
    double monotone = sine_error(50, YK_TABLE_MONOTONE) / sine_error(100, YK_TABLE_MONOTONE);
    assert_true(cubic > 14 && cubic < 18);
    assert_true(linear > 3.8 && linear < 4.2);
    assert_true(monotone > 3.5); // of second order at its summits
    assert_true(sine_error(50, YK_TABLE_CUBIC) < 1e-6);
}

static void a_monotone_table_never_leaves_the_range_of_neighbours(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 200; seed++) {
        double x[12], y[12];
        uint64_t random = seed;
        for (int i = 0; i < 12; i++) {
            x[i] = (i ? x[i - 1] : 0) + check_uniform(&random, 0.01, 2);
            y[i] = check_random(&random) % 3 == 0 && i > 0 ? y[i - 1] : check_uniform(&random, -1, 1);
        }
        double period = seed % 2 ? x[11] - x[0] + 1 : 0;
        Bench bench;
        const YkLaw *law = make(&bench, x, y, 12, YK_TABLE_MONOTONE, period);
        for (int i = 0; i < (period > 0 ? 12 : 11); i++) {
            double from = x[i], to = i < 11 ? x[i + 1] : x[0] + period, a = y[i], b = y[(i + 1) % 12];
            for (int k = 0; k < 40; k++) {
                double d[5];
                yk_law_eval(law, from + (to - from) * (k + 0.5) / 40, d);
                assert_true(d[0] >= fmin(a, b) - 1e-14 && d[0] <= fmax(a, b) + 1e-14);
                assert_true(d[1] * (b - a) >= -1e-12);
            }
        }
        YkLawJump jumps[40];
        size_t count = yk_law_jumps(law, jumps, 40);
        for (size_t i = 0; i < count; i++) { // the slope is continuous, but for the ends of one that then stands still
            bool is_end = period == 0 && (jumps[i].x == x[0] || jumps[i].x == x[11]);
            assert_true(jumps[i].order == 2 || (jumps[i].order == 1 && is_end));
        }
        bench_free(&bench);
    }
}

static void two_points_are_a_line_in_any_shape(void **state)
{
    (void)state;
    const double x[2] = {1, 3}, y[2] = {5, 9};
    for (int s = 0; s < 3; s++) {
        Bench bench;
        const YkLaw *law = make(&bench, x, y, 2, shapes[s], 0);
        CHECK_NEAR(law_value(law, 1.5, 0), 6, 1e-15);
        CHECK_NEAR(law_value(law, 2.5, 1), 2, 1e-15);
        bench_free(&bench);
    }
}

static void what_is_no_table_is_refused(void **state)
{
    (void)state;
    const double x[4] = {0, 1, 1, 2}, y[4] = {0, 1, 2, 3}, up[4] = {0, 1, 2, 3};
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_table(bench.builder, x, y, 1, YK_TABLE_LINEAR, 0), YK_LAW_TOO_FEW);
    assert_int_equal(yk_law_add_table(bench.builder, x, y, 4, YK_TABLE_CUBIC, 0), YK_LAW_UNORDERED);
    assert_int_equal(yk_law_builder_culprit(bench.builder), 2);
    assert_int_equal(yk_law_add_table(bench.builder, up, y, 4, YK_TABLE_CUBIC, 2.5), YK_LAW_OVERFILLED);
    assert_int_equal(yk_law_add_table(bench.builder, up, y, 4, YK_TABLE_CUBIC, 3), YK_LAW_OK);
    assert_int_equal(yk_law_add_table(bench.builder, up, y, 4, YK_TABLE_CUBIC, 3), YK_LAW_OVERLAP);
    bench_free(&bench);
}

static void a_hundred_thousand_points_are_no_trouble(void **state)
{
    (void)state;
    enum { MANY = 100000 };
    static double x[MANY], y[MANY];
    for (int i = 0; i < MANY; i++) {
        x[i] = i * 1e-3;
        y[i] = sin(x[i]);
    }
    Bench bench;
    const YkLaw *law = make(&bench, x, y, MANY, YK_TABLE_CUBIC, 0);
    for (double at = 1; at < 99; at += 0.7777) CHECK_NEAR(law_value(law, at, 1), cos(at), 1e-9);
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_goes_through_its_points),
        cmocka_unit_test(lines_are_straight),
        cmocka_unit_test(a_cubic_table_is_the_natural_spline),
        cmocka_unit_test(a_periodic_cubic_table_is_smooth_round_its_period),
        cmocka_unit_test(a_sine_is_approached_as_theory_says),
        cmocka_unit_test(a_monotone_table_never_leaves_the_range_of_neighbours),
        cmocka_unit_test(two_points_are_a_line_in_any_shape),
        cmocka_unit_test(what_is_no_table_is_refused),
        cmocka_unit_test(a_hundred_thousand_points_are_no_trouble),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
