// Formulas against the evaluator of trees, on random expressions: the same values to the last bit, and no value where
// the evaluator finds a fault.
#include "expr_check.h"
#include "base/vec.h"
#include "expr/formula_inside.h"

// Variables x, y, z are 0, 1, 2; a and b are constants.
enum { X, Y, Z, VARIABLES };
static const double a_value = 0.7, b_value = -1.3;

typedef struct Point {
    double value[VARIABLES];
    double rate; // of x; those of the others are multiples
} Point;

static int resolve(void *context, const YkExpr *name, double *value)
{
    int *calls = context;
    if (calls) ++*calls;
    if (strlen(name->name) != 1) return -2;
    switch (name->name[0]) {
    case 'a':
        *value = a_value;
        return -1;
    case 'b':
        *value = b_value;
        return -1;
    case 'n':
        *value = NAN;
        return -1;
    case 'x':
    case 'y':
    case 'z':
        return name->name[0] - 'x';
    default:
        return -2;
    }
}

static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    const Point *point = context;
    double value = 0;
    int variable = resolve(NULL, name, &value);
    if (variable == -2) return false;
    *jet = (YkJet){{variable == -1 ? value : point->value[variable]}};
    if (variable >= 0) jet->d[1] = point->rate * (1 + 0.37 * variable);
    return true;
}

static YkFormula *compile(Fixture *fixture, const char *text)
{
    const YkExpr *expr = fixture_parse(fixture, text);
    if (!expr) print_error("«%s»: %s", text, yk_problems_text(fixture->problems, 0));
    assert_non_null(expr);
    return yk_formula_compile(expr, resolve, NULL, fixture->arena);
}

static double value_of(const char *text, const double *variables)
{
    Fixture fixture = fixture_new();
    const YkFormula *formula = compile(&fixture, text);
    assert_non_null(formula);
    double value = yk_formula_eval(formula, variables);
    fixture_free(&fixture);
    return value;
}

// A random expression of all functions; with whole powers, which the tree multiplies out where the base varies, or with
// powers of any kind.
typedef enum Rules { WHOLE_POWERS, ANY_POWERS } Rules;

static void grow(uint64_t *seed, int depth, Rules rules, char *out, size_t size)
{
    static const char *const leaves[] = {"x", "y", "z", "x", "y", "a", "b", "0.4", "pi", "(3/2)", "(30 deg)", "0"};
    static const char *const powers[] = {"(x*y + z)^2", "(x - y)^3", "y^-1", "z^-2", "(x - 2*y)^17", "(y + z)^0"};
    static const char *const functions[] = {"sin(", "cos(", "atan(", "tanh(", "exp(",  "sinh(", "cosh(",
                                            "tan(", "abs(", "sqrt(", "log(",  "asin(", "acos(", "sign("};
    static const char *const pairs[] = {"min(", "max(", "atan2("};
    static const char *const operators[] = {" + ", " - ", " * ", " / ", "^"};
    const char *before = "(", *between = NULL;
    if (depth <= 0) {
        bool is_power = rules == WHOLE_POWERS && check_random(seed) % 4 == 0;
        tree_add(out, size,
                 is_power ? powers[check_random(seed) % 6]
                          : leaves[check_random(seed) % (11 + (rules == WHOLE_POWERS))]);
        return;
    }
    uint64_t choice = check_random(seed) % 10;
    if (choice < 5) {
        before = check_random(seed) % 8 == 0 ? "(-" : "(";
        between = operators[check_random(seed) % (rules == ANY_POWERS ? 5 : 4)];
    } else if (choice < 7) {
        before = pairs[check_random(seed) % 3];
        between = ", ";
    } else {
        before = functions[check_random(seed) % 14];
    }
    tree_add(out, size, before);
    grow(seed, depth - 1 - (int)(check_random(seed) % 2), rules, out, size);
    if (between) {
        tree_add(out, size, between);
        grow(seed, depth - 1 - (int)(check_random(seed) % 2), rules, out, size);
    }
    tree_add(out, size, ")");
}

static Point random_point(uint64_t *seed, double rate)
{
    Point point = {.rate = rate};
    for (int i = 0; i < VARIABLES; i++) {
        point.value[i] = rate != 0 && check_random(seed) % 10 == 0 ? 0 : check_uniform(seed, -2, 2);
    }
    return point;
}

