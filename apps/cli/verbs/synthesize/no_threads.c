// Where there are no threads the search runs in the caller's.
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
