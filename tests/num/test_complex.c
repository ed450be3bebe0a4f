// Complex linear systems: solutions satisfy their equations, kernels are kernels, singular matrices are refused.
#include "num/complex.h"
#include "check.h"

enum { N = 9 };

static void fill(YkVec *A, size_t count, uint64_t *seed)
{
    for (size_t k = 0; k < count; k++) {
        A[k].x = check_uniform(seed, -1, 1);
        A[k].y = check_uniform(seed, -1, 1);
    }
}

static YkVec row_times(const YkVec *row, const YkVec *x, size_t step, size_t n)
{
    YkVec sum = {0, 0};
    for (size_t k = 0; k < n; k++) sum = yk_add_product(sum, row[k], x[k * step]);
    return sum;
}

static void test_solutions_satisfy_their_equations(void **unused)
{
    (void)unused;
    uint64_t seed = 1;
    for (size_t n = 1; n <= N; n++)
        for (int trial = 0; trial < 50; trial++) {
            YkVec A[N * N], LU[N * N], b[N], x[N];
            int pivot[N];
            fill(A, n * n, &seed);
            fill(b, n, &seed);
            if (trial % 2 && n > 1) A[0] = yk_vec(0, 0); // needs a row exchange
            memcpy(LU, A, n * n * sizeof *A);
            memcpy(x, b, n * sizeof *b);
            assert_true(yk_complex_factor(n, LU, pivot));
            yk_complex_solve(n, LU, pivot, x);
            for (size_t i = 0; i < n; i++) {
                double size = 1;
                for (size_t k = 0; k < n; k++) size += yk_norm(x[k]);
                CHECK_NEAR(yk_norm(yk_sub(row_times(A + i * n, x, 1, n), b[i])), 0, 1e-14 * size);
            }
        }
}

static void test_kernels_are_annihilated_and_have_the_right_dimension(void **unused)
{
    (void)unused;
    uint64_t seed = 2;
    for (size_t m = 1; m <= 4; m++)
        for (size_t n = m; n <= N; n++)
            for (int dependent = 0; dependent < (m > 1 ? 2 : 1); dependent++) {
                YkVec A[4 * N], copy[4 * N], kernel[N * N];
                size_t order[N];
                fill(A, m * n, &seed);
                for (size_t k = 0; dependent && k < n; k++) A[(m - 1) * n + k] = yk_mul(yk_vec(0.3, 2), A[k]);
                memcpy(copy, A, m * n * sizeof *A);
                size_t rank = yk_complex_kernel(m, n, copy, order, 1e-12, kernel), free_count = n - rank;
                assert_int_equal(rank, m - (size_t)dependent);
                for (size_t i = 0; i < m; i++)
                    for (size_t j = 0; j < free_count; j++)
                        CHECK_NEAR(yk_norm(row_times(A + i * n, kernel + j, free_count, n)), 0, 1e-11);
                for (size_t j = 0; j < free_count; j++) { // a basis: its rows hold those of the identity
                    assert_true(kernel[order[rank + j] * free_count + j].x == 1);
                    for (size_t k = 0; k < free_count; k++)
                        assert_true(k == j || yk_norm(kernel[order[rank + j] * free_count + k]) == 0);
                }
            }
}

static void test_singular_matrices_are_refused(void **unused)
{
    (void)unused;
    int pivot[2];
    YkVec A[4] = {{1, 1}, {2, 0}, {2, 2}, {4, 0}}, not_a_number[4] = {{NAN, 0}, {1, 0}, {0, 1}, {1, 1}};
    assert_false(yk_complex_factor(2, A, pivot));
    assert_false(yk_complex_factor(2, not_a_number, pivot));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solutions_satisfy_their_equations),
        cmocka_unit_test(test_kernels_are_annihilated_and_have_the_right_dimension),
        cmocka_unit_test(test_singular_matrices_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
