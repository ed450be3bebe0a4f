// Codes of problems: their order, their explanations, their severities.
#include "check.h"
#include "base/codes.h"

static void codes_ascend_and_have_three_digits(void **state)
{
    (void)state;
    assert_true(yk_code_count() >= 2);
    for (size_t i = 0; i < yk_code_count(); i++) {
        int code = yk_code_at(i);
        if (i > 0 && yk_code_at(i - 1) >= code) fail_msg("code %d stands after %d", code, yk_code_at(i - 1));
        assert_true(code >= 100 && code <= 899);
    }
}

static void every_code_is_explained_in_whole_sentences(void **state)
{
    (void)state;
    for (size_t i = 0; i < yk_code_count(); i++) {
        const char *explanation = yk_code_explain(yk_code_at(i));
        assert_non_null(explanation);
        size_t length = strlen(explanation);
        if (length < 20 || !strchr(".!?)`", explanation[length - 1])) fail_msg("E%04d: %s", yk_code_at(i), explanation);
        for (size_t k = 0; k < length; k++) assert_true((unsigned char)explanation[k] >= ' ');
    }
}

static void an_unknown_code_has_no_explanation_and_counts_as_an_error(void **state)
{
    (void)state;
    const int unknown[] = {0, -1, 99, 900, 123456};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        assert_null(yk_code_explain(unknown[i]));
        assert_int_equal(yk_code_severity(unknown[i]), YK_SEVERITY_ERROR);
    }
    assert_int_equal(yk_code_at(yk_code_count()), YK_CODE_NONE);
}

static void severities_come_from_the_table(void **state)
{
    (void)state;
    assert_int_equal(yk_code_severity(YK_CODE_OUT_OF_MEMORY), YK_SEVERITY_ERROR);
    assert_int_equal(yk_code_severity(YK_CODE_MORE_PROBLEMS), YK_SEVERITY_NOTE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(codes_ascend_and_have_three_digits),
        cmocka_unit_test(every_code_is_explained_in_whole_sentences),
        cmocka_unit_test(an_unknown_code_has_no_explanation_and_counts_as_an_error),
        cmocka_unit_test(severities_come_from_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
