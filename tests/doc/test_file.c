// Reading files: whole, or not at all and with the reason.
#include "doc_check.h"
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/yoke-test-XXXXXX";
static char path[sizeof folder + 16];

static int make_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/file", folder);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

static void write_file(const char *data, size_t length)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

static void check_failure(const char *name, int code)
{
    YkProblems *problems = yk_problems_new();
    size_t length = 1;
    assert_null(yk_doc_read_file(name, &length, problems));
    assert_int_equal(length, 0);
    assert_int_equal(yk_problems_count(problems), 1);
    assert_int_equal(yk_problems_get(problems, 0)->code, code);
    assert_int_equal(yk_problems_get(problems, 0)->place.line, 0);
    yk_problems_free(problems);
}

static void files_of_every_size_come_back_byte_for_byte(void **state)
{
    (void)state;
    static const size_t sizes[] = {0, 1, 4095, 4096, 4097, 100000};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char *data = malloc(sizes[i] + 1);
        uint64_t seed = i;
        assert_non_null(data);
        for (size_t k = 0; k < sizes[i]; k++) data[k] = (char)check_random(&seed);
        write_file(data, sizes[i]);
        size_t length;
        YkProblems *problems = yk_problems_new();
        char *read = yk_doc_read_file(path, &length, problems);
        assert_non_null(read);
        assert_int_equal(length, sizes[i]);
        assert_memory_equal(read, data, sizes[i]);
        assert_int_equal(yk_problems_count(problems), 0);
        free(read);
        free(data);
        yk_problems_free(problems);
    }
}

static void what_is_not_there_or_no_file_is_named(void **state)
{
    (void)state;
    check_failure("/no/such/file.yaml", YK_CODE_FILE_NOT_FOUND);
    check_failure("", YK_CODE_FILE_NOT_FOUND);
    check_failure(folder, YK_CODE_FILE_DIRECTORY);
}

static void a_file_without_permission_is_unreadable(void **state)
{
    (void)state;
    if (geteuid() == 0) skip(); // root may read everything
    write_file("a", 1);
    assert_int_equal(chmod(path, 0), 0);
    check_failure(path, YK_CODE_FILE_UNREADABLE);
    assert_int_equal(chmod(path, 0600), 0);
}

static void a_huge_file_is_refused_without_reading_it(void **state)
{
    (void)state;
    write_file("a", 1);
    assert_int_equal(truncate(path, (off_t)1 << 40), 0); // sparse: takes no space
    check_failure(path, YK_CODE_FILE_TOO_LARGE);
    assert_int_equal(truncate(path, (off_t)YK_DOC_SIZE_MAX + 1), 0);
    check_failure(path, YK_CODE_FILE_TOO_LARGE);
}

static void a_source_that_never_ends_is_refused(void **state)
{
    (void)state;
    if (access("/dev/zero", R_OK) != 0) skip();
    check_failure("/dev/zero", YK_CODE_FILE_TOO_LARGE);
}

static void a_dash_reads_standard_input(void **state)
{
    (void)state;
    write_file("a: 1\n", 5);
    int before = dup(0);
    assert_non_null(freopen(path, "rb", stdin));
    size_t length;
    YkProblems *problems = yk_problems_new();
    char *read = yk_doc_read_file("-", &length, problems);
    assert_non_null(read);
    assert_int_equal(length, 5);
    assert_memory_equal(read, "a: 1\n", 5);
    free(read);
    yk_problems_free(problems);
    dup2(before, 0);
    close(before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_every_size_come_back_byte_for_byte),
        cmocka_unit_test(what_is_not_there_or_no_file_is_named),
        cmocka_unit_test(a_file_without_permission_is_unreadable),
        cmocka_unit_test(a_huge_file_is_refused_without_reading_it),
        cmocka_unit_test(a_source_that_never_ends_is_refused),
        cmocka_unit_test(a_dash_reads_standard_input),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
