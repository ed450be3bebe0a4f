// The contract of evaluation: period, ends, joints, derivatives.
#include "law/law_check.h"

// Rise, dwell, fall, dwell over [from, from + 2 pi).
static const YkLaw *make_cam(Bench *bench, double from, double period)
{
    const YkRise cycloidal = {.law = YK_RISE_CYCLOIDAL}, sine = {.law = YK_RISE_MODIFIED_SINE};
    *bench = bench_new(from, 5);
    assert_int_equal(yk_law_add_rise(bench->builder, from + 2, 20, &cycloidal), YK_LAW_OK);
    assert_int_equal(yk_law_add_dwell(bench->builder, from + 3), YK_LAW_OK);
    assert_int_equal(yk_law_add_fall(bench->builder, from + 5, 20, &sine), YK_LAW_OK);
    assert_int_equal(yk_law_add_dwell(bench->builder, from + 2 * YK_PI), YK_LAW_OK);
    return bench_finish(bench, period);
}

static void a_law_with_a_period_repeats_itself(void **state)
{
    (void)state;
    const double froms[] = {0, -1, 7.5};
    for (size_t f = 0; f < 3; f++) {
        Bench bench;
        const YkLaw *law = make_cam(&bench, froms[f], 2 * YK_PI);
        for (int turn = -5; turn <= 5; turn++) {
            for (double x = 0.1; x < 6.2; x += 0.3) {
                for (int m = 0; m <= YK_LAW_ORDER; m++) {
                    double here = law_value(law, froms[f] + x, m);
                    CHECK_NEAR(law_value(law, froms[f] + x + turn * 2 * YK_PI, m), here, 1e-11);
                }
            }
        }
        CHECK_NEAR(law_value(law, froms[f] + 2 * YK_PI, 3), law_value(law, froms[f], 3), 0); // the end is the start
        bench_free(&bench);
    }
}

// Evaluates the law at many places at once and at each alone: value, slope and curvature have the same bits.
static void check_lanes(const YkLaw *law, const double *x, size_t count)
{
    enum { MOST = 200 };
    double value[MOST], slope[MOST], curvature[MOST], *const d[] = {value, slope, curvature};
    assert_true(count <= MOST);
    yk_law_eval_lanes(law, x, d, count);
    for (size_t k = 0; k < count; k++)
        for (int m = 0; m < 3; m++) {
            double one = law_value(law, x[k], m);
            assert_memory_equal(&d[m][k], &one, sizeof one);
        }
}

// Across pieces, in other periods, outside the range.
static void many_places_have_the_bits_of_one(void **state)
{
    (void)state;
    enum { PLACES = 200 };
    for (int periodic = 0; periodic < 2; periodic++) {
        const YkRise polynomial = {.law = YK_RISE_4_5_6_7}, parabolas = {.law = YK_RISE_PARABOLIC},
                     sine = {.law = YK_RISE_MODIFIED_SINE};
        Bench bench = bench_new(-1, 5);
        assert_int_equal(yk_law_add_rise(bench.builder, 1, 20, &polynomial), YK_LAW_OK);
        assert_int_equal(yk_law_add_fall(bench.builder, 3, 15, &sine), YK_LAW_OK);
        assert_int_equal(yk_law_add_fall(bench.builder, 5, 5, &parabolas), YK_LAW_OK);
        assert_int_equal(yk_law_add_dwell(bench.builder, 2 * YK_PI - 1), YK_LAW_OK);
        const YkLaw *law = bench_finish(&bench, periodic * 2 * YK_PI);
        double x[PLACES];
        for (int k = 0; k < PLACES; k++) x[k] = -2 + 0.06 * k;
        check_lanes(law, x, PLACES);
        bench_free(&bench);
    }
}

// A polynomial of every number of terms, a straight line among them.
static void lanes_have_the_bits_of_one_in_polynomials_of_all_degrees(void **state)
{
    (void)state;
    enum { PLACES = 64, MOST = 12 };
    uint64_t seed = 5;
    for (size_t terms = 1; terms <= MOST; terms++) {
        YkLawCondition conditions[MOST];
        Bench bench = bench_new(-1, 0);
        for (size_t k = 0; k < terms; k++)
            conditions[k] = (YkLawCondition){-1 + 3.0 * (double)k / (double)terms, 0, check_uniform(&seed, -1, 1)};
        conditions[terms - 1].at = 2;
        if (terms == 1) assert_int_equal(yk_law_add_dwell(bench.builder, 2), YK_LAW_OK);
        if (terms > 1) assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, terms), YK_LAW_OK);
        const YkLaw *law = bench_finish(&bench, 0);
        double x[PLACES];
        for (int k = 0; k < PLACES; k++) x[k] = check_uniform(&seed, -1, 2);
        check_lanes(law, x, PLACES);
        bench_free(&bench);
    }
}

