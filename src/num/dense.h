// Small dense linear algebra, row-major: LU for square systems, QR with column pivoting for rank and least squares.
#ifndef NUM_DENSE_H
#define NUM_DENSE_H
#include <stdbool.h>
#include <stddef.h>

// Factors A[n][n] in place, P A = L U with partial pivoting; pivot[n]. Returns the determinant over the product of the
// column lengths, in [-1, 1]: it measures how far the columns are from linear dependence, 0 when singular. scale[n] is
// scratch. Source: Golub & Van Loan 2013, 3.4.
double yk_lu_factor(size_t n, double *A, int *pivot, double *scale);
// Solves A x = b in place of b. The factorisation of A must have returned a nonzero determinant.
void yk_lu_solve(size_t n, const double *A, const int *pivot, double *b);

// Factors A[m][n] in place by Householder QR with column pivoting. order[n]: the columns in pivot order; tau[n]
// scratch. Returns the numerical rank: the number of diagonal entries above `tolerance` times the largest. Source:
// Golub & Van Loan 2013, 5.4.
size_t yk_qr_factor(size_t m, size_t n, double *A, size_t *order, double *tau, double tolerance);
// Finds the basic least-squares solution of A x = b from the factors with that rank (unknowns beyond the rank are 0).
// Overwrites b[m].
void yk_qr_solve(size_t m, size_t n, const double *A, const size_t *order, const double *tau, size_t rank, double *b,
                 double *x);
// Finds an x[m] with A^T x = b[n] from factors of full rank n.
void yk_qr_solve_transposed(size_t m, size_t n, const double *A, const size_t *order, const double *tau,
                            const double *b, double *x);

// Computes the singular values of A[m][n], m >= n, in no order; overwrites A. Rotates pairs of columns until all are
// orthogonal: small values keep their digits however the columns are scaled. Cost O(m n^2) a round, some ten rounds.
// Source: Hestenes 1958; Demmel & Veselic 1992.
void yk_singular_values(size_t m, size_t n, double *A, double *values);

static inline double yk_inner_product(const double *a, const double *b, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += a[k] * b[k];
    return sum;
}

#endif
