// The functions of expressions.
#include "check.h"
#include "graph/function.h"

static void every_function_is_found_by_its_own_name(void **state)
{
    (void)state;
    for (int i = 0; i < YK_FUNCTION_COUNT; i++) {
        YkFunction found = YK_FUNCTION_COUNT;
        assert_true(yk_function_find(yk_function_name((YkFunction)i), &found));
        assert_int_equal(found, i);
    }
}

static void what_is_no_function_is_not_found(void **state)
{
    (void)state;
    YkFunction found;
    assert_false(yk_function_find("si", &found));
    assert_false(yk_function_find("sinus", &found));
    assert_false(yk_function_find("", &found));
}

static void two_arguments_go_to_three_functions(void **state)
{
    (void)state;
    int twos = 0;
    for (int i = 0; i < YK_FUNCTION_COUNT; i++) twos += yk_function_arity((YkFunction)i) == 2;
    assert_int_equal(twos, 3);
    assert_int_equal(yk_function_arity(YK_ATAN2), 2);
    assert_int_equal(yk_function_arity(YK_ATAN), 1);
}

static void other_languages_names_lead_to_ours(void **state)
{
    (void)state;
    assert_string_equal(yk_function_nearest("ln"), "log");
    assert_string_equal(yk_function_nearest("arccos"), "acos");
    assert_string_equal(yk_function_nearest("sqr"), "sqrt");
    assert_null(yk_function_nearest("coupler"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_is_found_by_its_own_name),
        cmocka_unit_test(what_is_no_function_is_not_found),
        cmocka_unit_test(two_arguments_go_to_three_functions),
        cmocka_unit_test(other_languages_names_lead_to_ours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
