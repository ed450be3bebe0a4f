// Singular values by one-sided Jacobi rotations.
#include <math.h>
#include "num/dense.h"

enum { ROUNDS = 60 };

// Makes columns p and q orthogonal; returns false if they already were.
static bool rotate(size_t m, size_t n, double *A, size_t p, size_t q)
{
    double a = 0, b = 0, c = 0; // |p|^2, |q|^2, p . q
    for (size_t i = 0; i < m; i++) {
        a += A[i * n + p] * A[i * n + p];
        b += A[i * n + q] * A[i * n + q];
        c += A[i * n + p] * A[i * n + q];
    }
    if (fabs(c) <= 1e-15 * sqrt(a) * sqrt(b)) return false;
    double zeta = (b - a) / (2 * c), t = copysign(1, zeta) / (fabs(zeta) + sqrt(1 + zeta * zeta));
    double cosine = 1 / sqrt(1 + t * t), sine = cosine * t;
    for (size_t i = 0; i < m; i++) {
        double x = A[i * n + p], y = A[i * n + q];
        A[i * n + p] = cosine * x - sine * y;
        A[i * n + q] = sine * x + cosine * y;
    }
    return true;
}

void yk_singular_values(size_t m, size_t n, double *A, double *values)
{
    bool goes_on = true;
    for (int round = 0; round < ROUNDS && goes_on; round++) {
        goes_on = false;
        for (size_t p = 0; p < n; p++)
            for (size_t q = p + 1; q < n; q++) goes_on |= rotate(m, n, A, p, q);
    }
    for (size_t k = 0; k < n; k++) {
        double sum = 0;
        for (size_t i = 0; i < m; i++) sum += A[i * n + k] * A[i * n + k];
        values[k] = sqrt(sum);
    }
}
