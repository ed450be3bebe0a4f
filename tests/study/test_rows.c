// Blocks of a study: designs by number, rows whoever computes them, and the file that keeps them.
#include <stdio.h>
#include <unistd.h>
#include <yoke/blocks.h>
#include "check.h"
#include "study_check.h"

enum { DESIGNS = 60, POSES = 19 };

typedef struct Task {
    Machine m;
    YkStudy *study;
    YkDesignAxis axes[2];
    YkDesigns designs;
    double poses[3 * POSES];
    const double *inputs[3];
    YkRowCase asked;
} Task;

static void begin(Task *t)
{
    static const char *const parameters[] = {"a", "b"}, *const of[] = {"theta4", "coupler.P.x"};
    t->m = machine_load("four-bar");
    t->study = study_of(&t->m, parameters, 2, of, 2, 2);
    t->axes[0] = (YkDesignAxis){.name = "a", .from = 0.038, .to = 0.09, .count = 20};
    t->axes[1] = (YkDesignAxis){.name = "b", .from = 0.11, .to = 0.13, .count = 3};
    t->designs = (YkDesigns){t->axes, 2, false, 0};
    for (size_t k = 0; k < 3 * POSES; k++) t->poses[k] = k < POSES ? (double)k / 3 : 0;
    for (size_t i = 0; i < 3; i++) t->inputs[i] = t->poses + i * POSES;
    t->asked = (YkRowCase){&t->designs, t->inputs, POSES, NULL, true};
}

static void end(Task *t)
{
    yk_study_free(t->study);
    machine_free(&t->m);
}

static void test_designs_have_numbers(void **unused)
{
    (void)unused;
    YkDesignAxis axes[] = {{.from = 1, .to = 2, .count = 3}, {.from = -1, .to = 1, .count = 5}};
    YkDesigns grid = {axes, 2, false, 0};
    double at[2];
    yk_designs_at(&grid, 0, at);
    assert_true(at[0] == 1 && at[1] == -1);
    yk_designs_at(&grid, 7, at);
    assert_true(at[0] == 1.5 && at[1] == 0);
    yk_designs_at(&grid, 14, at);
    assert_true(at[0] == 2 && at[1] == 1);
    axes[1].count = 0; // stays where it begins, and the others go on
    yk_designs_at(&grid, 2, at);
    assert_true(at[0] == 2 && at[1] == -1);
    axes[1].distribution = (YkDistribution){YK_DISTRIBUTION_NORMAL, -INFINITY, INFINITY, 3, 0.5};
    axes[0].distribution = (YkDistribution){YK_DISTRIBUTION_UNIFORM, 1, 2, 0, 0};
    YkDesigns sample = {axes, 2, true, 9};
    yk_designs_at(&sample, (uint64_t)1 << 40, at);
    assert_true(at[0] == yk_distribution_draw(&axes[0].distribution, 9, (uint64_t)1 << 40, 0));
    assert_true(at[1] == yk_distribution_draw(&axes[1].distribution, 9, (uint64_t)1 << 40, 1));
    yk_designs_at(NULL, 0, at);
    yk_designs_at(&grid, 0, NULL);
}

// The same bits in blocks of any size; and those of yk_study_reduce.
static void test_rows_do_not_depend_on_their_blocks(void **unused)
{
    (void)unused;
    Task t;
    begin(&t);
    size_t width = yk_study_row_width(t.study, &t.asked);
    assert_int_equal(width, 2 + 2 + 2 * 4);
    double *whole = calloc(DESIGNS * width, sizeof *whole), *parts = calloc(DESIGNS * width, sizeof *parts);
    assert_int_equal(yk_study_rows(t.study, &t.asked, 0, DESIGNS, whole), YK_OK);
    for (size_t size = 1; size < 40; size += 6) {
        for (size_t k = DESIGNS; k > 0;) { // from the last block to the first
            size_t count = k < size ? k : size;
            k -= count;
            assert_int_equal(yk_study_rows(t.study, &t.asked, k, count, parts + k * width), YK_OK);
        }
        assert_memory_equal(whole, parts, DESIGNS * width * sizeof *whole);
    }
    double values[2][DESIGNS];
    const double *given[2] = {values[0], values[1]};
    for (size_t d = 0; d < DESIGNS; d++)
        for (size_t k = 0; k < 2; k++) values[k][d] = whole[d * width + k];
    YkStudyCase asked = {given, DESIGNS, t.inputs, POSES, false, NULL};
    YkExtent extents[2 * DESIGNS];
    signed char status[DESIGNS];
    size_t standing[DESIGNS], failed = 0;
    yk_study_reduce(t.study, &asked, extents, status, standing);
    for (size_t d = 0; d < DESIGNS; d++) {
        const double *row = whole + d * width;
        assert_true(row[2] == status[d] && row[3] == (double)standing[d]);
        failed += status[d] < 0;
        for (size_t c = 0; c < 2; c++) {
            const YkExtent *e = &extents[c * DESIGNS + d];
            if (standing[d] == 0) assert_true(isnan(row[4 + 4 * c]));
            if (standing[d] > 0) assert_true(row[4 + 4 * c] == e->least && row[7 + 4 * c] == e->largest - e->least);
        }
    }
    assert_true(failed > 0 && failed < DESIGNS); // both kinds were seen
    assert_int_equal(yk_study_rows(NULL, &t.asked, 0, 1, parts), YK_BAD_ARGUMENT);
    assert_int_equal(yk_study_rows(t.study, NULL, 0, 1, parts), YK_BAD_ARGUMENT);
    assert_int_equal(yk_study_rows(t.study, &t.asked, 0, 1, NULL), YK_BAD_ARGUMENT);
    t.asked.is_reduced = false; // one pose only
    assert_int_equal(yk_study_rows(t.study, &t.asked, 0, 1, parts), YK_BAD_ARGUMENT);
    assert_int_equal(yk_study_row_width(NULL, NULL), 0);
    free(whole);
    free(parts);
    end(&t);
}

