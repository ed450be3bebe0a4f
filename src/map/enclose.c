// Encloses the poses of strands, at one input and over intervals of it.
#include <string.h>
#include "configurations/follow.h"
#include "map/strand.h"

bool yk_trace_is_inside(const YkPiece *piece, const YkVec *x, double radius, const YkVec *y, double within)
{
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        YkVec way = yk_piece_off(piece, x, y, k);
        double off = yk_hypot(way.x, way.y) * (1 + 0x1p-40);
        double reach = off + within * yk_piece_size(piece, y, k);
        if (!(reach < radius * yk_piece_size(piece, x, k))) return false;
    }
    return true;
}

void yk_cell_at(const YkPiece *piece, const YkCell *cell, double at, YkVec *x)
{
    double t = at - cell->middle;
    for (size_t k = 0; k < piece->shape.unknowns; k++)
        x[k] = yk_vec(cell->x[k].x + t * cell->rate[k].x, cell->x[k].y + t * cell->rate[k].y);
}

void yk_trace_steps(YkTracer *t, YkDiscs *discs, size_t level)
{
    size_t from = level == 0 ? 0 : t->pieces[level - 1].step + 1;
    size_t to = level < t->piece_count ? t->pieces[level].step : t->mech->step_count;
    for (size_t k = from; k < to; k++) yk_discs_take(discs, &t->mech->steps[k]);
}

static bool spend(YkTracer *t, const YkPiece *piece, size_t times)
{
    size_t n = piece->shape.unknowns;
    return yk_pace_spend(t->pace, times * 12 * n * n * (n + 10));
}

// --- at one input

bool yk_trace_enclose(YkTracer *t, size_t level, YkVec *x, YkCertificate *certificate)
{
    YkDiscCoefficients *c = &t->coefficients[0];
    const YkPiece *piece = &t->pieces[level];
    if (!spend(t, piece, 2)) return false;
    yk_piece_coefficients(piece, &t->discs, c);
    if (!(yk_system_polish(&piece->shape, c->at, x) < 1e-6)) return false;
    return yk_enclose(&piece->shape, c->at, c->radius, x, certificate);
}

// Makes the unknowns known, without their derivatives.
static void place_point(YkTracer *t, const YkPiece *piece, const YkVec *x, double within)
{
    YkDual known[YK_PIECE_UNKNOWNS];
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        known[k].at = yk_ball(x[k], YK_BALL_OUT(within * yk_piece_size(piece, x, k)));
        known[k].rate = yk_ball(yk_vec(0, 0), 0);
    }
    yk_discs_place(&t->discs, piece, known);
}

// Encloses the solution of a cell at an input of its: anew if that is possible, which is narrower.
static void enclose_in_cell(YkTracer *t, size_t level, const YkCell *cell, double at, YkVec *x, double *within)
{
    const YkPiece *piece = &t->pieces[level];
    YkVec line[YK_PIECE_UNKNOWNS];
    YkCertificate own;
    size_t bytes = piece->shape.unknowns * sizeof *x;
    yk_cell_at(piece, cell, at, line);
    memcpy(x, line, bytes);
    if (yk_trace_enclose(t, level, x, &own) && yk_trace_is_inside(piece, line, cell->radius, x, own.within)) {
        *within = own.within;
        return;
    }
    memcpy(x, line, bytes);
    *within = cell->within;
}

static void list_below(YkTracer *t, YkStrand *strand)
{
    for (YkStrand *s = strand; s; s = s->below) t->chain[s->level] = s;
}

bool yk_trace_place(YkTracer *t, YkStrand *strand, double at)
{
    YkVec x[YK_PIECE_UNKNOWNS];
    double within;
    list_below(t, strand);
    t->discs.input = yk_ball(yk_vec(at, 0), 0);
    yk_trace_steps(t, &t->discs, 0);
    for (size_t level = 1; level <= strand->level; level++) {
        const YkCell *cell = yk_strand_cell(t->chain[level], at, at);
        if (!cell) return false;
        enclose_in_cell(t, level - 1, cell, at, x, &within);
        place_point(t, &t->pieces[level - 1], x, within);
        yk_trace_steps(t, &t->discs, level);
    }
    return true;
}

bool yk_trace_read(YkTracer *t, YkStrand *strand, double at, YkVec *x, double *within)
{
    if (!yk_trace_place(t, strand->below, at)) return false;
    const YkCell *cell = yk_strand_cell(strand, at, at);
    if (cell) enclose_in_cell(t, strand->level - 1, cell, at, x, within);
    return cell != NULL;
}

// --- over an interval

bool yk_trace_enclose_path(YkTracer *t, size_t level, double half, YkVec *x, YkPathCertificate *certificate)
{
    YkDiscCoefficients *middle = &t->coefficients[0], *whole = &t->coefficients[1];
    const YkPiece *piece = &t->pieces[level];
    if (!spend(t, piece, 4)) return false;
    yk_piece_coefficients(piece, &t->discs, middle);
    yk_piece_coefficients(piece, &t->over, whole);
    if (!(yk_system_polish(&piece->shape, middle->at, x) < 1e-6)) return false;
    YkPathDiscs path = {middle->at, whole->at, whole->rate, middle->radius, whole->radius, whole->rate_radius, half};
    return yk_enclose_path(&piece->shape, &path, x, certificate);
}

