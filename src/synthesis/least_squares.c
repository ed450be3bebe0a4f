// One step of Levenberg and Marquardt within bounds, by orthogonal factors.
#include "synthesis/least_squares.h"
#include <math.h>
#include "num/dense.h"

enum { MAX = YK_LINEAR_MAX };

typedef struct Step {
    double *x;          // [n]
    bool is_held[MAX];  // at a bound or given
    double column[MAX]; // lengths of the columns
} Step;

// Holds unknowns that are given, and those at a bound against which the misses push.
static void hold(const YkLinear *l, Step *step)
{
    for (size_t j = 0; j < l->n; j++) {
        double slope = 0, sum = 0;
        for (size_t r = 0; r < l->rows; r++) {
            slope += l->row[r * l->n + j] * l->miss[r];
            sum += l->row[r * l->n + j] * l->row[r * l->n + j];
        }
        step->column[j] = sqrt(sum);
        step->x[j] = 0;
        step->is_held[j] = !(l->low[j] < l->high[j]) || sum == 0 || (l->at[j] <= l->low[j] && slope > 0) ||
                           (l->at[j] >= l->high[j] && slope < 0);
    }
}

// Solves for the unknowns that are not held; the others keep their steps.
static void solve(const YkLinear *l, double damping, Step *step)
{
    size_t free[MAX], count = 0, order[MAX], n = l->n, rows = l->rows;
    double tau[MAX], x[MAX];
    for (size_t j = 0; j < n; j++)
        if (!step->is_held[j]) free[count++] = j;
    if (count == 0) return;
    for (size_t r = 0; r < rows; r++) {
        const double *row = &l->row[r * n];
        l->b[r] = -l->miss[r];
        for (size_t j = 0; j < n; j++)
            if (step->is_held[j]) l->b[r] -= row[j] * step->x[j];
        for (size_t j = 0; j < count; j++) l->A[r * count + j] = row[free[j]] / step->column[free[j]];
    }
    for (size_t k = 0; k < count; k++) {
        for (size_t j = 0; j < count; j++) l->A[(rows + k) * count + j] = j == k ? sqrt(damping) : 0;
        l->b[rows + k] = 0;
    }
    size_t rank = yk_qr_factor(rows + count, count, l->A, order, tau, 1e-15);
    yk_qr_solve(rows + count, count, l->A, order, tau, rank, l->b, x);
    for (size_t j = 0; j < count; j++) step->x[free[j]] = x[j] / step->column[free[j]];
}

void yk_linear_step(const YkLinear *l, double damping, double *x)
{
    Step step = {.x = x};
    hold(l, &step);
    for (size_t round = 0; round <= l->n; round++) {
        bool is_inside = true;
        solve(l, damping, &step);
        for (size_t j = 0; j < l->n; j++) {
            double to = l->at[j] + x[j], kept = fmin(fmax(to, l->low[j]), l->high[j]);
            if (step.is_held[j] || kept == to) continue;
            x[j] = kept - l->at[j];
            step.is_held[j] = true;
            is_inside = false;
        }
        if (is_inside) return;
    }
}
