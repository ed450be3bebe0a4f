// Singular values: of matrices made of rotations, of graded columns, and by their invariants.
#include "check.h"
#include <stdlib.h>
#include "num/dense.h"

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void a_diagonal_has_its_entries(void **state)
{
    (void)state;
    double A[9] = {3, 0, 0, 0, -2, 0, 0, 0, 1e-9}, values[3];
    yk_singular_values(3, 3, A, values);
    qsort(values, 3, sizeof *values, ascending);
    CHECK_NEAR(values[0], 1e-9, 1e-24);
    CHECK_NEAR(values[1], 2, 1e-15);
    CHECK_NEAR(values[2], 3, 1e-15);
}

// The Hilbert matrix of order 5: its condition number is published (Higham 2002, ch. 28).
static void the_hilbert_matrix_is_as_bad_as_published(void **state)
{
    (void)state;
    double A[25], values[5];
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 5; k++) A[5 * i + k] = 1.0 / (i + k + 1);
    yk_singular_values(5, 5, A, values);
    qsort(values, 5, sizeof *values, ascending);
    CHECK_NEAR(values[4] / values[0], 4.766072502e5, 1e-3);
}

// Sum of squares is the sum of squares of the entries; their product the determinant.
static void invariants_hold(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int round = 0; round < 50; round++) {
        double A[16], F[16], values[4], squares = 0, sum = 0, product = 1, scale[4];
        int pivot[4];
        for (int i = 0; i < 16; i++) {
            A[i] = F[i] = check_uniform(&seed, -1, 1);
            squares += A[i] * A[i];
        }
        yk_singular_values(4, 4, A, values);
        for (int i = 0; i < 4; i++) sum += values[i] * values[i], product *= values[i];
        CHECK_NEAR(sum, squares, 1e-13 * squares);
        yk_lu_factor(4, F, pivot, scale);
        CHECK_NEAR(product, fabs(F[0] * F[5] * F[10] * F[15]), 1e-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_diagonal_has_its_entries),
        cmocka_unit_test(the_hilbert_matrix_is_as_bad_as_published),
        cmocka_unit_test(invariants_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
