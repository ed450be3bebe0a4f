// Sparse LU against its own products, against the dense LU, on what has zeros for a diagonal, on what is singular, on
// what is large, and where memory runs out.
#include "allocations.h"
#include "check.h"

#define malloc try_malloc
#define calloc try_calloc
#define realloc try_realloc
#define free count_free
#include "../../src/num/sparse.c"
#define allocate order_allocate
#define eliminate order_eliminate
#define Tree PostorderTree
#include "../../src/num/sparse_order.c"
#include "../../src/num/sparse_postorder.c"
#undef allocate
#undef eliminate
#undef Tree
#include "../../src/num/sparse_factor.c"
#define residual solve_residual
#include "../../src/num/sparse_solve.c"
#undef residual
#undef malloc
#undef calloc
#undef realloc
#undef free
#include "num/dense.h"

enum { DENSE_MAX = 60 };

// A matrix by columns that grows entry by entry.
typedef struct Matrix {
    size_t n;
    int32_t *start, *row;
    double *value;
    size_t count;
} Matrix;

static Matrix matrix_new(size_t n, size_t room)
{
    Matrix m = {n, calloc(n + 1, sizeof(int32_t)), malloc(room * sizeof(int32_t) + 1),
                malloc(room * sizeof(double) + 1), 0};
    assert_true(m.start && m.row && m.value);
    return m;
}
static void matrix_free(Matrix *m)
{
    free(m->start);
    free(m->row);
    free(m->value);
}
// Columns in turn.
static void put(Matrix *m, size_t row, size_t column, double value)
{
    m->row[m->count] = (int32_t)row;
    m->value[m->count++] = value;
    for (size_t j = column + 1; j <= m->n; j++) m->start[j] = (int32_t)m->count;
}
// The same for long matrices: the column's end alone; every column must be put in turn.
static void put_in_turn(Matrix *m, size_t row, size_t column, double value)
{
    m->row[m->count] = (int32_t)row;
    m->value[m->count++] = value;
    m->start[column + 1] = (int32_t)m->count;
}

static void multiply(const Matrix *m, const double *x, double *out)
{
    for (size_t i = 0; i < m->n; i++) out[i] = 0;
    for (size_t j = 0; j < m->n; j++)
        for (int32_t k = m->start[j]; k < m->start[j + 1]; k++) out[m->row[k]] += m->value[k] * x[j];
}

// Random entries; a permuted diagonal among them makes a full matching certain.
static Matrix random_matrix(size_t n, double density, uint64_t *seed)
{
    Matrix m = matrix_new(n, n * n + n);
    size_t offset = check_random(seed) % n;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++)
            if (i == (j + offset) % n || check_uniform(seed, 0, 1) < density) {
                double value = check_uniform(seed, -1, 1);
                put(&m, i, j, value * pow(10, check_uniform(seed, -2, 2)));
            }
    return m;
}

static double residual_of(const Matrix *m, const double *x, const double *b)
{
    double *r = malloc((m->n + 1) * sizeof *r), worst = 0, largest = 0;
    multiply(m, x, r);
    for (size_t i = 0; i < m->n; i++) {
        worst = fmax(worst, fabs(r[i] - b[i]));
        largest = fmax(largest, fabs(x[i]));
    }
    free(r);
    double norm = 0;
    for (size_t k = 0; k < m->count; k++) norm = fmax(norm, fabs(m->value[k]));
    return worst / (norm * largest);
}

static void dense_of(const Matrix *m, double *A)
{
    memset(A, 0, m->n * m->n * sizeof *A);
    for (size_t j = 0; j < m->n; j++)
        for (int32_t k = m->start[j]; k < m->start[j + 1]; k++) A[(size_t)m->row[k] * m->n + j] = m->value[k];
}

static void check_solution(const Matrix *m, uint64_t *seed)
{
    double b[DENSE_MAX], x[DENSE_MAX];
    YkSparse *s = yk_sparse_new(m->n, m->start, m->row);
    assert_non_null(s);
    if (yk_sparse_factor(s, m->value, NULL) > 1e-6) {
        for (int refine = 0; refine < 2; refine++) {
            for (size_t i = 0; i < m->n; i++) x[i] = b[i] = check_uniform(seed, -1, 1);
            yk_sparse_solve(s, x, refine);
            assert_true(residual_of(m, x, b) < (refine ? 1e-15 : 1e-13) * (double)(m->n + 1));
        }
    }
    yk_sparse_free(s);
}

