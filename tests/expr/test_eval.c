// Evaluation: closed forms, and random expressions against an independent evaluator in long double, whose derivatives
// come from differences with Richardson extrapolation.
#include "expr_check.h"
#include <float.h>

// t, and three constants.
static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    const double *t = context;
    *jet = (YkJet){{0}};
    if (strcmp(name->name, "t") == 0) {
        jet->d[0] = *t;
        jet->d[1] = 1;
        return true;
    }
    if (strcmp(name->name, "a") == 0) jet->d[0] = 0.7;
    if (strcmp(name->name, "b") == 0) jet->d[0] = -1.3;
    if (strcmp(name->name, "w") == 0) jet->d[0] = 2.5;
    return jet->d[0] != 0;
}

static YkJet eval_at(const char *text, double t)
{
    Fixture fixture = fixture_new();
    const YkExpr *expr = fixture_parse(&fixture, text);
    const char *why = NULL;
    YkJet jet;
    assert_non_null(expr);
    const YkExpr *fault = yk_expr_eval(expr, lookup, &t, &jet, &why);
    if (fault) print_error("«%s» at %g: %s\n", text, t, why);
    assert_null(fault);
    assert_null(why);
    fixture_free(&fixture);
    return jet;
}

static void check_jet(const char *text, double t, const double expected[5])
{
    YkJet jet = eval_at(text, t);
    for (int k = 0; k <= 4; k++) {
        double tolerance = 1e-13 * (1 + fabs(expected[k]));
        if (!(fabs(jet.d[k] - expected[k]) <= tolerance)) print_error("«%s», derivative %d\n", text, k);
        CHECK_NEAR(jet.d[k], expected[k], tolerance);
    }
}

static void derivatives_match_closed_forms(void **state)
{
    (void)state;
    const double w = 2.5, a = 0.7;
    for (double t = 0.3; t < 3; t += 0.4) {
        double s = sin(w * t), c = cos(w * t), e = exp(-a * t);
        check_jet("sin(w*t)", t, (double[]){s, w * c, -w * w * s, -pow(w, 3) * c, pow(w, 4) * s});
        check_jet("exp(-a*t)", t, (double[]){e, -a * e, a * a * e, -pow(a, 3) * e, pow(a, 4) * e});
        check_jet("t^5", t, (double[]){pow(t, 5), 5 * pow(t, 4), 20 * pow(t, 3), 60 * t * t, 120 * t});
        check_jet("1/t", t, (double[]){1 / t, -pow(t, -2), 2 * pow(t, -3), -6 * pow(t, -4), 24 * pow(t, -5)});
        check_jet("log(t)", t, (double[]){log(t), 1 / t, -pow(t, -2), 2 * pow(t, -3), -6 * pow(t, -4)});
        const double decade = log(10);
        check_jet("log10(t)", t,
                  (double[]){log10(t), 1 / t / decade, -pow(t, -2) / decade, 2 * pow(t, -3) / decade,
                             -6 * pow(t, -4) / decade});
        check_jet("sqrt(t)", t,
                  (double[]){sqrt(t), 0.5 * pow(t, -0.5), -0.25 * pow(t, -1.5), 0.375 * pow(t, -2.5),
                             -0.9375 * pow(t, -3.5)});
        check_jet("abs(b*t)", t, (double[]){1.3 * t, 1.3, 0, 0, 0});
        check_jet("a - b", t, (double[]){2.0, 0, 0, 0, 0});
    }
}

// An evaluator that shares nothing with the one under test: values only, in long double.
static long double naive(const YkExpr *expr, long double t)
{
    if (expr->kind == YK_EXPR_NUMBER) return (long double)expr->number * (expr->has_unit ? expr->unit_size : 1);
    if (expr->kind == YK_EXPR_NAME) {
        switch (expr->name[0]) {
        case 't':
            return t;
        case 'a':
            return 0.7;
        case 'b':
            return -1.3;
        default:
            return 2.5;
        }
    }
    long double a = naive(expr->a, t), b = expr->b ? naive(expr->b, t) : 0;
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        return -a;
    case YK_EXPR_ADD:
        return a + b;
    case YK_EXPR_SUBTRACT:
        return a - b;
    case YK_EXPR_MULTIPLY:
        return a * b;
    case YK_EXPR_DIVIDE:
        return a / b;
    case YK_EXPR_POWER:
        return powl(a, b);
    default:
        break;
    }
    switch (expr->function) {
    case YK_SIN:
        return sinl(a);
    case YK_COS:
        return cosl(a);
    case YK_TAN:
        return tanl(a);
    case YK_ASIN:
        return asinl(a);
    case YK_ACOS:
        return acosl(a);
    case YK_ATAN:
        return atanl(a);
    case YK_ATAN2:
        return atan2l(a, b);
    case YK_SINH:
        return sinhl(a);
    case YK_COSH:
        return coshl(a);
    case YK_TANH:
        return tanhl(a);
    case YK_SQRT:
        return sqrtl(a);
    case YK_EXP:
        return expl(a);
    case YK_LOG:
        return logl(a);
    case YK_LOG10:
        return log10l(a);
    case YK_ABS:
        return fabsl(a);
    case YK_SIGN:
        return (a > 0) - (a < 0);
    case YK_MIN:
        return a < b ? a : b;
    default:
        return a > b ? a : b;
    }
}

