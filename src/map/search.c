// Finds the strands of a piece in real unknowns: all its solutions at many inputs, followed from there.
//
// Complex solutions are not followed here. Between these inputs the space of all angles and distances is divided
// instead, for whole intervals of the input: every box of it is proved to hold no solution, or exactly one, which is on
// a strand.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "map/meshed.h"
#include "map/segments.h"

#define APART 0.1 // of the inputs at which all solutions are found, over the scale

// Returns whether a solution at an input lies on a strand that was found from another one.
static bool is_on(YkTracer *t, YkStrand *strand, double at, const YkVec *x)
{
    YkVec line[YK_PIECE_UNKNOWNS];
    const YkPiece *piece = &t->pieces[strand->level - 1];
    if (at < yk_strand_from(strand) || at > yk_strand_to(strand)) return false;
    const YkCell *cell = yk_strand_cell(strand, at, at);
    if (!cell) return false;
    yk_cell_at(piece, cell, at, line);
    return yk_trace_is_inside(piece, line, cell->radius, x, 1e-13);
}

// Follows a solution both ways, as far as it goes. Returns false when out of memory.
static bool follow(YkTracer *t, YkStrand *below, double at, const YkVec *x)
{
    YkVec y[YK_PIECE_UNKNOWNS];
    size_t level = below->level;
    YkStrand *strand = yk_strand_new(t, level + 1, below);
    if (!strand) return false;
    t->steps_left = YK_TRACE_STEPS;
    memcpy(y, x, sizeof y);
    yk_trace_follow(t, below, at, yk_strand_from(below), y, strand);
    yk_strand_reverse(strand);
    memcpy(y, x, sizeof y);
    yk_trace_follow(t, below, at, yk_strand_to(below), y, strand);
    if (strand->count > 0 && yk_strand_keep(t, strand)) return true;
    if (strand->count == 0) yk_note_unproved(t, at, level);
    yk_strand_free(strand);
    return !t->out_of_memory;
}

// Finds all solutions at an input, and follows those that are not on strands. Returns false if that is impossible.
static bool search_at(YkTracer *t, YkStrand *below, double at, size_t first)
{
    YkPiece *piece = &t->pieces[below->level];
    const YkStrands *list = &t->levels[below->level + 1];
    bool all, has_memory = true;
    if (!yk_trace_place(t, below, at)) return false;
    yk_piece_coefficients(piece, &t->discs, &t->coefficients[0]);
    if (!yk_meshed_solve(piece, &t->coefficients[0], t->pace, &all)) t->out_of_memory = true;
    if (t->out_of_memory || !all) return false;
    for (size_t s = 0; s < yk_meshed_count(piece) && has_memory; s++) {
        YkVec x[YK_PIECE_UNKNOWNS] = {{0, 0}};
        bool is_known = false;
        yk_meshed_solution(piece, s, x);
        for (size_t k = first; k < list->count && !is_known; k++) is_known = is_on(t, list->items[k], at, x);
        if (!is_known) has_memory = follow(t, below, at, x);
    }
    return true;
}

// --- nothing else

typedef struct YkBoxes {
    double *numbers; // [count][2][YK_GEARED_MAX]
    size_t count, capacity;
} YkBoxes;

// An interval of the input over which nothing but known strands is to be.
typedef struct Between {
    YkTracer *t;
    YkStrand *below;
    size_t first;
    double from, to;
    bool is_zone;  // solutions meet in it: boxes near ends of strands are left
    YkBoxes *rest; // of which nothing is known
    YkDiscCoefficients middle, whole;
    size_t left; // intervals that may still be taken
} Between;

// Returns whether a pose, known to `within`, lies in a box; `reach`: or no farther from its middle than that.
static bool is_in_box(const YkPiece *piece, const YkVec *x, double within, const double *box, const double *half,
                      double reach)
{
    YkVec middle[YK_PIECE_UNKNOWNS];
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        middle[k] = yk_vec(box[k], 0);
        double off = fabs(yk_piece_off(piece, x, middle, k).x) + within * yk_piece_size(piece, x, k);
        if (!(off < fmax(half[k], reach))) return false;
    }
    return true;
}

static bool is_near_end(const Between *b, const double *box, const double *half)
{
    const YkStrands *list = &b->t->levels[b->below->level + 1];
    const YkPiece *piece = &b->t->pieces[b->below->level];
    for (size_t k = b->first; k < list->count; k++)
        for (int end = 0; end < 2; end++) {
            YkStrand *s = list->items[k];
            double at = end == 1 ? yk_strand_to(s) : yk_strand_from(s);
            if (fabs(at - b->from) > 4 * YK_TRACE_BLUR * b->t->scale) continue;
            YkVec x[YK_PIECE_UNKNOWNS];
            yk_cell_at(piece, &s->cells[end == 1 ? s->count - 1 : 0], at, x);
            if (is_in_box(piece, x, 0, box, half, 2e-2)) return true;
        }
    return false;
}

