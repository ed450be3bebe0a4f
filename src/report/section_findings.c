// Writes the findings as a list.
#include "report/html.h"
#include "report/report.h"

void yk_section_findings(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    if (report->finding_count == 0) return;
    yk_text_puts(html, "<ul class=\"findings\">\n");
    for (size_t i = 0; i < report->finding_count; i++) {
        bool is_look = report->findings[i].kind == YK_FINDING_LOOK;
        yk_text_puts(html, is_look ? "<li class=\"look\"><strong>Note:</strong> " : "<li>");
        yk_html_words(html, report->findings[i].text);
        yk_text_puts(html, "</li>\n");
    }
    yk_text_puts(html, "</ul>\n");
}
