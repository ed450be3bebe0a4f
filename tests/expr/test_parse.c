// The grammar: accepted input becomes the right tree, other input is refused at the right place.
#include "expr_check.h"

typedef struct Accepted {
    const char *text, *tree;
} Accepted;
typedef struct Refused {
    const char *text;
    int code;
    unsigned column;
    const char *word;
} Refused;

static void accept(const Accepted *cases, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        Fixture fixture = fixture_new();
        char tree[512] = "";
        YkExpr *expr = fixture_parse(&fixture, cases[i].text);
        if (!expr) print_error("«%s» refused: %s\n", cases[i].text, yk_problems_text(fixture.problems, 0));
        assert_non_null(expr);
        tree_write(expr, tree, sizeof tree);
        assert_string_equal(tree, cases[i].tree);
        assert_int_equal(yk_problems_count(fixture.problems), 0);
        fixture_free(&fixture);
    }
}

static void refuse(const Refused *cases, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        Fixture fixture = fixture_new();
        assert_null(fixture_parse(&fixture, cases[i].text));
        check_one_problem(&fixture, cases[i].text, cases[i].code, cases[i].column, cases[i].word);
        fixture_free(&fixture);
    }
}
#define EACH(cases) (cases), sizeof(cases) / sizeof *(cases)

static void precedence_is_that_of_mathematics(void **state)
{
    (void)state;
    static const Accepted cases[] = {
        {"1 + 2*3", "(+ 1 (* 2 3))"},
        {"(1 + 2)*3", "(* (+ 1 2) 3)"},
        {"1 - 2 - 3", "(- (- 1 2) 3)"},
        {"8/4/2", "(/ (/ 8 4) 2)"},
        {"8/4*2", "(* (/ 8 4) 2)"},
        {"-a^2", "(- (^ a 2))"},
        {"(-a)^2", "(^ (- a) 2)"},
        {"2^3^2", "(^ 2 (^ 3 2))"},
        {"2^-3^2", "(^ 2 (- (^ 3 2)))"},
        {"a*-b", "(* a (- b))"},
        {"a - -b", "(- a (- b))"},
        {"--a", "(- (- a))"},
        {"+a + +b", "(+ a b)"},
        {"  a  ", "a"},
        {"-a*b", "(* (- a) b)"},
        {"((((a))))", "a"},
        {"a+b*c^d/e-f", "(- (+ a (/ (* b (^ c d)) e)) f)"},
    };
    accept(EACH(cases));
}

static void names_have_letters_digits_underscores_and_dots(void **state)
{
    (void)state;
    static const Accepted cases[] = {
        {"theta1.rate", "theta1.rate"},         {"_x", "_x"}, {"A_b2.c.d", "A_b2.c.d"}, {"sin", "sin"}, {"e1", "e1"},
        {"theta1.rate*t", "(* theta1.rate t)"},
    };
    accept(EACH(cases));
}

static void calls_take_their_arguments(void **state)
{
    (void)state;
    static const Accepted cases[] = {
        {"sin(x)", "(sin x)"},
        {"sin (x)", "(sin x)"},
        {"atan2( y , x )", "(atan2 y x)"},
        {"max(a, min(b, c))", "(max a (min b c))"},
        {"sqrt(a^2 + b^2)", "(sqrt (+ (^ a 2) (^ b 2)))"},
        {"2*sin(30 deg)", "(* 2 (sin 30[0.0174533]))"},
        {"cos(x)^2", "(^ (cos x) 2)"},
    };
    accept(EACH(cases));
}

static void a_missing_piece_is_named_where_it_is_missing(void **state)
{
    (void)state;
    static const Refused cases[] = {
        {"", 301, 1, "expected a value"},
        {"   ", 301, 4, "expected a value"},
        {"a +", 301, 4, "ends here"},
        {"a * / b", 301, 5, "found `/`"},
        {"(a + b", 301, 7, "`)`"},
        {"a + b)", 301, 6, "closes nothing"},
        {"()", 301, 2, "expected a value"},
        {"sin()", 301, 5, "expected a value"},
        {"sin(x", 301, 6, "`)`"},
        {"a b", 301, 3, "`*`"},
        {"a (b)", 304, 1, "`*`"},
        {"(a)(b)", 301, 4, "`*`"},
        {"(a) b", 301, 5, "`*`"},
        {"2^", 301, 3, "expected a value"},
        {"a**2", 301, 3, "`^`"},
        {"0,5", 301, 2, "1.5"},
        {".", 301, 1, "expected a value"},
        {"a.", 301, 2, "operator"},
        {"1.2.3", 301, 4, "operator"},
        {"2 N*s/m*s.rate", 301, 10, "2 N*s/m * s.rate"},
        {"-", 301, 2, "expected a value"},
    };
    refuse(EACH(cases));
}

static void strange_characters_are_refused_with_what_was_meant(void **state)
{
    (void)state;
    static const Refused cases[] = {
        {"a \xe2\x88\x92 b", 302, 3, "`-`"},
        {"a\xc3\x97"
         "b",
         302, 2, "`*`"},
        {"30\xc2\xb0", 302, 3, "`deg`"},
        {"a = b", 302, 3, "`=`"},
        {"$a", 302, 1, "`$`"},
        {"a;", 302, 2, "`;`"},
        {"[1]", 302, 1, "`[`"},
        {"2*\xcf\x80", 302, 3, "`pi`"},
        {"\xff", 302, 1, NULL},
    };
    refuse(EACH(cases));
}

