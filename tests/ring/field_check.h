// The prime field as the tests use it: linear equations with all their entries, forms compared at points of their own.
#ifndef TESTS_RING_FIELD_CHECK_H
#define TESTS_RING_FIELD_CHECK_H
#include <stdlib.h>
#include "ring/proof/form.h"

static inline YkFormVerdict compare_forms(YkRing *ring, const YkForm *a, const YkForm *b, int points, uint64_t seed)
{
    YkFieldPoints *kept = yk_field_points_new(ring, seed);
    YkFormVerdict verdict = yk_form_compare_at(ring, a, b, points, kept);
    yk_field_points_free(kept);
    return verdict;
}

// A x = b with all entries of A, row after row.
static inline int solve_dense(const uint64_t *A, const uint64_t *b, size_t rows, size_t columns, uint64_t *x)
{
    YkFieldEntry *entries = calloc(rows * columns + 1, sizeof *entries);
    size_t *first = calloc(rows + 1, sizeof *first);
    int rank = -1;
    for (size_t k = 0; entries && k < rows * columns; k++) entries[k] = (YkFieldEntry){k % columns, A[k]};
    for (size_t r = 0; first && r <= rows; r++) first[r] = r * columns;
    if (entries && first) rank = yk_field_solve(entries, first, b, rows, columns, x);
    free(entries);
    free(first);
    return rank;
}

#endif
