// Solves linear equations over the prime field, by elimination on sparse rows. The choice of pivot rows does not change
// the result, since a matrix has one reduced form; taking the shortest keeps the rows sparse.
#include <stdlib.h>
#include "ring/proof/field.h"

typedef struct Row {
    YkFieldEntry *entry; // by columns; the first is the leading entry
    size_t count;
    uint64_t right;
    size_t next; // next row with the same leading column; NONE: the last
} Row;

typedef struct Elimination {
    Row *rows;
    size_t columns, *first; // per column: the first of the rows it leads
    size_t *pivots, rank;
    bool contradicts, failed;
} Elimination;

static const size_t NONE = (size_t)-1;

static void enter(Elimination *e, size_t row)
{
    Row *own = &e->rows[row];
    if (own->count == 0) {
        e->contradicts |= own->right != 0;
        return;
    }
    size_t *first = &e->first[own->entry[0].column];
    own->next = *first;
    *first = row;
}

static size_t shortest(const Elimination *e, size_t first)
{
    size_t best = first;
    for (size_t r = first; r != NONE; r = e->rows[r].next)
        if (e->rows[r].count < e->rows[best].count) best = r;
    return best;
}

static void norm(Row *pivot)
{
    uint64_t inverse = yk_field_invert(pivot->entry[0].value);
    for (size_t k = 0; k < pivot->count; k++) pivot->entry[k].value = yk_field_multiply(pivot->entry[k].value, inverse);
    pivot->right = yk_field_multiply(pivot->right, inverse);
}

// Computes a - factor * b after their common leading entry, in order and without zeros.
static size_t merge(const Row *a, const Row *b, uint64_t factor, YkFieldEntry *out)
{
    size_t i = 1, k = 1, count = 0;
    while (i < a->count || k < b->count) {
        bool from_a = i < a->count && (k == b->count || a->entry[i].column <= b->entry[k].column),
             from_b = k < b->count && (i == a->count || b->entry[k].column <= a->entry[i].column);
        YkFieldEntry entry = {from_a ? a->entry[i].column : b->entry[k].column, from_a ? a->entry[i].value : 0};
        if (from_b) entry.value = yk_field_subtract(entry.value, yk_field_multiply(factor, b->entry[k].value));
        i += from_a, k += from_b;
        if (entry.value != 0) out[count++] = entry;
    }
    return count;
}

static void reduce(Elimination *e, size_t row, const Row *pivot)
{
    Row *own = &e->rows[row];
    uint64_t factor = own->entry[0].value;
    YkFieldEntry *out = malloc((own->count + pivot->count) * sizeof *out);
    e->failed |= !out;
    if (!out) return;
    own->right = yk_field_subtract(own->right, yk_field_multiply(factor, pivot->right));
    own->count = merge(own, pivot, factor, out);
    free(own->entry);
    own->entry = out;
    enter(e, row);
}

static void eliminate(Elimination *e)
{
    for (size_t column = 0; column < e->columns && !e->contradicts && !e->failed; column++) {
        size_t first = e->first[column];
        if (first == NONE) continue;
        size_t pivot = shortest(e, first);
        norm(&e->rows[pivot]);
        for (size_t r = first, next; r != NONE && !e->failed; r = next) {
            next = e->rows[r].next;
            if (r != pivot) reduce(e, r, &e->rows[pivot]);
        }
        e->pivots[e->rank++] = pivot;
    }
}

// Substitutes from the last pivot to the first: each row by the entries after its pivot.
static void substitute_back(const Elimination *e, uint64_t *x)
{
    for (size_t i = e->rank; i-- > 0;) {
        const Row *row = &e->rows[e->pivots[i]];
        uint64_t value = row->right;
        for (size_t k = 1; k < row->count; k++)
            value = yk_field_subtract(value, yk_field_multiply(row->entry[k].value, x[row->entry[k].column]));
        x[row->entry[0].column] = value;
    }
}

static bool take_row(Row *row, const YkFieldEntry *entries, size_t count, uint64_t right)
{
    row->entry = malloc((count + 1) * sizeof *row->entry);
    if (!row->entry) return false;
    for (size_t k = 0; k < count; k++)
        if (entries[k].value != 0) row->entry[row->count++] = entries[k];
    row->right = right;
    return true;
}

int yk_field_solve(const YkFieldEntry *entries, const size_t *first, const uint64_t *b, size_t rows, size_t columns,
                   uint64_t *x)
{
    Elimination e = {.columns = columns};
    e.rows = calloc(rows + 1, sizeof *e.rows);
    e.first = calloc(columns + rows + 1, sizeof *e.first);
    e.failed = !e.rows || !e.first;
    if (!e.failed) e.pivots = e.first + columns;
    for (size_t k = 0; k < columns && !e.failed; k++) e.first[k] = NONE;
    for (size_t r = 0; r < rows && !e.failed; r++) {
        e.failed = !take_row(&e.rows[r], entries + first[r], first[r + 1] - first[r], b[r]);
        if (!e.failed) enter(&e, r);
    }
    if (!e.failed) eliminate(&e);
    int rank = e.failed ? YK_FIELD_NO_MEMORY : e.contradicts ? -1 : (int)e.rank;
    if (rank >= 0) substitute_back(&e, x);
    for (size_t r = 0; e.rows && r < rows; r++) free(e.rows[r].entry);
    free(e.rows);
    free(e.first);
    return rank;
}
