// Polynomials from conditions.
#include "law/law_check.h"

typedef struct PolynomialCase {
    YkLawCondition conditions[21];
    struct {
        double x, d[YK_LAW_ORDER + 1];
    } expected[8];
} PolynomialCase;
#include "law/polynomial_cases.h"

static const YkLaw *make(Bench *bench, const YkLawCondition *conditions, size_t count)
{
    double from = INFINITY;
    for (size_t i = 0; i < count; i++) from = fmin(from, conditions[i].at);
    *bench = bench_new(from, 0);
    YkLawFault fault = yk_law_add_polynomial(bench->builder, conditions, count);
    if (fault != YK_LAW_OK) print_error("fault %d\n", (int)fault);
    assert_int_equal(fault, YK_LAW_OK);
    return bench_finish(bench, 0);
}

// The cam of the format: s = h (64 u^3 - 192 u^4 + 192 u^5 - 64 u^6), u = theta / (4 pi / 3).
static void the_cep_cam_is_its_closed_form(void **state)
{
    (void)state;
    const double b = 4 * YK_PI / 3, h = 0.2;
    const YkLawCondition conditions[] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {2 * YK_PI / 3, 0, h},
                                         {b, 0, 0}, {b, 1, 0}, {b, 2, 0}};
    Bench bench;
    const YkLaw *law = make(&bench, conditions, 7);
    for (double x = 0; x < b; x += 0.01) {
        double u = x / b, q = u * u;
        const double exact[5] = {q * u * (64 - 192 * u + 192 * q - 64 * q * u),
                                 q * (192 - 768 * u + 960 * q - 384 * q * u),
                                 u * (384 - 2304 * u + 3840 * q - 1920 * q * u),
                                 384 - 4608 * u + 11520 * q - 7680 * q * u, -4608 + 23040 * u - 23040 * q};
        for (int m = 0; m <= YK_LAW_ORDER; m++)
            CHECK_NEAR(law_value(law, x, m), h * exact[m] / pow(b, m), 1e-13 * h * pow(10, m));
    }
    double c[7];
    assert_true(yk_law_power_coefficients(law, 0, c));
    const double powers[7] = {0, 0, 0, 64, -192, 192, -64};
    for (int k = 0; k < 7; k++) CHECK_NEAR(c[k] * pow(b, k), powers[k] * h, 1e-12);
    bench_free(&bench);
}

static void degree_20_keeps_10_digits(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof polynomial_cases / sizeof *polynomial_cases; i++) {
        Bench bench;
        const YkLaw *law = make(&bench, polynomial_cases[i].conditions, 21);
        for (int m = 0; m <= YK_LAW_ORDER; m++) {
            double largest = fabs(yk_law_peak(law, m).value);
            for (int k = 0; k < 8; k++) {
                double expected = polynomial_cases[i].expected[k].d[m];
                double got = law_value(law, polynomial_cases[i].expected[k].x, m);
                CHECK_NEAR(got, expected, 1e-10 * fabs(expected) + 1e-13 * largest);
            }
        }
        bench_free(&bench);
    }
}

// Conditions of a random polynomial, in powers of (x - 2), give it back.
static void a_random_polynomial_is_recovered_from_its_conditions(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 200; seed++) {
        uint64_t random = seed;
        double c[12];
        size_t count = 4 + check_random(&random) % 9, given = 0;
        for (size_t k = 0; k < count; k++) c[k] = check_uniform(&random, -1, 1);
        YkLawCondition conditions[12];
        for (int place = 0; given < count; place++) {
            double x = 1 + (place % 2 ? 2 - place * 0.15 : place * 0.15);
            int orders = 1 + (int)(check_random(&random) % 3);
            for (int m = 0; m < orders && given < count; m++) conditions[given++] = (YkLawCondition){x, m, 0};
        }
        for (size_t i = 0; i < count; i++) {
            YkLawCondition shifted = conditions[i];
            double row[12];
            shifted.at -= 2;
            yk_law_power_row(&shifted, count, row);
            for (size_t k = 0; k < count; k++) conditions[i].value += row[k] * c[k];
        }
        Bench bench;
        const YkLaw *law = make(&bench, conditions, count);
        YkLawRange range = yk_law_range(law);
        for (int k = 0; k < 10; k++) {
            double x = range.from + (range.to - range.from) * (k + 0.5) / 10, value = 0;
            for (size_t j = count; j-- > 0;) value = value * (x - 2) + c[j];
            CHECK_NEAR(law_value(law, x, 0), value, 1e-11);
        }
        bench_free(&bench);
    }
}

// Of whatever order at whatever place, ends and inner ones.
static void conditions_are_met(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 300; seed++) {
        uint64_t random = seed;
        YkLawCondition conditions[25];
        size_t count = 0, places = 2 + check_random(&random) % 4;
        for (size_t i = 0; i < places; i++) {
            double x = -3 + 7 * (double)i / (double)(places - 1);
            int orders = 1 + (int)(check_random(&random) % 5);
            for (int m = 0; m < orders; m++)
                conditions[count++] = (YkLawCondition){x, m, check_uniform(&random, -1, 1)};
        }
        Bench bench;
        const YkLaw *law = make(&bench, conditions, count);
        for (size_t i = 0; i < count; i++) {
            int m = conditions[i].order;
            double x = conditions[i].at < 4 ? conditions[i].at : nextafter(4, 0);
            CHECK_NEAR(law_value(law, x, m), conditions[i].value, 1e-12 * fabs(yk_law_peak(law, m).value));
        }
        bench_free(&bench);
    }
}

