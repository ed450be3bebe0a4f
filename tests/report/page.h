// A machine's report, for tests.
#ifndef TESTS_REPORT_PAGE_H
#define TESTS_REPORT_PAGE_H
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "report/report.h"

typedef struct Page {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkProblems *problems;
    YkReportPage *report;
} Page;

static inline Page page_of(YkModel *model, YkProblems *problems, const YkReportOptions *options)
{
    Page page = {.model = model, .problems = problems};
    assert_non_null(page.model);
    page.mech = yk_mechanism_compile(page.model, NULL, page.problems);
    assert_non_null(page.mech);
    page.state = yk_state_new(page.mech);
    assert_non_null(page.state);
    assert_true(yk_state_set_time(page.state, 0, page.problems) >= 0);
    page.report = yk_report_new(page.state, options, page.problems);
    assert_non_null(page.report);
    return page;
}

static inline Page open_page(const char *name, const YkReportOptions *options)
{
    char path[500];
    YkProblems *problems = yk_problems_new();
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    return page_of(yk_model_load(path, NULL, problems), problems, options);
}

static inline Page open_text(const char *text, const YkReportOptions *options)
{
    YkProblems *problems = yk_problems_new();
    return page_of(yk_model_parse(text, strlen(text), "test.yaml", NULL, problems), problems, options);
}

static inline void close_page(Page *page)
{
    yk_report_free(page->report);
    yk_state_free(page->state);
    yk_mechanism_free(page->mech);
    yk_model_free(page->model);
    yk_problems_free(page->problems);
}

// The finding that holds these words, or NULL.
static inline const char *finding(const YkReportPage *report, const char *words)
{
    for (size_t i = 0; i < yk_report_finding_count(report); i++)
        if (strstr(yk_report_finding(report, i), words)) return yk_report_finding(report, i);
    return NULL;
}

// The number behind `words` in the finding that holds them; NaN where there is none.
static inline double told(const YkReportPage *report, const char *words)
{
    const char *found = finding(report, words);
    return found ? strtod(strstr(found, words) + strlen(words), NULL) : (double)NAN;
}
#endif
