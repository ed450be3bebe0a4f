// The inside of YkSparse: A[:, order] = P^T L U, columns of L and U stored one behind the other.
#ifndef NUM_SPARSE_INSIDE_H
#define NUM_SPARSE_INSIDE_H
#include "num/sparse.h"

// Columns of one triangular factor, without the diagonal. Column k: entries start[k] .. start[k + 1].
typedef struct YkTriangle {
    size_t *start; // [n + 1]
    int32_t *row;  // pivot positions (in L: rows of A until the factorisation is complete)
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
    int32_t *stack, *reach, *mark; // [n] scratch space for the search
    size_t *cursor;                // [n]
    void *memory;                  // holds all of the above except the triangles' entries
};

// Orders the columns for little fill-in whatever rows become pivots: approximate minimum degree of A^T A. Returns false
// when out of memory. Costs about as much as eliminating the pattern.
bool yk_sparse_order(size_t n, const int32_t *start, const int32_t *row, int32_t *order);
// Reorders the columns, with the same fill-in, so that columns eliminated one after the other lie together: a postorder
// of the column elimination tree. Returns false when out of memory.
bool yk_sparse_postorder(size_t n, const int32_t *start, const int32_t *row, int32_t *order);

#endif
