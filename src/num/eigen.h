// Eigenvalues of small dense matrices (up to a few hundred rows), row-major. No allocation.
#ifndef NUM_EIGEN_H
#define NUM_EIGEN_H
#include <stdbool.h>
#include <stddef.h>
#include "base/vec.h"

// Computes the eigenvalues of the symmetric A[n][n] (overwritten) in ascending order. Row k of vectors[n][n] is the
// eigenvector of values[k]; the vectors are orthonormal. vectors may be NULL. Returns false if A is not finite or the
// iteration does not converge. Cost about 10 n^3 to 60 n^3. Source: cyclic Jacobi, Golub & Van Loan 2013, 8.5.
bool yk_eigen_symmetric(size_t n, double *A, double *values, double *vectors);

// Computes the eigenvalues of any A[n][n] (overwritten): real[n] + i imaginary[n], ascending by real part; of a
// conjugate pair the one with positive imaginary part comes first. Returns false if A is not finite or the iteration
// does not converge. Cost about 10 n^3. Source: balancing, Parlett & Reinsch 1969; Householder reduction and Francis'
// double shift, Golub & Van Loan 2013, 7.4 and 7.5.
bool yk_eigen_general(size_t n, double *A, double *real, double *imaginary);

// Computes the eigenvalues and eigenvectors of any complex A[n][n] (overwritten), in the order of its Schur form.
// Column k of vectors[n][n] belongs to values[k]; its length is any. Those of eigenvalues that are equal to rounding
// are nearly parallel. Returns false if A is not finite or the iteration does not converge. Cost about 20 n^3 complex
// multiplications. Source: Hessenberg form and the QR iteration with Wilkinson's shift, Golub & Van Loan 2013, 7.3 to
// 7.6; all by Givens' rotations.
bool yk_eigen_complex(size_t n, YkVec *A, YkVec *values, YkVec *vectors);

#endif
