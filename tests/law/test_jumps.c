// Jumps at joints, and peaks.
#include "law/law_check.h"

static void check_jumps(const YkLaw *law, const YkLawJump *expected, size_t count)
{
    YkLawJump jumps[20];
    size_t found = yk_law_jumps(law, jumps, 20);
    for (size_t i = 0; i < found && i < 20 && found != count; i++)
        print_error("order %d at %.17g: %g\n", jumps[i].order, jumps[i].x, jumps[i].size);
    assert_int_equal(found, count);
    for (size_t i = 0; i < count; i++) {
        CHECK_NEAR(jumps[i].x, expected[i].x, 1e-12);
        assert_int_equal(jumps[i].order, expected[i].order);
        CHECK_NEAR(jumps[i].size, expected[i].size, 1e-9 * fabs(expected[i].size));
    }
    assert_int_equal(yk_law_jumps(law, jumps, 1), count); // all are counted, whatever the room
    assert_int_equal(yk_law_jumps(law, NULL, 0), count);
}

static void each_jump_is_found_with_its_size(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 1);
    const YkLawCondition parabola[] = {{2, 0, 3}, {2, 1, 4}, {3, 0, 9}}; // s 3, v 4, a 4; v 8 at its end
    assert_int_equal(yk_law_add_velocity(bench.builder, 1, 0.5), YK_LAW_OK);
    assert_int_equal(yk_law_add_dwell(bench.builder, 2), YK_LAW_OK);
    assert_int_equal(yk_law_add_polynomial(bench.builder, parabola, 3), YK_LAW_OK);
    const YkLawJump periodic[] = {{0, 0, -8},  {0, 1, -7.5}, {0, 2, -4}, {1, 1, -0.5},
                                  {2, 0, 1.5}, {2, 1, 4},    {2, 2, 4}};
    check_jumps(bench_finish(&bench, 3), periodic, 7);
    const YkLawJump single[] = {{0, 1, 0.5}, {1, 1, -0.5}, {2, 0, 1.5}, {2, 1, 4}, {2, 2, 4}, {3, 1, -8}, {3, 2, -4}};
    check_jumps(bench_finish(&bench, 0), single, 7);
    bench_free(&bench);
}

static void a_smooth_cam_has_none_in_whatever_unit(void **state)
{
    (void)state;
    const double lifts[] = {1e-12, 1e-3, 1, 1e9}, turns[] = {1e-6, 2 * YK_PI, 1e7}, starts[] = {0, 1e3};
    const YkRise sine = {.law = YK_RISE_MODIFIED_SINE}, trapezoid = {.law = YK_RISE_MODIFIED_TRAPEZOID};
    for (size_t i = 0; i < 4; i++) {
        for (size_t k = 0; k < 3; k++) {
            for (size_t s = 0; s < 2; s++) {
                Bench bench = bench_new(starts[s] * turns[k], 0.5 * lifts[i]);
                double from = starts[s] * turns[k];
                assert_int_equal(yk_law_add_rise(bench.builder, from + turns[k] / 3, lifts[i], &sine), YK_LAW_OK);
                assert_int_equal(yk_law_add_dwell(bench.builder, from + turns[k] / 2), YK_LAW_OK);
                assert_int_equal(yk_law_add_fall(bench.builder, from + turns[k], lifts[i], &trapezoid), YK_LAW_OK);
                check_jumps(bench_finish(&bench, turns[k]), NULL, 0);
                bench_free(&bench);
            }
        }
    }
}

static void rest_alone_has_none(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 7);
    assert_int_equal(yk_law_add_dwell(bench.builder, 1), YK_LAW_OK);
    check_jumps(bench_finish(&bench, 1), NULL, 0);
    check_jumps(bench_finish(&bench, 0), NULL, 0);
    bench_free(&bench);
}

static void a_small_jump_counts_and_rounding_does_not(void **state)
{
    (void)state;
    const double offs[] = {1e-11, 1e-7};
    for (int i = 0; i < 2; i++) {
        Bench bench = bench_new(0, 0);
        const YkLawCondition back[] = {{1, 0, 1 + offs[i]}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}};
        assert_int_equal(yk_law_add_rise(bench.builder, 1, 1, &(YkRise){.law = YK_RISE_3_4_5}), YK_LAW_OK);
        assert_int_equal(yk_law_add_polynomial(bench.builder, back, 4), YK_LAW_OK);
        YkLawJump jumps[10];
        size_t count = yk_law_jumps(bench_finish(&bench, 2), jumps, 10), steps = 0;
        for (size_t k = 0; k < count; k++) steps += jumps[k].order == 0;
        assert_int_equal(steps, i);
        bench_free(&bench);
    }
}

static void peaks_are_where_the_formula_says(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    const YkLawCondition cubic[] = {{-1, 0, -2}, {2, 0, 2}, {0, 0, 0}, {0, 1, -3}}; // x^3 - 3 x: -2 at 1, 2 at -1 and 2
    yk_law_builder_free(bench.builder);
    bench.builder = yk_law_builder_new(-1, 0);
    YkLawCondition conditions[4];
    for (int i = 0; i < 4; i++) conditions[i] = cubic[i];
    conditions[0].value = 2;
    assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, 4), YK_LAW_OK);
    const YkLaw *law = bench_finish(&bench, 0);
    CHECK_NEAR(fabs(yk_law_peak(law, 0).value), 2, 1e-14);
    CHECK_NEAR(yk_law_peak(law, 1).value, 9, 1e-13); // at its end, from the inside
    CHECK_NEAR(yk_law_peak(law, 1).x, 2, 0);
    CHECK_NEAR(yk_law_peak(law, 2).value, 12, 1e-12);
    CHECK_NEAR(yk_law_peak(law, 3).value, 6, 1e-12);
    CHECK_NEAR(yk_law_peak(law, 4).value, 0, 1e-11);
    bench_free(&bench);
}

// Against a dense scan of polynomials with many hills.
static void no_point_is_above_the_peak(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        uint64_t random = seed;
        YkLawCondition conditions[16];
        for (int i = 0; i < 16; i++)
            conditions[i] = (YkLawCondition){-cos(YK_PI * i / 15), 0, check_uniform(&random, -1, 1)};
        Bench bench = bench_new(-1, 0);
        assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, 16), YK_LAW_OK);
        const YkLaw *law = bench_finish(&bench, 0);
        for (int m = 0; m <= YK_LAW_ORDER; m++) {
            YkLawPeak peak = yk_law_peak(law, m);
            double highest = 0;
            for (int i = 0; i < 20000; i++) highest = fmax(highest, fabs(law_value(law, -1 + i * 1e-4, m)));
            assert_true(highest <= fabs(peak.value) * (1 + 1e-14));
            assert_true(fabs(peak.value) <= highest * (m == 0 ? 1 + 1e-4 : 1.05));
        }
        bench_free(&bench);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_jump_is_found_with_its_size),
        cmocka_unit_test(a_smooth_cam_has_none_in_whatever_unit),
        cmocka_unit_test(rest_alone_has_none),
        cmocka_unit_test(a_small_jump_counts_and_rounding_does_not),
        cmocka_unit_test(peaks_are_where_the_formula_says),
        cmocka_unit_test(no_point_is_above_the_peak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
