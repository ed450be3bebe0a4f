// Finds what happens where the ends of strands meet: limits, change points, or something that is not proved.
#include <stdlib.h>
#include <string.h>
#include "map/segments.h"
#include "num/complex.h"

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
    } else { // more than a limit or a crossing: reported, not judged
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
