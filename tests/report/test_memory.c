// Allocations of a report fail one after the other: it is refused or complete, and nothing crashes.
#include "interposed.h"
#include "report/page.h"

static void a_report_survives_every_failure(void **state)
{
    (void)state;
    skip_unless_interposed();
    Page page = open_page("pendulum", NULL);
    yk_report_free(page.report);
    page.report = NULL;
    bool is_done = false;
    for (long k = 0; !is_done; k += 1 + k / 16) { // every one at first, then some
        long before = live;
        has_failed = false;
        countdown = k;
        YkReportPage *report = yk_report_new(page.state, NULL, NULL);
        const char *html = report ? yk_report_html(report, NULL) : NULL;
        countdown = -1;
        if (!has_failed) assert_non_null(html);
        is_done = !has_failed;
        yk_report_free(report);
        assert_int_equal(live, before);
        assert_true(k < 10000000);
    }
    close_page(&page);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_report_survives_every_failure)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