// counts[0]: both have the same value, to a tolerance relative to 1 + |value|; [1]: neither has one; [2]: only the
// formula has one; [3]: anything else.
static void compare_all(Rules rules, double rate, double tolerance, int counts[4])
{
    uint64_t seed = 7;
    for (int trial = 0; trial < 6000; trial++) {
        char text[8192] = "";
        grow(&seed, 1 + trial % 6, rules, text, sizeof text);
        Fixture fixture = fixture_new();
        const YkExpr *expr = fixture_parse(&fixture, text);
        assert_non_null(expr);
        const YkFormula *formula = yk_formula_compile(expr, resolve, NULL, fixture.arena);
        assert_non_null(formula);
        for (int k = 0; k < 5; k++) {
            Point point = random_point(&seed, rate);
            YkJet jet;
            const char *why;
            bool has_value = !yk_expr_eval(expr, lookup, &point, &jet, &why);
            double value = yk_formula_eval(formula, point.value);
            bool is_same = fabs(value - jet.d[0]) <= tolerance * (1 + fabs(value));
            int kind = has_value ? (is_same ? 0 : 3) : isfinite(value) ? 2 : 1;
            if (kind == 3) print_error("«%s»: %.17g, the tree gives %.17g\n", text, value, jet.d[0]);
            counts[kind]++;
        }
        fixture_free(&fixture);
    }
}

static void values_are_those_of_the_tree_to_the_last_bit(void **state)
{
    (void)state;
    int counts[4] = {0};
    compare_all(WHOLE_POWERS, 1, 0, counts);
    assert_int_equal(counts[3], 0);
    assert_true(counts[0] > 10000);
}

static void there_is_no_value_exactly_where_the_tree_has_a_fault(void **state)
{
    (void)state;
    int counts[4] = {0};
    compare_all(ANY_POWERS, 0, 1e-12, counts); // a whole power of a value at rest is rounded otherwise there
    assert_int_equal(counts[3], 0);
    assert_int_equal(counts[2], 0);
    assert_true(counts[0] > 5000);
    assert_true(counts[1] > 2000);
}

// The jet of the tree has the rates of the variables; where it has none, the formula says so or differs by a kink.
static void slopes_are_those_of_the_tree(void **state)
{
    (void)state;
    uint64_t seed = 19;
    int compared = 0, none = 0;
    for (int trial = 0; trial < 4000; trial++) {
        char text[8192] = "";
        grow(&seed, 1 + trial % 5, trial % 2 ? WHOLE_POWERS : ANY_POWERS, text, sizeof text);
        Fixture fixture = fixture_new();
        const YkExpr *expr = fixture_parse(&fixture, text);
        const YkFormula *formula = yk_formula_compile(expr, resolve, NULL, fixture.arena);
        for (int k = 0; k < 5; k++) {
            Point point = random_point(&seed, 1);
            double direction[VARIABLES] = {1, 1.37, 1.74};
            YkJet jet;
            const char *why;
            bool has = !yk_expr_eval(expr, lookup, &point, &jet, &why);
            double slope = yk_formula_slope(formula, point.value, direction);
            if (!has && !isfinite(slope)) none++;
            if (!has || !isfinite(slope)) continue; // higher derivatives of the jet may overflow
            bool is_same = fabs(slope - jet.d[1]) <= 1e-11 * (1 + fabs(slope));
            if (!is_same) print_error("«%s»: %.17g, the tree gives %.17g\n", text, slope, jet.d[1]);
            assert_true(is_same);
            compared++;
        }
        fixture_free(&fixture);
    }
    assert_true(compared > 8000);
    assert_true(none > 1000);
}

// Lanes have the bits of one evaluation each, and a lane without a value leaves the others alone.
static void lanes_are_single_values_to_the_last_bit(void **state)
{
    (void)state;
    static double scratch[YK_FORMULA_SCRATCH], x[YK_FORMULA_LANES], y[YK_FORMULA_LANES], z[YK_FORMULA_LANES];
    const double *variables[VARIABLES] = {x, y, z};
    uint64_t seed = 23;
    int finite = 0, none = 0;
    for (int trial = 0; trial < 1200; trial++) {
        char text[8192] = "";
        grow(&seed, 1 + trial % 6, trial % 2 ? WHOLE_POWERS : ANY_POWERS, text, sizeof text);
        Fixture fixture = fixture_new();
        const YkFormula *formula = compile(&fixture, text);
        size_t n = 1 + check_random(&seed) % YK_FORMULA_LANES;
        for (size_t i = 0; i < n; i++) {
            Point point = random_point(&seed, 1);
            x[i] = point.value[X], y[i] = point.value[Y], z[i] = point.value[Z];
        }
        const double *lanes = yk_formula_lanes(formula, variables, scratch, n);
        for (size_t i = 0; i < n; i++) {
            const double point[VARIABLES] = {x[i], y[i], z[i]};
            double single = yk_formula_eval(formula, point);
            bool is_same = isfinite(single) ? memcmp(&single, &lanes[i], sizeof single) == 0 : !isfinite(lanes[i]);
            if (!is_same) print_error("«%s»: lane %zu is %.17g, alone %.17g\n", text, i, lanes[i], single);
            assert_true(is_same);
            *(isfinite(single) ? &finite : &none) += 1;
        }
        fixture_free(&fixture);
    }
    assert_true(finite > 5000 && none > 1000);
}

