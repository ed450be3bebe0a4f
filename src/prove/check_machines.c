// Tests an equation with other dimensions, in the numeric engine.
#include <stdlib.h>
#include <string.h>
#include "prove/check_inside.h"

enum { SHOWN_ONE_BY_ONE = 16 };

// Compares both sides at poses of the machine. shown: where they differ.
typedef struct Outcome {
    bool is_machine, differs;
    size_t poses;
} Outcome;

static Outcome judge_machine(YkCheck *own, YkCheckMachine *m, YkCheckShown *shown)
{
    Outcome outcome = {0};
    if (!m->is_machine) return outcome;
    YkCheck there = {.d = m->d,
                     .state = m->here,
                     .start = m->state,
                     .dynamics = m->dynamics,
                     .text = own->text,
                     .length = own->length,
                     .seed = m->seed,
                     .seen = own->seen};
    outcome.is_machine = yk_check_open(&there, &m->poses, (YkPlace){1, 1, 0}, NULL) == YK_CHECK_OPEN;
    if (outcome.is_machine) outcome.differs = yk_check_differs(&there, YK_CHECK_MACHINE_POSES, &outcome.poses);
    if (outcome.differs) yk_check_show(&there, own->d->arena, shown);
    yk_check_close(&there);
    return outcome;
}

// --- A machine for which it does not hold

// Writes "a = 0.053, b = 0.21": the parameters that differ from the file's.
static const char *name_machine(const YkCheckVariants *v, const double *target)
{
    YkText text = {0};
    for (size_t k = 0; k < v->count; k++)
        if (target[k] != v->own[k]) yk_text_format(&text, "%s%s = %e", text.length ? ", " : "", v->name[k], target[k]);
    YkArena *arena = v->check->d->arena;
    const char *words = yk_arena_copy(arena, yk_text_get(&text), text.length);
    yk_text_free(&text);
    return words;
}

// Returns to the file's values as many parameters as possible while the difference still shows.
static void simplify(YkCheckVariants *v, const YkCheckMachine *m, YkCheckVerdict *verdict)
{
    double *target = yk_derive_scratch(v->check->d, v->count + 1, sizeof *target);
    if (!target) return;
    memcpy(target, m->target, v->count * sizeof *target);
    for (size_t k = 0; k < v->count && v->count <= SHOWN_ONE_BY_ONE; k++) {
        YkCheckShown shown = {0};
        double value = target[k];
        target[k] = v->own[k];
        if (judge_machine(v->check, yk_check_machine_at(v, target, m->seed), &shown).differs)
            verdict->shown = shown;
        else
            target[k] = value;
    }
    verdict->shown.machine = name_machine(v, target);
    free(target);
}

void yk_check_machines(YkCheck *check, YkCheckVerdict *verdict)
{
    YkCheckVariants *v = yk_check_variants(check);
    YkCheckMachine *m;
    for (size_t k = 0; v && verdict->machines < YK_CHECK_MACHINES && !verdict->is_false_there; k++) {
        if ((m = yk_check_machine(v, k)) == NULL) break;
        Outcome outcome = judge_machine(check, m, &verdict->shown);
        verdict->machines += outcome.is_machine && outcome.poses > 0;
        verdict->machine_poses += outcome.poses;
        verdict->is_false_there = outcome.differs;
        if (outcome.differs) simplify(v, m, verdict);
    }
    if (verdict->machines == 0) return;
    verdict->varied = yk_check_list_names(v, check->d->arena, true);
    verdict->kept = yk_check_list_names(v, check->d->arena, false);
}
