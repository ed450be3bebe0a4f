// Regions of a field's cells, against a flood fill; and the table of crossings, against an array.
#include "check.h"
#include "base/mix.h"
#include "map/workspace/runs.h"

enum { N = 24 };

// Gives all cells that are connected to one by their sides and have its number the same part.
static void flood(const uint16_t *count, uint32_t *part, size_t cell, uint32_t id)
{
    if (part[cell] != 0) return;
    part[cell] = id;
    size_t x = cell % N, y = cell / N;
    if (x > 0 && count[cell - 1] == count[cell]) flood(count, part, cell - 1, id);
    if (x + 1 < N && count[cell + 1] == count[cell]) flood(count, part, cell + 1, id);
    if (y > 0 && count[cell - N] == count[cell]) flood(count, part, cell - N, id);
    if (y + 1 < N && count[cell + N] == count[cell]) flood(count, part, cell + N, id);
}

static void test_regions_are_those_of_a_flood(void **unused)
{
    (void)unused;
    uint64_t seed = 77;
    for (size_t c = 0; c < check_cases(300); c++) {
        uint16_t count[N * N];
        uint32_t part[N * N] = {0}, parts = 0;
        double likely = yk_mix_unit(&seed); // that a cell is as its neighbour: from single cells to wide regions
        for (size_t k = 0; k < N * N; k++) {
            bool is_same = yk_mix_unit(&seed) < likely, is_below = yk_mix_unit(&seed) < 0.5;
            count[k] = (uint16_t)(3 * yk_mix_unit(&seed));
            if (is_same && k >= N) count[k] = count[is_below || k % N == 0 ? k - N : k - 1];
        }
        for (size_t k = 0; k < N * N; k++)
            if (count[k] > 0 && part[k] == 0) flood(count, part, k, ++parts);
        YkField field = {.n = N, .count = count};
        YkRuns runs;
        assert_true(yk_runs_find(&runs, &field));
        assert_int_equal(runs.part_count, parts);
        for (size_t k = 0; k < N * N; k++) assert_int_equal(yk_runs_part(&runs, k % N, k / N), part[k]);
        yk_runs_end(&runs);
    }
}

static void test_crossings_are_found_again(void **unused)
{
    (void)unused;
    enum { CELLS = 5000 };
    YkCrossings crossings = {0};
    uint64_t seed = 5;
    bool is_in[2 * CELLS] = {false};
    assert_null(yk_crossings_find(&crossings, 1));
    for (size_t k = 0; k < CELLS; k++) {
        size_t cell = (size_t)(CELLS * yk_mix_unit(&seed));
        int axis = yk_mix_unit(&seed) < 0.5 ? 0 : 1;
        bool is_known = yk_crossings_find(&crossings, yk_crossing_key(cell, axis)) != NULL;
        assert_int_equal(is_known, is_in[2 * cell + (size_t)axis]);
        if (is_known) continue;
        YkCrossing crossing = {yk_crossing_key(cell, axis), (float)cell, (int16_t)axis};
        assert_true(yk_crossings_add(&crossings, crossing));
        is_in[2 * cell + (size_t)axis] = true;
    }
    size_t count = 0;
    for (size_t k = 0; k < 2 * CELLS; k++) {
        const YkCrossing *c = yk_crossings_find(&crossings, yk_crossing_key(k / 2, (int)(k % 2)));
        assert_int_equal(c != NULL, is_in[k]);
        if (!c) continue;
        count++;
        assert_true(yk_crossing_cell(c) == k / 2 && c->part == (float)(k / 2) && c->piece == (int16_t)(k % 2));
    }
    assert_int_equal(crossings.count, count);
    yk_crossings_end(&crossings);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_regions_are_those_of_a_flood),
                                       cmocka_unit_test(test_crossings_are_found_again)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