static void whole_powers_are_good_to_the_last_bits(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int n = -70; n <= 70; n++) {
        char text[20];
        snprintf(text, sizeof text, "x^(%d)", n);
        for (int k = 0; k < 20; k++) {
            double x = check_uniform(&seed, -3, 3), wanted = pow(x, n);
            CHECK_NEAR(value_of(text, &x), wanted, (2 + abs(n)) * 0x1p-53 * fabs(wanted));
        }
    }
}

static void what_has_no_value_is_not_finite(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "1/x",         "sqrt(x - 1)",   "log(x)",    "atan2(x, x)", "x^-1",      "(x - 1)^0.5",
        "min(3, 1/x)", "exp(-1/x^2)",   "sign(1/x)", "1/(1/x)",     "tanh(1/x)", "(1/x)^0",
        "0*(1/x)",     "asin(2 + x)",   "1/0",       "min(3, 1/0)", "x*0 + 1/0", "atan(log(0))",
        "exp(1000)",   "exp(1000 + x)", "n",         "min(n, x)",   "x + 0*n",
    };
    double x = 0;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double value = value_of(texts[i], &x);
        if (isfinite(value)) print_error("«%s» = %g\n", texts[i], value);
        assert_false(isfinite(value));
    }
}

static void a_variable_that_is_not_finite_leaves_no_value(void **state)
{
    (void)state;
    static const char *const texts[] = {"x", "min(1, x)", "sign(x)", "x^0", "atan(x)", "1/x", "exp(-abs(x))"};
    static const double values[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        for (int k = 0; k < 3; k++) assert_false(isfinite(value_of(texts[i], &values[k])));
    }
}

static void numbers_come_in_si(void **state)
{
    (void)state;
    CHECK_NEAR(value_of("20 mm", NULL), 0.02, 1e-18);
    CHECK_NEAR(value_of("sin(30 deg)", NULL), 0.5, 1e-16);
    CHECK_NEAR(value_of("2*pi", NULL), 2 * YK_PI, 0);
    Fixture fixture = fixture_new();
    YkExpr *bare = fixture_parse(&fixture, "12");
    bare->value_scale = 0.5;
    CHECK_NEAR(yk_formula_eval(yk_formula_compile(bare, resolve, NULL, fixture.arena), NULL), 6, 0);
    fixture_free(&fixture);
}

static bool depends_on(const YkFormula *formula, int variable)
{
    bool found = false;
    for (size_t k = 0; k < formula->variable_count; k++) found |= formula->variables[k] == variable;
    return found;
}

