// Eigenvalues and eigenvectors of symmetric matrices by cyclic Jacobi rotations.
#include <float.h>
#include <math.h>
#include "elementary/elementary.h"
#include "num/eigen.h"

enum { MOST_SWEEPS = 60 };

typedef struct Rotation {
    double c, s;
} Rotation;

// Returns the rotation that makes A[p][q] zero, by the smaller of the two angles; written so that nothing overflows.
static Rotation rotation_for(double pp, double pq, double qq)
{
    double tau = (qq - pp) / (2 * pq), t = (tau >= 0 ? 1 : -1) / (fabs(tau) + yk_hypot(1, tau));
    double c = 1 / sqrt(1 + t * t);
    return (Rotation){c, t * c};
}

static void rotate(Rotation r, double *a, double *b)
{
    double x = *a, y = *b;
    *a = r.c * x - r.s * y;
    *b = r.s * x + r.c * y;
}

static void eliminate(size_t n, double *A, double *vectors, size_t p, size_t q)
{
    Rotation r = rotation_for(A[p * n + p], A[p * n + q], A[q * n + q]);
    for (size_t k = 0; k < n; k++) rotate(r, &A[p * n + k], &A[q * n + k]);
    for (size_t k = 0; k < n; k++) rotate(r, &A[k * n + p], &A[k * n + q]);
    A[p * n + q] = A[q * n + p] = 0;
    for (size_t k = 0; vectors && k < n; k++) rotate(r, &vectors[p * n + k], &vectors[q * n + k]);
}

// Sweeps over all pairs except those negligible next to the whole matrix. Returns how many were left to do.
static size_t sweep(size_t n, double *A, double *vectors, double tiny)
{
    size_t done = 0;
    for (size_t p = 0; p + 1 < n; p++)
        for (size_t q = p + 1; q < n; q++)
            if (fabs(A[p * n + q]) > tiny) {
                eliminate(n, A, vectors, p, q);
                done++;
            }
    return done;
}

static void swap(double *a, double *b)
{
    double t = *a;
    *a = *b;
    *b = t;
}

static void sort_ascending(size_t n, double *values, double *vectors)
{
    for (size_t k = 0; k + 1 < n; k++) {
        size_t least = k;
        for (size_t i = k + 1; i < n; i++)
            if (values[i] < values[least]) least = i;
        if (least == k) continue;
        swap(&values[k], &values[least]);
        for (size_t j = 0; vectors && j < n; j++) swap(&vectors[k * n + j], &vectors[least * n + j]);
    }
}

bool yk_eigen_symmetric(size_t n, double *A, double *values, double *vectors)
{
    double largest = 0;
    for (size_t k = 0; k < n * n; k++) {
        if (!(fabs(A[k]) <= DBL_MAX)) return false;
        largest = fmax(largest, fabs(A[k]));
    }
    // Scales to sizes near 1 whatever the unit: by a power of two, so that nothing is rounded.
    int exponent = 0;
    frexp(largest, &exponent);
    for (size_t k = 0; k < n * n; k++) A[k] = ldexp(A[k], -exponent);
    for (size_t k = 0; vectors && k < n * n; k++) vectors[k] = k % (n + 1) == 0;
    int sweeps = 0;
    while (sweep(n, A, vectors, 0x1p-60) > 0)
        if (++sweeps == MOST_SWEEPS) return false;
    for (size_t k = 0; k < n; k++) values[k] = ldexp(A[k * n + k], exponent);
    sort_ascending(n, values, vectors);
    return true;
}
