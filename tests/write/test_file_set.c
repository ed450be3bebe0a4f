// Files that belong together appear all or not at all. mkdtemp is POSIX.
#define _XOPEN_SOURCE 700
#include "check.h"
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/codes.h"
#include "write/file_set.h"

static char folder[64], path[200];

static const char *at(const char *name)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static bool exists(const char *name)
{
    struct stat found;
    return stat(at(name), &found) == 0;
}

static bool write_two(const char *into, YkProblems *problems)
{
    char place[200];
    YkFileEntry files[] = {{"a", {0}}, {"b", {0}}};
    snprintf(place, sizeof place, "%s/%s", folder, into);
    yk_text_puts(&files[0].text, "one");
    bool good = yk_files_write(place, files, 2, problems); // b is empty
    yk_text_free(&files[0].text);
    return good;
}

static void a_folder_is_made_and_filled(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    assert_true(write_two("set", problems) && write_two("set", problems));
    assert_int_equal(yk_problems_count(problems), 0);
    assert_true(exists("set/a") && exists("set/b"));
    assert_int_equal(unlink(at("set/a")) + unlink(at("set/b")) + rmdir(at("set")), 0); // nothing else is there
    yk_problems_free(problems);
}

static void what_stands_in_the_way_keeps_all_away(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    assert_int_equal(mkdir(at("set"), 0777) + mkdir(at("set/b"), 0777), 0);
    assert_false(write_two("set", problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_OUTPUT_IS_FOLDER);
    assert_false(exists("set/a"));
    assert_int_equal(rmdir(at("set/b")) + rmdir(at("set")), 0);
    assert_false(write_two("no/set", problems));
    assert_int_equal(yk_problems_get(problems, 1)->code, YK_CODE_OUTPUT_NO_FOLDER);
    assert_false(exists("no"));
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_folder_is_made_and_filled),
                                       cmocka_unit_test(what_stands_in_the_way_keeps_all_away)};
    snprintf(folder, sizeof folder, "/tmp/yoke-test-XXXXXX");
    if (!mkdtemp(folder)) return 1;
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