// Makes the unknowns known over an interval: on the line x + rate t, about its middle.
static void place_path(YkTracer *t, const YkPiece *piece, const YkVec *x, const YkVec *rate, double within,
                       double rate_within, double half)
{
    YkDual known[YK_PIECE_UNKNOWNS];
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        double size = yk_piece_size(piece, x, k);
        known[k].at = yk_ball(x[k], YK_BALL_OUT(within * size + yk_sum_norm(rate[k]) * half));
        known[k].rate = yk_ball(rate[k], YK_BALL_OUT(rate_within * size));
    }
    yk_discs_place(&t->over, piece, known);
}

// Encloses the solution of a cell over a part of it, about `middle`; anew if the part is much smaller.
static void place_part(YkTracer *t, size_t level, const YkCell *cell, double middle, double half)
{
    const YkPiece *piece = &t->pieces[level];
    YkVec line[YK_PIECE_UNKNOWNS], x[YK_PIECE_UNKNOWNS];
    YkPathCertificate own;
    yk_cell_at(piece, cell, middle, line);
    memcpy(x, line, sizeof x);
    if (4 * half < cell->to - cell->from && yk_trace_enclose_path(t, level, half, x, &own) &&
        yk_trace_is_inside(piece, line, cell->radius, x, own.at.within))
        place_path(t, piece, x, own.rate, own.at.within, own.rate_within, half);
    else
        place_path(t, piece, line, cell->rate, cell->within, cell->rate_within, half);
}

bool yk_trace_place_path(YkTracer *t, YkStrand *strand, double from, double to, double *half)
{
    YkVec x[YK_PIECE_UNKNOWNS];
    double within, middle = from + 0.5 * (to - from);
    list_below(t, strand);
    *half = YK_BALL_OUT(fmax(to - middle, middle - from));
    t->discs.input = yk_ball(yk_vec(middle, 0), 0);
    t->over.input = yk_ball(yk_vec(middle, 0), *half);
    yk_trace_steps(t, &t->discs, 0);
    yk_trace_steps(t, &t->over, 0);
    for (size_t level = 1; level <= strand->level; level++) {
        const YkCell *cell = yk_strand_cell(t->chain[level], from, to);
        if (!cell) return false;
        place_part(t, level - 1, cell, middle, *half);
        enclose_in_cell(t, level - 1, cell, middle, x, &within);
        place_point(t, &t->pieces[level - 1], x, within);
        yk_trace_steps(t, &t->discs, level);
        yk_trace_steps(t, &t->over, level);
    }
    return true;
}

// --- at a tie

bool yk_trace_place_between(YkTracer *t, YkStrand *a, double at_a, YkStrand *b, double at_b)
{
    enum { LEVELS = 64 };
    YkVec x[2][YK_PIECE_UNKNOWNS], hull[LEVELS][YK_PIECE_UNKNOWNS];
    double within[2], radius[LEVELS], off = fabs(at_a - at_b);
    YkStrand *of_a[LEVELS], *of_b[LEVELS];
    if (a->level >= LEVELS) return false;
    for (YkStrand *s = a; s; s = s->below) of_a[s->level] = s;
    for (YkStrand *s = b; s; s = s->below) of_b[s->level] = s;
    for (size_t level = 1; level <= a->level; level++) {
        const YkPiece *piece = &t->pieces[level - 1];
        radius[level] = 0;
        if (!yk_trace_read(t, of_a[level], at_a, x[0], &within[0])) return false;
        if (!yk_trace_read(t, of_b[level], at_b, x[1], &within[1])) return false;
        for (size_t k = 0; k < piece->shape.unknowns; k++) {
            YkVec between = yk_piece_off(piece, x[0], x[1], k);
            hull[level][k] = yk_sub(x[0][k], yk_scale(0.5, between));
            double apart = yk_norm(between) / yk_piece_size(piece, hull[level], k);
            radius[level] = fmax(radius[level], 0.75 * apart + fmax(within[0], within[1]) + 1e-13);
        }
    }
    bool is_round = t->is_angle && off > t->period - 1; // ends a whole turn apart are the same input
    t->discs.input = is_round ? yk_ball(yk_vec(at_a, 0), 1e-14)
                              : yk_ball(yk_vec(0.5 * (at_a + at_b), 0), 0.75 * off + 1e-13 * t->scale);
    yk_trace_steps(t, &t->discs, 0);
    for (size_t level = 1; level <= a->level; level++) {
        place_point(t, &t->pieces[level - 1], hull[level], radius[level]);
        yk_trace_steps(t, &t->discs, level);
    }
    return true;
}
