// Sparse square matrices: left-looking LU with partial pivoting (Gilbert & Peierls 1988), columns ordered by
// approximate minimum degree of A^T A (Davis, Gilbert, Larimore & Ng 2004). The pattern is analysed once; factoring and
// solving allocate only when the fill-in grows beyond what was seen before.
#ifndef NUM_SPARSE_H
#define NUM_SPARSE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct YkSparse YkSparse;
// Analyses a pattern given by columns: the rows of column j are row[start[j] .. start[j + 1]), in any order, without
// repeats. Returns NULL when out of memory.
YkSparse *yk_sparse_new(size_t n, const int32_t *start, const int32_t *row);
void yk_sparse_free(YkSparse *sparse);
// Factors the matrix with these values (same order as the pattern). Returns the smallest pivot over the largest entry
// of its column of A, in [0, ..]: 0 when structurally or numerically singular (then do not solve), -1 when out of
// memory. *singular_column (may be NULL) gets the column of the worst pivot.
double yk_sparse_factor(YkSparse *sparse, const double *value, int32_t *singular_column);
// Solves A x = b in place. With refine, adds one step of iterative refinement with the values of the last
// factorisation.
void yk_sparse_solve(YkSparse *sparse, double *b, bool refine);

#endif
