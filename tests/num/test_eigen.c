// Eigenvalues against their defining properties: trace, determinant, residual, known matrices, similarity.
#include "check.h"
#include "num/dense.h"
#include "num/eigen.h"
#include <stdlib.h>

enum { MOST = 40 };
#define PI 3.14159265358979323846

static void fill(size_t count, double *A, uint64_t *seed)
{
    for (size_t k = 0; k < count; k++) A[k] = check_uniform(seed, -1, 1);
}
static void fill_symmetric(size_t n, double *A, uint64_t *seed)
{
    fill(n * n, A, seed);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++) A[i * n + j] = A[j * n + i];
}
static void multiply(size_t n, const double *A, const double *B, double *C)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            C[i * n + j] = 0;
            for (size_t k = 0; k < n; k++) C[i * n + j] += A[i * n + k] * B[k * n + j];
        }
}

static void symmetric_vectors_satisfy_their_equation(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int trial = 0; trial < 100; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % MOST);
        double A[MOST * MOST], work[MOST * MOST], values[MOST], V[MOST * MOST];
        fill_symmetric(n, A, &seed);
        memcpy(work, A, sizeof A);
        assert_true(yk_eigen_symmetric(n, work, values, V));
        double worst = 0;
        for (size_t k = 0; k < n; k++) {
            if (k > 0) assert_true(values[k - 1] <= values[k]);
            for (size_t i = 0; i < n; i++) {
                double residual = -values[k] * V[k * n + i], dot = 0;
                for (size_t j = 0; j < n; j++) {
                    residual += A[i * n + j] * V[k * n + j];
                    dot += V[k * n + j] * V[i * n + j];
                }
                worst = fmax(worst, fmax(fabs(residual), fabs(dot - (i == k))));
            }
        }
        CHECK_NEAR(worst, 0, 2e-14 * (double)n);
    }
}

static void vectors_are_not_needed(void **state)
{
    (void)state;
    uint64_t seed = 2;
    double A[100], B[100], V[100], with[10], without[10];
    fill_symmetric(10, A, &seed);
    memcpy(B, A, sizeof A);
    assert_true(yk_eigen_symmetric(10, A, with, V));
    assert_true(yk_eigen_symmetric(10, B, without, NULL));
    assert_memory_equal(with, without, sizeof with);
}

// The chain of n equal masses and springs between walls.
static void a_chain_of_springs_has_its_frequencies(void **state)
{
    (void)state;
    const size_t n = 200;
    double *A = calloc(n * n, sizeof *A), values[200];
    assert_non_null(A);
    for (size_t i = 0; i < n; i++) {
        A[i * n + i] = 2;
        if (i > 0) A[i * n + i - 1] = A[(i - 1) * n + i] = -1;
    }
    assert_true(yk_eigen_symmetric(n, A, values, NULL));
    for (size_t k = 0; k < n; k++)
        CHECK_NEAR(values[k], 4 * pow(sin(PI / 2 * (double)(k + 1) / (double)(n + 1)), 2), 5e-13);
    free(A);
}

static void repeated_and_zero_values_are_found(void **state)
{
    (void)state;
    double ones[25], values[5], V[25];
    for (size_t k = 0; k < 25; k++) ones[k] = 3;
    assert_true(yk_eigen_symmetric(5, ones, values, V));
    for (size_t k = 0; k < 4; k++) CHECK_NEAR(values[k], 0, 1e-14);
    CHECK_NEAR(values[4], 15, 1e-13);
    double zero[9] = {0}, real[3], imaginary[3];
    assert_true(yk_eigen_symmetric(3, zero, values, V));
    for (size_t k = 0; k < 9; k++) CHECK_NEAR(V[k], k % 4 == 0, 0);
    double zero_too[9] = {0};
    assert_true(yk_eigen_general(3, zero_too, real, imaginary));
    for (size_t k = 0; k < 3; k++) {
        CHECK_NEAR(values[k], 0, 0);
        CHECK_NEAR(real[k], 0, 0);
        CHECK_NEAR(imaginary[k], 0, 0);
    }
    assert_true(yk_eigen_general(0, zero, real, imaginary) && yk_eigen_symmetric(0, zero, real, NULL));
}

