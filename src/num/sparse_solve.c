// Solving with the factors A[:, order] = P^T L U.
#include <string.h>
#include "num/sparse_inside.h"

// Computes b = A \ b by the factors; x is scratch.
static void solve_once(const YkSparse *s, double *b, double *x)
{
    size_t n = s->n;
    for (size_t k = 0; k < n; k++) x[k] = b[s->pivot_row[k]];
    for (size_t k = 0; k < n; k++) {
        double t = x[k];
        if (t == 0) continue;
        for (size_t p = s->L.start[k]; p < s->L.start[k + 1]; p++) x[s->L.row[p]] -= s->L.value[p] * t;
    }
    for (size_t k = n; k-- > 0;) {
        double t = x[k] /= s->diagonal[k];
        for (size_t p = s->U.start[k]; p < s->U.start[k + 1]; p++) x[s->U.row[p]] -= s->U.value[p] * t;
        b[s->order[k]] = t;
    }
}

// Computes r = b - A x.
static void residual(const YkSparse *s, const double *x, double *r)
{
    for (size_t j = 0; j < s->n; j++)
        for (int32_t k = s->start[j]; k < s->start[j + 1]; k++) r[s->row[k]] -= s->value[k] * x[j];
}

void yk_sparse_solve(YkSparse *s, double *b, bool refine)
{
    if (refine) memcpy(s->b, b, s->n * sizeof *b);
    solve_once(s, b, s->x);
    if (refine) {
        residual(s, b, s->b);
        solve_once(s, s->b, s->x);
        for (size_t i = 0; i < s->n; i++) b[i] += s->b[i];
    }
    memset(s->x, 0, s->n * sizeof *s->x); // as the next factorisation needs it
}
