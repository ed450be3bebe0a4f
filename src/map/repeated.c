// Sifts the strands of a machine some of whose constraints repeat others.
//
// The blocks that repeat others were left out while strands were followed. The gap that they leave is an analytic
// function along a strand: it is zero everywhere, or in single poses. It counts as zero everywhere if it is zero to
// rounding in every cell.
#include <stdlib.h>
#include "map/strand.h"

enum { KNOT_MAX = 128 };

// Over the size: a loop that misses by no more closes, beside what the pose itself is not known to; a pose not known to
// the second of these is not asked; single poses are looked for down to the third, over the scale of the input.
#define CLOSE 1e-11
#define SHARP 1e-7
#define NARROW 1e-7

static bool is_repeated(const YkTracer *t, size_t step)
{
    if (t->mech->steps[step].kind != YK_STEP_BLOCK) return false;
    YkBlockKind kind = t->mech->blocks[t->mech->steps[step].target].kind;
    return kind == YK_BLOCK_LINK || kind == YK_BLOCK_CHECK;
}

// Returns whether some loop certainly misses at the pose placed, and as far as `half` from it, where poses are placed
// in t->over. *is_sharp: all are known well.
static bool misses(const YkTracer *t, double half, bool *is_sharp)
{
    bool does = false;
    *is_sharp = true;
    for (size_t k = 0; k < t->mech->step_count; k++) {
        if (!is_repeated(t, k)) continue;
        const YkBlock *block = &t->mech->blocks[t->mech->steps[k].target];
        YkBall miss = yk_discs_miss(&t->discs, block).at;
        double change = half > 0 ? half * yk_ball_most(yk_discs_miss(&t->over, block).rate) : 0;
        does |= yk_norm(miss.at) > YK_BALL_OUT(miss.radius + change) + CLOSE;
        *is_sharp &= miss.radius < SHARP;
    }
    return does;
}

// Returns whether the loops close on a strand: they miss in none of its cells. Notes if too little is known.
static bool closes(YkTracer *t, YkStrand *strand)
{
    size_t known = 0;
    for (size_t k = 0; k < strand->count; k++) {
        const YkCell *cell = &strand->cells[k];
        double middle = cell->from + 0.5 * (cell->to - cell->from);
        bool is_sharp;
        if (!yk_trace_place(t, strand, middle)) continue;
        if (misses(t, 0, &is_sharp)) return false;
        known += is_sharp;
    }
    if (2 * known < strand->count) yk_note_unproved(t, yk_strand_from(strand), strand->level - 1);
    return true;
}

// Notes a single pose, unless it is the one noted last: two intervals may hold it.
static void note_single(YkTracer *t, double at)
{
    const size_t most = sizeof t->single / sizeof *t->single;
    bool is_new = t->single_count == 0 || fabs(at - t->single_last) > 8 * NARROW * t->scale;
    t->single_last = at;
    if (!is_new) return;
    if (t->single_count < most) t->single[t->single_count] = at;
    t->single_count++;
}

// Looks for single poses on a strand whose loops do not close: halves an interval until they miss all over it.
static void look_for_single(YkTracer *t, YkStrand *strand, double from, double to)
{
    double half, middle = from + 0.5 * (to - from);
    bool is_sharp;
    if (yk_pace_is_stopped(t->pace)) return;
    if (yk_trace_place_path(t, strand, from, to, &half) && misses(t, half, &is_sharp)) return;
    if (to - from < NARROW * t->scale) {
        note_single(t, middle);
        return;
    }
    look_for_single(t, strand, from, middle);
    look_for_single(t, strand, middle, to);
}

// Returns whether an end of a strand is tied to one that is kept: the pose there is on that one.
static bool meets_kept(const YkTracer *t, const bool *is_kept, const YkStrand *strand, int end)
{
    const YkTies *ties = &t->ties[t->piece_count];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        bool is_there =
            (tie->strand[0] == strand && tie->end[0] == end) || (tie->strand[1] == strand && tie->end[1] == end);
        for (size_t j = 0; is_there && j < ties->count; j++)
            if (ties->items[j].event == tie->event)
                for (int side = 0; side < 2; side++)
                    if (is_kept[ties->items[j].strand[side]->index]) return true;
    }
    return false;
}

