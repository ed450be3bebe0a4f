// Small dense linear algebra, row-major: LU for the square, QR with column pivoting for rank and least squares.
#ifndef NUM_DENSE_H
#define NUM_DENSE_H
#include <stdbool.h>
#include <stddef.h>

// Factors A[n][n] in place, P A = L U with partial pivoting; pivot[n]. Returns the determinant over the product of the
// column lengths (in [-1, 1], 0 when singular): how far the columns are from dependent. scale[n] is scratch. Source:
// Golub & Van Loan 2013, 3.4.
double yk_lu_factor(size_t n, double *A, int *pivot, double *scale);
// Solves A x = b in place of b. A must have factored with a nonzero determinant.
void yk_lu_solve(size_t n, const double *A, const int *pivot, double *b);

// Householder QR with column pivoting of A[m][n], in place. order[n]: columns as pivoted; tau[n] scratch.
// Returns the numerical rank: diagonal entries above `tolerance` times the largest. Source: Golub & Van Loan 2013, 5.4.
size_t yk_qr_factor(size_t m, size_t n, double *A, size_t *order, double *tau, double tolerance);
// Basic least-squares solution of A x = b from the factors with that rank (unknowns beyond the rank are 0). b[m] is
// overwritten.
void yk_qr_solve(size_t m, size_t n, const double *A, const size_t *order, const double *tau, size_t rank, double *b,
                 double *x);

// Singular values of A[m][n], m >= n, in no order; A is overwritten. Rotates pairs of columns until all are orthogonal:
// small values keep their digits however columns are scaled. Cost O(m n^2) a round, some ten rounds. Source: Hestenes
// 1958; Demmel & Veselic 1992.
void yk_singular_values(size_t m, size_t n, double *A, double *values);

#endif
