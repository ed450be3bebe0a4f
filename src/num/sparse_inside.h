// The inside of YkSparse: A[:, order] = P^T L U, columns of L and U stored one behind the other.
#ifndef NUM_SPARSE_INSIDE_H
#define NUM_SPARSE_INSIDE_H
#include "num/sparse.h"

// Columns of one triangular factor, without the diagonal. Column k: entries start[k] .. start[k + 1].
typedef struct YkTriangle {
    size_t *start; // [n + 1]
    int32_t *row;  // pivot positions (of L: rows of A until the factorisation is complete)
    double *value;
    size_t count, capacity;
} YkTriangle;

struct YkSparse {
    size_t n;
    int32_t *start, *row; // the pattern
    double *value;        // of the last factorisation
    int32_t *order;       // [n]: pivot k eliminates column order[k]
    int32_t *position;    // [n]: row -> its pivot, -1 while it has none
    int32_t *pivot_row;   // [n]: pivot -> its row
    double *diagonal;     // [n] of U
    YkTriangle L, U;
    double *x, *b;                 // [n] scratch; x is zero between columns
    int32_t *stack, *reach, *mark; // [n] scratch of the search
    size_t *cursor;                // [n]
    void *memory;                  // of all the above but the triangles' entries
};

// Order of the columns for little fill whatever rows are chosen as pivots: approximate minimum degree of A^T A.
// False when out of memory. Cost about that of the elimination's pattern.
bool yk_sparse_order(size_t n, const int32_t *start, const int32_t *row, int32_t *order);
// The same columns, reordered so that what is eliminated in turn lies together: a postorder of the column elimination
// tree (same fill). False when out of memory.
bool yk_sparse_postorder(size_t n, const int32_t *start, const int32_t *row, int32_t *order);

#endif
