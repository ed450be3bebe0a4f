// All equations of a machine at once: evaluated, closed, and the kernel of their Jacobian.
#include <math.h>
#include "compile/closure.h"
#include "configurations/continuum_inside.h"
#include "num/dense.h"

#define CLOSED 1e-12 // over the size: a pose whose loops miss by no more
#define SHARE 1e-7   // of the largest pivot: smaller ones are rounding

double yk_continuum_unit(const YkContinua *c, size_t k)
{
    return k < c->mech->orientation_count - 1 ? 1 : c->mech->size;
}

// Writes the row of an input, over the size: the difference of two orientations, or a distance.
static void add_input_row(const YkContinua *c, size_t input, double *row)
{
    const YkTreeCoordinate *t = &c->mech->coordinates[c->mech->inputs[input]];
    if (t->is_distance) row[c->mech->orientation_count - 1 + (size_t)t->distance] = 1 / c->mech->size;
    if (!t->is_distance && t->angle.b > 0) row[t->angle.b - 1] += 1;
    if (!t->is_distance && t->angle.a > 0) row[t->angle.a - 1] -= 1;
}

double yk_continuum_evaluate(YkContinua *c, const double *x)
{
    const YkMechanism *mech = c->mech;
    size_t loops = 2 * mech->loop_count, n = c->columns, first = loops + mech->relation_count;
    double most = 0, at_start;
    memset(c->A, 0, c->rows * n * sizeof *c->A);
    memset(c->F, 0, c->rows * sizeof *c->F);
    yk_closure(mech, x, c->F, c->A);
    for (size_t k = 0; k < mech->relation_count; k++) { // the pose in question has it exactly, with its turns
        yk_closure_relation(mech, k, x, &c->F[loops + k], c->A + (loops + k) * n, NULL);
        yk_closure_relation(mech, k, c->x0, &at_start, NULL, NULL);
        c->F[loops + k] -= at_start;
    }
    for (size_t row = 0; row < first; row++) {
        c->F[row] /= mech->size;
        for (size_t k = 0; k < n; k++) c->A[row * n + k] /= mech->size;
    }
    for (size_t k = 0; k < mech->input_count; k++) {
        double *row = c->A + (first + k) * n;
        add_input_row(c, k, row);
        for (size_t j = 0; j < n; j++) c->F[first + k] += row[j] * (x[j] - c->x0[j]);
    }
    for (size_t row = 0; row < c->rows; row++) {
        most = fmax(most, fabs(c->F[row]));
        for (size_t k = 0; k < n; k++) c->A[row * n + k] *= yk_continuum_unit(c, k);
    }
    return most;
}

static void factor(YkContinua *c)
{
    c->rank = yk_qr_factor(c->rows, c->columns, c->A, c->order, c->tau, SHARE);
}

bool yk_continuum_close(YkContinua *c, double *x, double *miss)
{
    const double longest = 0.3;
    double before = INFINITY;
    for (int round = 0; round < 12; round++) {
        *miss = yk_continuum_evaluate(c, x);
        if (!(*miss < 0.5 * before) && *miss < CLOSED) break;
        if (!(*miss < 10)) return false;
        before = *miss;
        factor(c);
        for (size_t row = 0; row < c->rows; row++) c->b[row] = -c->F[row];
        yk_qr_solve(c->rows, c->columns, c->A, c->order, c->tau, c->rank, c->b, c->step);
        double most = 0;
        for (size_t k = 0; k < c->columns; k++) most = fmax(most, fabs(c->step[k]));
        for (size_t k = 0; k < c->columns; k++)
            x[k] += yk_continuum_unit(c, k) * c->step[k] * fmin(1, longest / fmax(most, 1e-300));
    }
    *miss = yk_continuum_evaluate(c, x);
    return *miss < CLOSED;
}

size_t yk_continuum_kernel(YkContinua *c, const double *x)
{
    size_t n = c->columns;
    yk_continuum_evaluate(c, x);
    factor(c);
    for (size_t f = c->rank; f < n; f++) { // R v = 0 with 1 in the place of one free unknown
        double *v = c->kernel + (f - c->rank) * n, most = 1;
        for (size_t k = 0; k < n; k++) v[c->order[k]] = k == f;
        for (size_t i = c->rank; i-- > 0;) {
            double sum = c->A[i * n + f];
            for (size_t k = i + 1; k < c->rank; k++) sum += c->A[i * n + k] * v[c->order[k]];
            v[c->order[i]] = -sum / c->A[i * n + i];
            most = fmax(most, fabs(v[c->order[i]]));
        }
        for (size_t k = 0; k < n; k++) v[k] /= most;
    }
    return n - c->rank;
}

double yk_continuum_apart(const YkContinua *c, const double *x, const double *y)
{
    double most = 0;
    for (size_t k = 0; k < c->columns; k++) {
        double off = (x[k] - y[k]) / yk_continuum_unit(c, k);
        most = fmax(most, fabs(k < c->mech->orientation_count - 1 ? yk_nearest_turn(off, 0) : off));
    }
    return most;
}