// Returns whether the one pose of a box is on a known strand; follows one that is not.
static bool judge(void *context, const double *box, const double *half)
{
    Between *b = context;
    YkTracer *t = b->t;
    const YkStrands *list = &t->levels[b->below->level + 1];
    const YkPiece *piece = &t->pieces[b->below->level];
    double at = 0.5 * (b->from + b->to), within;
    YkVec x[YK_PIECE_UNKNOWNS] = {{0, 0}};
    YkCertificate own;
    for (size_t k = b->first; k < list->count; k++) {
        YkStrand *s = list->items[k];
        if (yk_strand_from(s) > b->from || yk_strand_to(s) < b->to) continue;
        if (yk_trace_read(t, s, at, x, &within) && is_in_box(piece, x, within, box, half, 0)) return true;
    }
    for (size_t k = 0; k < piece->shape.unknowns; k++) x[k] = yk_vec(box[k], 0);
    if (!yk_trace_place(t, b->below, at) || !yk_trace_enclose(t, b->below->level, x, &own)) return false;
    for (size_t k = b->first; k < list->count; k++)
        if (is_on(t, list->items[k], at, x)) return false; // it ends within the interval
    follow(t, b->below, at, x);
    return false;
}

static bool keep(void *context, const double *box, const double *half)
{
    enum { BOXES = 100000 };
    Between *b = context;
    YkBoxes *rest = b->rest;
    if (b->is_zone && is_near_end(b, box, half)) return true;
    if (b->is_zone || rest->count >= BOXES) return false;
    if (!YK_ROW_ROOM(rest->numbers, 2 * YK_GEARED_MAX, rest->count, rest->capacity)) {
        b->t->out_of_memory = true;
        return false;
    }
    double *row = rest->numbers + 2 * YK_GEARED_MAX * rest->count++;
    memcpy(row, box, YK_GEARED_MAX * sizeof *row);
    memcpy(row + YK_GEARED_MAX, half, YK_GEARED_MAX * sizeof *row);
    return true;
}

// Returns whether an interval lies where strands end.
static bool is_at_ends(const Between *b, double from, double to)
{
    const YkStrands *list = &b->t->levels[b->below->level + 1];
    double low = INFINITY, high = -INFINITY, slack = 1e-6 * b->t->scale, near = YK_TRACE_BLUR * b->t->scale;
    for (size_t k = b->first; k < list->count; k++)
        for (int end = 0; end < 2; end++) {
            double at = end == 1 ? yk_strand_to(list->items[k]) : yk_strand_from(list->items[k]);
            if (fabs(at - from) > 2 * near) continue;
            low = fmin(low, at);
            high = fmax(high, at);
        }
    return from >= low - slack && to <= high + slack;
}

static bool prove_over(Between *b, double from, double to, const YkBoxes *boxes);

static bool prove_halves(Between *b, double from, double to, const YkBoxes *boxes)
{
    double middle = from + 0.5 * (to - from);
    return prove_over(b, from, middle, boxes) && prove_over(b, middle, to, boxes);
}

