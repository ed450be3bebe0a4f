// The report's script is a file of the system in memory, which the worker gives to the verb `report` (worker.ts):
// embedded it would be fetched with every study, map and synthesis.
#include <stdio.h>
#include "report/report.h"

static const char path[] = "/usr/share/yoke/report.js";

bool yk_report_has_script(void)
{
    FILE *file = fopen(path, "rb");
    bool has_some = file && fgetc(file) != EOF;
    if (file) fclose(file);
    return has_some;
}

void yk_report_add_script(YkText *html)
{
    char part[4096];
    FILE *file = fopen(path, "rb");
    if (!file) {
        yk_text_fail(html);
        return;
    }
    for (size_t got; (got = fread(part, 1, sizeof part, file)) > 0;) yk_text_add(html, part, got);
    fclose(file);
}
