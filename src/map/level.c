// Joins the segments of a block to strands, and tells what happens where they meet.
#include <stdlib.h>
#include <string.h>
#include "map/workspace/dyad.h"
#include "map/segments.h"
#include "num/complex.h"

// --- joining over a zone

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

// --- what meets in a zone

void yk_trace_meet(YkTracer *t, YkMeeting *m, YkStrand *strand, int end)
{
    if (m->count == YK_MEETING_MAX) {
        yk_note_unproved(t, m->from, strand->level - 1);
        return;
    }
    m->strand[m->count] = strand;
    m->end[m->count++] = end;
}

static double end_of(const YkStrand *s, int end)
{
    return end == 1 ? yk_strand_to(s) : yk_strand_from(s);
}

// Returns |det J| of the block at an input of the strand, or -1.
static double determinant(YkTracer *t, YkStrand *strand, double at)
{
    YkVec x[YK_PIECE_UNKNOWNS], F[YK_PIECE_UNKNOWNS], J[YK_PIECE_UNKNOWNS * YK_PIECE_UNKNOWNS];
    YkDiscCoefficients c;
    const YkPiece *piece = &t->pieces[strand->level - 1];
    size_t n = piece->shape.unknowns;
    int pivot[YK_PIECE_UNKNOWNS];
    double within, product = 1;
    if (!yk_trace_read(t, strand, at, x, &within)) return -1;
    yk_piece_coefficients(piece, &t->discs, &c);
    yk_system_evaluate(&piece->shape, c.at, x, F, J);
    if (!yk_complex_factor(n, J, pivot)) return -1;
    for (size_t k = 0; k < n; k++) product /= yk_norm(J[k * n + k]);
    return product;
}

// Returns where the determinant of a strand vanishes beyond its end: a parabola through three of its poses, evaluated
// at 0. Near a limit the input is a smooth function of the determinant's square, near a change point of itself.
static double locate(YkTracer *t, YkStrand *strand, int end, const YkMeeting *m, bool is_limit)
{
    double at = end_of(strand, end), length = yk_strand_to(strand) - yk_strand_from(strand);
    double d = fmin((is_limit ? 1e-6 : 1e-4) * t->scale, length / 8), u[3], y[3], found = 0;
    for (int k = 0; k < 3; k++) {
        u[k] = (k + 1) * d;
        y[k] = determinant(t, strand, end == 1 ? at - u[k] : at + u[k]);
        if (!(y[k] > 0)) return 0.5 * (m->from + m->to);
        if (is_limit) y[k] *= y[k];
    }
    for (int k = 0; k < 3; k++) {
        double a = y[(k + 1) % 3], b = y[(k + 2) % 3];
        found += u[k] * a * b / ((y[k] - a) * (y[k] - b));
    }
    found = end == 1 ? at - found : at + found;
    return isfinite(found) ? fmin(fmax(found, m->from), m->to) : 0.5 * (m->from + m->to);
}

static YkTie tie_of(YkTracer *t, const YkMeeting *m, size_t a, size_t b, double at, size_t event)
{
    size_t block = t->pieces[m->strand[a]->level - 1].block;
    return (YkTie){.strand = {m->strand[a], m->strand[b]},
                   .end = {m->end[a], m->end[b]},
                   .at = at,
                   .block = block,
                   .event = event};
}

static void tie_limit(YkTracer *t, const YkMeeting *m, size_t a, size_t b)
{
    YkTie tie = tie_of(t, m, a, b, locate(t, m->strand[a], m->end[a], m, true), t->event_count++);
    tie.kind = YK_TIE_LIMIT;
    yk_trace_tie(t, m->strand[a]->level, tie);
}

// Two branches arrive and two leave: they cross, unless they turn back on both sides of a narrow gap.
static void tie_crossing(YkTracer *t, const YkMeeting *m, const size_t *member)
{
    size_t first = member[0], event, other = 1;
    size_t level = m->strand[first]->level, opposite = 1, same = 1;
    for (size_t k = 1; k < 4; k++)
        if (m->end[member[k]] == m->end[first])
            same = k;
        else
            opposite = k;
    double a = locate(t, m->strand[first], m->end[first], m, false);
    double b = locate(t, m->strand[member[opposite]], m->end[member[opposite]], m, false);
    if (fabs(a - b) > 1e-9 * t->scale) {
        while (other == same || other == opposite) other++;
        tie_limit(t, m, first, member[same]);
        tie_limit(t, m, member[opposite], member[other]);
        return;
    }
    event = t->event_count++;
    for (size_t k = 1; k < 4; k++) {
        YkTie tie = tie_of(t, m, first, member[k], 0.5 * (a + b), event);
        tie.kind = YK_TIE_CHANGE;
        yk_trace_tie(t, level, tie);
    }
}

static void tie_group(YkTracer *t, const YkMeeting *m, const size_t *member, size_t count)
{
    size_t arriving = 0, level = m->strand[member[0]]->level;
    for (size_t k = 0; k < count; k++) arriving += (size_t)m->end[member[k]];
    if (count == 2 && arriving != 1) {
        tie_limit(t, m, member[0], member[1]);
    } else if (count == 4 && arriving == 2) {
        tie_crossing(t, m, member);
    } else { // more than a limit or a crossing: told, not judged
        size_t event = t->event_count++;
        yk_note_unproved(t, 0.5 * (m->from + m->to), level - 1);
        for (size_t k = 1; k < count; k++) {
            YkTie tie = tie_of(t, m, member[0], member[k], 0.5 * (m->from + m->to), event);
            tie.kind = YK_TIE_CHANGE;
            yk_trace_tie(t, level, tie);
        }
    }
}

// Returns how far two ends are apart in their unknowns.
static double apart(const YkPiece *piece, const YkVec *x, const YkVec *y)
{
    double most = 0;
    for (size_t k = 0; k < piece->shape.unknowns; k++)
        most = fmax(most, yk_norm(yk_piece_off(piece, x, y, k)) / yk_piece_size(piece, x, k));
    return most;
}

// Several may meet at the same input in different poses: those that are near each other belong together.
void yk_trace_tie_all(YkTracer *t, const YkMeeting *m)
{
    const double near = 1e-2;
    YkVec(*x)[YK_PIECE_UNKNOWNS] = malloc((m->count + 1) * sizeof *x);
    bool is_taken[YK_MEETING_MAX] = {false};
    size_t member[YK_MEETING_MAX];
    double within;
    if (!x) {
        t->out_of_memory = true;
        return;
    }
    for (size_t k = 0; k < m->count; k++)
        if (!yk_trace_read(t, m->strand[k], end_of(m->strand[k], m->end[k]), x[k], &within))
            memcpy(x[k], m->strand[k]->cells[m->end[k] == 1 ? m->strand[k]->count - 1 : 0].x,
                   t->pieces[m->strand[k]->level - 1].shape.unknowns * sizeof **x);
    for (size_t first = 0; first < m->count; first++) {
        size_t count = 0;
        if (is_taken[first]) continue;
        for (size_t k = first; k < m->count; k++) {
            if (is_taken[k] || !(apart(&t->pieces[m->strand[k]->level - 1], x[first], x[k]) < near)) continue;
            is_taken[k] = true;
            member[count++] = k;
        }
        tie_group(t, m, member, count);
    }
    free(x);
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
