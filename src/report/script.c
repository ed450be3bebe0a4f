// The page's script, embedded when Yoke is built.
#include "report/report.h"

extern const unsigned char yk_report_script[];
extern const size_t yk_report_script_size;

bool yk_report_has_script(void)
{
    return yk_report_script_size > 0;
}

void yk_report_add_script(YkText *html)
{
    yk_text_add(html, (const char *)yk_report_script, yk_report_script_size);
}
