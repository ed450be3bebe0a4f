// Exact values against the evaluator of doubles: a value is exact and then right, in lowest terms, or it is not exact;
// and what fits in 64 bits by the school's rules is.
#include "fixture.h"
#include "base/vec.h"

static int64_t divisor_of(int64_t a, int64_t b)
{
    while (b != 0) {
        int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

static double value_of(YkExact e)
{
    return (double)((long double)e.numerator / (long double)e.denominator) * pow(YK_PI, e.pi);
}

static void check_lowest(YkExact e)
{
    assert_true(e.denominator > 0);
    assert_int_equal(divisor_of(e.numerator, e.denominator), 1);
    if (e.numerator == 0) assert_true(e.denominator == 1 && e.pi == 0);
}

typedef struct Known {
    const char *text;
    bool is_exact;
    int64_t numerator, denominator;
    int pi;
} Known;

static void fractions_follow_the_rules_of_school(void **state)
{
    (void)state;
    static const Known cases[] = {
        {"3/4", true, 3, 4, 0},
        {"-6/8", true, -3, 4, 0},
        {"6/(-8)", true, -3, 4, 0},
        {"1/2 + 1/3", true, 5, 6, 0},
        {"1/6 + 1/3", true, 1, 2, 0},
        {"1/2 - 1/2", true, 0, 1, 0},
        {"0*pi", true, 0, 1, 0},
        {"2*pi/4", true, 1, 2, 1},
        {"pi + pi/2", true, 3, 2, 1},
        {"pi*pi", true, 1, 1, 2},
        {"1/pi", true, 1, 1, -1},
        {"pi/pi", true, 1, 1, 0},
        {"0 + pi", true, 1, 1, 1},
        {"pi - 0", true, 1, 1, 1},
        {"(2/3)^3", true, 8, 27, 0},
        {"(2/3)^-3", true, 27, 8, 0},
        {"(-2)^3", true, -8, 1, 0},
        {"(-1/2)^-1", true, -2, 1, 0},
        {"7^0", true, 1, 1, 0},
        {"2^62", true, INT64_C(4611686018427387904), 1, 0},
        {"1e18", true, INT64_C(1000000000000000000), 1, 0},
        {"2.5e-3", true, 1, 400, 0},
        {"0.1 + 0.2", true, 3, 10, 0},
        {"30 deg", true, 1, 6, 1},
        {"30 rpm * 1 s", true, 1, 1, 1},
        {"1 deg/ms * 1 s", true, 50, 9, 1},
        {"25 mm", true, 1, 40, 0},
        {"2 in", true, 127, 2500, 0},
        {"50 %", true, 1, 2, 0},
        {"two + 1", true, 3, 1, 0},
        {"two^two", true, 4, 1, 0},
        {"1 + pi", false, 0, 0, 0},
        {"2^63", false, 0, 0, 0},
        {"2^65", false, 0, 0, 0},
        {"1e19", false, 0, 0, 0},
        {"2^(1/2)", false, 0, 0, 0},
        {"2^pi", false, 0, 0, 0},
        {"sqrt(4)", false, 0, 0, 0},
        {"9223372036854775807 + 1", false, 0, 0, 0},
        {"-9223372036854775807 - 1", false, 0, 0, 0},
        {"9223372036854775807 + 0", true, INT64_MAX, 1, 0},
        {"1/3037000500 + 1/3037000501", false, 0, 0, 0},
        {"0*sqrt(4)", false, 0, 0, 0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[400];
        snprintf(text, sizeof text, "parameters: {two: 2, x: \"%s\"}\n" CRANK, cases[k].text);
        YkModel *model = fixture_load(text);
        YkExact e = yk_model_exact(model, model->parameters[1].expr);
        if (e.is_exact != cases[k].is_exact) print_error("%s\n", cases[k].text);
        assert_int_equal(e.is_exact, cases[k].is_exact);
        if (e.is_exact) {
            if (e.numerator != cases[k].numerator || e.denominator != cases[k].denominator || e.pi != cases[k].pi)
                print_error("%s\n", cases[k].text);
            assert_true(e.numerator == cases[k].numerator && e.denominator == cases[k].denominator);
            assert_int_equal(e.pi, cases[k].pi);
            double value = model->parameters[1].value;
            CHECK_NEAR(value_of(e), value, 4e-16 * fabs(value));
        }
        yk_model_free(model);
    }
}

static void grow(uint64_t *seed, int depth, char *out, size_t size)
{
    static const char *const leaves[] = {"1",      "2",     "3/7", "0.25", "pi",        "12",
                                         "1.5e-2", "11/13", "a",   "b",    "123456789", "-5"};
    static const char *const signs[] = {" + ", " - ", "*", "/"};
    size_t used = strlen(out);
    if (depth == 0) {
        snprintf(out + used, size - used, "(%s)", leaves[check_random(seed) % 12]);
        return;
    }
    snprintf(out + used, size - used, "(");
    grow(seed, depth - 1, out, size);
    used = strlen(out);
    if (check_random(seed) % 6 == 0) {
        snprintf(out + used, size - used, ")^%d", (int)(check_random(seed) % 7) - 3);
        return;
    }
    snprintf(out + used, size - used, "%s", signs[check_random(seed) % 4]);
    grow(seed, depth - 1, out, size);
    used = strlen(out);
    snprintf(out + used, size - used, ")");
}

static void what_is_exact_has_the_value_of_the_doubles(void **state)
{
    (void)state;
    uint64_t seed = 77, cases = check_cases(1500);
    size_t exact = 0, not = 0;
    for (uint64_t k = 0; k < cases; k++) {
        char x[3000] = "", text[4000];
        grow(&seed, (int)(k % 5), x, sizeof x);
        snprintf(text, sizeof text, "parameters: {a: 2/3, b: 3*a - pi/4, x: \"%s\"}\n" CRANK, x);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
        yk_problems_free(problems);
        if (!model) continue; // a division by zero
        YkExact e = yk_model_exact(model, model->parameters[2].expr);
        *(e.is_exact ? &exact : &not ) += 1;
        if (e.is_exact) {
            check_lowest(e);
            double value = model->parameters[2].value; // a difference may have cancelled
            if (!(fabs(value_of(e) - value) <= 1e-9 * (1 + fabs(value)))) print_error("%s\n", x);
            CHECK_NEAR(value_of(e), value, 1e-9 * (1 + fabs(value)));
        }
        yk_model_free(model);
    }
    assert_true(exact > cases / 5 && not > cases / 5);
}

// Of a drive: constant + rate t, exact each, or no line.
static void a_line_in_time_has_both_parts(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool is_line;
        double constant, rate;
    } cases[] = {{"30 deg + 2 rad/s * t", true, YK_PI / 6, 2},
                 {"1 rad - (t - 3 s)*2 rad/s/4", true, 2.5, -0.5},
                 {"60 rpm * t", true, 0, 2 * YK_PI},
                 {"2 rad", true, 2, 0},
                 {"3 rad/s * (2*t - t)", true, 0, 3},
                 {"1 rad/s^2 * t*t", false, 0, 0},
                 {"1 rad*s/t", false, 0, 0},
                 {"1 rad/s * sin(1)*t", false, 0, 0}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[400];
        snprintf(text, sizeof text, CRANK "drives: {theta: \"%s\"}\n", cases[k].text);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
        if (model) {
            YkExactLine line = yk_model_exact_line(model, model->drives[0].expr);
            bool is_line = line.constant.is_exact && line.rate.is_exact;
            if (is_line != cases[k].is_line) print_error("%s\n", cases[k].text);
            assert_int_equal(is_line, cases[k].is_line);
            if (is_line) CHECK_NEAR(value_of(line.constant), cases[k].constant, 1e-15);
            if (is_line) CHECK_NEAR(value_of(line.rate), cases[k].rate, 1e-14);
            YkExact alone = yk_model_exact(model, model->drives[0].expr);
            assert_int_equal(alone.is_exact, is_line && cases[k].rate == 0);
        } else {
            assert_false(cases[k].is_line);
        }
        yk_problems_free(problems);
        yk_model_free(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fractions_follow_the_rules_of_school),
        cmocka_unit_test(what_is_exact_has_the_value_of_the_doubles),
        cmocka_unit_test(a_line_in_time_has_both_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
