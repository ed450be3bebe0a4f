// Rows of a study in a file: what was written is found again, up to where the file is damaged or ends.
#define _XOPEN_SOURCE 700
#include "check.h"
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yoke/blocks.h>
#include "base/codes.h"

enum { DESIGNS = 40, WIDTH = 3, HEAD = 64, BLOCK_HEAD = 16 };

static char folder[64], path[100];
static double rows[DESIGNS * WIDTH];
static const size_t batches[] = {1, 7, 2, 0, 13, 5, 9, 3}; // 40 in all

static int make_folder(void **state)
{
    (void)state;
    uint64_t seed = 9;
    for (size_t k = 0; k < DESIGNS * WIDTH; k++) rows[k] = check_uniform(&seed, -1, 1);
    rows[4] = NAN, rows[5] = -INFINITY, rows[7] = -0.0;
    snprintf(folder, sizeof folder, "/tmp/yoke-test-XXXXXX");
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/study.partial", folder);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

// Opens the file; `code` is the first problem's, or 0.
static YkBlocks *open_it(uint64_t signature, bool is_fresh, int code)
{
    YkProblems *problems = yk_problems_new();
    YkBlocksOptions options = {.signature = signature, .design_count = DESIGNS, .width = WIDTH, .is_fresh = is_fresh};
    YkBlocks *blocks = yk_blocks_open(path, &options, problems);
    assert_int_equal(yk_problems_count(problems), code != 0);
    if (code != 0) assert_int_equal(yk_problems_get(problems, 0)->code, code);
    yk_problems_free(problems);
    return blocks;
}

// Adds batches from the first one that is not there, as far as `until`.
static void add(YkBlocks *blocks, size_t until)
{
    uint64_t at = 0;
    for (size_t k = 0; k < sizeof batches / sizeof *batches; k++) {
        if (at >= yk_blocks_done(blocks) && at + batches[k] <= until)
            assert_true(yk_blocks_add(blocks, rows + at * WIDTH, batches[k], NULL));
        at += batches[k];
    }
}

static void check_rows(YkBlocks *blocks)
{
    uint64_t seed = 4, done = yk_blocks_done(blocks);
    for (int k = 0; k < 100 && done > 0; k++) { // in any order
        uint64_t design = k < 40 ? (uint64_t)k % done : check_random(&seed) % done;
        const double *row = yk_blocks_row(blocks, design);
        assert_non_null(row);
        assert_memory_equal(row, rows + design * WIDTH, WIDTH * sizeof *rows);
    }
    assert_null(yk_blocks_row(blocks, done));
}

static void what_was_written_is_found_again(void **state)
{
    (void)state;
    for (size_t first = 0; first <= DESIGNS; first++) { // the first run ends there
        YkBlocks *blocks = open_it(77, false, 0);
        assert_int_equal(yk_blocks_done(blocks), 0);
        add(blocks, first);
        uint64_t done = yk_blocks_done(blocks);
        check_rows(blocks);
        yk_blocks_close(blocks, false);
        blocks = open_it(77, false, 0);
        assert_int_equal(yk_blocks_done(blocks), done);
        check_rows(blocks);
        add(blocks, DESIGNS);
        assert_int_equal(yk_blocks_done(blocks), DESIGNS);
        assert_false(yk_blocks_add(blocks, rows, 1, NULL)); // every design has been written
        check_rows(blocks);
        yk_blocks_close(blocks, true);
        assert_int_not_equal(access(path, F_OK), 0);
    }
}

// Cut off anywhere, or with one byte changed: the designs of the blocks before are there, and the others can be added.
static void a_damaged_file_is_read_up_to_the_damage(void **state)
{
    (void)state;
    size_t ends[8], size = HEAD, at = 0, count = 0, designs[9] = {0};
    for (size_t k = 0; k < sizeof batches / sizeof *batches; k++) {
        if (batches[k] == 0) continue;
        size += BLOCK_HEAD + batches[k] * WIDTH * sizeof *rows;
        at += batches[k];
        ends[count] = size, designs[++count] = at;
    }
    for (size_t place = HEAD; place <= size; place += 5)
        for (int cut = 0; cut < 2; cut++) {
            size_t whole = 0, hit = place < size || cut ? place : size - 1;
            while (whole < count && (cut ? ends[whole] <= hit : hit >= ends[whole])) whole++;
            YkBlocks *blocks = open_it(77, true, 0);
            add(blocks, DESIGNS);
            yk_blocks_close(blocks, false);
            if (cut) assert_int_equal(truncate(path, (off_t)hit), 0);
            FILE *file = cut ? NULL : fopen(path, "r+b");
            if (file) {
                fseek(file, (long)hit, SEEK_SET);
                int byte = fgetc(file);
                fseek(file, (long)hit, SEEK_SET);
                fputc(byte ^ 0x10, file);
                fclose(file);
            }
            YkProblems *problems = yk_problems_new();
            YkBlocksOptions options = {.signature = 77, .design_count = DESIGNS, .width = WIDTH};
            blocks = yk_blocks_open(path, &options, problems);
            assert_non_null(blocks);
            assert_int_equal(yk_blocks_done(blocks), designs[whole]);
            for (size_t k = 0; k < yk_problems_count(problems); k++)
                assert_int_equal(yk_problems_get(problems, k)->code, YK_CODE_STUDY_DAMAGED);
            if (cut) assert_int_equal(yk_problems_count(problems), 0); // a run that was killed
            yk_problems_free(problems);
            check_rows(blocks);
            add(blocks, DESIGNS);
            check_rows(blocks);
            assert_int_equal(yk_blocks_done(blocks), DESIGNS);
            yk_blocks_close(blocks, true);
        }
}

static void another_study_or_run_is_refused(void **state)
{
    (void)state;
    YkBlocks *blocks = open_it(77, false, 0);
    add(blocks, 8);
    pid_t child = fork();
    if (child == 0) _exit(open_it(77, false, YK_CODE_STUDY_BUSY) != NULL);
    int status = 1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    yk_blocks_close(blocks, false);
    assert_null(open_it(78, false, YK_CODE_STUDY_CHANGED));
    blocks = open_it(77, false, 0); // as it was
    assert_int_equal(yk_blocks_done(blocks), 8);
    yk_blocks_close(blocks, false);
    blocks = open_it(78, true, 0); // anew
    assert_int_equal(yk_blocks_done(blocks), 0);
    yk_blocks_close(blocks, true);
    FILE *file = fopen(path, "wb");
    fputs("a file of the user's, longer than what begins a study: it stays as it is, whatever is asked for.\n", file);
    fclose(file);
    assert_null(open_it(77, false, YK_CODE_STUDY_CHANGED));
    assert_int_equal(access(path, F_OK), 0);
}

static void what_is_written_to_a_file_that_is_gone_is_told(void **state)
{
    (void)state;
    unlink(path);
    YkBlocks *blocks = open_it(77, false, 0);
    YkProblems *problems = yk_problems_new();
    assert_true(yk_blocks_add(blocks, rows, 1, problems));
    unlink(path);
    assert_false(yk_blocks_add(blocks, rows + WIDTH, 1, problems));
    assert_int_equal(yk_problems_count(problems), 1);
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_OUTPUT_FAILED);
    assert_false(yk_blocks_add(blocks, rows + WIDTH, 1, NULL));
    assert_null(yk_blocks_row(blocks, 0));
    yk_problems_free(problems);
    yk_blocks_close(blocks, false);
    assert_int_not_equal(access(path, F_OK), 0);
    assert_false(yk_blocks_add(NULL, rows, 1, NULL));
    assert_null(yk_blocks_row(NULL, 0));
    assert_int_equal(yk_blocks_done(NULL), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_is_found_again),
        cmocka_unit_test(a_damaged_file_is_read_up_to_the_damage),
        cmocka_unit_test(another_study_or_run_is_refused),
        cmocka_unit_test(what_is_written_to_a_file_that_is_gone_is_told),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
