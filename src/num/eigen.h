// Eigenvalues of small dense matrices (up to a few hundred rows), row-major. No allocation.
#ifndef NUM_EIGEN_H
#define NUM_EIGEN_H
#include <stdbool.h>
#include <stddef.h>

// Eigenvalues of the symmetric A[n][n] (overwritten), ascending, in values[n]. Row k of vectors[n][n] is the
// eigenvector of values[k], all of length 1 and at right angles; NULL when not wanted. False: A is not finite, or no
// convergence. Cost about 10 n^3 to 60 n^3. Source: cyclic Jacobi, Golub & Van Loan 2013, 8.5.
bool yk_eigen_symmetric(size_t n, double *A, double *values, double *vectors);

// Eigenvalues of any A[n][n] (overwritten): real[n] + i imaginary[n], ascending by real part; of a conjugate pair the
// one with positive imaginary part first. False: A is not finite, or no convergence. Cost about 10 n^3. Source:
// balancing, Parlett & Reinsch 1969; Householder reduction and Francis' double shift, Golub & Van Loan 2013, 7.4
// and 7.5.
bool yk_eigen_general(size_t n, double *A, double *real, double *imaginary);

#endif
