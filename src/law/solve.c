// Solves the linear system of conditions: rank and the condition to blame, LU, refinement in twice the precision.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "law/inside.h"
#include "num/dense.h"

enum { REFINEMENTS = 4 };
// Rows whose remainder is below this count as dependent.
#define RANK 1e-13

// Everything a solution needs besides the system.
typedef struct Scratch {
    double *factors, *tau, *column, *work, *scale;
    int *pivot;
    size_t *order;
} Scratch;

static void scratch_free(Scratch *scratch)
{
    free(scratch->factors);
    free(scratch->tau);
    free(scratch->pivot);
    free(scratch->order);
}

static bool scratch_new(Scratch *scratch, size_t n)
{
    *scratch = (Scratch){.factors = malloc(n * n * sizeof(double)),
                         .tau = malloc(4 * n * sizeof(double)),
                         .pivot = malloc(n * sizeof(int)),
                         .order = malloc(n * sizeof(size_t))};
    if (!scratch->factors || !scratch->tau || !scratch->pivot || !scratch->order) {
        scratch_free(scratch);
        return false;
    }
    scratch->column = scratch->tau + n;
    scratch->work = scratch->tau + 2 * n;
    scratch->scale = scratch->tau + 3 * n;
    return true;
}

// Scales every row to 1 in its largest entry, so that a condition on a high derivative weighs like one on the value.
// The factors are powers of two, so this is exact.
static void scale_rows(size_t n, double *A, double *b)
{
    for (size_t i = 0; i < n; i++) {
        double largest = 0;
        int exponent;
        for (size_t k = 0; k < n; k++) largest = fmax(largest, fabs(A[i * n + k]));
        if (!(largest > 0) || !isfinite(largest)) continue;
        frexp(largest, &exponent);
        for (size_t k = 0; k < n; k++) A[i * n + k] = ldexp(A[i * n + k], -exponent);
        b[i] = ldexp(b[i], -exponent);
    }
}

// Returns the rank of the rows; *culprit gets a row that depends on the others, if there is one.
static size_t row_rank(size_t n, const double *A, Scratch *scratch, size_t *culprit)
{
    double *transposed = scratch->factors;
    for (size_t i = 0; i < n; i++) {
        double length = 0;
        for (size_t k = 0; k < n; k++) length += A[i * n + k] * A[i * n + k];
        length = length > 0 ? sqrt(length) : 1;
        for (size_t k = 0; k < n; k++) transposed[k * n + i] = A[i * n + k] / length;
    }
    size_t rank = yk_qr_factor(n, n, transposed, scratch->order, scratch->tau, RANK);
    // blames the condition given last
    for (size_t i = rank; i < n; i++) {
        if (i == rank || scratch->order[i] > *culprit) *culprit = scratch->order[i];
    }
    return rank;
}

// Returns whether the singular system still has solutions.
static bool is_consistent(size_t n, const double *A, const double *b, Scratch *scratch, double *x)
{
    double largest = 0, off = 0;
    memcpy(scratch->factors, A, n * n * sizeof *A);
    memcpy(scratch->column, b, n * sizeof *b);
    size_t rank = yk_qr_factor(n, n, scratch->factors, scratch->order, scratch->tau, RANK);
    yk_qr_solve(n, n, scratch->factors, scratch->order, scratch->tau, rank, scratch->column, x);
    for (size_t i = 0; i < n; i++) {
        double sum = b[i];
        for (size_t k = 0; k < n; k++) sum -= A[i * n + k] * x[k];
        off = fmax(off, fabs(sum));
        largest = fmax(largest, fabs(b[i]));
    }
    return off <= 1e-9 * largest;
}

// Computes b - A x, each entry in twice the precision. Source: Ogita, Rump & Oishi 2005, algorithm Dot2.
static void residual(size_t n, const double *A, const double *x, const double *b, double *r)
{
    for (size_t i = 0; i < n; i++) {
        double sum = b[i], low = 0;
        for (size_t k = 0; k < n; k++) {
            double product = -A[i * n + k] * x[k], rest = fma(-A[i * n + k], x[k], -product);
            double next = sum + product, back = next - sum;
            low += (sum - (next - back)) + (product - back) + rest;
            sum = next;
        }
        r[i] = sum + low;
    }
}

static double largest_column(size_t n, const double *A)
{
    double largest = 0;
    for (size_t k = 0; k < n; k++) {
        double sum = 0;
        for (size_t i = 0; i < n; i++) sum += fabs(A[i * n + k]);
        largest = fmax(largest, sum);
    }
    return largest;
}

// Returns |A| |A^-1| in the 1-norm, by the columns of the inverse.
static double condition(size_t n, const double *A, Scratch *scratch)
{
    double largest = 0;
    for (size_t k = 0; k < n; k++) {
        double sum = 0;
        memset(scratch->column, 0, n * sizeof *scratch->column);
        scratch->column[k] = 1;
        yk_lu_solve(n, scratch->factors, scratch->pivot, scratch->column);
        for (size_t i = 0; i < n; i++) sum += fabs(scratch->column[i]);
        largest = fmax(largest, sum);
    }
    return largest * largest_column(n, A);
}

static YkLawFault solve(size_t n, double *A, double *b, double *x, double *condition_number, size_t *culprit,
                        Scratch *scratch)
{
    scale_rows(n, A, b);
    if (row_rank(n, A, scratch, culprit) < n) {
        return is_consistent(n, A, b, scratch, x) ? YK_LAW_UNDETERMINED : YK_LAW_CONTRADICTION;
    }
    memcpy(scratch->factors, A, n * n * sizeof *A);
    if (yk_lu_factor(n, scratch->factors, scratch->pivot, scratch->scale) == 0) return YK_LAW_NOT_FINITE;
    *condition_number = condition(n, A, scratch);
    memset(x, 0, n * sizeof *x);
    for (int round = 0; round < REFINEMENTS; round++) {
        residual(n, A, x, b, scratch->column);
        yk_lu_solve(n, scratch->factors, scratch->pivot, scratch->column);
        for (size_t i = 0; i < n; i++) x[i] += scratch->column[i];
    }
    return isfinite(*condition_number) ? YK_LAW_OK : YK_LAW_NOT_FINITE;
}

YkLawFault yk_law_solve(size_t n, double *A, double *b, double *x, double *condition_number, size_t *culprit)
{
    Scratch scratch;
    if (!scratch_new(&scratch, n)) return YK_LAW_NO_MEMORY;
    YkLawFault fault = solve(n, A, b, x, condition_number, culprit, &scratch);
    scratch_free(&scratch);
    return fault;
}