static void any_unit_will_do(void **state)
{
    (void)state;
    uint64_t seed = 3;
    double A[36], plain[6], plain_i[6];
    fill_symmetric(6, A, &seed);
    double B[36], C[36], scaled[6], imaginary[6];
    for (int e = -1000; e <= 1000; e += 500) {
        for (size_t k = 0; k < 36; k++) B[k] = ldexp(A[k], e);
        memcpy(C, A, sizeof A);
        assert_true(yk_eigen_symmetric(6, B, scaled, NULL) && yk_eigen_symmetric(6, C, plain, NULL));
        for (size_t k = 0; k < 6; k++) CHECK_NEAR(ldexp(scaled[k], -e), plain[k], 0);
        for (size_t k = 0; k < 36; k++) B[k] = ldexp(A[k], e);
        memcpy(C, A, sizeof A);
        assert_true(yk_eigen_general(6, B, scaled, imaginary) && yk_eigen_general(6, C, plain, plain_i));
        for (size_t k = 0; k < 6; k++) CHECK_NEAR(ldexp(scaled[k], -e), plain[k], 0);
    }
}

// The general method on symmetric matrices: another way to the same values.
static void both_ways_agree_on_symmetric_matrices(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int trial = 0; trial < 100; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % MOST);
        double A[MOST * MOST], B[MOST * MOST], values[MOST], real[MOST], imaginary[MOST];
        fill_symmetric(n, A, &seed);
        memcpy(B, A, sizeof A);
        assert_true(yk_eigen_symmetric(n, A, values, NULL) && yk_eigen_general(n, B, real, imaginary));
        for (size_t k = 0; k < n; k++) {
            CHECK_NEAR(real[k], values[k], 1e-13 * (double)n);
            CHECK_NEAR(imaginary[k], 0, 1e-13 * (double)n);
        }
    }
}

// Sum = trace, sum of squares = trace of the square, product = determinant; pairs are conjugate and side by side.
static void check_invariants(size_t n, const double *A, const double *real, const double *imaginary)
{
    double square[MOST * MOST], trace = 0, trace2 = 0, sum = 0, sum2 = 0, scale = (double)n;
    multiply(n, A, A, square);
    for (size_t i = 0; i < n; i++) {
        trace += A[i * n + i];
        trace2 += square[i * n + i];
        sum += real[i];
        sum2 += real[i] * real[i] - imaginary[i] * imaginary[i];
    }
    CHECK_NEAR(sum, trace, 1e-13 * scale);
    CHECK_NEAR(sum2, trace2, 1e-12 * scale);
    for (size_t i = 0; i < n; i++) {
        if (i > 0) assert_true(real[i - 1] <= real[i]);
        if (imaginary[i] == 0) continue;
        assert_true(i + 1 < n && imaginary[i] > 0);
        CHECK_NEAR(real[i], real[i + 1], 0);
        CHECK_NEAR(imaginary[i], -imaginary[i + 1], 0);
        i++;
    }
}
static double determinant(size_t n, const double *A)
{
    double LU[MOST * MOST], scale[MOST], product = 1;
    int pivot[MOST];
    memcpy(LU, A, n * n * sizeof *A);
    product = yk_lu_factor(n, LU, pivot, scale);
    for (size_t k = 0; k < n; k++) product *= scale[k];
    return product;
}
static void trace_and_determinant_are_kept(void **state)
{
    (void)state;
    uint64_t seed = 5;
    size_t pairs = 0;
    for (int trial = 0; trial < 300; trial++) {
        size_t n = 1 + (size_t)(check_random(&seed) % MOST);
        double A[MOST * MOST], work[MOST * MOST], real[MOST], imaginary[MOST], re = 1, im = 0;
        fill(n * n, A, &seed);
        memcpy(work, A, sizeof A);
        assert_true(yk_eigen_general(n, work, real, imaginary));
        check_invariants(n, A, real, imaginary);
        for (size_t k = 0; k < n; k++) {
            double r = re * real[k] - im * imaginary[k];
            im = re * imaginary[k] + im * real[k];
            re = r;
            pairs += imaginary[k] > 0;
        }
        double expected = determinant(n, A);
        CHECK_NEAR(re, expected, 1e-10 * fmax(1, fabs(expected)));
        CHECK_NEAR(im, 0, 1e-10 * fmax(1, fabs(expected)));
    }
    assert_true(pairs > 500);
}

