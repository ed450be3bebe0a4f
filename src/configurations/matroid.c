// Computes the ranks of all sets of unknowns of a group.
#include "configurations/matroid.h"
#include <stdlib.h>
#include <string.h>
#include "num/complex.h"

enum { ELEMENTS_MAX = 2 * YK_SYSTEM_LOOPS_MAX + 1, RANK_MAX = YK_SYSTEM_LOOPS_MAX + 1 };
// A pivot of rows of length 1: below the first it is zero up to rounding, above the second it is not.
static const double zero = 1e-13, clear = 1e-10;

// Eliminates the rows of the set with complete pivoting. Returns the rank, or -1 where it is not clear.
static int rank_of_rows(const YkVec *rows, size_t width, size_t elements, size_t set)
{
    YkVec A[ELEMENTS_MAX * RANK_MAX];
    size_t count = 0;
    for (size_t e = 0; e < elements; e++)
        if (set >> e & 1) memcpy(A + count++ * width, rows + e * width, width * sizeof *A);
    for (size_t k = 0;; k++) {
        size_t row = k, column = k;
        if (k == count || k == width) return (int)k;
        for (size_t i = k; i < count; i++)
            for (size_t j = k; j < width; j++)
                if (yk_sum_norm(A[i * width + j]) > yk_sum_norm(A[row * width + column])) row = i, column = j;
        double size = yk_sum_norm(A[row * width + column]);
        if (size <= zero) return (int)k;
        if (!(size >= clear)) return -1;
        for (size_t j = 0; j < width; j++) {
            YkVec t = A[k * width + j];
            A[k * width + j] = A[row * width + j];
            A[row * width + j] = t;
        }
        for (size_t i = k; i < count; i++) {
            YkVec t = A[i * width + k];
            A[i * width + k] = A[i * width + column];
            A[i * width + column] = t;
        }
        YkVec minus = yk_scale(-1, yk_inverse(A[k * width + k]));
        for (size_t i = k + 1; i < count; i++) {
            YkVec factor = yk_mul(A[i * width + k], minus);
            for (size_t j = k; j < width; j++)
                A[i * width + j] = yk_add_product(A[i * width + j], factor, A[k * width + j]);
        }
    }
}

static void make_unit(YkVec *row, size_t width)
{
    double sum = 0;
    for (size_t j = 0; j < width; j++) sum += yk_dot(row[j], row[j]);
    for (size_t j = 0; j < width && sum > 0; j++) row[j] = yk_scale(1 / sqrt(sum), row[j]);
}

YkMatroidStatus yk_matroid_make(YkMatroid *matroid, const YkShape *shape, const YkVec *coefficients)
{
    size_t elements = shape->unknowns + 1, width = shape->loops + 1, order[ELEMENTS_MAX];
    YkVec A[YK_SYSTEM_LOOPS_MAX * ELEMENTS_MAX], rows[ELEMENTS_MAX * ELEMENTS_MAX];
    *matroid = (YkMatroid){elements, calloc((size_t)1 << elements, 1)};
    if (!matroid->rank) return YK_MATROID_NO_MEMORY;
    memcpy(A, coefficients, yk_coefficient_count(shape) * sizeof *A);
    if (yk_complex_kernel(shape->loops, elements, A, order, clear, rows) < shape->loops) return YK_MATROID_UNCLEAR;
    for (size_t e = 0; e < elements; e++) make_unit(rows + e * width, width);
    for (size_t set = 1; set < (size_t)1 << elements; set++) {
        int rank = rank_of_rows(rows, width, elements, set);
        if (rank < 0) return YK_MATROID_UNCLEAR;
        matroid->rank[set] = (unsigned char)rank;
    }
    return YK_MATROID_MADE;
}

void yk_matroid_free(YkMatroid *matroid)
{
    free(matroid->rank);
    *matroid = (YkMatroid){0};
}