static void test_solutions_satisfy_random_systems(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (int round = 0; round < 400; round++) {
        size_t n = 1 + check_random(&seed) % DENSE_MAX;
        Matrix m = random_matrix(n, check_uniform(&seed, 0, 0.3), &seed);
        check_solution(&m, &seed);
        matrix_free(&m);
    }
    assert_int_equal(live, 0);
}

static void test_sparse_and_dense_agree(void **unused)
{
    (void)unused;
    static double A[DENSE_MAX * DENSE_MAX], scale[DENSE_MAX];
    int pivot[DENSE_MAX];
    double x[DENSE_MAX], y[DENSE_MAX];
    uint64_t seed = 11;
    for (int round = 0; round < 200; round++) {
        size_t n = 2 + check_random(&seed) % (DENSE_MAX - 2);
        Matrix m = random_matrix(n, 0.2, &seed);
        YkSparse *s = yk_sparse_new(n, m.start, m.row);
        double ratio = yk_sparse_factor(s, m.value, NULL);
        dense_of(&m, A);
        if (ratio > 1e-4 && yk_lu_factor(n, A, pivot, scale) != 0) {
            double largest = 0;
            for (size_t i = 0; i < n; i++) x[i] = y[i] = check_uniform(&seed, -1, 1);
            yk_sparse_solve(s, x, true);
            yk_lu_solve(n, A, pivot, y);
            for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(y[i]));
            for (size_t i = 0; i < n; i++) CHECK_NEAR(x[i], y[i], 1e-8 * largest);
        }
        yk_sparse_free(s);
        matrix_free(&m);
    }
}

// [M A; A^T 0] has zeros on half its diagonal; its solution is M^-1-orthogonal to A.
static void test_saddle_points_with_a_zero_diagonal_are_solved(void **unused)
{
    (void)unused;
    enum { N = 8, C = 5 };
    uint64_t seed = 3;
    double a[N][C], b[N + C], x[N + C];
    Matrix m = matrix_new(N + C, (N + C) * (N + C));
    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < C; j++) a[i][j] = check_uniform(&seed, -1, 1);
    for (size_t i = 0; i < N; i++) {
        put(&m, i, i, 1e-3 * (double)(i + 1));
        for (size_t j = 0; j < C; j++) put(&m, N + j, i, a[i][j]);
    }
    for (size_t j = 0; j < C; j++)
        for (size_t i = 0; i < N; i++) put(&m, i, N + j, a[i][j]);
    YkSparse *s = yk_sparse_new(m.n, m.start, m.row);
    assert_true(yk_sparse_factor(s, m.value, NULL) > 1e-6);
    for (size_t i = 0; i < N + C; i++) x[i] = b[i] = i < N ? check_uniform(&seed, -1, 1) : 0;
    yk_sparse_solve(s, x, true);
    assert_true(residual_of(&m, x, b) < 1e-15);
    for (size_t j = 0; j < C; j++) {
        double sum = 0, largest = 0;
        for (size_t i = 0; i < N; i++) {
            sum += a[i][j] * x[i];
            largest = fmax(largest, fabs(x[i]));
        }
        CHECK_NEAR(sum, 0, 1e-14 * largest);
    }
    yk_sparse_free(s);
    matrix_free(&m);
}

static void test_a_column_without_a_pivot_is_named(void **unused)
{
    (void)unused;
    Matrix m = matrix_new(4, 16); // columns 1 and 2 have row 1 alone
    put(&m, 0, 0, 2);
    put(&m, 1, 1, 3);
    put(&m, 1, 2, 4);
    put(&m, 2, 3, 5);
    put(&m, 3, 3, 6);
    YkSparse *s = yk_sparse_new(4, m.start, m.row);
    int32_t column = -1;
    CHECK_NEAR(yk_sparse_factor(s, m.value, &column), 0, 0);
    assert_true(column == 1 || column == 2);
    yk_sparse_free(s);
    matrix_free(&m);
}

