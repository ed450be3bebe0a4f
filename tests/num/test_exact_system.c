// Exact linear equations against solutions that are known: of random systems of every rank, which solutions are the
// same in all.
#include "num/exact_system.h"
#include "check.h"

enum { MOST = 6, RIGHTS = 2 };

static int64_t some(uint64_t *seed, int64_t most)
{
    return (int64_t)floor(check_uniform(seed, -(double)most, (double)most + 1));
}

static bool is_same(const YkFraction *a, const YkFraction *b)
{
    YkOverflow overflow = false;
    YkFraction negative = yk_fraction_negative(b), rest = yk_fraction_add(a, &negative, &overflow);
    return yk_fraction_is_zero(&rest) && !overflow;
}

// A matrix with `rank` independent rows among `rows`, and right sides that x and y solve.
typedef struct Made {
    int rows, columns, rank;
    int64_t A[MOST][MOST], b[MOST][RIGHTS], x[RIGHTS][MOST];
} Made;

static Made make(uint64_t *seed)
{
    Made made = {.rows = 1 + (int)check_uniform(seed, 0, MOST), .columns = 1 + (int)check_uniform(seed, 0, MOST)};
    int most = made.rows < made.columns ? made.rows : made.columns;
    int64_t left[MOST][MOST], right[MOST][MOST];
    made.rank = (int)check_uniform(seed, 0, most + 1);
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < MOST; k++) { // triangles of full rank
            left[i][k] = i == k ? 1 + (some(seed, 1) & 2) : k < i ? some(seed, 2) : 0;
            right[k][i] = i == k ? 1 + (some(seed, 1) & 2) : k < i ? some(seed, 2) : 0;
        }
    for (int which = 0; which < RIGHTS; which++)
        for (int k = 0; k < made.columns; k++) made.x[which][k] = some(seed, 9);
    for (int i = 0; i < made.rows; i++)
        for (int j = 0; j < made.columns; j++) {
            for (int k = 0; k < made.rank; k++) made.A[i][j] += left[i][k] * right[k][j];
            for (int which = 0; which < RIGHTS; which++) made.b[i][which] += made.A[i][j] * made.x[which][j];
        }
    return made;
}

static void enter(YkExactSystem *system, const Made *made)
{
    assert_true(yk_exact_new(system, made->rows, made->columns, RIGHTS));
    for (int i = 0; i < made->rows; i++) {
        for (int j = 0; j < made->columns; j++) *yk_exact_cell(system, i, j) = yk_fraction(made->A[i][j], 3);
        for (int k = 0; k < RIGHTS; k++) *yk_exact_cell(system, i, made->columns + k) = yk_fraction(made->b[i][k], 3);
    }
}

// Whether an unknown is the same in all solutions: whether the rank falls where its column is left out.
static bool is_determined(const Made *made, int column)
{
    Made less = *made;
    YkExactSystem system;
    for (int i = 0; i < less.rows; i++) less.A[i][column] = 0;
    enter(&system, &less);
    yk_exact_reduce(&system);
    bool falls = system.rank < made->rank;
    yk_exact_free(&system);
    return falls;
}

static void random_systems_have_their_rank_and_solutions(void **state)
{
    (void)state;
    uint64_t seed = 17;
    size_t determined = 0, open = 0;
    for (size_t trial = 0; trial < 400; trial++) {
        Made made = make(&seed);
        YkExactSystem system;
        enter(&system, &made);
        yk_exact_reduce(&system);
        assert_false(system.overflow);
        assert_int_equal(system.rank, made.rank);
        assert_int_equal(yk_exact_contradiction(&system, RIGHTS), -1);
        for (int j = 0; j < made.columns; j++) {
            bool is = yk_exact_is_determined(&system, j);
            assert_int_equal(is, is_determined(&made, j));
            determined += is, open += !is;
            for (int k = 0; is && k < RIGHTS; k++) {
                YkFraction x = yk_fraction(made.x[k][j], 1);
                assert_true(is_same(yk_exact_cell(&system, system.pivot_row[j], made.columns + k), &x));
            }
        }
        yk_exact_free(&system);
    }
    assert_true(determined > 100 && open > 100);
}

// Every reduced row still holds for the solution: the rows are those of Gauss and Jordan.
static void reduced_rows_hold_for_the_solution(void **state)
{
    (void)state;
    uint64_t seed = 18;
    for (size_t trial = 0; trial < 200; trial++) {
        Made made = make(&seed);
        YkExactSystem system;
        enter(&system, &made);
        yk_exact_reduce(&system);
        for (int i = 0; i < made.rows; i++)
            for (int k = 0; k < RIGHTS; k++) {
                YkOverflow overflow = false;
                YkFraction sum = yk_fraction(0, 1);
                for (int j = 0; j < made.columns; j++) {
                    YkFraction x = yk_fraction(made.x[k][j], 1);
                    x = yk_fraction_multiply(&x, yk_exact_cell(&system, i, j), &overflow);
                    sum = yk_fraction_add(&sum, &x, &overflow);
                }
                assert_true(is_same(&sum, yk_exact_cell(&system, i, made.columns + k)));
            }
        for (int j = 0; j < made.columns; j++)
            for (int i = 0; i < made.rows && system.pivot_row[j] >= 0; i++) {
                bool is_pivot = i == system.pivot_row[j];
                assert_true(is_pivot ? yk_fraction_is_one(yk_exact_cell(&system, i, j))
                                     : yk_fraction_is_zero(yk_exact_cell(&system, i, j)));
            }
        yk_exact_free(&system);
    }
}

// A right side that a dependent row contradicts, the first or the second.
static void contradictions_are_found_in_the_sides_that_are_asked_for(void **state)
{
    (void)state;
    uint64_t seed = 19;
    size_t seen = 0;
    for (size_t trial = 0; trial < 200; trial++) {
        Made made = make(&seed);
        if (made.rank == made.rows) continue;
        for (int which = 0; which < RIGHTS; which++) {
            Made wrong = made;
            YkExactSystem system;
            wrong.b[made.rows - 1][which] += 1; // the last row depends on those before
            enter(&system, &wrong);
            yk_exact_reduce(&system);
            assert_int_equal(system.rank, made.rank);
            int32_t row = yk_exact_contradiction(&system, RIGHTS);
            assert_true(row >= 0 && system.pivot_column[row] < 0);
            assert_int_equal(yk_exact_contradiction(&system, 1) >= 0, which == 0);
            yk_exact_free(&system);
            seen++;
        }
    }
    assert_true(seen > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_systems_have_their_rank_and_solutions),
        cmocka_unit_test(reduced_rows_hold_for_the_solution),
        cmocka_unit_test(contradictions_are_found_in_the_sides_that_are_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
