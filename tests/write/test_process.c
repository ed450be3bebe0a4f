// Other programs as filters.
#include "survive.h"
#include <stdlib.h>
#include "base/codes.h"
#include "base/problems.h"
#include "write/process.h"

// Runs a filter; returns the code of its problem, 0 where it went well.
static int run(const char *const *argv, const YkText *input, YkText *output, char message[300])
{
    YkProblems *problems = yk_problems_new();
    bool good = yk_process_filter(argv, "testing", input, output, problems);
    assert_int_equal(yk_problems_count(problems), good ? 0 : 1);
    int code = good ? 0 : yk_problems_get(problems, 0)->code;
    snprintf(message, 300, "%s", good ? "" : yk_problems_get(problems, 0)->message);
    yk_problems_free(problems);
    return code;
}

static void text_goes_in_and_comes_out(void **state)
{
    (void)state;
    const char *const tr[] = {"tr", "a-z", "A-Z", NULL};
    char message[300];
    YkText input = {0}, output = {0};
    yk_text_puts(&input, "crank\n");
    assert_int_equal(run(tr, &input, &output, message), 0);
    assert_string_equal(yk_text_get(&output), "CRANK\n");
    yk_text_free(&input);
    yk_text_free(&output);
}

// More than a pipe holds, both ways: neither side may wait for the other.
static void large_texts_do_not_block(void **state)
{
    (void)state;
    const char *const cat[] = {"cat", NULL};
    char message[300];
    YkText input = {0}, output = {0};
    for (int i = 0; i < 300000; i++) yk_text_format(&input, "%d\n", i);
    assert_int_equal(run(cat, &input, &output, message), 0);
    assert_int_equal(output.length, input.length);
    assert_memory_equal(output.data, input.data, input.length);
    yk_text_free(&input);
    yk_text_free(&output);
}

static void bytes_of_any_value_pass(void **state)
{
    (void)state;
    const char *const cat[] = {"cat", NULL};
    char bytes[256], message[300];
    YkText input = {0}, output = {0};
    for (int i = 0; i < 256; i++) bytes[i] = (char)i;
    yk_text_add(&input, bytes, sizeof bytes);
    assert_int_equal(run(cat, &input, &output, message), 0);
    assert_int_equal(output.length, sizeof bytes);
    assert_memory_equal(output.data, bytes, sizeof bytes);
    yk_text_free(&input);
    yk_text_free(&output);
}

static void a_missing_program_is_named(void **state)
{
    (void)state;
    const char *const none[] = {"no-such-program-of-yoke", NULL};
    char message[300];
    YkText input = {0}, output = {0};
    assert_int_equal(run(none, &input, &output, message), YK_CODE_PROGRAM_MISSING);
    assert_non_null(strstr(message, "no-such-program-of-yoke"));
    assert_int_equal(output.length, 0);
    yk_text_free(&output);
}

static void a_failing_program_is_quoted(void **state)
{
    (void)state;
    const char *const ls[] = {"ls", "/no/such/folder", NULL};
    char message[300];
    YkText input = {0}, output = {0};
    assert_int_equal(run(ls, &input, &output, message), YK_CODE_PROGRAM_FAILED);
    assert_non_null(strstr(message, "/no/such/folder"));
    yk_text_free(&output);
}

static void words_are_handed_on_without_a_shell(void **state)
{
    (void)state;
    const char *const printf_words[] = {"printf", "%s|%s", "$HOME; echo", "a b", NULL};
    char message[300];
    YkText input = {0}, output = {0};
    assert_int_equal(run(printf_words, &input, &output, message), 0);
    assert_string_equal(yk_text_get(&output), "$HOME; echo|a b");
    yk_text_free(&output);
}

// A filter that lacked memory says so: neither that the program is missing nor that it failed.
static bool runs_or_says_why(void *context)
{
    YkText input = {0}, output = {0};
    YkProblems *problems = yk_problems_new();
    yk_text_puts(&input, "crank\n");
    bool good = problems && !input.failed && yk_process_filter(context, "testing", &input, &output, problems);
    if (!good && problems && !input.failed) assert_true(yk_problems_ran_out(problems));
    assert_true(!good || strcmp(yk_text_get(&output), "crank\n") == 0);
    yk_problems_free(problems);
    yk_text_free(&input);
    yk_text_free(&output);
    return good;
}

static void a_lack_of_memory_is_not_a_missing_program(void **state)
{
    (void)state;
    const char *const cat[] = {"cat", NULL};
    skip_unless_interposed();
    survive(runs_or_says_why, (void *)(uintptr_t)cat, "a filter");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_goes_in_and_comes_out),
        cmocka_unit_test(large_texts_do_not_block),
        cmocka_unit_test(bytes_of_any_value_pass),
        cmocka_unit_test(a_missing_program_is_named),
        cmocka_unit_test(a_failing_program_is_quoted),
        cmocka_unit_test(words_are_handed_on_without_a_shell),
        cmocka_unit_test(a_lack_of_memory_is_not_a_missing_program),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
