// Linear programs against all their corners.
#include "num/linear_program.h"
#include "num/dense.h"
#include "check.h"

enum { ROWS = 9, MOST = 3 };

// The largest value at any corner that n of the rows make; -HUGE_VAL where there is none.
static double best_corner(size_t m, size_t n, const double *A, const double *b, const double *c)
{
    double best = -HUGE_VAL;
    for (unsigned set = 0; set < 1u << m; set++) {
        double M[MOST * MOST], x[MOST], scale[MOST];
        int pivot[MOST];
        size_t count = 0;
        for (size_t i = 0; i < m; i++) {
            if (!(set >> i & 1)) continue;
            for (size_t k = 0; k < n && count < n; k++) M[count * n + k] = A[i * n + k];
            if (count < n) x[count] = b[i];
            count++;
        }
        if (count != n || fabs(yk_lu_factor(n, M, pivot, scale)) < 1e-9) continue;
        yk_lu_solve(n, M, pivot, x);
        bool is_allowed = true;
        double value = 0;
        for (size_t i = 0; i < m; i++) {
            double sum = -b[i];
            for (size_t k = 0; k < n; k++) sum += A[i * n + k] * x[k];
            is_allowed = is_allowed && sum <= 1e-9;
        }
        for (size_t k = 0; k < n; k++) value += c[k] * x[k];
        if (is_allowed) best = fmax(best, value);
    }
    return best;
}

static void the_best_corner_is_found(void **unused)
{
    (void)unused;
    uint64_t seed = 20262;
    size_t bounded = 0, unbounded = 0;
    for (int trial = 0; trial < 2000; trial++) {
        size_t n = 1 + (size_t)check_uniform(&seed, 0, MOST - 1e-9),
               m = n + (size_t)check_uniform(&seed, 0, ROWS - n + 0.999);
        double A[ROWS * MOST], b[ROWS], c[MOST], x[MOST], work[YK_LINEAR_WORK(ROWS, MOST)];
        size_t order[YK_LINEAR_ORDER(ROWS, MOST)];
        for (size_t k = 0; k < m * n; k++) A[k] = check_uniform(&seed, -1, 1);
        for (size_t i = 0; i < m; i++) b[i] = fmax(check_uniform(&seed, -0.5, 1), 0); // many corners at 0
        for (size_t k = 0; k < n; k++) c[k] = check_uniform(&seed, -1, 1);
        YkLinearStatus status = yk_linear_maximise(m, n, A, b, c, x, work, order);
        double best = best_corner(m, n, A, b, c);
        if (status == YK_LINEAR_UNBOUNDED) { // in a box it would grow with the box
            unbounded++;
            continue;
        }
        assert_int_equal(status, YK_LINEAR_OK);
        bounded++;
        double value = 0;
        for (size_t k = 0; k < n; k++) value += c[k] * x[k];
        CHECK_NEAR(value, best, 1e-9 * (1 + fabs(best)));
        for (size_t i = 0; i < m; i++) {
            double sum = -b[i];
            for (size_t k = 0; k < n; k++) sum += A[i * n + k] * x[k];
            assert_true(sum <= 1e-10);
        }
    }
    assert_true(bounded > 500 && unbounded > 100);
}

// A ray c . d > 0, A d <= 0 is what makes it unbounded: seen by rows that close it.
static void a_program_without_a_largest_value_says_so(void **unused)
{
    (void)unused;
    double A[] = {1, -1, -1, -1}, b[] = {0, 2}, up[] = {1, 1}, down[] = {0, -1}, x[2], work[YK_LINEAR_WORK(2, 2)];
    size_t order[YK_LINEAR_ORDER(2, 2)];
    assert_int_equal(yk_linear_maximise(2, 2, A, b, up, x, work, order), YK_LINEAR_UNBOUNDED);
    assert_int_equal(yk_linear_maximise(2, 2, A, b, down, x, work, order), YK_LINEAR_OK);
    CHECK_NEAR(x[1], -1, 1e-12); // x - y <= 0 and -x - y <= 2 meet there
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_best_corner_is_found),
        cmocka_unit_test(a_program_without_a_largest_value_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
