// LU and QR against their defining properties: residuals, known ranks, determinants of known matrices.
#include "check.h"
#include "num/dense.h"

enum { MOST = 24 };

static void fill(double *A, size_t count, uint64_t *seed)
{
    for (size_t k = 0; k < count; k++) A[k] = check_uniform(seed, -1, 1);
}

static void times(size_t m, size_t n, const double *A, const double *x, double *b)
{
    for (size_t i = 0; i < m; i++) {
        b[i] = 0;
        for (size_t j = 0; j < n; j++) b[i] += A[i * n + j] * x[j];
    }
}

// A matrix of known rank: the product of m x r and r x n random ones.
static void fill_of_rank(size_t m, size_t n, size_t r, double *A, uint64_t *seed)
{
    double left[MOST * MOST], right[MOST * MOST];
    fill(left, m * r, seed);
    fill(right, r * n, seed);
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++) {
            A[i * n + j] = 0;
            for (size_t k = 0; k < r; k++) A[i * n + j] += left[i * r + k] * right[k * n + j];
        }
}

// Leibniz by cofactors along the first row: slow, and nothing like elimination.
static double determinant(size_t n, const double *A)
{
    if (n == 1) return A[0];
    double sum = 0, minor[36];
    for (size_t c = 0; c < n; c++) {
        for (size_t i = 1; i < n; i++)
            for (size_t j = 0, k = 0; j < n; j++)
                if (j != c) minor[(i - 1) * (n - 1) + k++] = A[i * n + j];
        sum += (c % 2 ? -1 : 1) * A[c] * determinant(n - 1, minor);
    }
    return sum;
}

static double column_length(size_t n, const double *A, size_t j)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += A[i * n + j] * A[i * n + j];
    return sqrt(sum);
}

static void lu_returns_the_right_side(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int trial = 0; trial < 400; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % MOST);
        double A[MOST * MOST], LU[MOST * MOST], x[MOST], b[MOST], scale[MOST];
        int pivot[MOST];
        fill(A, n * n, &seed);
        fill(x, n, &seed);
        times(n, n, A, x, b);
        memcpy(LU, A, sizeof A);
        double det = yk_lu_factor(n, LU, pivot, scale);
        assert_true(det != 0);
        double back[MOST], error = 0;
        double solved[MOST];
        memcpy(solved, b, sizeof b);
        yk_lu_solve(n, LU, pivot, solved);
        times(n, n, A, solved, back);
        for (size_t i = 0; i < n; i++) error = fmax(error, fabs(back[i] - b[i]));
        if (error > 1e-11) print_error("trial %d of seed 1\n", trial);
        CHECK_NEAR(error, 0, 1e-11); // backward stable: the residual does not see the condition number
    }
}

static void lu_gives_the_determinant_over_the_column_lengths(void **state)
{
    (void)state;
    uint64_t seed = 2;
    for (int trial = 0; trial < 300; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % 6);
        double A[36], LU[36], scale[6], expected;
        int pivot[6];
        fill(A, n * n, &seed);
        expected = determinant(n, A);
        for (size_t j = 0; j < n; j++) expected /= column_length(n, A, j);
        memcpy(LU, A, sizeof A);
        double det = yk_lu_factor(n, LU, pivot, scale);
        CHECK_NEAR(det, expected, 1e-13);
        assert_true(fabs(det) <= 1 + 1e-12); // Hadamard
    }
}

static void the_determinant_does_not_depend_on_the_length_of_columns(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int trial = 0; trial < 100; trial++) {
        double A[16], B[16], scale[4];
        int pivot[4];
        fill(A, 16, &seed);
        for (size_t k = 0; k < 16; k++) B[k] = A[k] * pow(10, (double)(k % 4) * 3 - 4);
        double a = yk_lu_factor(4, A, pivot, scale), b = yk_lu_factor(4, B, pivot, scale);
        CHECK_NEAR(a, b, 1e-13);
    }
}

static void lu_says_when_columns_are_dependent(void **state)
{
    (void)state;
    double zero_column[] = {1, 0, 3, 0}, twins[] = {1, 2, 2, 4}, nothing[] = {0}, scale[2];
    int pivot[2];
    CHECK_NEAR(yk_lu_factor(2, zero_column, pivot, scale), 0, 0);
    CHECK_NEAR(yk_lu_factor(2, twins, pivot, scale), 0, 0);
    CHECK_NEAR(yk_lu_factor(1, nothing, pivot, scale), 0, 0);
    double right_angle[] = {0, 5, -3, 0}; // needs a row exchange; columns at right angles: +-1
    CHECK_NEAR(yk_lu_factor(2, right_angle, pivot, scale), 1, 1e-16);
}

