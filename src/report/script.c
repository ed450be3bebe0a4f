// Whether the page can move.
#include "report/report.h"

bool yk_report_has_script(void)
{
    return yk_report_script_size > 0;
}