// The central difference of order k at step h.
static long double difference(const YkExpr *expr, long double t, int k, long double h)
{
    static const int weights[5][5] = {
        {0, 0, 1, 0, 0}, {0, -1, 0, 1, 0}, {0, 1, -2, 1, 0}, {-1, 2, 0, -2, 1}, {1, -4, 6, -4, 1}};
    long double sum = 0;
    for (int i = 0; i < 5; i++)
        if (weights[k][i]) sum += weights[k][i] * naive(expr, t + (i - 2) * h);
    return sum / (k % 2 ? 2 : 1) / powl(h, k);
}

// Richardson's table over halved steps; *error is how far its last two corners lie apart.
static long double richardson(const YkExpr *expr, long double t, int k, long double *error)
{
    enum { ROWS = 5 }; // smaller steps lose the fourth derivative in rounding
    long double table[ROWS][ROWS], h = 0.08L;
    for (int i = 0; i < ROWS; i++, h /= 2) {
        table[i][0] = difference(expr, t, k, h);
        long double four = 4;
        for (int j = 1; j <= i; j++, four *= 4)
            table[i][j] = table[i][j - 1] + (table[i][j - 1] - table[i - 1][j - 1]) / (four - 1);
    }
    long double best = table[2][2];
    *error = fabsl(table[2][2] - table[1][1]);
    for (int i = 3; i < ROWS; i++) {
        long double change = fabsl(table[i][i] - table[i - 1][i - 1]);
        if (change >= *error) continue;
        *error = change;
        best = table[i][i];
    }
    return best;
}

// A random smooth expression of t, safe almost everywhere.
static void grow(uint64_t *seed, int depth, char *out, size_t size)
{
    static const char *const leaves[] = {"t", "a", "b", "w", "0.4", "t", "3/2"};
    static const char *const functions[] = {"sin", "cos", "atan", "tanh", "exp", "sinh", "cosh", "tan", "abs"};
    uint64_t choice = check_random(seed) % 14;
    if (depth == 0) {
        tree_add(out, size, leaves[check_random(seed) % 7]);
        return;
    }
    const char *before = "(", *between = NULL, *after = ")";
    if (choice < 2)
        between = " + ";
    else if (choice < 4)
        between = " - ";
    else if (choice < 6)
        between = "*";
    else if (choice == 6)
        between = ")/(2 + sin(", before = "((", after = ")))";
    else if (choice == 7)
        before = "(", after = ")^3";
    else if (choice == 8)
        before = "(1.5 + sin(", after = "))^2.5";
    else if (choice == 9)
        before = "sqrt(1.5 + cos(", after = "))";
    else if (choice == 10)
        before = "log(1.2 + sin(", after = "))";
    else if (choice == 11)
        before = "asin(0.6*cos(", after = "))";
    else if (choice == 12)
        before = "atan2(1.1 + sin(", between = "), 2 + cos(", after = "))";
    else {
        tree_add(out, size, functions[check_random(seed) % 9]);
    }
    tree_add(out, size, before);
    grow(seed, depth - 1, out, size);
    if (between) {
        tree_add(out, size, between);
        grow(seed, depth - 1, out, size);
    }
    tree_add(out, size, after);
}

static void random_expressions_agree_with_differences_of_an_independent_evaluator(void **state)
{
    (void)state;
    if (LDBL_MANT_DIG < 64) skip();
    uint64_t seed = 20240601;
    int compared = 0;
    for (int trial = 0; trial < 600; trial++) {
        char text[4096] = "";
        grow(&seed, 1 + trial % 4, text, sizeof text);
        Fixture fixture = fixture_new();
        const YkExpr *expr = fixture_parse(&fixture, text);
        assert_non_null(expr);
        double t = check_uniform(&seed, 0.2, 1.5);
        const char *why;
        YkJet jet;
        if (!yk_expr_eval(expr, lookup, &t, &jet, &why))
            for (int k = 0; k <= 4; k++) {
                long double error = 0, wanted = k == 0 ? naive(expr, t) : richardson(expr, t, k, &error);
                // a pole or kink nearby shows in differences that do not settle
                if (!(error < 1e-6L * (1 + fabsl(wanted)))) continue;
                double allowed = k == 0 ? 1e-13 * (1 + fabs((double)wanted))
                                        : 1e-8 * (1 + fabs((double)wanted)) + 10 * (double)error;
                if (!(fabs(jet.d[k] - (double)wanted) <= allowed))
                    print_error("«%s» at %.17g, derivative %d\n", text, t, k);
                CHECK_NEAR(jet.d[k], (double)wanted, allowed);
                compared++;
            }
        fixture_free(&fixture);
    }
    assert_true(compared > 2000); // of 3000: the test must not skip itself away
}

