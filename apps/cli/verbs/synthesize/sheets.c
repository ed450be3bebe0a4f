// The further pictures in the folder of `yoke synthesize -o`.
#include "verbs/synthesize/synthesize.h"

const char *yk_synthesis_sheet_file(const YkSynthesisAnswer *answer, size_t index, const char **svg, bool *ran_out)
{
    static const char *const names[] = {[YK_SHEET_BURMESTER] = "burmester.svg", [YK_SHEET_ERRORS] = "errors.svg"};
    *svg = yk_synthesis_sheet(answer->synthesis, (YkSynthesisSheet)index, ran_out);
    return names[index];
}
