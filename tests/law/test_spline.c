// Splines through points, with conditions at their ends.
#include "law/law_check.h"

static const YkLaw *make(Bench *bench, const YkLawCondition *conditions, size_t count, int degree)
{
    *bench = bench_new(conditions[0].at, 0);
    YkLawFault fault = yk_law_add_spline(bench->builder, conditions, count, degree);
    if (fault != YK_LAW_OK)
        print_error("fault %d, condition %d\n", (int)fault, (int)yk_law_builder_culprit(bench->builder));
    assert_int_equal(fault, YK_LAW_OK);
    return bench_finish(bench, 0);
}

// Rise, through points, at rest at both ends.
static size_t cam_conditions(YkLawCondition *conditions, int inner)
{
    size_t count = 0;
    for (int m = 0; m < 3; m++) conditions[count++] = (YkLawCondition){0, m, 0};
    for (int i = 1; i <= inner; i++) {
        double x = 4.0 * i / (inner + 1);
        conditions[count++] = (YkLawCondition){x, 0, 5 * sin(x) + x};
    }
    for (int m = 0; m < 3; m++) conditions[count++] = (YkLawCondition){4, m, m == 0 ? 5 : 0};
    return count;
}

static void a_spline_meets_its_conditions(void **state)
{
    (void)state;
    for (int degree = 3; degree <= YK_LAW_DEGREE_MAX; degree++) {
        for (int inner = degree > 5 ? degree - 5 : 1; inner < 30; inner += 4) {
            YkLawCondition conditions[50];
            Bench bench;
            size_t count = cam_conditions(conditions, inner);
            const YkLaw *law = make(&bench, conditions, count, degree);
            for (size_t i = 0; i < count; i++) {
                int m = conditions[i].order;
                double x = conditions[i].at < 4 ? conditions[i].at : nextafter(4, 0);
                CHECK_NEAR(law_value(law, x, m), conditions[i].value, 1e-10 * (1 + fabs(yk_law_peak(law, m).value)));
            }
            bench_free(&bench);
        }
    }
}

// Of degree k it is continuous to derivative k - 1 at its knots.
static void a_spline_is_smooth_at_its_knots(void **state)
{
    (void)state;
    for (int degree = 3; degree <= 7; degree++) {
        YkLawCondition conditions[50];
        Bench bench;
        const YkLaw *law = make(&bench, conditions, cam_conditions(conditions, 9), degree);
        int smooth = degree - 1 < YK_LAW_ORDER ? degree - 1 : YK_LAW_ORDER;
        assert_int_equal(yk_law_segment(law, 0).piece_count, 15 - degree);
        for (int i = 1, count = (int)check_cases(4000); i < count; i++) {
            double x = i * 4.0 / count, d[5], e[5];
            yk_law_eval(law, x, d);
            yk_law_eval(law, x + 1e-12, e);
            for (int m = 0; m <= smooth; m++) CHECK_NEAR(e[m], d[m], 1e-7 * (1 + fabs(yk_law_peak(law, m).value)));
        }
        bench_free(&bench);
    }
}

// A polynomial of no higher degree is its own spline.
static void a_polynomial_is_recovered(void **state)
{
    (void)state;
    for (int degree = 1; degree <= YK_LAW_DEGREE_MAX; degree++) {
        YkLawCondition conditions[20];
        for (int i = 0; i < 20; i++) {
            double x = 1 + i / 5.0;
            conditions[i] = (YkLawCondition){x, 0, pow(x - 2, degree) - x};
        }
        Bench bench;
        const YkLaw *law = make(&bench, conditions, 20, degree);
        for (double x = 1.01; x < 4.8; x += 0.0371) {
            CHECK_NEAR(law_value(law, x, 0), pow(x - 2, degree) - x, 1e-9);
            CHECK_NEAR(law_value(law, x, 1), degree * pow(x - 2, degree - 1) - 1, 1e-7);
        }
        bench_free(&bench);
    }
}

// With as many conditions as its degree has coefficients it is the polynomial of these conditions: here the 3-4-5.
static void without_inner_knots_it_is_the_polynomial(void **state)
{
    (void)state;
    YkLawCondition conditions[6];
    for (int m = 0; m < 3; m++) {
        conditions[m] = (YkLawCondition){0, m, 0};
        conditions[3 + m] = (YkLawCondition){1, m, m == 0};
    }
    Bench bench, other = bench_new(0, 0);
    const YkLaw *law = make(&bench, conditions, 6, 5);
    assert_int_equal(yk_law_add_rise(other.builder, 1, 1, &(YkRise){.law = YK_RISE_3_4_5}), YK_LAW_OK);
    const YkLaw *rise = bench_finish(&other, 0);
    for (double x = 0.01; x < 1; x += 0.03) {
        for (int m = 0; m <= YK_LAW_ORDER; m++)
            CHECK_NEAR(law_value(law, x, m), law_value(rise, x, m), 1e-12 * pow(10, m));
    }
    bench_free(&bench);
    bench_free(&other);
}

static void what_cannot_be_a_spline_is_refused(void **state)
{
    (void)state;
    YkLawCondition conditions[50];
    size_t count = cam_conditions(conditions, 1);
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_spline(bench.builder, conditions, count, 7), YK_LAW_TOO_FEW);
    assert_int_equal(yk_law_add_spline(bench.builder, conditions, count, 0), YK_LAW_SHAPE);
    assert_int_equal(yk_law_add_spline(bench.builder, conditions, count, 10), YK_LAW_SHAPE);
    conditions[3] = (YkLawCondition){0, 3, 1}; // a jerk, but straight lines have none
    assert_int_equal(yk_law_add_spline(bench.builder, conditions, count, 1), YK_LAW_CONTRADICTION);
    conditions[3] = conditions[1];
    assert_int_equal(yk_law_add_spline(bench.builder, conditions, count, 4), YK_LAW_REPEATED);
    assert_int_equal(yk_law_builder_culprit(bench.builder), 3);
    bench_free(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spline_meets_its_conditions),
        cmocka_unit_test(a_spline_is_smooth_at_its_knots),
        cmocka_unit_test(a_polynomial_is_recovered),
        cmocka_unit_test(without_inner_knots_it_is_the_polynomial),
        cmocka_unit_test(what_cannot_be_a_spline_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
