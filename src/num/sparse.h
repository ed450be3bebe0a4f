// Sparse square matrices: LU factors with partial pivoting, left-looking (Gilbert & Peierls 1988), columns ordered by
// approximate minimum degree of A^T A (Davis, Gilbert, Larimore & Ng 2004). The pattern is analysed once; factoring and
// solving allocate only when fill grows beyond what was seen before.
#ifndef NUM_SPARSE_H
#define NUM_SPARSE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct YkSparse YkSparse;
// Pattern by columns: rows of column j are row[start[j] .. start[j + 1]), any order, no repeats. NULL when out of
// memory.
YkSparse *yk_sparse_new(size_t n, const int32_t *start, const int32_t *row);
void yk_sparse_free(YkSparse *sparse);
// Factors the matrix with these values (same order as the pattern). Returns the smallest pivot over the largest entry
// of its column of A, in [0, ..]: 0 when structurally or numerically singular (then do not solve). *singular_column
// (may be NULL): where the worst pivot was. -1 when out of memory.
double yk_sparse_factor(YkSparse *sparse, const double *value, int32_t *singular_column);
// A x = b, in place. One step of iterative refinement with the values of the last factorisation if refine.
void yk_sparse_solve(YkSparse *sparse, double *b, bool refine);
// A^T x = b, in place.
void yk_sparse_solve_transposed(YkSparse *sparse, double *b, bool refine);

#endif
