// Solves for contact forces within bounds: by sweeps, and by an active set where these converge slowly.
#include "num/bounded.h"
#include <math.h>
#include "num/dense.h"

static const double ENOUGH = 1e-12, SETTLED = 1e-15;

static double residual(size_t n, const double *A, const double *b, const double *x, size_t i)
{
    double sum = b[i];
    for (size_t k = 0; k < n; k++) sum += A[i * n + k] * x[k];
    return sum;
}

static double clamp(double x, YkBounds bounds)
{
    return fmin(bounds.high, fmax(bounds.low, x));
}

// Makes one sweep. Returns the largest change over the largest unknown.
static double sweep(size_t n, const double *A, const double *b, const YkBounds *bounds, double *x)
{
    double moved = 0, size = 0;
    for (size_t i = 0; i < n; i++) {
        double diagonal = A[i * n + i];
        if (!(diagonal > 0)) continue;
        double next = clamp(x[i] - residual(n, A, b, x, i) / diagonal, bounds[i]);
        moved = fmax(moved, fabs(next - x[i]));
        size = fmax(size, fmax(fabs(next), fabs(x[i])));
        x[i] = next;
    }
    return moved > 0 ? moved / size : 0;
}

// Returns whether x is the solution, up to rounding.
static bool is_answer(size_t n, const double *A, const double *b, const YkBounds *bounds, const double *x)
{
    double size = 0;
    for (size_t i = 0; i < n; i++) size = fmax(size, fabs(x[i]));
    for (size_t i = 0; i < n; i++) {
        if (!(A[i * n + i] > 0)) continue;
        double r = residual(n, A, b, x, i), scale = fabs(b[i]) + A[i * n + i] * size;
        if (!isfinite(r)) return false;
        bool may_rise = x[i] <= bounds[i].low, may_fall = x[i] >= bounds[i].high;
        if ((r > ENOUGH * scale && !may_rise) || (r < -ENOUGH * scale && !may_fall)) return false;
    }
    return true;
}

// A step of the active set: the system of the unknowns that are not fixed.
typedef struct Inner {
    size_t n, f;
    const double *A, *b;
    const YkBounds *bounds;
    double *x, *system, *right, *step, *tau, *fixed; // fixed[i]: 1 if the unknown is held at a bound
    size_t *order, *place;
} Inner;

static void choose_free(Inner *in)
{
    in->f = 0;
    for (size_t i = 0; i < in->n; i++)
        if (in->A[i * in->n + i] > 0 && in->fixed[i] == 0) in->place[in->f++] = i;
    for (size_t i = 0; i < in->f; i++) {
        in->right[i] = -residual(in->n, in->A, in->b, in->x, in->place[i]);
        for (size_t k = 0; k < in->f; k++) in->system[i * in->f + k] = in->A[in->place[i] * in->n + in->place[k]];
    }
}

// Moves along `step` to its end, or to the first bound, which then holds its unknown. Returns whether a bound was met.
static bool go(Inner *in, double way)
{
    size_t met = in->f;
    for (size_t i = 0; i < in->f; i++) {
        size_t at = in->place[i];
        double room = in->step[i] > 0 ? in->bounds[at].high - in->x[at] : in->bounds[at].low - in->x[at];
        if (in->step[i] == 0 || !(room / in->step[i] < way)) continue;
        way = fmax(room / in->step[i], 0);
        met = i;
    }
    if (!isfinite(way)) return false;
    for (size_t i = 0; i < in->f; i++)
        in->x[in->place[i]] = clamp(in->x[in->place[i]] + way * in->step[i], in->bounds[in->place[i]]);
    if (met == in->f) return false;
    size_t at = in->place[met];
    in->x[at] = in->step[met] > 0 ? in->bounds[at].high : in->bounds[at].low;
    in->fixed[at] = 1;
    return true;
}

// Releases the unknown that its bound holds back most. Returns whether there was one.
static bool let_go(Inner *in)
{
    size_t worst = in->n;
    double most = 0;
    for (size_t i = 0; i < in->n; i++) {
        if (in->fixed[i] == 0) continue;
        double r = residual(in->n, in->A, in->b, in->x, i), size = fabs(in->b[i]) + 1e-300;
        for (size_t k = 0; k < in->n; k++) size += fabs(in->A[i * in->n + k] * in->x[k]);
        double off = in->x[i] <= in->bounds[i].low ? -r : r;
        if (in->bounds[i].low == in->bounds[i].high) off = 0;
        if (!(off > 0.1 * ENOUGH * size) || off / size <= most) continue;
        most = off / size;
        worst = i;
    }
    if (worst < in->n) in->fixed[worst] = 0;
    return worst < in->n;
}

// Runs the active-set method for a convex quadratic form from x, which is within its bounds. Where the system of the
// free unknowns is singular and contradictory, moves along its residual until a bound is met. Source: Nocedal & Wright
// 2006, 16.5.
static void settle(Inner *in, int steps)
{
    for (size_t i = 0; i < in->n; i++) in->fixed[i] = in->x[i] <= in->bounds[i].low || in->x[i] >= in->bounds[i].high;
    for (int k = 0; k < steps; k++) {
        choose_free(in);
        size_t rank = in->f > 0 ? yk_qr_factor(in->f, in->f, in->system, in->order, in->tau, 1e-13) : 0;
        if (in->f > 0) yk_qr_solve(in->f, in->f, in->system, in->order, in->tau, rank, in->right, in->step);
        if (go(in, 1)) continue;
        if (rank < in->f && !is_answer(in->n, in->A, in->b, in->bounds, in->x)) {
            for (size_t i = 0; i < in->f; i++) in->step[i] = -residual(in->n, in->A, in->b, in->x, in->place[i]);
            if (go(in, (double)INFINITY)) continue;
        }
        if (!let_go(in)) return;
    }
}

bool yk_bounded_solve(size_t n, const double *A, const double *b, const YkBounds *bounds, int steps, double *x,
                      double *work, size_t *order)
{
    enum { FIRST = 12 };
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(b[i]) || !isfinite(A[i * n + i])) return false;
        if (A[i * n + i] > 0) x[i] = clamp(x[i], bounds[i]);
    }
    for (int k = 0; k < steps && k < FIRST; k++)
        if (sweep(n, A, b, bounds, x) <= SETTLED) return true;
    if (steps > FIRST) {
        Inner in = {.n = n,
                    .A = A,
                    .b = b,
                    .bounds = bounds,
                    .x = x,
                    .system = work,
                    .right = work + n * n,
                    .step = work + n * n + n,
                    .tau = work + n * n + 2 * n,
                    .fixed = work + n * n + 3 * n,
                    .order = order,
                    .place = order + n};
        settle(&in, steps - FIRST);
    }
    return is_answer(n, A, b, bounds, x);
}
