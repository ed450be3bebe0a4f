// Segments that follow a function: agreement with it, kinks, refusals.
#include "law/law_check.h"

static bool wave(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    const double *w = context; // amplitude, frequency, shift
    double s = w[0] * sin(w[1] * x), c = w[0] * cos(w[1] * x);
    const double cycle[] = {w[2] + s, w[1] * c, -w[1] * w[1] * s, -w[1] * w[1] * w[1] * c,
                            w[1] * w[1] * w[1] * w[1] * s};
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = cycle[m];
    return true;
}

static void the_pieces_agree_with_the_function_to_rounding(void **state)
{
    (void)state;
    static const double cases[][3] = {{1, 1, 0}, {3e-3, 7, 0.1}, {20, 40, -5}, {1e-6, 0.5, 2}};
    static const double close[] = {1e-13, 1e-12, 1e-11, 1e-10, 1e-8};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Bench bench = bench_new(-1, 0);
        assert_int_equal(yk_law_add_function(bench.builder, 5, YK_LAW_FORMULA, wave, cases[i]), YK_LAW_OK);
        const YkLaw *law = bench_finish(&bench, 0);
        assert_int_equal(yk_law_segment_count(law), 1);
        assert_int_equal(yk_law_segment(law, 0).kind, YK_LAW_FORMULA);
        for (double x = -1; x < 5; x += 0.00937) {
            double wanted[YK_LAW_ORDER + 1], scale = cases[i][0] + fabs(cases[i][2]);
            wave(cases[i], x, wanted);
            for (int m = 0; m <= YK_LAW_ORDER; m++, scale = cases[i][0] * pow(cases[i][1], m))
                CHECK_NEAR(law_value(law, x, m), wanted[m], 4 * close[m] * scale);
        }
        YkLawJump jumps[8]; // only where it begins and ends: without a period it stands still outside its range
        size_t count = yk_law_jumps(law, jumps, 8);
        for (size_t k = 0; k < count; k++) assert_true(jumps[k].x == -1 || jumps[k].x == 5);
        bench_free(&bench);
    }
}

static bool bent(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    double at = *(const double *)context;
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = 0;
    d[0] = fabs(x - at) + x * x;
    d[1] = (x >= at ? 1 : -1) + 2 * x;
    d[2] = 2;
    return true;
}

static void a_kink_becomes_a_joint_where_it_is(void **state)
{
    (void)state;
    static const double places[] = {0.3, 0.5, 0.7071067811865476, 1 - 1e-7, 1e-7};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        Bench bench = bench_new(0, 0);
        YkLawJump jumps[10];
        assert_int_equal(yk_law_add_function(bench.builder, 1, YK_LAW_FORMULA, bent, &places[i]), YK_LAW_OK);
        const YkLaw *law = bench_finish(&bench, 0);
        size_t count = yk_law_jumps(law, jumps, 10), found = 0;
        for (size_t k = 0; k < count && k < 10; k++) {
            if (jumps[k].x <= 0 || jumps[k].x >= 1) continue; // the ends, where it stands still
            assert_int_equal(jumps[k].order, 1);
            CHECK_NEAR(jumps[k].size, 2, 1e-9);
            CHECK_NEAR(jumps[k].x, places[i], 1e-12);
            found++;
        }
        assert_int_equal(found, 1);
        for (double x = 0; x < 1; x += 0.0137) CHECK_NEAR(law_value(law, x, 0), fabs(x - places[i]) + x * x, 1e-12);
        bench_free(&bench);
    }
}

static bool noise(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    (void)context;
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = fmod(fabs(x) * 1e15, 7);
    return true;
}

static bool root(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    double at = *(const double *)context;
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = 0;
    d[0] = x;
    d[1] = 1;
    return x < at;
}

static void what_no_pieces_follow_is_refused_with_its_place(void **state)
{
    (void)state;
    const double at = 0.61;
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_function(bench.builder, 0, YK_LAW_FORMULA, noise, NULL), YK_LAW_BACKWARD);
    assert_int_equal(yk_law_add_function(bench.builder, 1, YK_LAW_FORMULA, noise, NULL), YK_LAW_ROUGH);
    assert_int_equal(yk_law_add_function(bench.builder, 1, YK_LAW_FORMULA, root, &at), YK_LAW_NO_VALUE);
    assert_true(yk_law_builder_trouble(bench.builder) >= at && yk_law_builder_trouble(bench.builder) <= 1);
    assert_int_equal(yk_law_add_function(bench.builder, 0.6, YK_LAW_FORMULA, root, &at), YK_LAW_OK); // it is unchanged
    CHECK_NEAR(yk_law_builder_value(bench.builder), 0.6, 1e-15);
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pieces_agree_with_the_function_to_rounding),
        cmocka_unit_test(a_kink_becomes_a_joint_where_it_is),
        cmocka_unit_test(what_no_pieces_follow_is_refused_with_its_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