// A - lambda I is singular: a real matrix of twice the size for complex lambda. How far from dependent its columns are.
static void every_value_makes_the_matrix_singular(void **state)
{
    (void)state;
    uint64_t seed = 6;
    enum { N = 6, TWO = 2 * N };
    for (int trial = 0; trial < 100; trial++) {
        double A[N * N], work[N * N], real[N], imaginary[N];
        fill(N * N, A, &seed);
        memcpy(work, A, sizeof A);
        assert_true(yk_eigen_general(N, work, real, imaginary));
        for (size_t k = 0; k < N; k++) {
            double B[TWO * TWO] = {0}, tau[TWO];
            size_t order[TWO];
            for (size_t i = 0; i < N; i++) {
                for (size_t j = 0; j < N; j++) {
                    double entry = A[i * N + j] - (i == j ? real[k] : 0);
                    B[i * TWO + j] = B[(i + N) * TWO + j + N] = entry;
                }
                B[i * TWO + i + N] = imaginary[k];
                B[(i + N) * TWO + i] = -imaginary[k];
            }
            assert_true(yk_qr_factor(TWO, TWO, B, order, tau, 1e-12) <= TWO - 2);
        }
    }
}

// Companion matrix of the polynomial with these roots.
static void companion(size_t n, const double *roots, double *A)
{
    double c[MOST] = {1}; // leading coefficient first
    for (size_t k = 0; k < n; k++)
        for (size_t i = k + 1; i > 0; i--) c[i] -= roots[k] * c[i - 1];
    for (size_t k = 0; k < n * n; k++) A[k] = 0;
    for (size_t j = 0; j < n; j++) A[j] = -c[j + 1];
    for (size_t i = 1; i < n; i++) A[i * n + i - 1] = 1;
}
static void roots_of_known_polynomials_are_found(void **state)
{
    (void)state;
    const double roots[6] = {-3, -1.5, 0, 0.25, 2, 100};
    double A[MOST * MOST], real[MOST], imaginary[MOST];
    companion(6, roots, A);
    assert_true(yk_eigen_general(6, A, real, imaginary));
    for (size_t k = 0; k < 6; k++) {
        CHECK_NEAR(real[k], roots[k], 1e-11);
        CHECK_NEAR(imaginary[k], 0, 1e-11);
    }
}

// x^n = 1: all on a circle, where unshifted iteration and some shifts stand still.
static void roots_of_one_stand_on_the_circle(void **state)
{
    (void)state;
    for (size_t n = 2; n <= MOST; n++) {
        double A[MOST * MOST] = {0}, real[MOST], imaginary[MOST];
        A[n - 1] = 1;
        for (size_t i = 1; i < n; i++) A[i * n + i - 1] = 1;
        assert_true(yk_eigen_general(n, A, real, imaginary));
        for (size_t k = 0; k < n; k++) {
            double turns = atan2(imaginary[k], real[k]) / (2 * PI) * (double)n;
            CHECK_NEAR(hypot(real[k], imaginary[k]), 1, 1e-13);
            CHECK_NEAR(turns, round(turns), 1e-11);
        }
    }
}

// A damped oscillator: -d +- i sqrt(k - d^2); over-damped both are real, also when far apart.
static void an_oscillator_swings_or_creeps(void **state)
{
    (void)state;
    for (double d = 0; d < 1e6; d = d * 3 + 0.1) {
        double A[4] = {0, 1, -4, -2 * d}, real[2], imaginary[2];
        assert_true(yk_eigen_general(2, A, real, imaginary));
        if (d < 2) {
            CHECK_NEAR(real[0], -d, 1e-14);
            CHECK_NEAR(imaginary[0], sqrt(4 - d * d), 1e-14);
            CHECK_NEAR(imaginary[1], -imaginary[0], 0);
        } else {
            double fast = -d - sqrt(d * d - 4);
            CHECK_NEAR(real[0], fast, -1e-14 * fast);
            CHECK_NEAR(real[1], 4 / fast, 1e-10);
            CHECK_NEAR(imaginary[0], 0, 0);
        }
    }
}

// Rows and columns in wild units: balancing finds the same values.
static void bad_units_are_balanced(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int trial = 0; trial < 100; trial++) {
        double A[64], B[64], real[8], imaginary[8], real_b[8], imaginary_b[8];
        fill(64, A, &seed);
        for (int i = 0; i < 8; i++)
            for (int j = 0; j < 8; j++) B[8 * i + j] = ldexp(A[8 * i + j], 9 * (i - j));
        assert_true(yk_eigen_general(8, A, real, imaginary) && yk_eigen_general(8, B, real_b, imaginary_b));
        for (int k = 0; k < 8; k++) {
            CHECK_NEAR(real_b[k], real[k], 1e-11);
            CHECK_NEAR(imaginary_b[k], imaginary[k], 1e-11);
        }
    }
}