static void the_order_in_which_conditions_are_given_does_not_matter(void **state)
{
    (void)state;
    const YkLawCondition a[] = {{0, 0, 1}, {0, 1, 2}, {3, 0, -1}, {3, 2, 4}, {1, 1, 0.5}};
    const YkLawCondition b[] = {{1, 1, 0.5}, {3, 2, 4}, {0, 1, 2}, {3, 0, -1}, {0, 0, 1}};
    Bench one, two;
    const YkLaw *first = make(&one, a, 5), *second = make(&two, b, 5);
    for (double x = 0; x < 3; x += 0.1) {
        for (int m = 0; m <= YK_LAW_ORDER; m++) CHECK_NEAR(law_value(first, x, m), law_value(second, x, m), 0);
    }
    YkLawSegment segment = yk_law_segment(second, 0);
    const YkLawCondition sorted[] = {{0, 0, 1}, {3, 0, -1}, {0, 1, 2}, {1, 1, 0.5}, {3, 2, 4}}; // s, s, v, v, a
    assert_int_equal(segment.condition_count, 5);
    for (size_t i = 0; i < 5; i++) {
        CHECK_NEAR(segment.conditions[i].at, sorted[i].at, 0);
        assert_int_equal(segment.conditions[i].order, sorted[i].order);
        CHECK_NEAR(segment.conditions[i].value, sorted[i].value, 0);
    }
    assert_true(segment.condition_number >= 1 && segment.condition_number < 1e4);
    bench_free(&one);
    bench_free(&two);
}

static void the_power_matrix_times_the_coefficients_is_the_right_side(void **state)
{
    (void)state;
    const YkLawCondition conditions[] = {{0.5, 0, 1}, {0.5, 1, 2}, {2, 0, -1}, {2, 2, 4}, {1, 3, 0.5}, {2, 4, 1}};
    Bench bench;
    const YkLaw *law = make(&bench, conditions, 6);
    YkLawSegment segment = yk_law_segment(law, 0);
    double c[6], row[6];
    assert_true(yk_law_power_coefficients(law, 0, c));
    for (size_t i = 0; i < segment.condition_count; i++) {
        double sum = 0;
        yk_law_power_row(&segment.conditions[i], 6, row);
        for (size_t k = 0; k < 6; k++) sum += row[k] * c[k];
        CHECK_NEAR(sum, segment.conditions[i].value, 1e-11);
    }
    assert_false(yk_law_power_coefficients(law, 1, c));
    bench_free(&bench);
}

static void refused(const YkLawCondition *conditions, size_t count, YkLawFault fault, size_t culprit)
{
    Bench bench = bench_new(0, 0);
    assert_int_equal(yk_law_add_polynomial(bench.builder, conditions, count), fault);
    if (culprit < count) assert_int_equal(yk_law_builder_culprit(bench.builder), culprit);
    // the builder is as before
    assert_int_equal(yk_law_finish(bench.builder, 0, bench.arena, &bench.law), YK_LAW_EMPTY);
    assert_int_equal(yk_law_add_dwell(bench.builder, 1), YK_LAW_OK);
    bench_finish(&bench, 0);
    assert_int_equal(yk_law_segment(bench.law, 0).condition_count, 0);
    bench_free(&bench);
}

static void conditions_that_determine_nothing_are_named(void **state)
{
    (void)state;
    // a parabola's slope in the middle follows from its ends
    const YkLawCondition follows[] = {{0, 0, 1}, {2, 0, 3}, {1, 1, 1}};
    const YkLawCondition contradicts[] = {{0, 0, 1}, {2, 0, 3}, {1, 1, 2}};
    refused(follows, 3, YK_LAW_UNDETERMINED, 2);
    refused(contradicts, 3, YK_LAW_CONTRADICTION, 2);
    // nothing but velocities: where it stands remains open
    const YkLawCondition floats[] = {{0, 1, 1}, {2, 1, 3}, {1, 1, 7}};
    refused(floats, 3, YK_LAW_CONTRADICTION, 99);
    const YkLawCondition twice[] = {{0, 0, 1}, {2, 0, 3}, {2, 1, 0}, {0, 0, 2}};
    refused(twice, 4, YK_LAW_REPEATED, 3);
    const YkLawCondition one_place[] = {{0, 0, 1}, {0, 1, 3}};
    refused(one_place, 2, YK_LAW_TOO_FEW, 99);
    refused(follows, 1, YK_LAW_TOO_FEW, 99);
    const YkLawCondition late[] = {{1, 0, 1}, {2, 0, 3}}, early[] = {{-1, 0, 1}, {2, 0, 3}};
    refused(late, 2, YK_LAW_GAP, 99);
    refused(early, 2, YK_LAW_OVERLAP, 99);
    const YkLawCondition huge[] = {{0, 0, 1e300}, {1e-10, 0, 3}, {1e-10, 1, 5}};
    refused(huge, 3, YK_LAW_NOT_FINITE, 99);
}

static void too_many_conditions_are_refused(void **state)
{
    (void)state;
    YkLawCondition conditions[YK_LAW_CONDITIONS_MAX + 1];
    for (size_t i = 0; i <= YK_LAW_CONDITIONS_MAX; i++) conditions[i] = (YkLawCondition){(double)i, 0, 0};
    refused(conditions, YK_LAW_CONDITIONS_MAX + 1, YK_LAW_TOO_MANY, 999);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cep_cam_is_its_closed_form),
        cmocka_unit_test(degree_20_keeps_10_digits),
        cmocka_unit_test(a_random_polynomial_is_recovered_from_its_conditions),
        cmocka_unit_test(conditions_are_met),
        cmocka_unit_test(the_order_in_which_conditions_are_given_does_not_matter),
        cmocka_unit_test(the_power_matrix_times_the_coefficients_is_the_right_side),
        cmocka_unit_test(conditions_that_determine_nothing_are_named),
        cmocka_unit_test(too_many_conditions_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