static void look_along(YkTracer *t, const bool *is_kept, YkStrand *strand)
{
    const double aside = YK_TRACE_BLUR * t->scale;
    double first = yk_strand_from(strand), last = yk_strand_to(strand);
    if (meets_kept(t, is_kept, strand, 0)) first += aside;
    if (meets_kept(t, is_kept, strand, 1)) last -= aside;
    for (size_t k = 0; k < strand->count; k++) {
        double from = fmax(strand->cells[k].from, first), to = fmin(strand->cells[k].to, last);
        if (from < to) look_for_single(t, strand, from, to);
    }
}

// The ends that are tied at an event.
typedef struct Knot {
    YkStrand *strand[KNOT_MAX];
    int end[KNOT_MAX];
    size_t count, dropped;
} Knot;

static void add_end(Knot *knot, const bool *is_kept, YkStrand *strand, int end)
{
    for (size_t k = 0; k < knot->count; k++)
        if (knot->strand[k] == strand && knot->end[k] == end) return;
    if (!is_kept[strand->index]) {
        knot->dropped++;
    } else if (knot->count < KNOT_MAX) {
        knot->strand[knot->count] = strand;
        knot->end[knot->count++] = end;
    }
}

// Ties the remaining strands of an event anew if some are dropped. If one that arrives at a crossing and one that
// leaves it remain, the branch passes.
static void tie_anew(YkTracer *t, const bool *is_kept, size_t first, YkTies *kept)
{
    const YkTies *ties = &t->ties[t->piece_count];
    Knot knot = {.count = 0};
    for (size_t k = first; k < ties->count; k++)
        for (int side = 0; side < 2 && ties->items[k].event == ties->items[first].event; side++)
            add_end(&knot, is_kept, ties->items[k].strand[side], ties->items[k].end[side]);
    bool passes = knot.dropped > 0 && knot.count == 2 && knot.end[0] != knot.end[1];
    if (knot.count == 1 || knot.count == KNOT_MAX)
        yk_note_unproved(t, ties->items[first].at, ties->items[first].strand[0]->level - 1);
    for (size_t k = 1; k < knot.count; k++) {
        YkTie tie = ties->items[first];
        tie.kind = passes ? YK_TIE_PASS : tie.kind;
        tie.strand[0] = knot.strand[0];
        tie.strand[1] = knot.strand[k];
        tie.end[0] = knot.end[0];
        tie.end[1] = knot.end[k];
        kept->items[kept->count++] = tie;
    }
}

static bool sift_ties(YkTracer *t, const bool *is_kept)
{
    YkTies *ties = &t->ties[t->piece_count];
    YkTies kept = {.items = malloc((ties->count + 1) * sizeof *kept.items), .capacity = ties->count + 1};
    if (!kept.items) return false;
    for (size_t k = 0; k < ties->count; k++) {
        bool is_first = true;
        for (size_t j = 0; j < k && is_first; j++) is_first = ties->items[j].event != ties->items[k].event;
        if (ties->items[k].kind == YK_TIE_ROUND) {
            if (is_kept[ties->items[k].strand[0]->index] && is_kept[ties->items[k].strand[1]->index])
                kept.items[kept.count++] = ties->items[k];
        } else if (is_first) {
            tie_anew(t, is_kept, k, &kept);
        }
    }
    free(ties->items);
    *ties = kept;
    return true;
}

void yk_repeated_sift(YkTracer *t)
{
    YkStrands *all = &t->levels[t->piece_count];
    bool *is_kept = calloc(all->count + 1, sizeof *is_kept);
    bool good = is_kept != NULL;
    size_t kept = 0;
    for (size_t k = 0; good && k < all->count; k++) is_kept[k] = closes(t, all->items[k]);
    for (size_t k = 0; good && k < all->count; k++)
        if (!is_kept[k]) look_along(t, is_kept, all->items[k]);
    good = good && sift_ties(t, is_kept);
    for (size_t k = 0; good && k < all->count; k++) {
        YkStrand *strand = all->items[k];
        if (is_kept[k]) {
            all->items[kept] = strand;
            strand->index = kept++;
        } else {
            yk_strand_free(strand);
        }
    }
    if (good) all->count = kept;
    t->out_of_memory |= !good;
    free(is_kept);
}
