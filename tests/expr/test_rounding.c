// The bound of rounding against the errors written out by hand for each operation, and against values in long double.
#include <float.h>
#include "base/vec.h"
#include "expr_check.h"

static const double a = 0.7, b = 1.3, t = 0.6;

static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    (void)context;
    if (strlen(name->name) != 1) return false;
    switch (name->name[0]) {
    case 'a':
        *jet = (YkJet){{a}};
        return true;
    case 'b':
        *jet = (YkJet){{b}};
        return true;
    case 'k':
        *jet = (YkJet){{4}};
        return true;
    case 't':
        *jet = (YkJet){{t, 1}};
        return true;
    default:
        return false;
    }
}

static double rounding(const char *text)
{
    Fixture f = fixture_new();
    const YkExpr *expr = fixture_parse(&f, text);
    assert_non_null(expr);
    double found = yk_expr_rounding(expr, lookup, NULL);
    fixture_free(&f);
    return found;
}

// Every name and number that is not whole, and every result, is off by its last bit; the slopes carry it on.
static void each_operation_adds_its_last_bit(void **unused)
{
    (void)unused;
    double power = pow(a, b);
    const struct {
        const char *text;
        double epsilons;
    } cases[] = {
        {"3", 0},
        {"k", 0}, // whole
        {"t", 0}, // exact
        {"a", a},
        {"-a", a},
        {"0.4", 0.4},
        {"20 mm", 0.02},
        {"pi", YK_PI},
        {"k + 2", 6},
        {"t + 3", 3.6},
        {"a + b", a + b + 2},
        {"a - b", a + b + 0.6},
        {"b - a - 0.5", 0.6 + a + b + 0.5 + 0.1},
        {"a*b", 3 * a * b},
        {"k*b", 2 * 4 * b},
        {"b*k", 2 * 4 * b},
        {"a/b", 3 * a / b},
        {"k/b", 2 * 4 / b},
        {"b/k", 2 * b / 4},
        {"sin(a)", a * cos(a) + sin(a)},
        {"sin(t)", sin(t)},
        {"sqrt(b)", sqrt(b) / 2 + sqrt(b)},
        {"log(a)", 1 - log(a)},
        {"a^2", 2 * a * a + a * a},
        {"a^b", b * power - b * log(a) * power + power},
        {"k^b", b * log(4) * pow(4, b) + pow(4, b)},
        {"atan2(a, b)", 2 * a * b / (a * a + b * b) + atan2(a, b)},
        {"max(a, b)", 2 * b},
        {"2*(a + t)", 2 * (a + a + t) + 2 * (a + t)},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double found = rounding(cases[i].text) / DBL_EPSILON;
        if (!(fabs(found - cases[i].epsilons) <= 1e-12 * (1 + found))) print_error("%s\n", cases[i].text);
        CHECK_NEAR(found, cases[i].epsilons, 1e-12 * (1 + found));
    }
}

static void what_has_no_value_has_no_bound(void **unused)
{
    (void)unused;
    static const char *const texts[] = {"stranger", "1 + stranger", "1/0", "0/0", "sqrt(-a)", "log(0)"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (isfinite(rounding(texts[i]))) print_error("%s\n", texts[i]);
        assert_true(rounding(texts[i]) == HUGE_VAL);
    }
}

// b - a - 0.6 is all rounding; the bound is more than the error, by a small factor.
static void cancellation_is_within_the_bound(void **unused)
{
    (void)unused;
    long double exact = (1.3L - 0.7L) - 0.6L; // 0
    double value = b - a - 0.6, bound = rounding("b - a - 0.6");
    assert_true(fabsl(value - exact) <= bound);
    assert_true(bound < 20 * DBL_EPSILON);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_operation_adds_its_last_bit),
        cmocka_unit_test(what_has_no_value_has_no_bound),
        cmocka_unit_test(cancellation_is_within_the_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
