// Output files appear whole or not at all. mkdtemp and symlink are POSIX.
#define _XOPEN_SOURCE 700
#include "check.h"
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/codes.h"
#include "write/file.h"

static char folder[64];

static const char *at(const char *name)
{
    static char path[2][160];
    static int turn;
    turn = !turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

static int make_folder(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/yoke-test-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int entries(bool remove_them)
{
    int count = 0;
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        count++;
        if (remove_them && unlink(at(entry->d_name)) != 0) rmdir(at(entry->d_name));
    }
    if (dir) closedir(dir);
    return count;
}

static int remove_folder(void **state)
{
    (void)state;
    entries(true);
    return rmdir(folder);
}

static void check_content(const char *path, const char *expected)
{
    char content[64] = "";
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    content[fread(content, 1, sizeof content - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(content, expected);
}

// Tries to write and returns the code of the one problem, 0 where there is none.
static int try_to_write(const char *path, const char *data)
{
    YkProblems *problems = yk_problems_new();
    bool good = yk_file_write(path, data, strlen(data), problems);
    assert_int_equal(yk_problems_count(problems), good ? 0 : 1);
    int code = good ? 0 : yk_problems_get(problems, 0)->code;
    yk_problems_free(problems);
    return code;
}

static void a_new_file_holds_what_was_written_and_nothing_else_appears(void **state)
{
    (void)state;
    assert_int_equal(try_to_write(at("new.svg"), "content"), 0);
    check_content(at("new.svg"), "content");
    assert_int_equal(entries(false), 1);
}

static void an_old_file_is_replaced_and_keeps_its_permissions(void **state)
{
    (void)state;
    struct stat after;
    assert_int_equal(try_to_write(at("old.csv"), "a longer first content"), 0);
    assert_int_equal(chmod(at("old.csv"), 0640), 0);
    assert_int_equal(try_to_write(at("old.csv"), "short"), 0);
    check_content(at("old.csv"), "short");
    assert_int_equal(stat(at("old.csv"), &after), 0);
    assert_int_equal(after.st_mode & 07777, 0640);
}

static void an_empty_output_is_an_empty_file(void **state)
{
    (void)state;
    assert_int_equal(try_to_write(at("empty"), ""), 0);
    check_content(at("empty"), "");
}

static void a_link_is_followed_not_replaced(void **state)
{
    (void)state;
    struct stat after;
    assert_int_equal(try_to_write(at("target"), "one"), 0);
    assert_int_equal(symlink("target", at("link")), 0);
    assert_int_equal(try_to_write(at("link"), "two"), 0);
    check_content(at("target"), "two");
    assert_int_equal(lstat(at("link"), &after), 0);
    assert_true(S_ISLNK(after.st_mode));
}

static void a_missing_folder_has_its_own_code(void **state)
{
    (void)state;
    assert_int_equal(try_to_write(at("no/such/file.svg"), "x"), YK_CODE_OUTPUT_NO_FOLDER);
    assert_int_equal(try_to_write("", "x"), YK_CODE_OUTPUT_NO_FOLDER);
}

static void a_folder_is_no_file(void **state)
{
    (void)state;
    assert_int_equal(try_to_write(folder, "x"), YK_CODE_OUTPUT_IS_FOLDER);
    assert_int_equal(try_to_write(at("name/"), "x"), YK_CODE_OUTPUT_IS_FOLDER);
}

static void a_folder_that_may_not_be_written_has_its_own_code(void **state)
{
    (void)state;
    if (geteuid() == 0) skip(); // root may write everywhere
    assert_int_equal(chmod(folder, 0500), 0);
    int code = try_to_write(at("file"), "x");
    assert_int_equal(chmod(folder, 0700), 0);
    assert_int_equal(code, YK_CODE_OUTPUT_DENIED);
    assert_int_equal(entries(false), 0);
}

static void a_full_device_has_its_own_code(void **state)
{
    (void)state;
    if (access("/dev/full", W_OK) != 0) skip();
    assert_int_equal(try_to_write("/dev/full", "x"), YK_CODE_OUTPUT_FULL);
    assert_int_equal(try_to_write("/dev/null", "x"), 0); // devices are written, never replaced
}

// A disk that fills up half way: a limit on the file's size, in a process of its own.
static void a_write_that_fails_half_way_leaves_the_old_file_alone(void **state)
{
    (void)state;
    assert_int_equal(try_to_write(at("kept"), "what stood before"), 0);
    pid_t child = fork();
    if (child == 0) {
        static char large[100000];
        struct rlimit limit = {4096, 4096};
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &limit);
        YkProblems *problems = yk_problems_new();
        bool good = yk_file_write(at("kept"), large, sizeof large, problems);
        bool is_right = !good && yk_problems_get(problems, 0)->code == YK_CODE_OUTPUT_FULL;
        yk_problems_free(problems);
        _exit(is_right ? 0 : 1);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    check_content(at("kept"), "what stood before");
    assert_int_equal(entries(false), 1);
}

static void names_in_messages_carry_no_control_characters(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    assert_false(yk_file_write("/no/such/\x1b[31mred", "x", 1, problems));
    assert_null(strchr(yk_problems_get(problems, 0)->message, '\x1b'));
    yk_problems_free(problems);
}

static void the_ending_says_the_kind(void **state)
{
    (void)state;
    assert_int_equal(yk_file_kind("a.svg"), YK_FILE_SVG);
    assert_int_equal(yk_file_kind("dir.x/a.PDF"), YK_FILE_PDF);
    assert_int_equal(yk_file_kind("a.b.png"), YK_FILE_PNG);
    assert_int_equal(yk_file_kind("png"), YK_FILE_OTHER);
    assert_int_equal(yk_file_kind("dir.svg/a"), YK_FILE_OTHER);
    assert_int_equal(yk_file_kind("a."), YK_FILE_OTHER);
    assert_int_equal(yk_file_kind(""), YK_FILE_OTHER);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, make_folder, remove_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_new_file_holds_what_was_written_and_nothing_else_appears),
        IN_FOLDER(an_old_file_is_replaced_and_keeps_its_permissions),
        IN_FOLDER(an_empty_output_is_an_empty_file),
        IN_FOLDER(a_link_is_followed_not_replaced),
        IN_FOLDER(a_missing_folder_has_its_own_code),
        IN_FOLDER(a_folder_is_no_file),
        IN_FOLDER(a_folder_that_may_not_be_written_has_its_own_code),
        IN_FOLDER(a_full_device_has_its_own_code),
        IN_FOLDER(a_write_that_fails_half_way_leaves_the_old_file_alone),
        IN_FOLDER(names_in_messages_carry_no_control_characters),
        cmocka_unit_test(the_ending_says_the_kind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