static YkBlocks *open_file(const char *path, uint64_t signature, bool is_fresh, size_t problems_expected)
{
    YkBlocksOptions options = {signature, 100, 3, is_fresh};
    YkProblems *problems = yk_problems_new();
    YkBlocks *blocks = yk_blocks_open(path, &options, problems);
    assert_int_equal(yk_problems_count(problems), problems_expected);
    yk_problems_free(problems);
    return blocks;
}

static void flip(const char *path, long place)
{
    FILE *file = fopen(path, "r+b");
    assert_non_null(file);
    fseek(file, place, SEEK_SET);
    int byte = fgetc(file);
    fseek(file, place, SEEK_SET);
    fputc(byte ^ 4, file);
    fclose(file);
}

static void test_a_file_goes_on_after_its_last_whole_block(void **unused)
{
    (void)unused;
    char path[] = "/tmp/yoke-blocks-XXXXXX";
    double rows[300];
    for (size_t k = 0; k < 300; k++) rows[k] = k % 7 == 0 ? NAN : (double)k / 3;
    close(mkstemp(path));
    YkBlocks *blocks = open_file(path, 5, false, 0);
    YkProblems *problems = yk_problems_new();
    assert_true(yk_blocks_add(blocks, rows, 10, problems) && yk_blocks_add(blocks, rows + 30, 25, problems));
    assert_memory_equal(yk_blocks_row(blocks, 34), rows + 102, 24);
    assert_memory_equal(yk_blocks_row(blocks, 2), rows + 6, 24); // back
    assert_true(yk_blocks_add(blocks, rows + 105, 5, problems)); // reading between does not matter
    assert_memory_equal(yk_blocks_row(blocks, 39), rows + 117, 24);
    assert_null(yk_blocks_row(blocks, 40));
    assert_false(yk_blocks_add(blocks, rows, 61, problems)); // more than the study has
    yk_blocks_close(blocks, false);
    assert_null(open_file(path, 6, false, 1)); // another study
    blocks = open_file(path, 5, false, 0);
    assert_int_equal(yk_blocks_done(blocks), 40);
    yk_blocks_close(blocks, false);
    flip(path, 64 + 16 + 10 * 24 + 16 + 100); // in the second block
    blocks = open_file(path, 5, false, 1);
    assert_int_equal(yk_blocks_done(blocks), 10);
    assert_true(yk_blocks_add(blocks, rows + 30, 90, problems));
    for (size_t d = 0; d < 100; d++) assert_memory_equal(yk_blocks_row(blocks, d), rows + 3 * d, 24);
    remove(path);
    assert_true(yk_problems_count(problems) == 0);
    yk_blocks_close(blocks, true);
    blocks = open_file(path, 6, true, 0);
    assert_int_equal(yk_blocks_done(blocks), 0);
    remove(path); // what is added now would be lost
    assert_false(yk_blocks_add(blocks, rows, 10, problems));
    assert_int_equal(yk_problems_count(problems), 1);
    assert_false(yk_blocks_add(blocks, rows, 10, problems));
    yk_blocks_close(blocks, true);
    assert_int_not_equal(access(path, F_OK), 0);
    assert_null(yk_blocks_open(NULL, NULL, problems));
    assert_null(yk_blocks_row(NULL, 0));
    assert_int_equal(yk_blocks_done(NULL), 0);
    yk_blocks_close(NULL, true);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_designs_have_numbers),
        cmocka_unit_test(test_rows_do_not_depend_on_their_blocks),
        cmocka_unit_test(test_a_file_goes_on_after_its_last_whole_block),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