// Returns whether nothing but known strands is in boxes (NULL: anywhere) over an interval. Boxes that this does not
// decide are left to its halves.
static bool prove_over(Between *b, double from, double to, const YkBoxes *boxes)
{
    enum { MOST = 400000, FEW = 100 };
    YkTracer *t = b->t;
    YkPiece *piece = &t->pieces[b->below->level];
    YkBoxes rest = {0}, finer = {0};
    double half, end = yk_strand_cell_end(b->below, from, 1);
    for (; end > from && end < to; end = yk_strand_cell_end(b->below, from, 1)) {
        if (!prove_over(b, from, end, boxes)) return false;
        from = end;
    }
    double length = (to - from) / t->scale;
    if (length > YK_TRACE_LONGEST) return prove_halves(b, from, to, boxes);
    if (t->out_of_memory || yk_pace_is_stopped(t->pace) || b->left == 0) return false;
    b->left--;
    b->from = from;
    b->to = to;
    b->is_zone = is_at_ends(b, from, to);
    b->rest = &rest;
    if (!yk_trace_place_path(t, b->below, from, to, &half)) return false;
    yk_piece_coefficients(piece, &t->discs, &b->middle);
    yk_piece_coefficients(piece, &t->over, &b->whole);
    YkExclusion over = {.judge = judge,
                        .keep = keep,
                        .context = b,
                        .path = {b->middle.at, b->whole.rate, b->middle.radius, b->whole.rate_radius, half},
                        .boxes = boxes ? boxes->numbers : NULL,
                        .count = boxes ? boxes->count : 0,
                        .smallest = b->is_zone ? 2e-3 : 0.5 * sqrt(length),
                        .most = MOST};
    bool is_bounded = yk_meshed_take(piece->meshed, &b->whole);
    bool is_divided = is_bounded && yk_exclude_over(&piece->meshed->geared, t->pace, &over);
    bool is_short = length < YK_TRACE_ZONE || b->is_zone;
    bool is_proved = is_divided && rest.count == 0;
    if (is_divided && !is_proved && !b->is_zone &&
        rest.count <= FEW) { // near a limit smaller boxes may decide, from which halves could not start
        over.boxes = rest.numbers;
        over.count = rest.count;
        over.smallest *= 0.1;
        b->rest = &finer;
        is_proved = yk_exclude_over(&piece->meshed->geared, t->pace, &over) && finer.count == 0;
    }
    if (!is_proved && is_short)
        yk_note_unproved(t, from, b->below->level);
    else if (!is_proved && (is_divided || !is_bounded))
        is_proved = prove_halves(b, from, to, is_bounded ? &rest : boxes);
    free(rest.numbers);
    free(finer.numbers);
    return is_proved;
}

static bool prove_all(YkTracer *t, YkStrand *below, size_t first)
{
    enum { INTERVALS = 20000 };
    const double aside = 1.1 * YK_TRACE_BLUR * t->scale; // what happens there belongs to what ends the strand below
    double from = yk_strand_from(below), to = yk_strand_to(below);
    Between b = {.t = t, .below = below, .first = first, .left = INTERVALS};
    if (from > t->low) from += aside;
    if (to < t->high) to -= aside;
    return from >= to || prove_over(&b, from, to, NULL);
}

// --- ends

typedef struct End {
    YkStrand *strand;
    int end;
    double at;
} End;

static int compare(const void *a, const void *b)
{
    const End *p = a, *q = b;
    return p->at < q->at ? -1 : p->at > q->at;
}

// Ties the ends of strands that lie inside: those that agree to rounding meet.
static void tie_ends(YkTracer *t, YkStrand *below, size_t first)
{
    const YkStrands *list = &t->levels[below->level + 1];
    const double near = YK_TRACE_BLUR * t->scale;
    End *ends = malloc((2 * (list->count - first) + 1) * sizeof *ends);
    size_t count = 0;
    if (!ends) {
        t->out_of_memory = true;
        return;
    }
    for (size_t k = first; k < list->count; k++)
        for (int end = 0; end < 2; end++) {
            double at = end == 1 ? yk_strand_to(list->items[k]) : yk_strand_from(list->items[k]);
            double bound = end == 1 ? yk_strand_to(below) : yk_strand_from(below);
            if (fabs(at - bound) > near) ends[count++] = (End){list->items[k], end, at};
        }
    qsort(ends, count, sizeof *ends, compare);
    for (size_t k = 0; k < count;) {
        YkMeeting m = {.from = ends[k].at - 2 * near};
        do {
            m.to = ends[k].at + 2 * near;
            yk_trace_meet(t, &m, ends[k].strand, ends[k].end);
            k++;
        } while (k < count && ends[k].at < m.to);
        yk_trace_tie_all(t, &m);
    }
    free(ends);
}

void yk_trace_search(YkTracer *t, YkStrand *below)
{
    static const double places[] = {0.5137, 0.4142, 0.6180, 0.2929, 0.7639};
    double from = yk_strand_from(below), length = yk_strand_to(below) - from;
    bool is_listed = t->pieces[below->level].meshed->is_listed;
    size_t parts = is_listed ? 1 : (size_t)ceil(length / (APART * t->scale)) + 4;
    size_t first = t->levels[below->level + 1].count;
    for (size_t k = 0; k < parts && !t->out_of_memory && !yk_pace_is_stopped(t->pace); k++) {
        bool is_searched = false;
        for (size_t p = 0; p < sizeof places / sizeof *places && !is_searched && !t->out_of_memory; p++)
            is_searched = search_at(t, below, from + ((double)k + places[p]) / (double)parts * length, first);
        if (!is_searched) yk_note_unproved(t, from + ((double)k + 0.5) / (double)parts * length, below->level);
    }
    if (!is_listed && !t->is_searched && !prove_all(t, below, first)) {
        t->is_searched = true;
        t->searched_piece = below->level;
    }
    if (!t->out_of_memory) tie_ends(t, below, first);
}
