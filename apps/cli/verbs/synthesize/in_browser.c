// Synthesis in a browser: the search runs in the page's thread. Pictures are refused because there is no folder for
// them.
#include "verbs/synthesize/synthesize.h"

YkSynthesisThreads *yk_synthesis_threads(YkSynthesisAnswer *answer, YkSynthesisOptions *options, YkProblems *problems)
{
    (void)answer, (void)options, (void)problems;
    return NULL;
}

void yk_synthesis_join(YkSynthesisThreads *threads)
{
    (void)threads;
}

const char *yk_synthesis_sheet_file(const YkSynthesisAnswer *answer, size_t index, const char **svg, bool *ran_out)
{
    (void)answer, (void)index;
    *svg = NULL;
    *ran_out = false;
    return NULL;
}
