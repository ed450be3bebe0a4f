// Follows all complex solutions of a block both ways from one input after the other, until the interval is covered.
#include "map/segments.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "num/complex.h"

enum { DEPTH_MAX = 120 };

typedef struct Search {
    YkTracer *tracer;
    YkStrand *below;
    YkSegments *out;
} Search;

void yk_segments_free(YkSegments *segments)
{
    for (size_t k = 0; k < segments->count; k++) {
        for (size_t s = 0; s < segments->items[k].count; s++) yk_strand_free(segments->items[k].real[s]);
        free(segments->items[k].real);
    }
    free(segments->items);
    *segments = (YkSegments){0};
}

// Enumerates all complex solutions at an input inside the interval. Returns false if that succeeds nowhere.
static bool enumerate(Search *s, double low, double high, double *at)
{
    static const double places[] = {0.5137, 0.4142, 0.6180, 0.2929, 0.7639, 0.1459, 0.8819};
    YkTracer *t = s->tracer;
    size_t level = s->below->level;
    YkDiscCoefficients coefficients;
    YkGroupSolutions *all = &t->solutions[level];
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        *at = low + places[k] * (high - low);
        if (!yk_trace_place(t, s->below, *at)) continue;
        yk_piece_coefficients(&t->pieces[level], &t->discs, &coefficients);
        YkGroupStatus status = yk_group_solve_at(&t->kept[level], coefficients.at, t->mech->size, t->pace, all);
        t->out_of_memory |= status == YK_GROUP_NO_MEMORY;
        if (t->out_of_memory || yk_pace_is_stopped(t->pace)) return false;
        if (!all->is_complete || all->expected < t->expected[level]) continue;
        // More than anywhere before: some were missed there.
        if (t->expected[level] > 0 && all->expected > t->expected[level]) yk_note_unproved(t, *at, level);
        t->expected[level] = all->expected;
        return true;
    }
    return false;
}

static bool keep_real(YkTracer *t, YkSegment *segment, YkStrand *strand)
{
    if (!YK_ROOM(segment->real, segment->count, segment->capacity)) {
        t->out_of_memory = true;
        return false;
    }
    segment->real[segment->count++] = strand;
    return true;
}

// Returns whether a solution is the conjugate of another, whose way mirrors its own.
static bool is_conjugate(const YkPiece *piece, const YkVec *x, const YkVec *y)
{
    const double near = 1e-9;
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        YkVec mirrored = k < piece->shape.angles ? yk_inverse(yk_conj(y[k])) : yk_conj(y[k]);
        if (!(yk_norm(yk_sub(x[k], mirrored)) < near * yk_piece_size(piece, x, k))) return false;
    }
    return true;
}

// Returns whether the conjugate of a solution is among those before it.
static bool is_mirrored(const YkPiece *piece, const YkGroupSolutions *all, size_t index)
{
    for (size_t k = 0; k < index; k++)
        if (is_conjugate(piece, all->proved[index].x, all->proved[k].x)) return true;
    return false;
}

// Returns whether a solution is on its way to infinity: of a real one every |z| is 1.
static bool is_far(const YkPiece *piece, const YkVec *x)
{
    const double far = 100;
    for (size_t k = 0; k < piece->shape.angles; k++) {
        double size = yk_norm(x[k]);
        if (size > far || size < 1 / far) return true;
    }
    return false;
}

// Follows a solution from `at` towards an end of the segment, which it shortens if it does not get there.
static void follow_to(Search *s, double at, int end, YkVec *x, YkStrand *strand, YkSegment *segment)
{
    double *bound = end == 1 ? &segment->to : &segment->from;
    double reached = yk_trace_follow(s->tracer, s->below, at, *bound, x, strand);
    if (reached != *bound) segment->is_far[end] = is_far(&s->tracer->pieces[s->below->level], x);
    *bound = reached;
}

// Follows one solution both ways, no farther than the others came. Cells of the way down come first, descending.
static void follow_both(Search *s, const YkProved *solution, double at, YkSegment *segment)
{
    YkTracer *t = s->tracer;
    size_t level = s->below->level, bytes = t->pieces[level].shape.unknowns * sizeof *solution->x;
    YkVec x[YK_PIECE_UNKNOWNS];
    YkStrand *strand = NULL;
    if (solution->certificate.reality == YK_REAL) {
        strand = yk_strand_new(t, level + 1, s->below);
        if (!strand) return;
        if (!keep_real(t, segment, strand)) {
            yk_strand_free(strand);
            return;
        }
    }
    memcpy(x, solution->x, bytes);
    follow_to(s, at, 0, x, strand, segment);
    if (strand) yk_strand_reverse(strand);
    memcpy(x, solution->x, bytes);
    follow_to(s, at, 1, x, strand, segment);
}

// Cuts a strand to the interval that all solutions reached.
static void clip(YkStrand *strand, double from, double to)
{
    size_t first = 0;
    while (strand->count > 0 && strand->cells[strand->count - 1].from >= to) free(strand->cells[--strand->count].x);
    while (first < strand->count && strand->cells[first].to <= from) free(strand->cells[first++].x);
    strand->count -= first;
    if (first > 0 && strand->count > 0)
        memmove(strand->cells, strand->cells + first, strand->count * sizeof *strand->cells);
    if (strand->count == 0) return;
    strand->cells[0].from = from;
    strand->cells[strand->count - 1].to = to;
}

static bool add_segment(Search *s, YkSegment segment)
{
    if (YK_ROOM(s->out->items, s->out->count, s->out->capacity)) {
        s->out->items[s->out->count++] = segment;
        return true;
    }
    s->tracer->out_of_memory = true;
    YkSegments alone = {.items = &segment, .count = 1};
    for (size_t k = 0; k < segment.count; k++) yk_strand_free(alone.items->real[k]);
    free(segment.real);
    return false;
}

static void cover(Search *s, double low, double high, int depth)
{
    YkTracer *t = s->tracer;
    double at;
    if (high - low < YK_TRACE_ZONE * t->scale || t->out_of_memory || yk_pace_is_stopped(t->pace)) return;
    if (depth == DEPTH_MAX || (depth > 0 && t->steps_left == 0) || !enumerate(s, low, high, &at))
        return; // a gap, which who joins the segments judges
    const YkGroupSolutions *all = &t->solutions[s->below->level];
    if (depth == 0) t->steps_left = YK_TRACE_STEPS * (all->proved_count + 1);
    YkSegment segment = {.from = low, .to = high};
    for (size_t k = 0; k < all->proved_count && !t->out_of_memory; k++) {
        bool is_real = all->proved[k].certificate.reality == YK_REAL;
        if (is_real || !is_mirrored(&t->pieces[s->below->level], all, k)) follow_both(s, &all->proved[k], at, &segment);
    }
    if (!(segment.from < segment.to)) {
        for (size_t k = 0; k < segment.count; k++) yk_strand_free(segment.real[k]);
        free(segment.real);
        return;
    }
    for (size_t k = 0; k < segment.count; k++) clip(segment.real[k], segment.from, segment.to);
    double from = segment.from, to = segment.to;
    cover(s, low, from, depth + 1);
    if (add_segment(s, segment)) cover(s, to, high, depth + 1);
}

void yk_segments_find(YkTracer *tracer, YkStrand *below, YkSegments *out)
{
    Search s = {tracer, below, out};
    *out = (YkSegments){0};
    cover(&s, yk_strand_from(below), yk_strand_to(below), 0);
}
