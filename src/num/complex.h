// Small dense linear systems of complex numbers, row-major; a complex number is a YkVec, x + iy.
#ifndef NUM_COMPLEX_H
#define NUM_COMPLEX_H
#include <stdbool.h>
#include <stddef.h>
#include "base/vec.h"

// Returns 1 / a.
static inline YkVec yk_inverse(YkVec a)
{
    double square = yk_dot(a, a);
    return yk_vec(a.x / square, -a.y / square);
}
// Returns |x| + |y|, which is between |a| and sqrt(2) |a| and costs no root.
static inline double yk_sum_norm(YkVec a)
{
    return fabs(a.x) + fabs(a.y);
}
// Returns sum + a b.
static inline YkVec yk_add_product(YkVec sum, YkVec a, YkVec b)
{
    return yk_vec(sum.x + a.x * b.x - a.y * b.y, sum.y + a.x * b.y + a.y * b.x);
}

// Factors A[n][n] in place, P A = L U with partial pivoting; the diagonal of U is stored inverted. pivot[n]. Returns
// false if a pivot vanishes or is not a number. Cost n^3 / 3 complex multiplications. Source: Golub & Van Loan 2013,
// 3.4.
bool yk_complex_factor(size_t n, YkVec *A, int *pivot);
// Solves A x = b in place of b from the factors.
void yk_complex_solve(size_t n, const YkVec *A, const int *pivot, YkVec *b);
// Computes a basis of the kernel of A[m][n] (overwritten) with complete pivoting: the columns of kernel[n][n - rank].
// Pivots of at most `tolerance` times the largest entry count as zero. order[n] is scratch. Returns the rank.
size_t yk_complex_kernel(size_t m, size_t n, YkVec *A, size_t *order, double tolerance, YkVec *kernel);

#endif