static void test_dependent_columns_are_singular_and_nearly_dependent_ones_show_how_nearly(void **unused)
{
    (void)unused;
    double off[] = {0, 1e-6, 1e-3};
    for (int k = 0; k < 3; k++) {
        Matrix m = matrix_new(3, 9);
        double third[3] = {1 + 4, 2 + 5, 3 + 6 + off[k]};
        for (size_t i = 0; i < 3; i++) put(&m, i, 0, (double)i + 1);
        for (size_t i = 0; i < 3; i++) put(&m, i, 1, (double)i + 4);
        for (size_t i = 0; i < 3; i++) put(&m, i, 2, third[i]);
        YkSparse *s = yk_sparse_new(3, m.start, m.row);
        double ratio = yk_sparse_factor(s, m.value, NULL);
        if (k == 0) CHECK_NEAR(ratio, 0, 0);
        if (k > 0) assert_true(ratio > 0.01 * off[k] && ratio < off[k]);
        yk_sparse_free(s);
        matrix_free(&m);
    }
}

static void test_what_is_no_number_is_singular_or_gives_no_number(void **unused)
{
    (void)unused;
    double bad[] = {NAN, INFINITY};
    for (int k = 0; k < 2; k++) {
        Matrix m = matrix_new(2, 4);
        put(&m, 0, 0, 1);
        put(&m, 1, 0, bad[k]);
        put(&m, 0, 1, 2);
        put(&m, 1, 1, 1);
        YkSparse *s = yk_sparse_new(2, m.start, m.row);
        double ratio = yk_sparse_factor(s, m.value, NULL), x[2] = {1, 1};
        if (ratio > 0) {
            yk_sparse_solve(s, x, false);
            assert_false(isfinite(x[0]) && isfinite(x[1]));
        }
        m.value[1] = 3; // and the next factorisation is none the worse
        assert_true(yk_sparse_factor(s, m.value, NULL) > 0.1);
        double b[2] = {1, 1}, y[2] = {1, 1};
        yk_sparse_solve(s, y, false);
        assert_true(residual_of(&m, y, b) < 1e-15);
        yk_sparse_free(s);
        matrix_free(&m);
    }
}

static void test_nothing_and_one_are_systems_too(void **unused)
{
    (void)unused;
    int32_t start[2] = {0, 1}, row[1] = {0};
    double value[1] = {4}, b[1] = {2};
    YkSparse *none = yk_sparse_new(0, start, row), *one = yk_sparse_new(1, start, row);
    assert_true(yk_sparse_factor(none, value, NULL) > 0);
    yk_sparse_solve(none, b, true);
    CHECK_NEAR(yk_sparse_factor(one, value, NULL), 1, 0);
    yk_sparse_solve(one, b, true);
    CHECK_NEAR(b[0], 0.5, 0);
    value[0] = 0;
    CHECK_NEAR(yk_sparse_factor(one, value, NULL), 0, 0);
    yk_sparse_free(none);
    yk_sparse_free(one);
    yk_sparse_free(NULL);
}

static void test_the_same_pattern_is_factored_again_without_allocating(void **unused)
{
    (void)unused;
    uint64_t seed = 21;
    Matrix m = random_matrix(50, 0.1, &seed);
    double b[50], x[50];
    YkSparse *s = yk_sparse_new(m.n, m.start, m.row);
    for (int round = 0; round < 20; round++) {
        if (round == 1) yk_sparse_factor(s, m.value, NULL);
        long before = requests;
        yk_sparse_factor(s, m.value, NULL);
        for (size_t i = 0; i < m.n; i++) x[i] = b[i] = check_uniform(&seed, -1, 1);
        yk_sparse_solve(s, x, true);
        if (round > 0) assert_int_equal(requests, before);
        assert_true(residual_of(&m, x, b) < 1e-13);
        for (size_t k = 0; k < m.count; k++) m.value[k] *= 1 + 1e-3 * (double)round / 20;
    }
    yk_sparse_free(s);
    matrix_free(&m);
}

static void check_permutation(const int32_t *order, size_t n)
{
    bool *seen = calloc(n + 1, sizeof *seen);
    for (size_t k = 0; k < n; k++) {
        assert_true(order[k] >= 0 && (size_t)order[k] < n && !seen[order[k]]);
        seen[order[k]] = true;
    }
    free(seen);
}

// Fill of a large matrix, after a solution that satisfies it.
static size_t solve_large(const Matrix *m)
{
    YkSparse *s = yk_sparse_new(m->n, m->start, m->row);
    assert_non_null(s);
    check_permutation(s->order, m->n);
    assert_true(yk_sparse_factor(s, m->value, NULL) > 0);
    double *x = malloc(m->n * sizeof *x), *b = malloc(m->n * sizeof *b);
    for (size_t i = 0; i < m->n; i++) x[i] = b[i] = sin((double)i);
    yk_sparse_solve(s, x, true);
    assert_true(residual_of(m, x, b) < 1e-14);
    size_t fill = s->L.count + s->U.count;
    yk_sparse_free(s);
    free(x);
    free(b);
    return fill;
}

