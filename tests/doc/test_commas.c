// Values that YAML splits at the comma of a function.
#include "doc_check.h"

static void a_function_of_two_arguments_between_braces_or_brackets_is_told_once(void **state)
{
    (void)state;
    check_refused("a: {along: atan2(3, 1.5), to: B}\n", YK_CODE_YAML_COMMA, 1, 12, "quote it: `\"atan2(3, 1.5)\"`");
    check_refused("a: [max(1, 2), 0]\n", YK_CODE_YAML_COMMA, 1, 5, "`max(1, 2)`");
    check_refused("a: [0, max(min(3, x), max(1, 2)), 0]\n", YK_CODE_YAML_COMMA, 1, 8, "`max(min(3, x), max(1, 2))`");
    check_refused("a: [(1, 2), 0]\n", YK_CODE_YAML_COMMA, 1, 5, "`(1, 2)`");
    check_refused("a:\n  - {b: max(1,\n        2)}\n", YK_CODE_YAML_COMMA, 2, 9, "`max(1, 2)`");
}

static void every_split_value_is_told_and_repeated_keys_of_its_pieces_are_not(void **state)
{
    (void)state;
    Fixture fixture = fixture_of("{a: max(1, 2), b: max(3, 2)}");
    assert_null(fixture.root);
    assert_int_equal(yk_problems_count(fixture.problems), 2);
    for (size_t i = 0; i < 2; i++) assert_int_equal(yk_problems_get(fixture.problems, i)->code, YK_CODE_YAML_COMMA);
    fixture_free(&fixture);
}

static void what_is_whole_stays_as_it_is(void **state)
{
    (void)state;
    check_tree("{a: \"max(1, 2)\", b: 3}", 0, "{a: \"max(1, 2)\", b: 3}");
    check_tree("['f(1', 2)]", 0, "[\"f(1\", 2)]");
    check_tree("a: max(1, 2)\n", 0, "{a: max(1, 2)}");
    check_tree("[(1 + 2), (3)]", 0, "[(1 + 2), (3)]");
    check_tree("{a: (1, b: 2}", 0, "{a: (1, b: 2}"); // never closed: the expression says so
}

// A look ahead of each to the end of the list would take longer than a test may.
static void a_long_list_of_values_that_never_end_is_read(void **state)
{
    (void)state;
    enum { VALUES = 2000000 };
    char *text = malloc(2 * VALUES + 1);
    assert_non_null(text);
    for (size_t k = 0; k < VALUES; k++) memcpy(text + 2 * k, k == 0 ? "[(" : ",(", 2);
    text[2 * VALUES] = ']';
    Fixture fixture = fixture_of_bytes(text, 2 * VALUES + 1);
    assert_non_null(fixture.root);
    assert_int_equal(fixture.root->count, VALUES);
    assert_int_equal(yk_problems_count(fixture.problems), 0);
    fixture_free(&fixture);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_function_of_two_arguments_between_braces_or_brackets_is_told_once),
        cmocka_unit_test(every_split_value_is_told_and_repeated_keys_of_its_pieces_are_not),
        cmocka_unit_test(what_is_whole_stays_as_it_is),
        cmocka_unit_test(a_long_list_of_values_that_never_end_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
