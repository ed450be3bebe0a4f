// Bounded systems against the definition of their answer, on random and singular ones.
#include "num/bounded.h"
#include "check.h"

enum { MOST = 6 };

typedef struct Problem {
    size_t n;
    double A[MOST * MOST], b[MOST], x[MOST], work[YK_BOUNDED_WORK(MOST)];
    YkBounds bounds[MOST];
    size_t order[YK_BOUNDED_ORDER(MOST)];
} Problem;

static double residual(const Problem *p, size_t i)
{
    double sum = p->b[i];
    for (size_t k = 0; k < p->n; k++) sum += p->A[i * p->n + k] * p->x[k];
    return sum;
}

// A = G G^T of a rank, b in its range: stops push only, friction is bounded, some unknowns are free.
static Problem make(uint64_t *seed, size_t n, size_t rank)
{
    Problem p = {.n = n};
    double G[MOST * MOST], into[MOST];
    for (size_t k = 0; k < n * rank; k++) G[k] = check_uniform(seed, -1, 1) * pow(10, check_uniform(seed, -2, 2));
    for (size_t k = 0; k < rank; k++) into[k] = check_uniform(seed, -3, 3);
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < rank; k++) p.b[i] += G[i * rank + k] * into[k];
        for (size_t j = 0; j < n; j++)
            for (size_t k = 0; k < rank; k++) p.A[i * n + j] += G[i * rank + k] * G[j * rank + k];
        double most = check_uniform(seed, 0, 3), kind = check_uniform(seed, 0, 3);
        p.bounds[i] = kind < 1   ? (YkBounds){0, HUGE_VAL}
                      : kind < 2 ? (YkBounds){-most, most}
                                 : (YkBounds){-HUGE_VAL, HUGE_VAL};
    }
    return p;
}

static void the_answer_is_what_defines_it(void **unused)
{
    (void)unused;
    uint64_t seed = 20261;
    for (int trial = 0; trial < 3000; trial++) {
        size_t n = 1 + (size_t)check_uniform(&seed, 0, MOST - 1e-9),
               rank = 1 + (size_t)check_uniform(&seed, 0, (double)n - 1e-9);
        Problem p = make(&seed, n, rank);
        assert_true(yk_bounded_solve(n, p.A, p.b, p.bounds, 5000, p.x, p.work, p.order));
        double size = 0;
        for (size_t i = 0; i < n; i++) size = fmax(size, fabs(p.x[i]));
        for (size_t i = 0; i < n; i++) {
            double r = residual(&p, i), none = 1e-11 * (fabs(p.b[i]) + p.A[i * n + i] * size);
            assert_true(p.x[i] >= p.bounds[i].low && p.x[i] <= p.bounds[i].high);
            if (p.x[i] > p.bounds[i].low) assert_true(r <= none);
            if (p.x[i] < p.bounds[i].high) assert_true(r >= -none);
        }
    }
}

// An unknown that nothing resists stays as it is, and the others are solved as if it were not there.
static void an_unknown_without_a_diagonal_entry_stays(void **unused)
{
    (void)unused;
    for (double guess = -2; guess <= 2; guess += 0.5) {
        Problem p = {.n = 3, .A = {2, 0, 1, 0, 0, 0, 1, 0, 2}, .b = {-3, 1, -3}, .x = {0, guess, 0}};
        for (size_t i = 0; i < 3; i++) p.bounds[i] = (YkBounds){-5, 5};
        assert_true(yk_bounded_solve(3, p.A, p.b, p.bounds, 100, p.x, p.work, p.order));
        CHECK_NEAR(p.x[0], 1, 1e-12);
        CHECK_NEAR(p.x[1], guess, 0);
        CHECK_NEAR(p.x[2], 1, 1e-12);
    }
}

// Two unknowns almost alike: sweeps alone creep.
static void what_creeps_is_solved_at_once(void **unused)
{
    (void)unused;
    Problem p = {.n = 2, .A = {1, 1 - 1e-9, 1 - 1e-9, 1}, .b = {-1, -1.5}, .bounds = {{-1e10, 1e10}, {-1e10, 1e10}}};
    assert_true(yk_bounded_solve(2, p.A, p.b, p.bounds, 64, p.x, p.work, p.order));
    CHECK_NEAR(residual(&p, 0), 0, 1e-6);
    CHECK_NEAR(residual(&p, 1), 0, 1e-6);
    CHECK_NEAR(p.x[1] - p.x[0], 0.5e9, 1e2);
}

static void what_is_not_found_is_told(void **unused)
{
    (void)unused;
    Problem p = {.n = 2, .A = {1, 0.5, 0.5, 1}, .b = {-1, -1}, .bounds = {{0, 9}, {0, 9}}};
    assert_false(yk_bounded_solve(2, p.A, p.b, p.bounds, 1, p.x, p.work, p.order));
    assert_true(yk_bounded_solve(2, p.A, p.b, p.bounds, 5000, p.x, p.work, p.order));
    Problem none = {.n = 2, .A = {1, 1, 1, 1}, .b = {-1, -2}, .bounds = {{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}}};
    assert_false(yk_bounded_solve(2, none.A, none.b, none.bounds, 5000, none.x, none.work, none.order));
    Problem wrong = {.n = 1, .A = {1}, .b = {NAN}, .bounds = {{0, 1}}};
    assert_false(yk_bounded_solve(1, wrong.A, wrong.b, wrong.bounds, 5000, wrong.x, wrong.work, wrong.order));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_answer_is_what_defines_it),
        cmocka_unit_test(an_unknown_without_a_diagonal_entry_stays),
        cmocka_unit_test(what_creeps_is_solved_at_once),
        cmocka_unit_test(what_is_not_found_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
