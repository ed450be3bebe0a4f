// The matching against brute force over all assignments, and against its own guarantees.
#include "check.h"
#include "num/matching.h"

enum { ROWS = 8, COLUMNS = 7 };

typedef struct Graph {
    size_t rows, columns;
    unsigned row[ROWS]; // bit c: the row has column c
} Graph;

static Graph random_graph(uint64_t *seed)
{
    Graph g = {.rows = 1 + (size_t)(check_random(seed) % ROWS), .columns = 1 + (size_t)(check_random(seed) % COLUMNS)};
    double density = check_uniform(seed, 0.05, 0.9);
    for (size_t r = 0; r < g.rows; r++)
        for (size_t c = 0; c < g.columns; c++)
            if (check_uniform(seed, 0, 1) < density) g.row[r] |= 1u << c;
    return g;
}

// The most rows from `r` on that can be given columns of their own out of those free: every choice tried.
static size_t most_matched(const Graph *g, size_t r, unsigned used)
{
    if (r == g->rows) return 0;
    size_t best = most_matched(g, r + 1, used);
    for (size_t c = 0; c < g->columns; c++) {
        if (!(g->row[r] >> c & 1) || used >> c & 1) continue;
        size_t with = 1 + most_matched(g, r + 1, used | 1u << c);
        if (with > best) best = with;
    }
    return best;
}

static bool add(YkMatching *m, unsigned row, bool keep)
{
    int32_t columns[COLUMNS];
    size_t count = 0;
    for (int32_t c = 0; c < COLUMNS; c++)
        if (row >> c & 1) columns[count++] = c;
    return yk_matching_add(m, columns, count, keep);
}

// Every matched row has a column of its own that it contains; both tables say the same.
static void check_consistent(const YkMatching *m, const unsigned *rows)
{
    size_t taken = 0, given = 0;
    for (size_t r = 0; r < m->rows; r++) {
        int32_t c = m->column_of[r];
        if (c < 0) continue;
        given++;
        assert_true(rows[r] >> c & 1);
        assert_int_equal(m->row_of[c], r);
    }
    for (size_t c = 0; c < m->columns; c++) taken += m->row_of[c] >= 0;
    assert_int_equal(taken, given);
}

static void it_matches_as_many_rows_as_brute_force(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int trial = 0; trial < 3000; trial++) {
        Graph g = random_graph(&seed);
        YkArena *arena = yk_arena_new();
        YkMatching m;
        assert_true(yk_matching_start(&m, arena, g.columns, g.rows, g.rows * g.columns));
        size_t matched = 0, most = most_matched(&g, 0, 0);
        for (size_t r = 0; r < g.rows; r++) matched += add(&m, g.row[r], true);
        if (matched != most) print_error("trial %d of seed 11\n", trial);
        assert_int_equal(matched, most);
        assert_int_equal(m.rows, g.rows);
        check_consistent(&m, g.row);
        yk_arena_free(arena);
    }
}

// Row by row: a row is matched exactly when the rows kept so far and it can all be matched together (matroid of
// transversals), so that what comes first is preferred.
static void rows_that_come_first_are_preferred(void **state)
{
    (void)state;
    uint64_t seed = 12;
    for (int trial = 0; trial < 1500; trial++) {
        Graph g = random_graph(&seed), kept = {.columns = g.columns};
        YkArena *arena = yk_arena_new();
        YkMatching m;
        assert_true(yk_matching_start(&m, arena, g.columns, g.rows, g.rows * g.columns));
        for (size_t r = 0; r < g.rows; r++) {
            Graph with = kept;
            with.row[with.rows++] = g.row[r];
            bool fits = most_matched(&with, 0, 0) == with.rows;
            assert_int_equal(add(&m, g.row[r], false), fits);
            if (fits) kept = with;
            assert_int_equal(m.rows, kept.rows); // what did not fit was dropped
            check_consistent(&m, kept.row);
        }
        yk_arena_free(arena);
    }
}

static void a_row_beyond_the_room_is_refused(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    YkMatching m;
    const int32_t both[] = {0, 1};
    assert_true(yk_matching_start(&m, arena, 2, 2, 3));
    assert_true(yk_matching_add(&m, both, 2, true));
    assert_false(yk_matching_add(&m, both, 2, true)); // entries are used up
    assert_true(yk_matching_add(&m, both, 1, true));
    assert_false(yk_matching_add(&m, both, 0, true)); // rows are used up
    assert_int_equal(m.rows, 2);
    yk_arena_free(arena);
}

static void a_row_without_columns_stays_unmatched(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    YkMatching m;
    assert_true(yk_matching_start(&m, arena, 1, 1, 0));
    assert_false(yk_matching_add(&m, NULL, 0, true));
    assert_int_equal(m.rows, 1);
    assert_int_equal(m.column_of[0], -1);
    yk_arena_free(arena);
}

// The worst path: every row must move by one. Also deep: no recursion to overflow.
static void a_path_through_all_rows_is_found(void **state)
{
    (void)state;
    enum { LONG = 200000 };
    YkArena *arena = yk_arena_new();
    YkMatching m;
    assert_true(yk_matching_start(&m, arena, LONG + 1, LONG + 1, 2 * (LONG + 1)));
    for (int32_t r = 0; r < LONG; r++) assert_true(yk_matching_add(&m, (int32_t[]){r, r + 1}, 2, true));
    assert_true(yk_matching_add(&m, (int32_t[]){0}, 1, true));
    assert_int_equal(m.row_of[0], LONG);
    assert_int_equal(m.row_of[LONG], LONG - 1);
    yk_arena_free(arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_matches_as_many_rows_as_brute_force),
        cmocka_unit_test(rows_that_come_first_are_preferred),
        cmocka_unit_test(a_row_beyond_the_room_is_refused),
        cmocka_unit_test(a_row_without_columns_stays_unmatched),
        cmocka_unit_test(a_path_through_all_rows_is_found),
    };
    return cmocka_run_group_tests_name("num/matching", tests, NULL, NULL);
}
