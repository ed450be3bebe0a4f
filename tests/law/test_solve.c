// The linear system of conditions: solutions of ill-conditioned systems that are known exactly, and messages about
// systems that have none or many, in whatever unit.
#include "law/inside.h"
#include "law/law_check.h"

enum { N = 7 };

// Hilbert's matrix of seven rows times 360360, which makes its entries whole: its condition number in the 1-norm is
// 9.85e8. With a whole solution everything is exact.
static void hilbert_system(double *A, double *b, double *x, uint64_t *seed)
{
    for (int k = 0; k < N; k++) x[k] = floor(check_uniform(seed, -1000, 1000));
    for (int i = 0; i < N; i++) {
        b[i] = 0;
        for (int k = 0; k < N; k++) {
            A[i * N + k] = 360360.0 / (i + k + 1);
            b[i] += A[i * N + k] * x[k];
        }
    }
}

static void ill_conditioned_systems_are_solved_to_the_last_digit(void **state)
{
    (void)state;
    for (uint64_t seed = 1, k = 0; k < 20; k++) {
        double A[N * N], b[N], x[N], found[N], condition = 0;
        size_t culprit;
        hilbert_system(A, b, x, &seed);
        assert_int_equal(yk_law_solve(N, A, b, found, &condition, &culprit), YK_LAW_OK);
        for (int i = 0; i < N; i++) CHECK_NEAR(found[i], x[i], 1e-15 * fabs(x[i]));
        assert_true(condition > 1e8 && condition < 1e10); // 9.85e8 where rows are not scaled
    }
}

// The condition number in closed form: |A| |A^-1| of ((1, a), (0, 1)) / 2 is (1 + a)^2.
static void the_condition_number_is_that_of_the_one_norm(void **state)
{
    (void)state;
    for (double a = 0; a < 1; a += 0.125) {
        double A[4] = {1, a, 0, 1}, b[2] = {3, 4}, x[2], condition;
        size_t culprit;
        assert_int_equal(yk_law_solve(2, A, b, x, &condition, &culprit), YK_LAW_OK);
        CHECK_NEAR(condition, (1 + a) * (1 + a), 1e-15 * condition);
        CHECK_NEAR(x[0], 3 - 4 * a, 1e-15);
        CHECK_NEAR(x[1], 4, 1e-15);
    }
}

// Three equations of which the last follows from the others, or contradicts them by a part in a thousand: which it is
// does not depend on units, and a row that depends on others is blamed.
static void dependent_rows_contradict_or_leave_open_in_every_unit(void **state)
{
    (void)state;
    for (int power = -12; power <= 12; power += 3)
        for (int of = -6; of <= 6; of += 3)
            for (int good = 0; good < 2; good++) {
                double unit = pow(10, power), scale = pow(10, of);
                double A[9] = {1, 2, 3, 0, 1, -1, 2, 5, 5}, b[3] = {unit, 2 * unit, (good ? 4 : 4.004) * unit}, x[3],
                       condition;
                size_t culprit = 9;
                for (int k = 0; k < 9; k++) A[k] *= scale;
                YkLawFault fault = yk_law_solve(3, A, b, x, &condition, &culprit);
                assert_int_equal(fault, good ? YK_LAW_UNDETERMINED : YK_LAW_CONTRADICTION);
                assert_true(culprit < 3);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ill_conditioned_systems_are_solved_to_the_last_digit),
        cmocka_unit_test(the_condition_number_is_that_of_the_one_norm),
        cmocka_unit_test(dependent_rows_contradict_or_leave_open_in_every_unit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
