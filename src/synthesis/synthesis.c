// Runs a synthesis: the search of its kind, then the ranking.
#include "synthesis/synthesis.h"
#include <stdlib.h>

YkSynthesisOptions yk_default_synthesis_options(void)
{
    return (YkSynthesisOptions){.seed = 1};
}

const char *yk_defect_name(YkDefect defect)
{
    static const char *const names[YK_DEFECT_COUNT] = {"none",  "assembly",     "circuit", "branch", "order",
                                                       "input", "transmission", "bounds",  "size",   "require"};
    return (size_t)defect < YK_DEFECT_COUNT ? names[defect] : NULL;
}

static bool search(YkSynthesis *s, YkProblems *problems)
{
    switch (s->task->kind) {
    case YK_TASK_MOTION:
        return yk_synthesise_motion(s, problems);
    case YK_TASK_FUNCTION:
        return yk_synthesise_function(s, problems);
    case YK_TASK_STROKE:
        return yk_synthesise_stroke(s, problems);
    case YK_TASK_PATH:
        return yk_synthesise_path(s, problems);
    case YK_TASK_MACHINE:
        return yk_synthesise_machine(s, problems);
    default:
        return false;
    }
}

YkSynthesis *yk_synthesis_run(const YkTask *task, const YkSynthesisOptions *options, YkProblems *problems)
{
    YkSynthesis *s = task ? calloc(1, sizeof *s) : NULL;
    if (s) s->arena = yk_arena_new();
    if (!s || !s->arena) {
        if (task) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory during the synthesis");
        free(s);
        return NULL;
    }
    s->task = task;
    s->options = options ? *options : yk_default_synthesis_options();
    bool found = yk_pace_begin(&s->pace, s->options.progress) ? search(s, problems) : true;
    s->was_stopped = yk_pace_is_stopped(&s->pace);
    if (s->was_stopped) s->is_complete = false;
    if (found && !s->failed) yk_synthesis_rank(s);
    if (!found || s->failed || yk_arena_failed(s->arena)) {
        if (found) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory during the synthesis");
        yk_synthesis_free(s);
        return NULL;
    }
    return s;
}

void yk_synthesis_free(YkSynthesis *s)
{
    if (!s) return;
    yk_text_free(&s->picture);
    for (size_t k = 0; k < 2; k++) yk_text_free(&s->sheet[k]);
    free(s->dyads);
    free(s->sides);
    free(s->candidates.items);
    free(s->defects.items);
    yk_arena_free(s->arena);
    free(s);
}
