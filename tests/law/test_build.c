// The builder: segments in a row, periods, refusals.
#include "law/law_check.h"

static void segments_follow_one_another(void **state)
{
    (void)state;
    Bench bench = bench_new(1, 4);
    assert_int_equal(yk_law_add_rise(bench.builder, 2, 3, &(YkRise){.law = YK_RISE_HARMONIC}), YK_LAW_OK);
    CHECK_NEAR(yk_law_builder_at(bench.builder), 2, 0);
    CHECK_NEAR(yk_law_builder_value(bench.builder), 7, 0);
    assert_int_equal(yk_law_add_velocity(bench.builder, 2.5, -2), YK_LAW_OK);
    CHECK_NEAR(yk_law_builder_value(bench.builder), 6, 1e-15);
    const YkLawCondition conditions[] = {{2.5, 0, 6}, {2.5, 1, -2}, {4, 0, 4}, {4, 1, 0}};
    assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, 4), YK_LAW_OK);
    CHECK_NEAR(yk_law_builder_value(bench.builder), 4, 1e-14);
    assert_int_equal(yk_law_add_dwell(bench.builder, 5), YK_LAW_OK);
    const YkLaw *law = bench_finish(&bench, 4);
    for (double x = 1; x < 5; x += 0.01) CHECK_NEAR(law_value(law, x, 0), law_before(law, x, 0), 1e-13);
    CHECK_NEAR(law_value(law, 5, 0), 4, 1e-14);
    bench_free(&bench);
}

static void a_period_must_be_filled_exactly(void **state)
{
    (void)state;
    Bench bench = bench_new(1, 0);
    YkLaw *law;
    assert_int_equal(yk_law_finish(bench.builder, 1, bench.arena, &law), YK_LAW_EMPTY);
    assert_null(law);
    assert_int_equal(yk_law_add_dwell(bench.builder, 3), YK_LAW_OK);
    assert_int_equal(yk_law_finish(bench.builder, 2.1, bench.arena, &law), YK_LAW_NOT_FILLED);
    assert_int_equal(yk_law_finish(bench.builder, 1.9, bench.arena, &law), YK_LAW_OVERFILLED);
    assert_null(law);
    assert_int_equal(yk_law_finish(bench.builder, 2 * (1 + 1e-12), bench.arena, &law), YK_LAW_OK); // rounding
    assert_non_null(law);
    bench_free(&bench);
    for (int power = -12; power <= 12; power += 4) { // in whatever unit
        double unit = pow(10, power);
        bench = bench_new(0, 0);
        assert_int_equal(yk_law_add_dwell(bench.builder, unit), YK_LAW_OK);
        assert_int_equal(yk_law_finish(bench.builder, unit * (1 + 1e-7), bench.arena, &law), YK_LAW_NOT_FILLED);
        assert_int_equal(yk_law_finish(bench.builder, unit * (1 - 1e-7), bench.arena, &law), YK_LAW_OVERFILLED);
        assert_int_equal(yk_law_finish(bench.builder, unit * (1 + 1e-12), bench.arena, &law), YK_LAW_OK);
        assert_int_equal(yk_law_finish(bench.builder, unit * (1 - 1e-12), bench.arena, &law), YK_LAW_OK);
        bench_free(&bench);
    }
}

static void a_segment_must_end_after_it_starts(void **state)
{
    (void)state;
    Bench bench = bench_new(1, 0);
    const double ends[] = {1, 0.5, -INFINITY, NAN};
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(yk_law_add_dwell(bench.builder, ends[i]), YK_LAW_BACKWARD);
        assert_int_equal(yk_law_add_velocity(bench.builder, ends[i], 1), YK_LAW_BACKWARD);
        assert_int_equal(yk_law_add_fall(bench.builder, ends[i], 1, &(YkRise){.law = YK_RISE_3_4_5}), YK_LAW_BACKWARD);
    }
    bench_free(&bench);
}

static void overflow_is_refused(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_velocity(bench.builder, 1e10, 1e300), YK_LAW_NOT_FINITE);
    assert_int_equal(yk_law_add_rise(bench.builder, 1e-90, 1, &(YkRise){.law = YK_RISE_3_4_5}), YK_LAW_NOT_FINITE);
    assert_int_equal(yk_law_add_rise(bench.builder, 1, 1, &(YkRise){.law = YK_RISE_3_4_5}), YK_LAW_OK);
    const YkLaw *law = bench_finish(&bench, 0);
    assert_int_equal(yk_law_segment_count(law), 1);
    CHECK_NEAR(law_value(law, 0.5, 0), 0.5, 1e-15);
    bench_free(&bench);
}

static void one_builder_makes_several_laws(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    YkLaw *first, *second;
    assert_int_equal(yk_law_add_velocity(bench.builder, 1, 1), YK_LAW_OK);
    assert_int_equal(yk_law_finish(bench.builder, 0, bench.arena, &first), YK_LAW_OK);
    assert_int_equal(yk_law_add_velocity(bench.builder, 2, -1), YK_LAW_OK);
    assert_int_equal(yk_law_finish(bench.builder, 2, bench.arena, &second), YK_LAW_OK);
    CHECK_NEAR(law_value(first, 1.5, 0), 1, 0);
    CHECK_NEAR(law_value(second, 1.5, 0), 0.5, 0);
    yk_law_builder_free(NULL);
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_follow_one_another),        cmocka_unit_test(a_period_must_be_filled_exactly),
        cmocka_unit_test(a_segment_must_end_after_it_starts), cmocka_unit_test(overflow_is_refused),
        cmocka_unit_test(one_builder_makes_several_laws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