static void triangular_matrices_show_their_diagonal(void **state)
{
    (void)state;
    uint64_t seed = 8;
    for (int lower = 0; lower < 2; lower++) {
        double A[100], real[10], imaginary[10];
        fill(100, A, &seed);
        for (size_t i = 0; i < 10; i++)
            for (size_t j = 0; j < 10; j++)
                if (i == j)
                    A[10 * i + j] = (double)i;
                else if (lower ? j > i : j < i)
                    A[10 * i + j] = 0;
        assert_true(yk_eigen_general(10, A, real, imaginary));
        for (size_t k = 0; k < 10; k++) {
            CHECK_NEAR(real[k], (double)k, 1e-9);
            CHECK_NEAR(imaginary[k], 0, 1e-9);
        }
    }
}

static void a_large_random_matrix_fills_its_disc(void **state)
{
    (void)state;
    const size_t n = 200;
    uint64_t seed = 9;
    double *A = malloc(n * n * sizeof *A), real[200], imaginary[200], trace = 0, sum = 0, largest = 0;
    assert_non_null(A);
    fill(n * n, A, &seed);
    for (size_t k = 0; k < n; k++) trace += A[k * n + k];
    assert_true(yk_eigen_general(n, A, real, imaginary));
    for (size_t k = 0; k < n; k++) {
        sum += real[k];
        largest = fmax(largest, hypot(real[k], imaginary[k]));
    }
    CHECK_NEAR(sum, trace, 1e-11);
    CHECK_NEAR(largest / sqrt((double)n / 3), 1, 0.2); // the circular law
    free(A);
}

// --- complex matrices

static YkVec random_complex(uint64_t *seed)
{
    double x = check_uniform(seed, -1, 1), y = check_uniform(seed, -1, 1);
    return yk_vec(x, y);
}

// Returns the largest entry of A v - value v, over that of v; v is column k of vectors.
static double complex_miss(size_t n, const YkVec *A, YkVec value, const YkVec *vectors, size_t k)
{
    double most = 0, size = 0;
    for (size_t i = 0; i < n; i++) {
        YkVec sum = yk_scale(-1, yk_mul(value, vectors[i * n + k]));
        for (size_t j = 0; j < n; j++) sum = yk_add(sum, yk_mul(A[i * n + j], vectors[j * n + k]));
        most = fmax(most, yk_norm(sum));
        size = fmax(size, yk_norm(vectors[i * n + k]));
    }
    return most / size;
}

static void complex_vectors_satisfy_their_equation(void **state)
{
    (void)state;
    uint64_t seed = 21;
    for (size_t n = 1; n <= 40; n += 1 + n / 4) {
        YkVec A[1600], B[1600], values[40], vectors[1600], trace = {0, 0};
        for (size_t k = 0; k < n * n; k++) A[k] = B[k] = random_complex(&seed);
        assert_true(yk_eigen_complex(n, B, values, vectors));
        for (size_t k = 0; k < n; k++) {
            assert_true(complex_miss(n, A, values[k], vectors, k) < 1e-12 * (double)n);
            trace = yk_add(trace, yk_sub(A[k * n + k], values[k]));
        }
        assert_true(yk_norm(trace) < 1e-13 * (double)n);
    }
}

// A real matrix has the values that the real routine finds, by reflections and double shifts.
static void both_ways_agree_on_real_matrices(void **state)
{
    (void)state;
    enum { N = 12 };
    uint64_t seed = 22;
    for (int trial = 0; trial < 20; trial++) {
        double A[N * N], real[N], imaginary[N];
        YkVec B[N * N], values[N], vectors[N * N];
        fill((size_t)N * N, A, &seed);
        for (size_t k = 0; k < N * N; k++) B[k] = yk_vec(A[k], 0);
        assert_true(yk_eigen_general(N, A, real, imaginary) && yk_eigen_complex(N, B, values, vectors));
        for (size_t k = 0; k < N; k++) {
            double nearest = 1;
            for (size_t j = 0; j < N; j++)
                nearest = fmin(nearest, hypot(values[j].x - real[k], values[j].y - imaginary[k]));
            assert_true(nearest < 1e-11);
        }
    }
}