static void only_what_varies_makes_a_formula_variable(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool depends[VARIABLES];
    } cases[] = {
        {"3", {0}},
        {"2*a + sin(b)^2 - max(a, pi)", {0}},
        {"y", {false, true}},
        {"a*z + 3*x - x/2 + z", {true, false, true}},
        {"-(z + y + x)*(x + y + z)", {true, true, true}},
        {"x^0", {true}}, // what is not finite must show
        {"x + 1/0", {0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        const YkFormula *formula = compile(&fixture, cases[i].text);
        bool depends = false;
        for (int k = 0; k < VARIABLES; k++) {
            assert_int_equal(depends_on(formula, k), cases[i].depends[k]);
            depends |= cases[i].depends[k];
        }
        assert_int_equal(yk_formula_is_constant(formula), !depends);
        fixture_free(&fixture);
    }
}

// What a formula is when it is a variable or its opposite, and nothing else: then it is that column of a table.
static void a_variable_alone_or_its_opposite_is_recognised(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int variable;
        double sign;
    } cases[] = {{"x", X, 1},    {"z", Z, 1},        {"-y", Y, -1},       {"+y", Y, 1},   {"(-z)", Z, -1},
                 {"--y", -1, 1}, {"-sin(y)", -1, 1}, {"-(x + y)", -1, 1}, {"2*y", -1, 1}, {"abs(y)", -1, 1},
                 {"3", -1, 1},   {"-3", -1, 1},      {"-a", -1, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        const YkFormula *formula = compile(&fixture, cases[i].text);
        double sign = 7, point[VARIABLES] = {0.3, -0.8, 1.7};
        int variable = yk_formula_variable(formula, &sign);
        if (variable != cases[i].variable) print_error("«%s»\n", cases[i].text);
        assert_int_equal(variable, cases[i].variable);
        CHECK_NEAR(sign, cases[i].sign, 0);
        if (variable >= 0) CHECK_NEAR(sign * point[variable], yk_formula_eval(formula, point), 0);
        fixture_free(&fixture);
    }
}

static void an_unknown_name_gives_no_formula(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    assert_null(compile(&fixture, "x + stranger"));
    assert_null(compile(&fixture, "q"));
    assert_null(compile(&fixture, "0*q + 1/0"));
    assert_non_null(compile(&fixture, "x + pi"));
    fixture_free(&fixture);
}

static void each_mention_is_resolved_once(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    int calls = 0;
    const YkFormula *formula = yk_formula_compile(fixture_parse(&fixture, "x*x + a*y"), resolve, &calls, fixture.arena);
    double variables[] = {2, 3, 4};
    for (int k = 0; k < 10; k++) yk_formula_eval(formula, variables);
    assert_int_equal(calls, 4);
    fixture_free(&fixture);
}

// Left and right combs as high as the parser lets them, and a bushy tree that needs many registers.
static void deep_and_wide_expressions_stand(void **state)
{
    (void)state;
    static char text[400000];
    double x = 1;
    strcpy(text, "x");
    for (int i = 1; i < YK_EXPR_HEIGHT_MAX - 1; i++) strcat(text, i % 2 ? " + x" : " - x/2");
    CHECK_NEAR(value_of(text, &x), 1 + 499 - 499 * 0.5, 0);
    text[0] = 0;
    for (int i = 1; i < YK_EXPR_DEPTH_MAX - 2; i++) strcat(text, "x - (");
    strcat(text, "x");
    for (int i = 1; i < YK_EXPR_DEPTH_MAX - 2; i++) strcat(text, ")");
    CHECK_NEAR(value_of(text, &x), 0, 0);
    strcpy(text, "x");
    for (int level = 0; level < 13; level++) { // t -> (t)*(t): 8192 leaves
        size_t length = strlen(text);
        memmove(text + 1, text, length);
        text[0] = '(';
        text[length + 1] = 0;
        strcat(text, level % 2 ? ")/(" : ")+(");
        memcpy(text + length + 4, text + 1, length);
        text[2 * length + 4] = ')';
        text[2 * length + 5] = 0;
    }
    CHECK_NEAR(value_of(text, &x), 2, 0);
}

static void formulas_agree_with_mathematics(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int k = 0; k < 200; k++) {
        double v[VARIABLES] = {check_uniform(&seed, -3, 3), check_uniform(&seed, 0.1, 3), check_uniform(&seed, -3, 3)};
        CHECK_NEAR(value_of("sin(x)^2 + cos(x)^2", v), 1, 1e-15);
        CHECK_NEAR(value_of("exp(log(y))/y", v), 1, 1e-15);
        CHECK_NEAR(value_of("atan2(y*sin(x), y*cos(x)) - x", v), fabs(v[0]) <= YK_PI ? 0 : NAN, 2e-15);
        CHECK_NEAR(value_of("max(x, z) + min(x, z) - (x + z)", v), 0, 1e-15);
        CHECK_NEAR(value_of("sign(z)*abs(z) - z", v), 0, 0);
        CHECK_NEAR(value_of("(x - a)*(x + a) - x^2 + a^2", v), 0, 1e-14);
        CHECK_NEAR(value_of("cosh(x)^2 - sinh(x)^2", v), 1, 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_those_of_the_tree_to_the_last_bit),
        cmocka_unit_test(there_is_no_value_exactly_where_the_tree_has_a_fault),
        cmocka_unit_test(slopes_are_those_of_the_tree),
        cmocka_unit_test(whole_powers_are_good_to_the_last_bits),
        cmocka_unit_test(what_has_no_value_is_not_finite),
        cmocka_unit_test(a_variable_that_is_not_finite_leaves_no_value),
        cmocka_unit_test(numbers_come_in_si),
        cmocka_unit_test(only_what_varies_makes_a_formula_variable),
        cmocka_unit_test(a_variable_alone_or_its_opposite_is_recognised),
        cmocka_unit_test(an_unknown_name_gives_no_formula),
        cmocka_unit_test(each_mention_is_resolved_once),
        cmocka_unit_test(deep_and_wide_expressions_stand),
        cmocka_unit_test(formulas_agree_with_mathematics),
        cmocka_unit_test(lanes_are_single_values_to_the_last_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
