// In panels.wasm only movies go through a report's motion. They show no findings, for which yoke.wasm alone has the
// parts.
#include "report/report.h"

void yk_report_findings(YkReportPage *report)
{
    (void)report;
}
