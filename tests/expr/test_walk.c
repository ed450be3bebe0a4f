// Walks over the names in an expression.
#include "expr_check.h"

static void collect(void *context, const YkExpr *name)
{
    tree_add(context, 200, name->name);
    tree_add(context, 200, " ");
}

static void names_come_from_left_to_right_as_often_as_they_stand(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    char names[200] = "";
    yk_expr_names(fixture_parse(&fixture, "a*sin(b.rate + a) - 3^max(c, -pi)"), collect, names);
    assert_string_equal(names, "a b.rate a c pi ");
    names[0] = '\0';
    yk_expr_names(fixture_parse(&fixture, "3 mm"), collect, names);
    assert_string_equal(names, "");
    fixture_free(&fixture);
}

static void mentions_compares_whole_names(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    const YkExpr *expr = fixture_parse(&fixture, "theta1.rate + sqrt(tau)");
    assert_true(yk_expr_mentions(expr, "theta1.rate"));
    assert_true(yk_expr_mentions(expr, "tau"));
    assert_false(yk_expr_mentions(expr, "theta1"));
    assert_false(yk_expr_mentions(expr, "t"));
    assert_false(yk_expr_mentions(expr, "sqrt"));
    fixture_free(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_come_from_left_to_right_as_often_as_they_stand),
        cmocka_unit_test(mentions_compares_whole_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
