// Ties strands where the strands below them are tied: the solutions on both sides of the tie are the same ones.
#include <string.h>
#include "map/strand.h"

static double end_of(const YkStrand *s, int end)
{
    return end == 1 ? yk_strand_to(s) : yk_strand_from(s);
}

// Returns whether a strand reaches an end of the one below it.
static bool reaches(const YkTracer *t, const YkStrand *strand, const YkStrand *below, int end)
{
    return strand->below == below && fabs(end_of(strand, end) - end_of(below, end)) <= YK_TRACE_BLUR * t->scale;
}

static bool read_end(YkTracer *t, YkStrand *strand, int end, YkVec *x, double *within)
{
    return yk_trace_read(t, strand, end_of(strand, end), x, within);
}

// Returns the number of the event that one below becomes for a strand.
static size_t event_for(YkTracer *t, size_t level, const YkTie *below, const YkStrand *strand, int end)
{
    const YkTies *ties = &t->ties[level];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        if (tie->source_event == below->event && tie->strand[0] == strand && tie->end[0] == end) return tie->event;
    }
    return t->event_count++;
}

static bool carry_one(YkTracer *t, size_t level, const YkTie *below, YkStrand *a)
{
    const YkStrands *all = &t->levels[level];
    const YkPiece *piece = &t->pieces[level - 1];
    YkVec x[YK_PIECE_UNKNOWNS], y[YK_PIECE_UNKNOWNS];
    YkCertificate own;
    double within;
    if (!read_end(t, a, below->end[0], x, &within)) return false;
    double at_a = end_of(below->strand[0], below->end[0]), at_b = end_of(below->strand[1], below->end[1]);
    if (!yk_trace_place_between(t, below->strand[0], at_a, below->strand[1], at_b)) return false;
    memcpy(y, x, sizeof y);
    if (!yk_trace_enclose(t, level - 1, y, &own) || !yk_trace_is_inside(piece, y, own.radius, x, within)) return false;
    for (size_t k = 0; k < all->count; k++) {
        YkStrand *b = all->items[k];
        if (!reaches(t, b, below->strand[1], below->end[1]) || !read_end(t, b, below->end[1], x, &within)) continue;
        if (!yk_trace_is_inside(piece, y, own.radius, x, within)) continue;
        YkTie tie = *below;
        tie.strand[0] = a;
        tie.strand[1] = b;
        tie.source_event = below->event;
        tie.event = event_for(t, level, below, a, below->end[0]);
        return yk_trace_tie(t, level, tie);
    }
    return false;
}

void yk_trace_carry(YkTracer *t, size_t level)
{
    const YkStrands *all = &t->levels[level];
    for (size_t k = 0; k < t->ties[level - 1].count && !t->out_of_memory; k++) {
        YkTie below = t->ties[level - 1].items[k];
        size_t first = 0, second = 0;
        for (size_t s = 0; s < all->count && !t->out_of_memory && !yk_pace_is_stopped(t->pace); s++) {
            if (reaches(t, all->items[s], below.strand[1], below.end[1])) second++;
            if (!reaches(t, all->items[s], below.strand[0], below.end[0])) continue;
            first++;
            if (!carry_one(t, level, &below, all->items[s])) yk_note_unproved(t, below.at, level - 1);
        }
        if (first != second) yk_note_unproved(t, below.at, level - 1);
    }
}