static void qr_finds_the_rank_of_a_product(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int trial = 0; trial < 400; trial++) {
        size_t m = 1 + (size_t)(check_random(&seed) % MOST), n = 1 + (size_t)(check_random(&seed) % MOST);
        size_t most = m < n ? m : n, r = (size_t)(check_random(&seed) % (most + 1));
        double A[MOST * MOST], tau[MOST];
        size_t order[MOST], seen = 0;
        fill_of_rank(m, n, r, A, &seed);
        size_t rank = yk_qr_factor(m, n, A, order, tau, 1e-10);
        if (rank != r) print_error("trial %d of seed 4: %zu x %zu\n", trial, m, n);
        assert_int_equal(rank, r);
        for (size_t j = 0; j < n; j++) seen |= (size_t)1 << order[j];
        assert_int_equal(seen, ((size_t)1 << n) - 1); // a permutation
    }
}

static void the_diagonal_of_r_falls(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int trial = 0; trial < 100; trial++) {
        double A[MOST * MOST], tau[MOST];
        size_t order[MOST], n = 2 + (size_t)(check_random(&seed) % 20);
        fill(A, n * n, &seed);
        assert_int_equal(yk_qr_factor(n, n, A, order, tau, 1e-14), n);
        for (size_t k = 1; k < n; k++) assert_true(fabs(A[k * n + k]) <= fabs(A[(k - 1) * n + k - 1]) * (1 + 1e-12));
    }
}

// Least squares: the residual stands at right angles on every column, whatever the rank.
static void qr_leaves_a_residual_at_right_angles(void **state)
{
    (void)state;
    uint64_t seed = 6;
    for (int trial = 0; trial < 400; trial++) {
        size_t m = 1 + (size_t)(check_random(&seed) % MOST), n = 1 + (size_t)(check_random(&seed) % MOST);
        size_t most = m < n ? m : n, r = (size_t)(check_random(&seed) % (most + 1)), nonzero = 0;
        double A[MOST * MOST], QR[MOST * MOST], tau[MOST], b[MOST], right[MOST], x[MOST], Ax[MOST];
        size_t order[MOST];
        fill_of_rank(m, n, r, A, &seed);
        fill(b, m, &seed);
        memcpy(QR, A, sizeof A);
        memcpy(right, b, sizeof b);
        size_t rank = yk_qr_factor(m, n, QR, order, tau, 1e-10);
        yk_qr_solve(m, n, QR, order, tau, rank, right, x);
        times(m, n, A, x, Ax);
        for (size_t j = 0; j < n; j++) {
            double along = 0;
            for (size_t i = 0; i < m; i++) along += A[i * n + j] * (b[i] - Ax[i]);
            CHECK_NEAR(along, 0, 1e-8);
            nonzero += x[j] != 0;
        }
        assert_true(nonzero <= rank); // the basic solution
    }
}

static void the_transpose_is_solved_by_the_same_factors(void **state)
{
    (void)state;
    uint64_t seed = 8;
    for (int trial = 0; trial < 400; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % MOST), m = n + (size_t)(check_random(&seed) % (MOST - n + 1));
        double A[MOST * MOST], QR[MOST * MOST], tau[MOST], b[MOST], x[MOST];
        size_t order[MOST];
        fill_of_rank(m, n, n, A, &seed);
        fill(b, n, &seed);
        memcpy(QR, A, sizeof A);
        assert_int_equal(yk_qr_factor(m, n, QR, order, tau, 1e-10), n);
        yk_qr_solve_transposed(m, n, QR, order, tau, b, x);
        for (size_t j = 0; j < n; j++) {
            double sum = 0;
            for (size_t i = 0; i < m; i++) sum += A[i * n + j] * x[i];
            CHECK_NEAR(sum, b[j], 1e-8);
        }
    }
}

static void a_zero_matrix_has_rank_zero_and_solution_zero(void **state)
{
    (void)state;
    double A[12] = {0}, tau[3], b[] = {1, 2, 3, 4}, x[] = {7, 7, 7};
    size_t order[3];
    assert_int_equal(yk_qr_factor(4, 3, A, order, tau, 1e-12), 0);
    yk_qr_solve(4, 3, A, order, tau, 0, b, x);
    for (size_t j = 0; j < 3; j++) CHECK_NEAR(x[j], 0, 0);
}

static void the_tolerance_decides_what_counts(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        double A[] = {1, 0, 0, 1e-6}, tau[2];
        size_t order[2];
        assert_int_equal(yk_qr_factor(2, 2, A, order, tau, k ? 1e-5 : 1e-7), k ? 1 : 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lu_returns_the_right_side),
        cmocka_unit_test(lu_gives_the_determinant_over_the_column_lengths),
        cmocka_unit_test(the_determinant_does_not_depend_on_the_length_of_columns),
        cmocka_unit_test(lu_says_when_columns_are_dependent),
        cmocka_unit_test(qr_finds_the_rank_of_a_product),
        cmocka_unit_test(the_diagonal_of_r_falls),
        cmocka_unit_test(qr_leaves_a_residual_at_right_angles),
        cmocka_unit_test(the_transpose_is_solved_by_the_same_factors),
        cmocka_unit_test(a_zero_matrix_has_rank_zero_and_solution_zero),
        cmocka_unit_test(the_tolerance_decides_what_counts),
    };
    return cmocka_run_group_tests_name("num/dense", tests, NULL, NULL);
}
