// Joins the segments of a block to strands, over the zones between them.
#include "map/workspace/dyad.h"
#include "map/segments.h"

// Appends the cells of b to a.
static bool append(YkTracer *t, YkStrand *a, YkStrand *b)
{
    for (size_t k = 0; k < b->count; k++) {
        const YkCell *c = &b->cells[k];
        if (!yk_strand_add(t, a, *c, c->x, c->rate)) return false;
    }
    return true;
}

// Follows a strand over the zone. Returns whether it arrives; it then has cells there.
static bool go_over(YkTracer *t, YkStrand *strand, double to, YkVec *x)
{
    double within, from = yk_strand_to(strand);
    size_t before = strand->count;
    t->steps_left = YK_TRACE_STEPS;
    if (yk_trace_read(t, strand, from, x, &within) && yk_trace_follow(t, strand->below, from, to, x, strand) == to)
        return true;
    yk_strand_shorten(strand, before);
    return false;
}

// Joins a strand that arrives with the one of the next segment that it is. Returns false if there is none.
static bool join(YkTracer *t, YkStrand *strand, YkSegment *next, const YkVec *x)
{
    const YkPiece *piece = &t->pieces[strand->level - 1];
    for (size_t k = 0; k < next->count; k++) {
        YkStrand *other = next->real[k];
        YkVec line[YK_PIECE_UNKNOWNS];
        yk_cell_at(piece, &other->cells[0], yk_strand_from(other), line);
        if (!yk_trace_is_inside(piece, line, other->cells[0].radius, x, 1e-13)) continue;
        next->real[k] = strand;
        bool ok = append(t, strand, other);
        yk_strand_free(other);
        return ok;
    }
    return false;
}

// Returns whether a dyad is proved to have as many real solutions all over a zone as are followed through it. For a
// dyad the bounds of its triangle tell, also where complex solutions pass through infinity.
static bool is_counted(YkTracer *t, YkStrand *below, const YkMeeting *m, size_t arriving)
{
    const YkPiece *piece = &t->pieces[below->level];
    double half;
    if (piece->shape.loops != 1 || !yk_trace_place_path(t, below, m->from, m->to, &half)) return false;
    yk_piece_coefficients(piece, &t->over, &t->coefficients[0]);
    return yk_dyad_count(&piece->shape, &t->coefficients[0]) == (int)arriving;
}

// Goes from one segment to the next.
static void pass_zone(YkTracer *t, YkStrand *below, YkSegment *before, YkSegment *after)
{
    size_t level = below->level;
    YkVec x[YK_PIECE_UNKNOWNS];
    YkMeeting m = {.from = before->to, .to = after->from};
    size_t joined = 0, arriving = 0;
    bool is_far = before->is_far[1] && after->is_far[0]; // solutions pass through infinity, none of them real
    for (size_t k = 0; k < before->count; k++) {
        YkStrand *strand = before->real[k];
        if (!go_over(t, strand, m.to, x)) {
            yk_trace_meet(t, &m, strand, 1);
            continue;
        }
        arriving++;
        if (join(t, strand, after, x)) joined++;
    }
    for (size_t k = 0; k < after->count; k++)
        if (yk_strand_from(after->real[k]) >= m.to) yk_trace_meet(t, &m, after->real[k], 0);
    // A wider zone could hide solutions that come in and go again; a dyad's are counted.
    bool is_narrow = m.to - m.from < YK_TRACE_BLUR * t->scale;
    if (!is_narrow && (m.count > 0 || !is_counted(t, below, &m, arriving)))
        yk_note_unproved(t, 0.5 * (m.from + m.to), level);
    if (joined < arriving || (m.count == 0 && !is_far)) yk_note_unproved(t, m.from, level);
    if (m.count > 0) yk_trace_tie_all(t, &m);
}

// At its ends a strand must be covered: what happens there belongs to what ends it.
static void note_gaps_at_ends(YkTracer *t, YkStrand *below, const YkSegments *segments)
{
    double from = yk_strand_from(below), to = yk_strand_to(below), most = YK_TRACE_BLUR * t->scale;
    if (t->out_of_memory || yk_pace_is_stopped(t->pace)) return;
    if (segments->count == 0) {
        if (to - from > most) yk_note_unproved(t, 0.5 * (from + to), below->level);
        return;
    }
    if (segments->items[0].from - from > most) yk_note_unproved(t, from, below->level);
    if (to - segments->items[segments->count - 1].to > most) yk_note_unproved(t, to, below->level);
}

static void trace_on(YkTracer *t, YkStrand *below)
{
    YkSegments segments;
    yk_segments_find(t, below, &segments);
    note_gaps_at_ends(t, below, &segments);
    for (size_t k = 0; k + 1 < segments.count && !t->out_of_memory; k++)
        pass_zone(t, below, &segments.items[k], &segments.items[k + 1]);
    // A strand stands in every segment that it passes; its last one hands it over.
    for (size_t k = 0; k < segments.count; k++) {
        YkSegment *s = &segments.items[k];
        for (size_t r = 0; r < s->count; r++) {
            bool goes_on = false;
            for (size_t q = 0; k + 1 < segments.count && q < segments.items[k + 1].count; q++)
                goes_on |= segments.items[k + 1].real[q] == s->real[r];
            if (goes_on || (!t->out_of_memory && yk_strand_keep(t, s->real[r]))) s->real[r] = NULL;
        }
    }
    yk_segments_free(&segments);
}

void yk_trace_level(YkTracer *t, size_t level)
{
    const YkStrands *below = &t->levels[level - 1];
    for (size_t k = 0; k < below->count && !t->out_of_memory && !yk_pace_is_stopped(t->pace); k++)
        (t->pieces[level - 1].meshed ? yk_trace_search : trace_on)(t, below->items[k]);
}
