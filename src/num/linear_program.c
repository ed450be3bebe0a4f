// The simplex method on a dense dictionary.
#include "num/linear_program.h"
#include <math.h>
#include <string.h>

static const double NOTHING = 1e-12; // negligible among rows and unknowns of size 1

// basic = T[row][0] - sum T[row][1 + k] * (nonbasic k); row m: the objective, with + for the sum.
typedef struct Dictionary {
    size_t m, k; // k: nonbasic unknowns
    double *T;
    size_t *basic, *nonbasic; // names: 0 .. n-1 x's positive parts, n .. 2n-1 negative parts, then slacks
} Dictionary;

static double *row_of(const Dictionary *d, size_t row)
{
    return d->T + row * (d->k + 1);
}

static void start(Dictionary *d, size_t n, const double *A, const double *b, const double *c)
{
    for (size_t i = 0; i <= d->m; i++) {
        double *row = row_of(d, i);
        const double *from = i < d->m ? A + i * n : c;
        row[0] = i < d->m ? b[i] : 0;
        for (size_t j = 0; j < n; j++) {
            row[1 + j] = from[j];
            row[1 + n + j] = -from[j];
        }
        if (i < d->m) d->basic[i] = 2 * n + i;
    }
    for (size_t j = 0; j < 2 * n; j++) d->nonbasic[j] = j;
}

// Returns the unknown of lowest index that would raise the objective; k if there is none.
static size_t entering(const Dictionary *d)
{
    const double *objective = row_of(d, d->m);
    size_t found = d->k;
    for (size_t j = 0; j < d->k; j++)
        if (objective[1 + j] > NOTHING && (found == d->k || d->nonbasic[j] < d->nonbasic[found])) found = j;
    return found;
}

// Returns the row that limits the unknown's growth most, of equal ones that of lowest index; m if none limits it.
static size_t leaving(const Dictionary *d, size_t column)
{
    size_t found = d->m;
    double least = INFINITY;
    for (size_t i = 0; i < d->m; i++) {
        const double *row = row_of(d, i);
        if (!(row[1 + column] > NOTHING)) continue;
        double way = row[0] / row[1 + column];
        if (way < least || (way == least && d->basic[i] < d->basic[found])) {
            least = way;
            found = i;
        }
    }
    return found;
}

static void pivot(Dictionary *d, size_t row, size_t column)
{
    double *own = row_of(d, row), by = 1 / own[1 + column];
    own[1 + column] = 1;
    for (size_t j = 0; j <= d->k; j++) own[j] *= by;
    for (size_t i = 0; i <= d->m; i++) {
        if (i == row) continue;
        double *other = row_of(d, i), share = other[1 + column];
        if (share == 0) continue;
        other[1 + column] = 0;
        for (size_t j = 1; j <= d->k; j++) other[j] -= share * own[j];
        other[0] += (i == d->m ? 1 : -1) * share * own[0];
        if (i < d->m && other[0] < 0) other[0] = 0; // a negative value here is only rounding
    }
    size_t name = d->basic[row];
    d->basic[row] = d->nonbasic[column];
    d->nonbasic[column] = name;
}

YkLinearStatus yk_linear_maximise(size_t m, size_t n, const double *A, const double *b, const double *c, double *x,
                                  double *work, size_t *order)
{
    Dictionary d = {m, 2 * n, work, order, order + m};
    size_t most = 200 + 50 * (m + n);
    start(&d, n, A, b, c);
    for (size_t step = 0; step < most; step++) {
        size_t column = entering(&d);
        if (column == d.k) {
            memset(x, 0, n * sizeof *x);
            for (size_t i = 0; i < m; i++)
                if (d.basic[i] < 2 * n) x[d.basic[i] % n] += (d.basic[i] < n ? 1 : -1) * row_of(&d, i)[0];
            return YK_LINEAR_OK;
        }
        size_t row = leaving(&d, column);
        if (row == m) return YK_LINEAR_UNBOUNDED;
        pivot(&d, row, column);
    }
    return YK_LINEAR_EXHAUSTED;
}
