// Bounds of a law's derivatives, against closed forms and against differences.
#include "law/law_check.h"

// A rise from 0 to 1 and a fall back over a period of 2, of the same kind.
static const YkLaw *there_and_back(Bench *bench, YkRiseLaw kind, bool periodic)
{
    const YkRise rise = {.law = kind, .blend = 0.25};
    *bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_rise(bench->builder, 1, 1, &rise), YK_LAW_OK);
    assert_int_equal(yk_law_add_fall(bench->builder, 2, 1, &rise), YK_LAW_OK);
    return bench_finish(bench, periodic ? 2 : 0);
}

// Peaks of the rises as the textbooks have them (Norton 2009, table 2-3). Where the slope of a law jumps, its
// curvature is infinite, which does not count as a jump of curvature.
static void bounds_are_those_of_the_textbooks(void **state)
{
    (void)state;
    static const struct {
        YkRiseLaw kind;
        double slope, curvature;
    } cases[] = {
        {YK_RISE_HARMONIC, YK_PI / 2, YK_PI * YK_PI / 2},
        {YK_RISE_CYCLOIDAL, 2, 2 * YK_PI},
        {YK_RISE_PARABOLIC, 2, 4},
        {YK_RISE_3_4_5, 1.875, 10 / 1.7320508075688772},
        {YK_RISE_4_5_6_7, 2.1875, 7.5131880995},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        for (int periodic = 0; periodic < 2; periodic++) {
            Bench bench;
            YkLawBound bound = yk_law_bound(there_and_back(&bench, cases[k].kind, periodic));
            assert_true(bound.is_continuous);
            assert_true(bound.slope >= cases[k].slope * (1 - 1e-9));
            CHECK_NEAR(bound.slope, cases[k].slope, 3e-6 * cases[k].slope);
            if (periodic) CHECK_NEAR(bound.curvature, cases[k].curvature, 3e-6 * cases[k].curvature);
            if (!periodic) assert_true(isinf(bound.curvature)); // the law may stand still from one moment to the next
            bench_free(&bench);
        }
}

// At each joint one thing jumps: the value, the slope, or none.
static void the_first_jump_tells_what_is_bounded(void **state)
{
    (void)state;
    for (int jump = 0; jump < 3; jump++)
        for (int place = 0; place < 3; place++) {
            Bench bench = bench_new(0, 0);
            for (int k = 0; k < 3; k++) {
                double slope = k == place && jump == 1 ? 1 : 0, from = k, value = yk_law_builder_value(bench.builder);
                double up = k == place && jump == 0 ? 0.25 : 0;
                const YkLawCondition conditions[] = {{from, 0, value + up},
                                                     {from, 1, slope},
                                                     {from + 1, 0, value},
                                                     {from + 1, 1, 0},
                                                     {from + 0.5, 0, value + 0.01}};
                assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, 5), YK_LAW_OK);
            }
            YkLawBound bound = yk_law_bound(bench_finish(&bench, 3));
            assert_int_equal(bound.is_continuous, jump > 0);
            assert_int_equal(isfinite(bound.curvature) != 0, jump > 1);
            bench_free(&bench);
        }
}

// A law with more jumps than are read counts as one that may jump anywhere.
static void too_many_jumps_bound_nothing(void **state)
{
    (void)state;
    Bench bench = bench_new(0, 0);
    for (int k = 0; k < 200; k++)
        assert_int_equal(yk_law_add_velocity(bench.builder, k + 1, k % 2 ? -1 : 1), YK_LAW_OK);
    YkLawBound bound = yk_law_bound(bench_finish(&bench, 200));
    assert_false(bound.is_continuous);
    assert_true(isinf(bound.curvature));
    CHECK_NEAR(bound.slope, 1, 3e-6);
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_are_those_of_the_textbooks),
        cmocka_unit_test(the_first_jump_tells_what_is_bounded),
        cmocka_unit_test(too_many_jumps_bound_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
