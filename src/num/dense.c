// Dense LU and QR factorisation, row-major.
#include "num/dense.h"
#include <math.h>

static void swap_rows(size_t n, double *A, size_t i, size_t k)
{
    for (size_t j = 0; j < n; j++) {
        double t = A[i * n + j];
        A[i * n + j] = A[k * n + j];
        A[k * n + j] = t;
    }
}

double yk_lu_factor(size_t n, double *A, int *pivot, double *scale)
{
    double det = 1;
    for (size_t j = 0; j < n; j++) {
        double sum = 0;
        for (size_t i = 0; i < n; i++) sum += A[i * n + j] * A[i * n + j];
        scale[j] = sqrt(sum);
    }
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < n; i++)
            if (fabs(A[i * n + k]) > fabs(A[best * n + k])) best = i;
        pivot[k] = (int)best;
        if (best != k) {
            swap_rows(n, A, best, k);
            det = -det;
        }
        double p = A[k * n + k];
        det *= scale[k] > 0 ? p / scale[k] : 0;
        if (p == 0) return 0;
        for (size_t i = k + 1; i < n; i++) {
            double f = A[i * n + k] /= p;
            for (size_t j = k + 1; j < n; j++) A[i * n + j] -= f * A[k * n + j];
        }
    }
    return det;
}

void yk_lu_solve(size_t n, const double *A, const int *pivot, double *b)
{
    for (size_t k = 0; k < n; k++) {
        size_t p = (size_t)pivot[k];
        double t = b[k];
        b[k] = b[p];
        b[p] = t;
    }
    for (size_t i = 1; i < n; i++)
        for (size_t j = 0; j < i; j++) b[i] -= A[i * n + j] * b[j];
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; j++) b[i] -= A[i * n + j] * b[j];
        b[i] /= A[i * n + i];
    }
}

static double column_length(size_t m, size_t n, const double *A, size_t from, size_t column)
{
    double sum = 0;
    for (size_t i = from; i < m; i++) sum += A[i * n + column] * A[i * n + column];
    return sqrt(sum);
}

static void swap_columns(size_t m, size_t n, double *A, size_t j, size_t k)
{
    for (size_t i = 0; i < m; i++) {
        double t = A[i * n + j];
        A[i * n + j] = A[i * n + k];
        A[i * n + k] = t;
    }
}

// Makes the Householder vector of column k below row k: v[k] = 1 is implied, the rest stays in A, the diagonal gets R.
static void reflect_column(size_t m, size_t n, double *A, size_t k, double *tau)
{
    double length = column_length(m, n, A, k, k), a = A[k * n + k];
    if (length == 0) {
        tau[k] = 0;
        return;
    }
    double beta = a > 0 ? -length : length;
    tau[k] = (beta - a) / beta;
    for (size_t i = k + 1; i < m; i++) A[i * n + k] /= a - beta;
    A[k * n + k] = beta;
    for (size_t j = k + 1; j < n; j++) {
        double sum = A[k * n + j];
        for (size_t i = k + 1; i < m; i++) sum += A[i * n + k] * A[i * n + j];
        sum *= tau[k];
        A[k * n + j] -= sum;
        for (size_t i = k + 1; i < m; i++) A[i * n + j] -= sum * A[i * n + k];
    }
}

size_t yk_qr_factor(size_t m, size_t n, double *A, size_t *order, double *tau, double tolerance)
{
    size_t steps = m < n ? m : n, rank = 0;
    double largest = 0;
    for (size_t j = 0; j < n; j++) order[j] = j;
    for (size_t k = 0; k < steps; k++) {
        size_t best = k;
        double length = -1;
        for (size_t j = k; j < n; j++) {
            double other = column_length(m, n, A, k, j);
            if (other > length) {
                length = other;
                best = j;
            }
        }
        if (best != k) {
            swap_columns(m, n, A, best, k);
            size_t t = order[best];
            order[best] = order[k];
            order[k] = t;
        }
        if (k == 0) largest = length;
        if (!(length > tolerance * largest) || length == 0) break;
        reflect_column(m, n, A, k, tau);
        rank++;
    }
    return rank;
}

// Applies the Householder reflection of column k to b[m].
static void reflect(size_t m, size_t n, const double *A, const double *tau, size_t k, double *b)
{
    double sum = b[k];
    for (size_t i = k + 1; i < m; i++) sum += A[i * n + k] * b[i];
    sum *= tau[k];
    b[k] -= sum;
    for (size_t i = k + 1; i < m; i++) b[i] -= sum * A[i * n + k];
}

void yk_qr_solve(size_t m, size_t n, const double *A, const size_t *order, const double *tau, size_t rank, double *b,
                 double *x)
{
    for (size_t k = 0; k < rank; k++) reflect(m, n, A, tau, k, b);
    for (size_t j = 0; j < n; j++) x[j] = 0;
    for (size_t i = rank; i-- > 0;) {
        double sum = b[i];
        for (size_t j = i + 1; j < rank; j++) sum -= A[i * n + j] * x[order[j]];
        x[order[i]] = sum / A[i * n + i];
    }
}

void yk_qr_solve_transposed(size_t m, size_t n, const double *A, const size_t *order, const double *tau,
                            const double *b, double *x)
{
    for (size_t i = 0; i < m; i++) x[i] = i < n ? b[order[i]] : 0;
    for (size_t i = 0; i < n; i++) { // R^T y = b in the order of the pivots
        for (size_t j = 0; j < i; j++) x[i] -= A[j * n + i] * x[j];
        x[i] /= A[i * n + i];
    }
    for (size_t k = n; k-- > 0;) reflect(m, n, A, tau, k, x);
}
