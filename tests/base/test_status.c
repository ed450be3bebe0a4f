// The words of statuses.
#include "check.h"
#include <yoke/status.h>

static void every_status_has_its_own_word(void **state)
{
    (void)state;
    for (int a = YK_IO; a <= YK_SINGULAR; a++) {
        const char *name = yk_status_name((YkStatus)a);
        assert_string_not_equal(name, "unknown");
        assert_true(strspn(name, "abcdefghijklmnopqrstuvwxyz-") == strlen(name));
        for (int b = YK_IO; b < a; b++) assert_string_not_equal(name, yk_status_name((YkStatus)b));
    }
}

static void the_words_are_those_of_the_header(void **state)
{
    (void)state;
    assert_string_equal(yk_status_name(YK_OK), "ok");
    assert_string_equal(yk_status_name(YK_LIMIT), "limit");
    assert_string_equal(yk_status_name(YK_CHANGE_POINT), "change-point");
    assert_string_equal(yk_status_name(YK_SINGULAR), "singular");
    assert_string_equal(yk_status_name(YK_NOT_CONVERGED), "not-converged");
}

static void a_number_that_is_no_status_is_unknown(void **state)
{
    (void)state;
    assert_string_equal(yk_status_name((YkStatus)4), "unknown");
    assert_string_equal(yk_status_name((YkStatus)-9), "unknown");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_its_own_word),
        cmocka_unit_test(the_words_are_those_of_the_header),
        cmocka_unit_test(a_number_that_is_no_status_is_unknown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
