// Pictures of syntheses, for those who have none: nothing is drawn, and no memory was missing.
#include <yoke/synthesis.h>
#include "check.h"

static void without_an_answer_there_is_no_sheet(void **state)
{
    (void)state;
    for (int sheet = 0; sheet <= YK_SHEET_ERRORS + 1; sheet++) {
        bool ran_out = true;
        assert_null(yk_synthesis_sheet(NULL, (YkSynthesisSheet)sheet, &ran_out));
        assert_false(ran_out);
        assert_null(yk_synthesis_sheet(NULL, (YkSynthesisSheet)sheet, NULL));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(without_an_answer_there_is_no_sheet)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
