// Are random points of the loops' equations points of the machine? All dimensions and coordinates that close the loops
// may form a surface with several sheets: with the same length L twice, one sheet has L = 0 and any angles, another any
// L and angles that are bound to each other. The points of one rank, made by solving linear equations at random angles,
// fill one sheet. The machine moves on it if the same equations have that rank at its own pose: these equations then
// give all solutions near it. With bonds more must be known, namely that no other sheet meets this one there: the
// number of independent equations, in all variables, must equal the freedoms that bonds and lengths take away.
#include <math.h>
#include <stdlib.h>
#include "num/dense.h"
#include "prove/loop_point.h"

static const double RANK_TOLERANCE = 1e-8, NOTHING = 1e-9;

typedef struct Matrix {
    size_t rows, columns;
    double *entry;
} Matrix;

// Returns an entry's value at the pose; a remainder of terms that cancel is 0, and must not grow when lines are scaled.
static double value_of(const YkDerivation *d, const YkPoisson *entry, const double *values)
{
    double value = yk_ring_value(d->ring, entry, values).x;
    return fabs(value) > NOTHING * yk_ring_magnitude(d->ring, entry, values) ? value : 0;
}

// Scales a line, since columns and rows have units of their own.
static void scale_line(double *entry, size_t count, size_t step)
{
    double most = 0;
    for (size_t k = 0; k < count; k++) most = fmax(most, fabs(entry[k * step]));
    for (size_t k = 0; k < count && most > 0; k++) entry[k * step] /= most;
}

static int rank_of(YkDerivation *d, Matrix *m)
{
    size_t n = m->rows > m->columns ? m->rows : m->columns;
    size_t *order = yk_derive_scratch(d, n + 1, sizeof *order);
    double *tau = yk_derive_scratch(d, n + 1, sizeof *tau);
    int rank = -1;
    for (size_t k = 0; k < m->columns; k++) scale_line(m->entry + k, m->rows, m->columns);
    for (size_t r = 0; r < m->rows; r++) scale_line(m->entry + r * m->columns, m->columns, 1);
    if (order && tau)
        rank = m->rows && m->columns ? (int)yk_qr_factor(m->rows, m->columns, m->entry, order, tau, RANK_TOLERANCE) : 0;
    free(order);
    free(tau);
    return rank;
}

// --- The equations for what enters linearly

static int linear_rank(YkDerivation *d, const YkDeriveBlocks *blocks, const double *values)
{
    int32_t *unknowns = yk_derive_scratch(d, d->coordinate_count + d->model->parameter_count + 1, sizeof *unknowns);
    Matrix m = {.rows = blocks->row_count};
    if (unknowns) m.columns = yk_loop_linear(d, blocks, unknowns);
    m.entry = yk_derive_scratch(d, m.rows * m.columns + 1, sizeof *m.entry);
    for (size_t r = 0; m.entry && r < m.rows; r++)
        for (size_t k = 0; k < m.columns; k++) {
            const YkPoisson *slope = yk_ring_coefficient(d->ring, blocks->rows[r].value, unknowns[k], 1);
            m.entry[r * m.columns + k] = value_of(d, slope, values);
        }
    int rank = m.entry && unknowns ? rank_of(d, &m) : -1;
    free(unknowns);
    free(m.entry);
    return rank;
}

// --- All equations in all variables, including definitions of parameters by others

typedef struct Equations {
    const YkPoisson **zero;
    size_t count, definitions;
    int32_t *variable; // symbols
    size_t variable_count;
} Equations;

static void collect(YkDerivation *d, const YkDeriveBlocks *blocks, Equations *all)
{
    for (size_t r = 0; r < blocks->row_count; r++) all->zero[all->count++] = blocks->rows[r].value;
    for (size_t k = 0; k < d->model->parameter_count; k++) {
        const YkPoisson *definition = yk_derive_definition(d, k);
        if (!definition) continue;
        const YkPoisson *own = yk_ring_of(d->ring, d->parameters[k]);
        all->zero[all->count++] = yk_ring_subtract(d->ring, own, definition);
        all->definitions++;
    }
    bool *is_there = yk_derive_scratch(d, yk_ring_symbol_count(d->ring) + 1, sizeof *is_there);
    for (size_t r = 0; is_there && r < all->count; r++)
        for (int32_t s = yk_ring_next_symbol(d->ring, all->zero[r], -1); s >= 0;
             s = yk_ring_next_symbol(d->ring, all->zero[r], s)) {
            if (!is_there[s]) all->variable[all->variable_count++] = s;
            is_there[s] = true;
        }
    free(is_there);
}

static bool is_alone(YkDerivation *d, const YkDeriveBlocks *blocks, const YkLoopBonds *bonds, int rank,
                     const double *values)
{
    Equations all = {0};
    all.zero =
        (const YkPoisson **)yk_derive_scratch(d, blocks->row_count + d->model->parameter_count + 1, sizeof *all.zero);
    all.variable = yk_derive_scratch(d, yk_ring_symbol_count(d->ring) + 1, sizeof *all.variable);
    if (all.zero && all.variable) collect(d, blocks, &all);
    Matrix m = {.rows = all.count, .columns = all.variable_count};
    m.entry = yk_derive_scratch(d, m.rows * m.columns + 1, sizeof *m.entry);
    for (size_t r = 0; m.entry && r < m.rows; r++)
        for (size_t k = 0; k < m.columns; k++)
            m.entry[r * m.columns + k] = value_of(d, yk_ring_partial(d->ring, all.zero[r], all.variable[k]), values);
    bool is = m.entry && all.zero && all.variable && rank_of(d, &m) == rank + (int)bonds->count + (int)all.definitions;
    free((void *)all.zero);
    free(all.variable);
    free(m.entry);
    return is;
}

bool yk_loop_is_assembly(YkDerivation *d, const YkLoopBonds *bonds, int rank, const double *values)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(d);
    if (!blocks || linear_rank(d, blocks, values) != rank) return false;
    return !bonds || is_alone(d, blocks, bonds, rank, values);
}