static void units_and_scales_lead_to_si(void **state)
{
    (void)state;
    CHECK_NEAR(eval_at("sin(30 deg)", 0).d[0], 0.5, 1e-15);
    CHECK_NEAR(eval_at("3/4 mm", 0).d[0], 0.75e-3, 1e-18);
    CHECK_NEAR(eval_at("20 rpm * t", 3).d[0], 20 * 2 * 3.14159265358979323846 / 60 * 3, 1e-14);
    CHECK_NEAR(eval_at("pi", 0).d[0], 3.14159265358979323846, 0);
    Fixture fixture = fixture_new();
    YkExpr *bare = fixture_parse(&fixture, "12"), *unit = fixture_parse(&fixture, "12 mm");
    YkJet jet;
    const char *why;
    bare->value_scale = unit->value_scale = 0.5;
    assert_null(yk_expr_eval(bare, NULL, NULL, &jet, &why));
    CHECK_NEAR(jet.d[0], 6, 0);
    assert_null(yk_expr_eval(unit, NULL, NULL, &jet, &why));
    CHECK_NEAR(jet.d[0], 0.012, 1e-18);
    fixture_free(&fixture);
}

static void the_part_at_fault_is_returned_with_the_reason(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        unsigned column, length;
        const char *why;
    } cases[] = {
        {"1 + 2/(a - a)", 5, 9, "division by zero"}, {"3*sqrt(b)", 3, 7, "negative"},
        {"log(0)", 1, 6, "logarithm of zero"},       {"1 + c", 5, 1, "no value"},
        {"a + exp(1000)*2", 5, 9, "too large"},      {"asin(2)", 1, 7, "beyond 1"},
        {"2*b^0.5", 3, 5, "broken power"},           {"(t - t)^-1", 1, 10, "division by zero"},
        {"atan2(0, 0)", 1, 11, "two zeros"},         {"1e300*1e300", 1, 11, "too large"},
        {"sqrt(t)", 1, 7, "no derivative"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        double t = 0;
        YkJet jet = {{1, 1, 1, 1, 1}};
        const char *why = NULL;
        const YkExpr *fault = yk_expr_eval(fixture_parse(&fixture, cases[i].text), lookup, &t, &jet, &why);
        assert_non_null(fault);
        assert_int_equal(fault->place.column, 10 + cases[i].column);
        assert_int_equal(fault->place.length, cases[i].length);
        assert_non_null(strstr(why, cases[i].why));
        CHECK_NEAR(jet.d[0], 0, 0);
        fixture_free(&fixture);
    }
}

static bool frozen(const void *context, const YkExpr *name, YkJet *jet)
{
    (void)context, (void)name;
    *jet = (YkJet){{0}};
    return true;
}

static void values_without_derivatives_may_stand_at_the_end_of_a_range(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    YkJet jet;
    const char *why;
    assert_null(yk_expr_eval(fixture_parse(&fixture, "1 + sqrt(t) + t^1.5"), frozen, NULL, &jet, &why));
    CHECK_NEAR(jet.d[0], 1, 0);
    fixture_free(&fixture);
}

static bool infinite(const void *context, const YkExpr *name, YkJet *jet)
{
    (void)context, (void)name;
    *jet = (YkJet){{1, 0, 0, INFINITY, 0}};
    return true;
}

static void an_infinite_derivative_from_outside_is_a_fault(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    YkJet jet;
    const char *why;
    assert_non_null(yk_expr_eval(fixture_parse(&fixture, "2*x"), infinite, NULL, &jet, &why));
    fixture_free(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_match_closed_forms),
        cmocka_unit_test(random_expressions_agree_with_differences_of_an_independent_evaluator),
        cmocka_unit_test(units_and_scales_lead_to_si),
        cmocka_unit_test(the_part_at_fault_is_returned_with_the_reason),
        cmocka_unit_test(values_without_derivatives_may_stand_at_the_end_of_a_range),
        cmocka_unit_test(an_infinite_derivative_from_outside_is_a_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
