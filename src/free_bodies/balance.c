// Finds the reactions and efforts that balance a part: A f = inertia - load.
//
// Redundant parts: f of least norm, from the saddle point [d A; -A^T 1] (y, f): with d = 0, f = A^T y is orthogonal to
// all f that change nothing. If A has dependent rows too (inputs without effort), a small d keeps the system regular;
// solving again for the residual gives the solution of d = 0 (the method of multipliers: Hestenes 1969). To find which
// shares are determined, the same system projects a random f onto those that change nothing; where nothing of it is
// left, every solution has the same share.
#include <string.h>
#include "free_bodies/inside.h"

enum { ROUNDS_MAX = 12 };
static const double softness = 1e-7; // d, unless it is 0
static const double loose = 1e-8;    // a projection above this is not rounding

static bool is_taken(const YkWrenchColumn *c, const bool *is_prescribed)
{
    return c->input == YK_NONE || !is_prescribed || is_prescribed[c->input];
}

static void emit_square(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s)
{
    for (size_t k = 0; k < part->column_count; k++)
        yk_body_system_wrench(f, s, &f->columns[part->columns[k]], k, 1, false);
}

static void emit_saddle(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, const bool *is_prescribed)
{
    size_t n = part->column_count, m = 3 * part->body_count;
    for (size_t k = 0; k < n; k++) {
        const YkWrenchColumn *c = &f->columns[part->columns[k]];
        double taken = is_taken(c, is_prescribed);
        yk_body_system_emit(s, m + k, m + k, 1);
        yk_body_system_wrench(f, s, c, m + k, taken, false);
        yk_body_system_wrench(f, s, c, m + k, -taken, true);
    }
    for (size_t i = 0; i < m; i++) yk_body_system_emit(s, i, i, is_prescribed ? softness : 0);
}

static void emit_balance(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, const bool *is_prescribed)
{
    if (part->is_redundant)
        emit_saddle(f, part, s, is_prescribed);
    else
        emit_square(f, part, s);
}

static bool make_system(const YkFreeBodies *f, YkBodyPart *part)
{
    size_t n = part->column_count, m = 3 * part->body_count;
    YkBodySystem *s = &part->balance;
    if (s->sparse) return true;
    if (!yk_body_system_start(s, part->is_redundant ? n + m : m, (2 * YK_WRENCH_ENTRIES + 1) * n + m)) return false;
    emit_balance(f, part, s, NULL);
    return yk_body_system_finish(s);
}

// Computes what the bodies require of their joints, N.
static void wanted(const YkFreeBodies *f, const YkBodyPart *part, double *b)
{
    for (size_t k = 0; k < part->body_count; k++)
        for (size_t i = 0; i < 3; i++) {
            size_t at = 3 * (size_t)part->bodies[k] + i;
            b[3 * k + i] = f->inertia[at] - f->load[at];
        }
}

// Solves the saddle point into f->x = (y, f): the f nearest to start[n] (NULL: 0) with A f = want[m] (NULL: 0).
static void solve_saddle(YkFreeBodies *f, YkBodyPart *part, const double *want, const double *start, bool is_soft)
{
    size_t n = part->column_count, m = 3 * part->body_count;
    double *x = f->x, *y = f->y, last = INFINITY;
    memset(y, 0, m * sizeof *y);
    for (int round = 0; round < ROUNDS_MAX; round++) {
        for (size_t i = 0; i < m; i++) x[i] = (want ? want[i] : 0) + (is_soft ? softness * y[i] : 0);
        for (size_t k = 0; k < n; k++) x[m + k] = start ? start[k] : 0;
        yk_sparse_solve(part->balance.sparse, x, true);
        if (!is_soft) return;
        double change = 0;
        for (size_t i = 0; i < m; i++) change = fmax(change, softness * fabs(x[i] - y[i]));
        if (!(change < 0.5 * last)) return;
        last = change;
        memcpy(y, x, m * sizeof *y);
    }
}

// Returns an arbitrary but fixed vector: entries between 0.5 and 1.5.
static double arbitrary(size_t k)
{
    uint64_t z = (k + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    return 0.5 + (double)((z ^ (z >> 27)) >> 11) * 0x1p-53;
}

static void find_freeness(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed)
{
    size_t n = part->column_count, m = 3 * part->body_count;
    for (size_t k = 0; k < n; k++) f->b[k] = is_taken(&f->columns[part->columns[k]], is_prescribed) ? arbitrary(k) : 0;
    solve_saddle(f, part, NULL, f->b, is_prescribed != NULL);
    for (size_t k = 0; k < n; k++) f->columns[part->columns[k]].freeness = fabs(f->x[m + k]) > loose ? 1 : 0;
}

static void balance_redundant(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed)
{
    size_t m = 3 * part->body_count;
    wanted(f, part, f->b);
    solve_saddle(f, part, f->b, NULL, is_prescribed != NULL);
    for (size_t k = 0; k < part->column_count; k++) f->columns[part->columns[k]].share = f->x[m + k];
    find_freeness(f, part, is_prescribed);
}

YkStatus yk_part_balance(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed)
{
    YkBodySystem *s = &part->balance;
    if (part->column_count < 3 * part->body_count) return YK_SINGULAR; // a freedom that no input holds
    if (!make_system(f, part)) return YK_NO_MEMORY;
    yk_body_system_begin(s);
    emit_balance(f, part, s, is_prescribed);
    double pivot = yk_sparse_factor(s->sparse, s->value, NULL);
    if (pivot < 0) return YK_NO_MEMORY;
    if (!(pivot > YK_PIVOT_TOLERANCE)) return YK_SINGULAR;
    if (part->is_redundant) {
        balance_redundant(f, part, is_prescribed);
        return YK_REDUNDANT;
    }
    wanted(f, part, f->x);
    yk_sparse_solve(s->sparse, f->x, true);
    for (size_t k = 0; k < part->column_count; k++) f->columns[part->columns[k]].share = f->x[k];
    return YK_OK;
}
