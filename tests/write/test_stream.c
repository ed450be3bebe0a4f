// Output line by line: files appear at the end, and end after a whole line whatever happens.
#define _XOPEN_SOURCE 700
#include "check.h"
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/codes.h"
#include "write/stream.h"

static char folder[64], path[100];

static int make_folder(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/yoke-test-XXXXXX");
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/out.csv", folder);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder); // fails where something was left beside
}

static size_t read_file(char *content, size_t capacity)
{
    FILE *file = fopen(path, "rb");
    if (!file) return 0;
    size_t length = fread(content, 1, capacity - 1, file);
    content[length] = '\0';
    fclose(file);
    return length;
}

static void put(const char *text)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void a_dropped_stream_leaves_the_file_as_it_was(void **state)
{
    (void)state;
    char content[64];
    for (int had_file = 0; had_file < 2; had_file++) {
        YkProblems *problems = yk_problems_new();
        YkStream stream;
        if (had_file) put("old\n");
        assert_true(yk_stream_open(&stream, path, problems));
        assert_true(yk_stream_write(&stream, "new\n", 4, problems));
        yk_stream_drop(&stream);
        yk_stream_drop(&stream); // no harm
        assert_int_equal(yk_problems_count(problems), 0);
        assert_int_equal(read_file(content, sizeof content), had_file ? 4 : 0);
        if (had_file) assert_string_equal(content, "old\n");
        yk_problems_free(problems);
    }
}

static void a_file_appears_when_the_stream_is_closed(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkStream stream;
    char content[64];
    assert_true(yk_stream_open(&stream, path, problems));
    assert_true(yk_stream_write(&stream, "t,x\n", 4, problems));
    assert_int_not_equal(access(path, F_OK), 0);
    assert_true(yk_stream_write(&stream, "0,1\n2,3\n", 8, problems));
    assert_true(yk_stream_close(&stream, problems));
    read_file(content, sizeof content);
    assert_string_equal(content, "t,x\n0,1\n2,3\n");
    assert_int_equal(yk_problems_count(problems), 0);
    yk_problems_free(problems);
}

static void without_lines_what_stood_there_still_stands(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkStream stream;
    char content[64];
    put("old");
    assert_true(yk_stream_open(&stream, path, problems));
    assert_true(yk_stream_close(&stream, problems));
    assert_true(yk_stream_close(&stream, problems)); // a closed stream may be closed again
    read_file(content, sizeof content);
    assert_string_equal(content, "old");
    yk_problems_free(problems);
}

static void a_new_file_keeps_the_old_ones_permissions(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkStream stream;
    struct stat after;
    put("old");
    assert_int_equal(chmod(path, 0640), 0);
    assert_true(yk_stream_open(&stream, path, problems));
    assert_true(yk_stream_write(&stream, "new\n", 4, problems));
    assert_true(yk_stream_close(&stream, problems));
    assert_int_equal(stat(path, &after), 0);
    assert_int_equal(after.st_mode & 07777, 0640);
    yk_problems_free(problems);
}

static void what_cannot_be_opened_has_its_code(void **state)
{
    (void)state;
    YkStream stream;
    const struct {
        const char *path;
        int code;
    } cases[] = {{"/no/such/folder/x.csv", YK_CODE_OUTPUT_NO_FOLDER}, {folder, YK_CODE_OUTPUT_IS_FOLDER}};
    for (size_t i = 0; i < 2; i++) {
        YkProblems *problems = yk_problems_new();
        assert_false(yk_stream_open(&stream, cases[i].path, problems));
        assert_int_equal(yk_problems_get(problems, 0)->code, cases[i].code);
        assert_true(yk_stream_close(&stream, problems));
        yk_problems_free(problems);
    }
}

// In a process of its own, whose files may have 1000 bytes: lines of 16 bytes come in pieces of some; is the outcome as
// it must be?
static bool fill_up(bool to_standard_output)
{
    struct rlimit limit = {1000, 1000};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    if (to_standard_output) dup2(open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    YkProblems *problems = yk_problems_new();
    YkStream stream;
    bool good = yk_stream_open(&stream, to_standard_output ? NULL : path, problems);
    for (int k = 0; k < 100 && good; k++)
        good = yk_stream_write(&stream, "0123456789abcde\n0123456789abcde\n0123456789abcde\n", 48, problems);
    bool is_right = !good && yk_problems_get(problems, 0)->code == YK_CODE_OUTPUT_FULL;
    is_right = yk_stream_close(&stream, problems) && is_right;
    yk_problems_free(problems);
    return is_right;
}

static void a_full_disk_leaves_all_lines_that_fit(void **state)
{
    (void)state;
    for (int way = 0; way < 2; way++) {
        static char content[2000];
        fflush(NULL);
        pid_t child = fork();
        if (child == 0) _exit(fill_up(way) ? 0 : 1);
        int status = 0;
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        assert_int_equal(read_file(content, sizeof content), 1000 / 16 * 16);
        assert_int_equal(content[1000 / 16 * 16 - 1], '\n');
    }
}

static void devices_are_written_and_never_replaced(void **state)
{
    (void)state;
    if (access("/dev/full", W_OK) != 0) skip();
    YkProblems *problems = yk_problems_new();
    YkStream stream;
    assert_true(yk_stream_open(&stream, "/dev/null", problems));
    assert_true(yk_stream_write(&stream, "x\n", 2, problems) && yk_stream_close(&stream, problems));
    assert_true(yk_stream_open(&stream, "/dev/full", problems));
    assert_false(yk_stream_write(&stream, "x\n", 2, problems));
    assert_true(yk_stream_close(&stream, problems));
    yk_problems_free(problems);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, make_folder, remove_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_file_appears_when_the_stream_is_closed),
        IN_FOLDER(a_dropped_stream_leaves_the_file_as_it_was),
        IN_FOLDER(without_lines_what_stood_there_still_stands),
        IN_FOLDER(a_new_file_keeps_the_old_ones_permissions),
        IN_FOLDER(what_cannot_be_opened_has_its_code),
        IN_FOLDER(a_full_disk_leaves_all_lines_that_fit),
        cmocka_unit_test(devices_are_written_and_never_replaced),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
