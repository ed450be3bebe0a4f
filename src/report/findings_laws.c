// Findings on laws whose range the motion leaves.
#include <yoke/simulation.h>
#include "report/report.h"
#include "write/law_left.h"

// Takes what a simulation has found.
static void note_events(YkReportPage *report)
{
    for (size_t k = 0; report->simulation && k < yk_simulation_happening_count(report->simulation); k++) {
        YkHappening h = yk_simulation_happening(report->simulation, k);
        if (h.kind == YK_HAPPENING_LAW_LEFT) yk_law_watch_note(report->laws, h.name, h.value, h.time);
    }
}

void yk_findings_laws(YkReportPage *report, YkText *text)
{
    note_events(report);
    for (size_t k = 0; k < yk_law_watch_count(report->laws); k++) {
        YkLawLeft left = yk_law_watch_get(report->laws, k);
        yk_law_left_write(text, report->model, &left);
        if (text->length > 0) text->data[0] = 'T'; // it begins with "the"
        yk_text_puts(text, " (first at ");
        yk_report_amount_at(report, text, left.at);
        yk_text_puts(text, ").");
        yk_report_find(report, YK_FINDING_LOOK, text);
    }
}