static void test_long_bands_fill_linearly(void **unused)
{
    (void)unused;
    size_t fill[2];
    for (int k = 0; k < 2; k++) {
        size_t n = k ? 100000 : 10000;
        Matrix m = matrix_new(n, 5 * n);
        uint64_t seed = 5;
        for (size_t j = 0; j < n; j++) // numbered at random along the band, so that the order has to find it
            for (size_t i = j > 2 ? j - 2 : 0; i <= j + 2 && i < n; i++)
                put_in_turn(&m, (i * 7919) % n, j, check_uniform(&seed, 0.5, 1) * (i == j ? 0 : 1));
        fill[k] = solve_large(&m);
        matrix_free(&m);
    }
    assert_true(fill[0] < 12 * 10000);
    assert_true(fill[1] < 11 * fill[0]);
}

// A grid of k x k: nested dissection would fill as n log n; a minimum degree keeps within a small factor.
static void test_grids_fill_moderately(void **unused)
{
    (void)unused;
    enum { K = 100 };
    Matrix m = matrix_new(K * K, 5 * K * K);
    for (size_t j = 0; j < K * K; j++) {
        size_t x = j % K, y = j / K;
        if (y > 0) put_in_turn(&m, j - K, j, -1);
        if (x > 0) put_in_turn(&m, j - 1, j, -1);
        put_in_turn(&m, j, j, 4.1);
        if (x + 1 < K) put_in_turn(&m, j + 1, j, -1);
        if (y + 1 < K) put_in_turn(&m, j + K, j, -1);
    }
    assert_true(solve_large(&m) < 150 * K * K);
    matrix_free(&m);
}

// A row and a column that are full would join everything if they took part in the order.
static void test_arrows_stay_sparse(void **unused)
{
    (void)unused;
    size_t n = 50000;
    Matrix m = matrix_new(n, 4 * n);
    for (size_t i = 0; i < n; i++) put_in_turn(&m, i, 0, 1); // a full column
    for (size_t j = 1; j < n; j++) {
        put_in_turn(&m, 0, j, 1e-3); // a full row
        put_in_turn(&m, j, j, 2);
    }
    assert_true(solve_large(&m) < 4 * n);
    matrix_free(&m);
}

static bool use_sparse(void)
{
    uint64_t seed = 5;
    Matrix m = random_matrix(30, 0.4, &seed);
    YkSparse *s = yk_sparse_new(m.n, m.start, m.row);
    double ratio = s ? yk_sparse_factor(s, m.value, NULL) : -1;
    if (s && ratio < 0) { // it can be tried again
        countdown = -1;
        assert_true(yk_sparse_factor(s, m.value, NULL) > 0);
    }
    yk_sparse_free(s);
    matrix_free(&m);
    return ratio >= 0;
}

static void test_every_allocation_may_fail(void **unused)
{
    (void)unused;
    for (long k = 0; k < 100; k++) {
        countdown = k;
        bool well = use_sparse();
        bool reached = well && countdown >= 0;
        countdown = -1;
        assert_int_equal(live, 0);
        if (reached) {
            assert_true(k >= 5);
            return;
        }
        assert_false(well && k == 0);
    }
    fail();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solutions_satisfy_random_systems),
        cmocka_unit_test(test_sparse_and_dense_agree),
        cmocka_unit_test(test_saddle_points_with_a_zero_diagonal_are_solved),
        cmocka_unit_test(test_a_column_without_a_pivot_is_named),
        cmocka_unit_test(test_dependent_columns_are_singular_and_nearly_dependent_ones_show_how_nearly),
        cmocka_unit_test(test_what_is_no_number_is_singular_or_gives_no_number),
        cmocka_unit_test(test_nothing_and_one_are_systems_too),
        cmocka_unit_test(test_the_same_pattern_is_factored_again_without_allocating),
        cmocka_unit_test(test_long_bands_fill_linearly),
        cmocka_unit_test(test_grids_fill_moderately),
        cmocka_unit_test(test_arrows_stay_sparse),
        cmocka_unit_test(test_every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
