// The finds of a search: dyads, machines that passed, best first, and those that were left out.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "synthesis/synthesis.h"

void yk_synthesis_add_dyad(YkSynthesis *s, const YkDyad *dyad, unsigned sides)
{
    size_t capacity = s->dyad_capacity;
    bool good = YK_ROOM(s->dyads, s->dyad_count, capacity);
    if (good && capacity != s->dyad_capacity) { // both arrays grow together
        unsigned char *more = realloc(s->sides, capacity);
        good = more != NULL;
        if (more) s->sides = more;
        if (good) s->dyad_capacity = capacity;
    }
    s->failed |= !good;
    if (!good) return;
    s->sides[s->dyad_count] = (unsigned char)sides;
    s->dyads[s->dyad_count++] = *dyad;
}

bool yk_synthesis_fetch(YkSynthesis *s, size_t piece, double *numbers)
{
    YkStatus status = s->options.pieces.get(s->options.pieces.context, piece, numbers);
    if (status == YK_STOPPED) s->pace.is_stopped = true;
    if (status < 0 && status != YK_STOPPED) s->failed = true;
    return status >= 0 && !s->pace.is_stopped;
}

YkDefect yk_synthesis_try(YkSynthesis *s, const YkDesign *design, const YkJourney *journey, YkText *text,
                          YkVerdict *verdict)
{
    enum { MICROSECONDS = 600 };
    *verdict = (YkVerdict){.defect = YK_DEFECT_ASSEMBLY};
    if (!yk_synthesis_goes_on(s, MICROSECONDS)) return YK_DEFECT_ASSEMBLY;
    yk_text_clear(text);
    yk_design_write(design, journey, text);
    if (text->failed || yk_design_judge(yk_text_get(text), design, journey, verdict) != YK_OK) s->failed = true;
    return verdict->defect;
}

static YkFound *add(YkSynthesis *s, YkFoundList *list, const YkDesign *design, const YkVerdict *verdict)
{
    if (!YK_ROOM(list->items, list->count, list->capacity)) {
        s->failed = true;
        return NULL;
    }
    YkFound *found = &list->items[list->count];
    *found = (YkFound){.design = *design, .defect = verdict->defect, .order = list->count++};
    found->error = verdict->error;
    found->interpolating = NAN;
    found->worst = verdict->worst;
    memcpy(found->transmission, verdict->transmission, sizeof found->transmission);
    return found;
}

// Returns whether two machines are nearly the same: all lengths within 15 %, the pivots within 15 % of the size.
static bool is_alike(const YkDesign *a, const YkDesign *b)
{
    static const double near_to = 0.15;
    double size = 0;
    for (size_t k = 0; k < 4; k++) {
        size = fmax(size, b->length[k]);
        if (fabs(a->length[k] - b->length[k]) > near_to * fabs(b->length[k])) return false;
    }
    for (size_t k = 0; k < 2; k++) {
        size = fmax(size, b->dyad_length[k]);
        if (fabs(a->dyad_length[k] - b->dyad_length[k]) > near_to * b->dyad_length[k]) return false;
    }
    for (size_t i = 0; i < YK_SIDES; i++)
        if (yk_norm(yk_sub(a->pivot[i], b->pivot[i])) > near_to * size) return false;
    return a->kind == b->kind && a->variant == b->variant;
}

static size_t best_of(const YkSynthesis *s)
{
    return s->options.best > 0 ? s->options.best : s->task->best;
}

// Lets the caller hear of a machine that is among the best so far.
static void tell(const YkSynthesis *s, YkFound *found)
{
    size_t place = 0, best = best_of(s);
    const YkFoundList *list = &s->candidates;
    for (size_t k = 0; k < list->count; k++) {
        const YkFound *other = &list->items[k];
        if (!other->is_told || other->merit < found->merit) continue;
        if (++place >= best || is_alike(&other->design, &found->design)) return;
    }
    found->is_told = true;
    YkCandidate candidate = yk_found_candidate(found);
    s->options.findings.tell(s->options.findings.context, &candidate, place, best);
}

YkFound *yk_synthesis_keep(YkSynthesis *s, const YkDesign *design, const YkText *text, const YkVerdict *verdict,
                           double merit)
{
    if (yk_pace_is_stopped(&s->pace)) return NULL;
    YkFound *found = add(s, &s->candidates, design, verdict);
    double *curve = YK_NEW(s->arena, double, 2 * verdict->rows + 1);
    if (!found || !curve) return NULL;
    memcpy(curve, verdict->curve, 2 * verdict->rows * sizeof *curve);
    found->model = yk_arena_copy(s->arena, yk_text_get(text), text->length);
    found->curve = curve;
    found->rows = verdict->rows;
    found->merit = merit;
    if (s->options.findings.tell && s->task->kind != YK_TASK_MACHINE && !yk_arena_failed(s->arena)) tell(s, found);
    return found;
}

void yk_synthesis_leave(YkSynthesis *s, const YkDesign *design, YkDefect defect, const YkVerdict *verdict)
{
    if (yk_pace_is_stopped(&s->pace)) return;
    s->left_out[defect]++;
    if (s->defects.count >= YK_DEFECTS_KEPT) return;
    YkFound *found = add(s, &s->defects, design, verdict);
    if (found) found->defect = defect;
}

// --- ranking

static int by_merit(const void *a, const void *b)
{
    const YkFound *p = a, *q = b;
    if (p->merit != q->merit) return p->merit > q->merit ? -1 : 1;
    return p->order < q->order ? -1 : p->order > q->order;
}

// Where a choice was sampled, keeps the best of machines that are alike.
static void keep_different(YkFoundList *list, size_t most)
{
    size_t kept = 0;
    for (size_t k = 0; k < list->count && kept < most; k++) {
        bool is_new = true;
        for (size_t i = 0; i < kept && is_new; i++) is_new = !is_alike(&list->items[k].design, &list->items[i].design);
        if (is_new) list->items[kept++] = list->items[k];
    }
    list->count = kept;
}

void yk_synthesis_rank(YkSynthesis *s)
{
    YkFoundList *list = &s->candidates;
    YkText name = {0};
    size_t best = best_of(s);
    if (list->count > 0) qsort(list->items, list->count, sizeof *list->items, by_merit);
    if (!s->is_complete && s->task->kind != YK_TASK_MACHINE) keep_different(list, best);
    if (list->count > best) list->count = best;
    for (size_t k = 0; k < list->count; k++) {
        yk_text_clear(&name);
        yk_text_format(&name, "%s%z-%s.yaml", k < 9 ? "0" : "", k + 1,
                       s->task->kind == YK_TASK_MACHINE ? "machine" : yk_design_kind_name(list->items[k].design.kind));
        list->items[k].file = yk_arena_copy(s->arena, yk_text_get(&name), name.length);
    }
    yk_text_free(&name);
}
