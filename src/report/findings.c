// Findings: what a reader wants to know first, in sentences, with one file for each kind.
#include "report/report.h"

void yk_report_findings(YkReportPage *report)
{
    YkText text = {0};
    if (report->status < 0) {
        yk_text_format(&text, "The machine cannot be assembled at its start: %s.", report->message);
        yk_report_find(report, YK_FINDING_LOOK, &text);
    }
    yk_findings_structure(report, &text);
    yk_findings_motion(report, &text);
    yk_findings_forces(report, &text);
    yk_findings_simulation(report, &text);
    yk_findings_parts(report, &text);
    yk_findings_laws(report, &text);
    report->failed |= text.failed;
    yk_text_free(&text);
}
