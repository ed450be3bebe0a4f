// The damped step within bounds against closed forms: columns that are orthogonal leave each unknown to itself, and any
// others have the normal equations, which a step fulfils wherever it does not end at a bound.
#include "check.h"
#include "synthesis/least_squares.h"

enum { ROWS = 7, MOST = 5 };

typedef struct Bounded {
    double row[ROWS * MOST], miss[ROWS], at[MOST], low[MOST], high[MOST], A[(ROWS + MOST) * MOST], b[ROWS + MOST];
    size_t n;
} Bounded;

static YkLinear linear_of(Bounded *p)
{
    return (YkLinear){p->n, ROWS, p->row, p->miss, p->at, p->low, p->high, p->A, p->b};
}

// Draws a problem that starts inside its bounds, at one of them, or with an empty range.
static void draw(Bounded *p, uint64_t *seed)
{
    p->n = 1 + check_random(seed) % MOST;
    for (size_t k = 0; k < ROWS * MOST; k++) p->row[k] = check_uniform(seed, -1, 1);
    for (size_t r = 0; r < ROWS; r++) p->miss[r] = check_uniform(seed, -.5, .5);
    for (size_t j = 0; j < p->n; j++) {
        uint64_t kind = check_random(seed) % 8;
        p->at[j] = check_uniform(seed, -2, 2);
        p->low[j] = kind < 2 ? p->at[j] : p->at[j] - check_uniform(seed, .01, .5);
        p->high[j] = kind == 0 || kind == 2 ? p->at[j] : p->at[j] + check_uniform(seed, .01, .5);
    }
}

static double dot(const double *row, size_t n, size_t i, const double *other, size_t m, size_t k)
{
    double sum = 0;
    for (size_t r = 0; r < ROWS; r++) sum += row[r * n + i] * other[r * m + k];
    return sum;
}

// Makes the columns orthogonal, of lengths that differ; a column of zeros changes nothing and is left alone.
static void part(Bounded *p, uint64_t *seed)
{
    for (size_t j = 0; j < p->n; j++) {
        for (size_t i = 0; i < j; i++) {
            double part = dot(p->row, p->n, i, p->row, p->n, j) / dot(p->row, p->n, i, p->row, p->n, i);
            for (size_t r = 0; r < ROWS; r++) p->row[r * p->n + j] -= part * p->row[r * p->n + i];
        }
        double size = check_uniform(seed, .1, 10);
        for (size_t r = 0; r < ROWS; r++) p->row[r * p->n + j] *= size;
    }
}

static void orthogonal_columns_step_apart_as_far_as_their_bounds(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (uint64_t run = 0; run < check_cases(2000); run++) {
        Bounded p;
        double x[MOST], damping = check_random(&seed) % 2 ? check_uniform(&seed, 1e-3, 2) : 1e-3;
        draw(&p, &seed);
        part(&p, &seed);
        YkLinear linear = linear_of(&p);
        yk_linear_step(&linear, damping, x);
        for (size_t j = 0; j < p.n; j++) {
            double free = -dot(p.row, p.n, j, p.miss, 1, 0) / dot(p.row, p.n, j, p.row, p.n, j) / (1 + damping);
            CHECK_NEAR(x[j], fmin(fmax(free, p.low[j] - p.at[j]), p.high[j] - p.at[j]), 1e-12 * (1 + fabs(free)));
        }
    }
}

static void what_does_not_end_at_a_bound_fulfils_the_normal_equations(void **state)
{
    (void)state;
    uint64_t seed = 5;
    size_t inside = 0;
    for (uint64_t run = 0; run < check_cases(2000); run++) {
        Bounded p;
        double x[MOST], rest[ROWS], damping = check_uniform(&seed, 1e-3, 1);
        draw(&p, &seed);
        YkLinear linear = linear_of(&p);
        yk_linear_step(&linear, damping, x);
        for (size_t r = 0; r < ROWS; r++) {
            rest[r] = p.miss[r];
            for (size_t j = 0; j < p.n; j++) rest[r] += p.row[r * p.n + j] * x[j];
        }
        for (size_t j = 0; j < p.n; j++) {
            double low = p.low[j] - p.at[j], high = p.high[j] - p.at[j];
            assert_true(low <= x[j] && x[j] <= high);
            if (x[j] == 0 || x[j] == low || x[j] == high) continue;
            double own = dot(p.row, p.n, j, p.row, p.n, j);
            CHECK_NEAR(dot(p.row, p.n, j, rest, 1, 0) + damping * own * x[j], 0, 1e-12);
            inside++;
        }
    }
    assert_true(inside > 10);
}

static void a_column_of_zeros_asks_for_no_step(void **state)
{
    (void)state;
    double row[2] = {0, 2}, miss = 1, at[2] = {0, 0}, low[2] = {-9, -9}, high[2] = {9, 9}, A[6], b[3], x[2] = {7, 7};
    YkLinear linear = {2, 1, row, &miss, at, low, high, A, b};
    yk_linear_step(&linear, 0, x);
    CHECK_NEAR(x[0], 0, 0);
    CHECK_NEAR(x[1], -.5, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orthogonal_columns_step_apart_as_far_as_their_bounds),
        cmocka_unit_test(what_does_not_end_at_a_bound_fulfils_the_normal_equations),
        cmocka_unit_test(a_column_of_zeros_asks_for_no_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
