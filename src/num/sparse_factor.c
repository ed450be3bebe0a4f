// Left-looking LU: solves column by column with the columns of L before it, visiting only those that a search in the
// pattern of L reaches. Source: Gilbert & Peierls 1988; partial pivoting.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "num/sparse_inside.h"

static bool ensure_room(YkTriangle *t, size_t more)
{
    if (t->count + more <= t->capacity) return true;
    size_t capacity = 2 * t->capacity + more;
    int32_t *row = realloc(t->row, capacity * sizeof *row);
    if (row) t->row = row;
    double *value = realloc(t->value, capacity * sizeof *value);
    if (value) t->value = value;
    if (!row || !value) return false;
    t->capacity = capacity;
    return true;
}

// The nodes a column reaches: pivots in topological order in reach[top .. n), rows without pivot in reach[0 .. free).
typedef struct Reach {
    size_t top, free;
} Reach;

// Marks a row; pushes its pivot on the stack, or puts it with the rows that have none.
static size_t enter(YkSparse *s, int32_t row, int32_t stamp, size_t depth, Reach *r)
{
    if (s->mark[row] == stamp) return depth;
    s->mark[row] = stamp;
    int32_t pivot = s->position[row];
    if (pivot < 0) {
        s->reach[r->free++] = row;
        return depth;
    }
    s->stack[depth] = pivot;
    s->cursor[pivot] = s->L.start[pivot];
    return depth + 1;
}

static void search(YkSparse *s, int32_t row, int32_t stamp, Reach *r)
{
    size_t depth = enter(s, row, stamp, 0, r);
    while (depth > 0) {
        int32_t pivot = s->stack[depth - 1];
        size_t end = s->L.start[pivot + 1], before = depth;
        while (depth == before && s->cursor[pivot] < end)
            depth = enter(s, s->L.row[s->cursor[pivot]++], stamp, depth, r);
        if (depth > before) continue;
        s->reach[--r->top] = pivot;
        depth--;
    }
}

// Scatters column `column` of A into x and finds what it reaches. Returns its largest entry. Zeros count as absent.
static double scatter(YkSparse *s, int32_t column, int32_t stamp, Reach *r)
{
    double largest = 0;
    *r = (Reach){s->n, 0};
    for (int32_t k = s->start[column]; k < s->start[column + 1]; k++) {
        double v = s->value[k];
        if (v == 0) continue;
        search(s, s->row[k], stamp, r);
        s->x[s->row[k]] = v;
        if (fabs(v) > largest) largest = fabs(v); // skips NaN
    }
    return largest;
}

// Solves x = L \ x over the pivots reached; they become column k of U.
static void eliminate(YkSparse *s, const Reach *r)
{
    for (size_t t = r->top; t < s->n; t++) {
        int32_t pivot = s->reach[t];
        double u = s->x[s->pivot_row[pivot]];
        s->x[s->pivot_row[pivot]] = 0;
        if (u == 0) continue;
        s->U.row[s->U.count] = pivot;
        s->U.value[s->U.count++] = u;
        for (size_t p = s->L.start[pivot]; p < s->L.start[pivot + 1]; p++) s->x[s->L.row[p]] -= s->L.value[p] * u;
    }
}

static int32_t largest_row(const YkSparse *s, const Reach *r)
{
    int32_t best = -1;
    double largest = 0;
    for (size_t t = 0; t < r->free; t++) {
        double v = fabs(s->x[s->reach[t]]);
        if (!(v > largest)) continue; // also skips NaN
        largest = v;
        best = s->reach[t];
    }
    return best;
}

// Stores the rest of x over the pivot as column k of L; x is zero again.
static void keep_column(YkSparse *s, size_t k, int32_t pivot_row, const Reach *r)
{
    double pivot = s->x[pivot_row];
    s->position[pivot_row] = (int32_t)k;
    s->pivot_row[k] = pivot_row;
    s->diagonal[k] = pivot;
    for (size_t t = 0; t < r->free; t++) {
        int32_t row = s->reach[t];
        double v = s->x[row];
        s->x[row] = 0;
        if (v == 0 || row == pivot_row) continue;
        s->L.row[s->L.count] = row;
        s->L.value[s->L.count++] = v / pivot;
    }
    s->L.start[k + 1] = s->L.count;
    s->U.start[k + 1] = s->U.count;
}

// Returns the pivot over the largest entry of the column; 0 if there is none; -1 when out of memory.
static double factor_column(YkSparse *s, size_t k)
{
    Reach r;
    double largest = scatter(s, s->order[k], (int32_t)k + 1, &r);
    if (!ensure_room(&s->L, r.free) || !ensure_room(&s->U, s->n - r.top)) {
        for (size_t i = 0; i < s->n; i++) s->x[i] = 0;
        return -1;
    }
    eliminate(s, &r);
    int32_t pivot_row = largest_row(s, &r);
    double ratio = pivot_row < 0 ? 0 : fabs(s->x[pivot_row]) / largest;
    if (ratio > 4 * 0x1p-52 && isfinite(s->x[pivot_row])) {
        keep_column(s, k, pivot_row, &r);
        return ratio;
    }
    for (size_t t = 0; t < r.free; t++) s->x[s->reach[t]] = 0;
    return 0;
}

double yk_sparse_factor(YkSparse *s, const double *value, int32_t *singular_column)
{
    double least = INFINITY;
    if (s->start[s->n] > 0) memcpy(s->value, value, (size_t)s->start[s->n] * sizeof *value);
    memset(s->mark, 0, s->n * sizeof *s->mark);
    for (size_t i = 0; i < s->n; i++) s->position[i] = -1;
    s->L.count = s->U.count = 0;
    for (size_t k = 0; k < s->n; k++) {
        double ratio = factor_column(s, k);
        if (ratio < least) {
            least = ratio;
            if (singular_column) *singular_column = s->order[k];
        }
        if (ratio <= 0) return ratio;
    }
    for (size_t p = 0; p < s->L.count; p++) s->L.row[p] = s->position[s->L.row[p]];
    return least;
}
