// Converts SVG text to PDF or PNG by rsvg-convert.
#include "picture/convert.h"
#include "base/problems.h"
#include "write/process.h"

bool yk_convert_svg(const char *svg, YkFileKind kind, YkText *output, YkProblems *problems)
{
    static const char *const pdf[] = {"rsvg-convert", "--format=pdf", NULL};
    static const char *const png[] = {"rsvg-convert", "--format=png", "--zoom=2", NULL};
    YkText input = {0};
    bool good = false;
    yk_text_puts(&input, svg);
    if (input.failed) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    } else if (kind == YK_FILE_SVG) {
        yk_text_puts(output, svg);
        good = !output->failed;
    } else {
        good = yk_process_filter(kind == YK_FILE_PDF ? pdf : png, "writing PDF and PNG", &input, output, problems);
        if (!good) yk_problem_hint(problems, "write the drawing as .svg, or install librsvg2-bin");
    }
    yk_text_free(&input);
    return good;
}