static void just_below_its_start_a_periodic_law_is_at_its_end(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_velocity(bench.builder, 1, 2), YK_LAW_OK); // a saw
    const YkLaw *law = bench_finish(&bench, 1);
    CHECK_NEAR(law_value(law, -1e-12, 0), 2, 1e-10);
    CHECK_NEAR(law_value(law, -1e-300, 0), 0, 0); // no double lies between: it is the start
    CHECK_NEAR(law_value(law, 1, 0), 0, 0);
    CHECK_NEAR(law_value(law, 1e9 + 0.25, 0), 0.5, 1e-6);
    assert_true(isnan(law_value(law, NAN, 0)));
    assert_true(isnan(law_value(law, INFINITY, 0)));
    bench_free(&bench);
}

static void outside_its_range_a_law_without_a_period_stands_still(void **state)
{
    (void)state;
    Bench bench = bench_new(1, 3);
    assert_int_equal(yk_law_add_velocity(bench.builder, 2, 4), YK_LAW_OK);
    const YkLaw *law = bench_finish(&bench, 0);
    const double outside[] = {-INFINITY, -1e300, 0.999, 2, 2.1, INFINITY};
    for (size_t i = 0; i < 6; i++) {
        CHECK_NEAR(law_value(law, outside[i], 0), outside[i] < 1 ? 3 : 7, 0);
        for (int m = 1; m <= YK_LAW_ORDER; m++) CHECK_NEAR(law_value(law, outside[i], m), 0, 0);
    }
    CHECK_NEAR(law_value(law, 1, 1), 4, 0); // at the start: just after it
    YkLawRange range = yk_law_range(law);
    CHECK_NEAR(range.from, 1, 0);
    CHECK_NEAR(range.to, 2, 0);
    CHECK_NEAR(range.period, 0, 0);
    bench_free(&bench);
}

static void at_a_joint_holds_what_follows(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    for (int i = 0; i < 40; i++) assert_int_equal(yk_law_add_velocity(bench.builder, i + 1, i), YK_LAW_OK);
    const YkLaw *law = bench_finish(&bench, 0);
    for (int i = 0; i < 40; i++) {
        CHECK_NEAR(law_value(law, i, 1), i, 0);
        CHECK_NEAR(law_before(law, i + 1, 1), i, 0);
        CHECK_NEAR(law_value(law, i + 0.5, 1), i, 0);
        CHECK_NEAR(law_value(law, i, 0), i * (i - 1) / 2.0, 1e-12);
    }
    bench_free(&bench);
}

static void every_derivative_is_the_slope_of_the_one_below(void **state)
{
    (void)state;
    Bench bench;
    const YkLaw *law = make_cam(&bench, 0, 2 * YK_PI);
    const double inside[] = {0.2, 0.9, 1.1, 1.8, 2.5, 3.1, 3.5, 4.4, 4.9, 6};
    for (size_t i = 0; i < sizeof inside / sizeof *inside; i++) {
        for (int m = 1; m <= YK_LAW_ORDER; m++) {
            double d = law_value(law, inside[i], m);
            CHECK_NEAR(law_difference(law, inside[i], m, 2e-3), d, 1e-8 * (1 + fabs(d)));
        }
    }
    bench_free(&bench);
}

static void segments_tell_what_the_law_is_made_of(void **state)
{
    (void)state;
    Bench bench;
    const YkLaw *law = make_cam(&bench, 0, 2 * YK_PI);
    const YkLawKind kinds[] = {YK_LAW_RISE, YK_LAW_DWELL, YK_LAW_FALL, YK_LAW_DWELL};
    const double ends[] = {0, 2, 3, 5, 2 * YK_PI};
    assert_int_equal(yk_law_segment_count(law), 4);
    for (size_t i = 0; i < 4; i++) {
        YkLawSegment segment = yk_law_segment(law, i);
        assert_int_equal(segment.kind, kinds[i]);
        CHECK_NEAR(segment.from, ends[i], 0);
        CHECK_NEAR(segment.to, ends[i + 1], 0);
        assert_int_equal(segment.condition_count, 0);
    }
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_law_with_a_period_repeats_itself),
        cmocka_unit_test(many_places_have_the_bits_of_one),
        cmocka_unit_test(lanes_have_the_bits_of_one_in_polynomials_of_all_degrees),
        cmocka_unit_test(just_below_its_start_a_periodic_law_is_at_its_end),
        cmocka_unit_test(outside_its_range_a_law_without_a_period_stands_still),
        cmocka_unit_test(at_a_joint_holds_what_follows),
        cmocka_unit_test(every_derivative_is_the_slope_of_the_one_below),
        cmocka_unit_test(segments_tell_what_the_law_is_made_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
