// Follows one solution of a block along the input, real or complex, cell by cell.
#include <string.h>
#include "map/strand.h"

// One step: the cell that leads to `at`, and the solution x there.
typedef struct Step {
    double at, middle, within; // within: of x
    YkVec x[YK_PIECE_UNKNOWNS], center[YK_PIECE_UNKNOWNS];
    YkPathCertificate cell;
} Step;

// Returns whether the solution y at an input lies in the moving polydisc of the step.
static bool is_in_cell(const YkPiece *piece, const Step *step, double at, const YkVec *y, double within)
{
    YkVec line[YK_PIECE_UNKNOWNS];
    for (size_t k = 0; k < piece->shape.unknowns; k++)
        line[k] = yk_add(step->center[k], yk_scale(at - step->middle, step->cell.rate[k]));
    return yk_trace_is_inside(piece, line, step->cell.at.radius, y, within);
}

// Encloses the solution near x at one input.
static bool at_point(YkTracer *t, YkStrand *below, double at, YkVec *x, double *within)
{
    YkCertificate own;
    if (!yk_trace_place(t, below, at) || !yk_trace_enclose(t, below->level, x, &own)) return false;
    *within = own.within;
    return true;
}

static bool try_step(YkTracer *t, YkStrand *below, const Step *now, double target, Step *next)
{
    const YkPiece *piece = &t->pieces[below->level];
    size_t n = piece->shape.unknowns;
    double half, from = fmin(now->at, target), to = fmax(now->at, target);
    next->at = target;
    next->middle = from + 0.5 * (to - from);
    // From the line of the cell before, once there is one.
    for (size_t k = 0; k < n; k++)
        next->center[k] = yk_add(now->x[k], yk_scale(next->middle - now->at, now->cell.rate[k]));
    if (!yk_trace_place_path(t, below, from, to, &half)) return false;
    if (!yk_trace_enclose_path(t, below->level, half, next->center, &next->cell)) return false;
    if (!is_in_cell(piece, next, now->at, now->x, now->within)) return false;
    for (size_t k = 0; k < n; k++)
        next->x[k] = yk_add(next->center[k], yk_scale(target - next->middle, next->cell.rate[k]));
    return at_point(t, below, target, next->x, &next->within) && is_in_cell(piece, next, target, next->x, next->within);
}

static bool keep(YkTracer *t, YkStrand *strand, const Step *now, const Step *next)
{
    YkCell cell = {.from = fmin(now->at, next->at),
                   .to = fmax(now->at, next->at),
                   .middle = next->middle,
                   .radius = next->cell.at.radius,
                   .within = next->cell.at.within,
                   .rate_within = next->cell.rate_within};
    return yk_strand_add(t, strand, cell, next->center, next->cell.rate);
}

double yk_trace_follow(YkTracer *t, YkStrand *below, double from, double to, YkVec *x, YkStrand *strand)
{
    Step now = {.at = from}, next;
    int direction = to > from ? 1 : -1;
    double h = 0.3 * YK_TRACE_LONGEST * t->scale;
    size_t bytes = t->pieces[below->level].shape.unknowns * sizeof *x;
    memcpy(now.x, x, bytes);
    if (from == to || !at_point(t, below, from, now.x, &now.within)) return from;
    while (now.at != to && !t->out_of_memory && !yk_pace_is_stopped(t->pace)) {
        double end = yk_strand_cell_end(below, now.at, direction), target = now.at + direction * h;
        if (direction > 0 ? target > end : target < end) target = end;
        if (direction > 0 ? target > to : target < to) target = to;
        if (target == now.at || t->steps_left == 0) break;
        t->steps_left--;
        if (!try_step(t, below, &now, target, &next)) {
            h = 0.5 * fmin(h, fabs(target - now.at));
            if (h < YK_TRACE_SHORTEST * t->scale) break;
            continue;
        }
        if (strand && !keep(t, strand, &now, &next)) break;
        now = next;
        h = fmin(YK_TRACE_LONGEST * t->scale, 1.4 * h);
    }
    memcpy(x, now.x, bytes);
    return now.at;
}