static void an_unknown_function_gets_a_suggestion(void **state)
{
    (void)state;
    static const Refused cases[] = {
        {"sine(x)", 304, 1, "`sin`"},     {"1 + ln(x)", 304, 5, "`log`"}, {"arctan(x)", 304, 1, "`atan`"},
        {"pow(a, b)", 304, 1, "`a^b`"},   {"Sin(x)", 304, 1, "`sin`"},    {"abd(x)", 304, 1, "`abs`"},
        {"l1(a + b)", 304, 1, "product"},
    };
    refuse(EACH(cases));
}

static void the_number_of_arguments_is_checked(void **state)
{
    (void)state;
    static const Refused cases[] = {
        {"atan2(y)", 305, 1, "two arguments"},
        {"1 + max(a)", 305, 5, "two arguments"},
        {"sin(0,5)", 305, 6, "one argument"},
        {"min(a, b, c)", 305, 9, "two arguments"},
    };
    refuse(EACH(cases));
}

// «open» n times, «middle», «close» n times; parsed, and whether it was accepted.
static bool accepts_nest(const char *open, size_t n, const char *middle, const char *close, int *code)
{
    Fixture fixture = fixture_new();
    size_t a = strlen(open), m = strlen(middle), c = strlen(close);
    char *text = malloc(n * (a + c) + m + 1), *at = text;
    assert_non_null(text);
    for (size_t i = 0; i < n; i++, at += a) memcpy(at, open, a);
    memcpy(at, middle, m);
    at += m;
    for (size_t i = 0; i < n; i++, at += c) memcpy(at, close, c);
    *at = '\0';
    bool accepted = fixture_parse(&fixture, text) != NULL;
    *code = accepted ? 0 : yk_problems_get(fixture.problems, 0)->code;
    free(text);
    fixture_free(&fixture);
    return accepted;
}

static void depth_and_length_have_limits_that_are_reported(void **state)
{
    (void)state;
    int code;
    assert_true(accepts_nest("(", YK_EXPR_DEPTH_MAX - 1, "a", ")", &code));
    assert_false(accepts_nest("(", YK_EXPR_DEPTH_MAX, "a", ")", &code));
    assert_int_equal(code, YK_CODE_EXPR_TOO_DEEP);
    assert_false(accepts_nest("-", 1000000, "a", "", &code));
    assert_int_equal(code, YK_CODE_EXPR_TOO_DEEP);
    assert_false(accepts_nest("2^", 1000000, "a", "", &code));
    assert_int_equal(code, YK_CODE_EXPR_TOO_DEEP);
    assert_false(accepts_nest("sin(", 100000, "a", ")", &code));
    assert_int_equal(code, YK_CODE_EXPR_TOO_DEEP);
    assert_true(accepts_nest("", YK_EXPR_HEIGHT_MAX - 1, "a", "+a", &code));
    assert_false(accepts_nest("", YK_EXPR_HEIGHT_MAX, "a", "+a", &code));
    assert_int_equal(code, YK_CODE_EXPR_TOO_DEEP);
}

static void every_part_knows_its_place(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    const YkExpr *sum = fixture_parse(&fixture, " (a + 20 mm)*b - sin( c )");
    assert_non_null(sum);
    const YkExpr *product = sum->a, *call = sum->b, *inner = product->a;
    const struct {
        const YkExpr *node;
        unsigned column, length;
    } parts[] = {{sum, 2, 24},        {product, 2, 13}, {inner, 3, 9},   {inner->b, 7, 5},
                 {product->b, 14, 1}, {call, 18, 8},    {call->a, 23, 1}};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        assert_int_equal(parts[i].node->place.line, 3);
        assert_int_equal(parts[i].node->place.column, 10 + parts[i].column);
        assert_int_equal(parts[i].node->place.length, parts[i].length);
    }
    fixture_free(&fixture);
}

static void a_text_from_nowhere_stays_nowhere(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    assert_null(yk_expr_parse("a +", 3, (YkPlace){0, 0, 0}, fixture.arena, fixture.problems));
    assert_int_equal(yk_problems_get(fixture.problems, 0)->place.line, 0);
    assert_int_equal(yk_problems_get(fixture.problems, 0)->place.column, 0);
    fixture_free(&fixture);
}

static void the_length_is_obeyed_not_a_final_zero(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    const YkExpr *expr = yk_expr_parse("a + b", 1, (YkPlace){1, 1, 0}, fixture.arena, fixture.problems);
    assert_non_null(expr);
    assert_string_equal(expr->name, "a");
    assert_null(yk_expr_parse("a\0b", 3, (YkPlace){1, 1, 0}, fixture.arena, fixture.problems));
    fixture_free(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(precedence_is_that_of_mathematics),
        cmocka_unit_test(names_have_letters_digits_underscores_and_dots),
        cmocka_unit_test(calls_take_their_arguments),
        cmocka_unit_test(a_missing_piece_is_named_where_it_is_missing),
        cmocka_unit_test(strange_characters_are_refused_with_what_was_meant),
        cmocka_unit_test(an_unknown_function_gets_a_suggestion),
        cmocka_unit_test(the_number_of_arguments_is_checked),
        cmocka_unit_test(depth_and_length_have_limits_that_are_reported),
        cmocka_unit_test(every_part_knows_its_place),
        cmocka_unit_test(a_text_from_nowhere_stays_nowhere),
        cmocka_unit_test(the_length_is_obeyed_not_a_final_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
