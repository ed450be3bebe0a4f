// Complex LU factorisation, and kernels by elimination with complete pivoting.
#include "num/complex.h"

static void swap(YkVec *a, YkVec *b)
{
    YkVec t = *a;
    *a = *b;
    *b = t;
}

static void swap_rows(size_t n, YkVec *A, size_t i, size_t k)
{
    for (size_t j = 0; j < n; j++) swap(&A[i * n + j], &A[k * n + j]);
}

// Takes factor times row k from row i, from column `from` on.
static void subtract_row(size_t n, YkVec *A, size_t i, size_t k, size_t from, YkVec factor)
{
    YkVec minus = yk_vec(-factor.x, -factor.y), *to = A + i * n;
    const YkVec *row = A + k * n;
    for (size_t j = from; j < n; j++) to[j] = yk_add_product(to[j], minus, row[j]);
}

bool yk_complex_factor(size_t n, YkVec *A, int *pivot)
{
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < n; i++)
            if (yk_sum_norm(A[i * n + k]) > yk_sum_norm(A[best * n + k])) best = i;
        pivot[k] = (int)best;
        if (best != k) swap_rows(n, A, best, k);
        double size = yk_sum_norm(A[k * n + k]);
        if (!(size > 0 && size < INFINITY)) return false;
        YkVec inverse = A[k * n + k] = yk_inverse(A[k * n + k]);
        for (size_t i = k + 1; i < n; i++) {
            if (A[i * n + k].x == 0 && A[i * n + k].y == 0) continue;
            A[i * n + k] = yk_mul(A[i * n + k], inverse);
            subtract_row(n, A, i, k, k + 1, A[i * n + k]);
        }
    }
    return true;
}

void yk_complex_solve(size_t n, const YkVec *A, const int *pivot, YkVec *b)
{
    for (size_t k = 0; k < n; k++) swap(&b[k], &b[pivot[k]]);
    for (size_t i = 1; i < n; i++)
        for (size_t j = 0; j < i; j++) b[i] = yk_sub(b[i], yk_mul(A[i * n + j], b[j]));
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; j++) b[i] = yk_sub(b[i], yk_mul(A[i * n + j], b[j]));
        b[i] = yk_mul(b[i], A[i * n + i]);
    }
}

// Brings the largest entry of the rest to the diagonal; returns its size.
static double bring_pivot(size_t m, size_t n, YkVec *A, size_t *order, size_t k)
{
    size_t row = k, column = k;
    for (size_t i = k; i < m; i++)
        for (size_t j = k; j < n; j++)
            if (yk_sum_norm(A[i * n + j]) > yk_sum_norm(A[row * n + column])) row = i, column = j;
    swap_rows(n, A, row, k);
    for (size_t i = 0; i < m; i++) swap(&A[i * n + column], &A[i * n + k]);
    size_t moved = order[column];
    order[column] = order[k];
    order[k] = moved;
    return yk_sum_norm(A[k * n + k]);
}

size_t yk_complex_kernel(size_t m, size_t n, YkVec *A, size_t *order, double tolerance, YkVec *kernel)
{
    size_t rank = 0;
    double largest = 0;
    for (size_t j = 0; j < n; j++) order[j] = j;
    for (size_t most = m < n ? m : n; rank < most; rank++) {
        double size = bring_pivot(m, n, A, order, rank);
        largest = fmax(largest, size);
        if (!(size > tolerance * largest)) break;
        YkVec inverse = yk_inverse(A[rank * n + rank]);
        for (size_t j = rank; j < n; j++) A[rank * n + j] = yk_mul(A[rank * n + j], inverse);
        for (size_t i = 0; i < m; i++)
            if (i != rank) subtract_row(n, A, i, rank, rank, A[i * n + rank]);
    }
    size_t free_count = n - rank;
    for (size_t j = 0; j < free_count; j++) {
        for (size_t i = 0; i < n; i++) kernel[i * free_count + j] = yk_vec(0, 0);
        kernel[order[rank + j] * free_count + j] = yk_vec(1, 0);
        for (size_t i = 0; i < rank; i++) kernel[order[i] * free_count + j] = yk_scale(-1, A[i * n + rank + j]);
    }
    return rank;
}
