// Numbers and units.
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

static void a_unit_is_one_word_after_its_number(void **state)
{
    (void)state;
    static const Accepted cases[] = {
        {"0.75", "0.75"},
        {"30 deg", "30[0.0174533]"},
        {"30deg", "30[0.0174533]"},
        {"5%", "5[0.01]"},
        {"0.025 kg*m^2", "0.025[1]"},
        {"9.81 m/s^2", "9.81[1]"},
        {"5 N*s/m", "5[1]"},
        {"3 s^-1", "3[1]"},
        {"0.5 rad/s * t", "(* 0.5[1] t)"},
        {"20 rpm * t", "(* 20[0.10472] t)"},
        {"2 mm*3", "(* 2[0.001] 3)"},
        {"2 mm/2", "(/ 2[0.001] 2)"},
        {"2 mm*(a + b)", "(* 2[0.001] (+ a b))"},
        {"2 mm+3 cm", "(+ 2[0.001] 3[0.01])"},
        {"2 mm^n", "(^ 2[0.001] n)"},
        {"(2 mm)^2", "(^ 2[0.001] 2)"},
        {"2 mm ^2", "(^ 2[0.001] 2)"},
        {"2 mm^2", "2[1e-06]"},
        {"1e3 mm", "1000[0.001]"},
        {"2e", NULL},
        {"5 t", "5[1000]"},
        {"a*2 mm", "(* a 2[0.001])"},
        {"atan2(1 m, 2 m)", "(atan2 1[1] 2[1])"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        char tree[256] = "";
        YkExpr *expr = fixture_parse(&fixture, cases[i].text);
        if ((expr != NULL) != (cases[i].tree != NULL)) print_error("«%s»\n", cases[i].text);
        assert_int_equal(expr != NULL, cases[i].tree != NULL);
        if (expr) tree_write(expr, tree, sizeof tree);
        if (expr) assert_string_equal(tree, cases[i].tree);
        fixture_free(&fixture);
    }
}

static void a_ratio_of_integers_takes_the_unit_as_a_whole(void **state)
{
    (void)state;
    static const Accepted cases[] = {
        {"3/4 m", "(/ 3[1] 4)"},      {"3/4m", "(/ 3[1] 4)"},      {"7/4", "(/ 7 4)"},
        {"3 / 4 m", "(/ 3 4[1])"},    {"3.5/4 m", "(/ 3.5 4[1])"}, {"3/4.5 m", "(/ 3 4.5[1])"},
        {"3/4e1 m", "(/ 3 40[1])"},   {"a/4 m", "(/ a 4[1])"},     {"2*3/4 m", "(* 2 (/ 3[1] 4))"},
        {"-3/4 m", "(- (/ 3[1] 4))"}, {"3/4*m", "(* (/ 3 4) m)"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        char tree[256] = "";
        YkExpr *expr = fixture_parse(&fixture, cases[i].text);
        assert_non_null(expr);
        tree_write(expr, tree, sizeof tree);
        assert_string_equal(tree, cases[i].tree);
        fixture_free(&fixture);
    }
}

static void what_is_no_unit_is_refused_with_what_to_write(void **state)
{
    (void)state;
    static const Refused cases[] = {
        {"2 mmm", 303, 3, "`mm`"},
        {"20 RPM", 303, 4, "`rpm`"},
        {"2a1", 303, 2, "`2*a1`"},
        {"2 l_1", 303, 3, "`2*l_1`"},
        {"2pi", 303, 2, "for a product write `2*pi`"},
        {"2 m*pi", 303, 5, "for a product put spaces around the operator: `2 m * pi`"},
        {"2sin(x)", 303, 2, "`2*sin(...)`"},
        {"2 m(x)", 303, 3, "`2*m(...)`"},
        {"20 rpm*t", 303, 8, "`20 rpm * t`"},
        {"20 rpm*t1", 303, 8, "`20 rpm * t1`"},
        {"1 m/t", 303, 5, "`1 m / t`"},
        {"2 m*sin(x)", 303, 5, "`2 m * sin(...)`"},
        {"1 + 3/4 lengths", 303, 9, "3/4*lengths"},
        {"2 m^99", 303, 3, NULL},
        {"5 kg*mn", 303, 6, "did you mean `mN`? For a product put spaces around the operator: `5 kg * mn`"},
        {"5 kg/mn", 303, 6, "`5 kg / mn`"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        assert_null(fixture_parse(&fixture, cases[i].text));
        check_one_problem(&fixture, cases[i].text, cases[i].code, cases[i].column, cases[i].word);
        fixture_free(&fixture);
    }
}

static void a_very_long_wrong_unit_is_cut_in_the_message(void **state)
{
    (void)state;
    enum { LENGTH = 5000 };
    Fixture fixture = fixture_new();
    char *text = malloc(LENGTH); // no zero at its end
    assert_non_null(text);
    memset(text, 'm', LENGTH);
    text[0] = '2';
    assert_null(yk_expr_parse(text, LENGTH, (YkPlace){3, 11, 0}, fixture.arena, fixture.problems));
    check_one_problem(&fixture, "2mmm...", YK_CODE_EXPR_UNIT, 2, "mmm");
    assert_true(strlen(yk_problems_get(fixture.problems, 0)->message) < 200);
    free(text);
    fixture_free(&fixture);
}

static void a_number_beyond_double_is_refused_and_a_tiny_one_is_not(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    assert_null(fixture_parse(&fixture, "1 + 1e400"));
    check_one_problem(&fixture, "1 + 1e400", YK_CODE_EXPR_OVERFLOW, 5, "1e400");
    const YkExpr *tiny = fixture_parse(&fixture, "1e-400");
    assert_non_null(tiny);
    assert_true(tiny->number == 0);
    fixture_free(&fixture);
}

static void the_exact_decimal_is_kept(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool is_exact;
        int64_t mantissa;
        int32_t exponent;
    } cases[] = {{"0.75", true, 75, -2}, {"12", true, 12, 0}, {"99999999999999999999999", false, 0, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture fixture = fixture_new();
        const YkExpr *expr = fixture_parse(&fixture, cases[i].text);
        assert_non_null(expr);
        assert_int_equal(expr->is_exact, cases[i].is_exact);
        if (expr->is_exact)
            CHECK_NEAR((double)expr->mantissa * pow(10, expr->exponent), expr->number, 1e-15 * expr->number);
        fixture_free(&fixture);
    }
}

static void the_dimension_of_a_unit_is_read_too(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    const YkExpr *expr = fixture_parse(&fixture, "3 N*mm");
    assert_non_null(expr);
    assert_true(yk_dimension_equal(expr->unit, (YkDimension){2, 1, -2, 0}));
    CHECK_NEAR(expr->unit_size, 1e-3, 1e-18);
    assert_int_equal(expr->place.length, 6);
    fixture_free(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_unit_is_one_word_after_its_number),
        cmocka_unit_test(a_ratio_of_integers_takes_the_unit_as_a_whole),
        cmocka_unit_test(what_is_no_unit_is_refused_with_what_to_write),
        cmocka_unit_test(a_very_long_wrong_unit_is_cut_in_the_message),
        cmocka_unit_test(a_number_beyond_double_is_refused_and_a_tiny_one_is_not),
        cmocka_unit_test(the_exact_decimal_is_kept),
        cmocka_unit_test(the_dimension_of_a_unit_is_read_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