// Equal values: with a vector each where the matrix has them, and without end where it has not.
static void equal_complex_values_are_found(void **state)
{
    (void)state;
    const YkVec value = {0.5, -2};
    YkVec values[3], vectors[9], zero[9] = {{0, 0}}, jordan[4] = {value, {1, 0}, {0, 0}, value}, diagonal[9] = {{0, 0}};
    assert_true(yk_eigen_complex(3, zero, values, vectors));
    for (size_t k = 0; k < 3; k++) assert_true(values[k].x == 0 && values[k].y == 0 && vectors[4 * k].x == 1);
    YkVec tiny[4] = {{0, 0}, {1e-300, 0}, {-4e-300, 0}, {0, 0}}; // 2e-300 i and its conjugate
    assert_true(yk_eigen_complex(2, tiny, values, vectors));
    CHECK_NEAR(fabs(values[0].y), 2e-300, 1e-314);
    CHECK_NEAR(values[0].y, -values[1].y, 1e-314);
    assert_true(yk_eigen_complex(2, jordan, values, vectors));
    for (size_t k = 0; k < 2; k++) CHECK_NEAR(yk_norm(yk_sub(values[k], value)), 0, 1e-7);
    diagonal[0] = diagonal[4] = value;
    diagonal[2] = diagonal[8] = yk_vec(1, 0); // the first and the last share a plane
    YkVec A[9];
    memcpy(A, diagonal, sizeof A);
    assert_true(yk_eigen_complex(3, diagonal, values, vectors));
    for (size_t k = 0; k < 3; k++) assert_true(complex_miss(3, A, values[k], vectors, k) < 1e-14);
}

// All eigenvalues are equal, and there is one vector: its entries grow by 1/epsilon from row to row.
static void a_large_jordan_block_has_finite_vectors(void **state)
{
    (void)state;
    enum { N = 40 };
    YkVec A[N * N] = {{0, 0}}, values[N], vectors[N * N];
    for (size_t k = 0; k < N; k++) {
        A[k * (N + 1)] = yk_vec(0.5, -2);
        if (k + 1 < N) A[k * (N + 1) + 1] = yk_vec(1, 0);
    }
    YkVec B[N * N];
    memcpy(B, A, sizeof A);
    assert_true(yk_eigen_complex(N, B, values, vectors));
    for (size_t k = 0; k < N; k++) assert_true(complex_miss(N, A, values[k], vectors, k) < 1e-14);
}

static void what_is_not_a_number_is_refused(void **state)
{
    (void)state;
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (size_t i = 0; i < 3; i++) {
        double A[4] = {1, 2, bad[i], 3}, B[4] = {1, bad[i], bad[i], 3}, real[2], imaginary[2];
        assert_false(yk_eigen_general(2, A, real, imaginary));
        assert_false(yk_eigen_symmetric(2, B, real, NULL));
        YkVec C[4] = {{1, 0}, {0, bad[i]}, {2, 1}, {0, 0}}, values[2], vectors[4];
        assert_false(yk_eigen_complex(2, C, values, vectors));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(symmetric_vectors_satisfy_their_equation),
        cmocka_unit_test(vectors_are_not_needed),
        cmocka_unit_test(a_chain_of_springs_has_its_frequencies),
        cmocka_unit_test(repeated_and_zero_values_are_found),
        cmocka_unit_test(any_unit_will_do),
        cmocka_unit_test(both_ways_agree_on_symmetric_matrices),
        cmocka_unit_test(trace_and_determinant_are_kept),
        cmocka_unit_test(every_value_makes_the_matrix_singular),
        cmocka_unit_test(roots_of_known_polynomials_are_found),
        cmocka_unit_test(roots_of_one_stand_on_the_circle),
        cmocka_unit_test(an_oscillator_swings_or_creeps),
        cmocka_unit_test(bad_units_are_balanced),
        cmocka_unit_test(triangular_matrices_show_their_diagonal),
        cmocka_unit_test(a_large_random_matrix_fills_its_disc),
        cmocka_unit_test(complex_vectors_satisfy_their_equation),
        cmocka_unit_test(both_ways_agree_on_real_matrices),
        cmocka_unit_test(equal_complex_values_are_found),
        cmocka_unit_test(a_large_jordan_block_has_finite_vectors),
        cmocka_unit_test(what_is_not_a_number_is_refused),
    };
    return cmocka_run_group_tests_name("num/eigen", tests, NULL, NULL);
}
