// Problems as they are printed: place, line, caret, hint.
#include "check.h"
#include <stdlib.h>
#include "base/problems.h"

// One error at a place of a source, printed.
static void check_print(const char *source, YkPlace place, const char *expected)
{
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "m.yaml", source, source ? strlen(source) : 0);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, place, "bad");
    assert_string_equal(yk_problems_text(problems, 0), expected);
    yk_problems_free(problems);
}

static void a_problem_prints_place_message_code_line_caret_and_hint(void **state)
{
    (void)state;
    const char *source = "name: toggle\nbodies:\n  link1: {masss: m1}\n";
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "toggle.yaml", source, strlen(source));
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){3, 11, 5}, "unknown key %q", "masss");
    yk_problem_hint(problems, "did you mean %q?", "mass");
    yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){1, 7, 0}, "a name");
    assert_string_equal(yk_problems_text(problems, 0), "toggle.yaml:1:7: note: a name [N0101]\n"
                                                       "    name: toggle\n"
                                                       "          ^\n"
                                                       "toggle.yaml:3:11: error: unknown key `masss` [E0100]\n"
                                                       "      link1: {masss: m1}\n"
                                                       "              ^~~~~\n"
                                                       "hint: did you mean `mass`?\n");
    yk_problems_free(problems);
}

static void a_teller_names_what_has_no_place(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problems_set_teller(problems, "yoke");
    yk_problems_set_source(problems, "m.yaml", "a: b\n", 5);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, 4, 1}, "bad");
    yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){0}, "more");
    assert_string_equal(yk_problems_text(problems, 0), "yoke: note: more [N0101]\n"
                                                       "m.yaml:1:4: error: bad [E0100]\n"
                                                       "    a: b\n"
                                                       "       ^\n");
    yk_problems_set_teller(problems, NULL);
    assert_non_null(strstr(yk_problems_text(problems, 0), "m.yaml: note: more"));
    yk_problems_free(problems);
}

static void colours_surround_words_and_change_nothing_else(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "a", "xyz", 3);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, 2, 1}, "bad");
    yk_problem_hint(problems, "mend it");
    char plain[200], coloured[300], *out = coloured;
    snprintf(plain, sizeof plain, "%s", yk_problems_text(problems, 0));
    const char *text = yk_problems_text(problems, 1);
    assert_non_null(strstr(text, "\033[1;31merror: \033[0m"));
    assert_null(strchr(plain, '\033'));
    for (; *text; text++) {
        if (*text == '\033')
            text = strchr(text, 'm');
        else
            *out++ = *text;
    }
    *out = '\0';
    assert_string_equal(coloured, plain);
    yk_problems_free(problems);
}

static void what_is_not_known_is_left_out(void **state)
{
    (void)state;
    check_print(NULL, (YkPlace){3, 4, 1}, "m.yaml:3:4: error: bad [E0100]\n");
    check_print("x: 1\n", (YkPlace){0, 0, 0}, "m.yaml: error: bad [E0100]\n");
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "bad");
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){2, 3, 0}, "worse");
    assert_string_equal(yk_problems_text(problems, 0), "error: bad [E0100]\nline 2, column 3: error: worse [E0100]\n");
    yk_problems_free(problems);
}

static void the_caret_stands_right_after_tabs_wide_and_combining_text(void **state)
{
    (void)state;
    check_print("\tab", (YkPlace){1, 3, 1}, "m.yaml:1:3: error: bad [E0100]\n        ab\n         ^\n");
    check_print("a\tb", (YkPlace){1, 3, 1}, "m.yaml:1:3: error: bad [E0100]\n    a   b\n        ^\n");
    check_print("曲柄: x", (YkPlace){1, 5, 1}, "m.yaml:1:5: error: bad [E0100]\n    曲柄: x\n          ^\n");
    check_print("a: 曲柄", (YkPlace){1, 4, 2}, "m.yaml:1:4: error: bad [E0100]\n    a: 曲柄\n       ^~~~\n");
    check_print("e\xcc\x81t: x", (YkPlace){1, 5, 1}, "m.yaml:1:5: error: bad [E0100]\n    e\xcc\x81t: x\n       ^\n");
    check_print("θ1: é", (YkPlace){1, 5, 1}, "m.yaml:1:5: error: bad [E0100]\n    θ1: é\n        ^\n");
}

static void bytes_that_are_no_text_are_escaped_in_the_quoted_line(void **state)
{
    (void)state;
    check_print("a\xff: b", (YkPlace){1, 2, 1}, "m.yaml:1:2: error: bad [E0100]\n    a\\xff: b\n     ^~~~\n");
    check_print("a: \x1b[2J", (YkPlace){1, 1, 1}, "m.yaml:1:1: error: bad [E0100]\n    a: \\x1b[2J\n    ^\n");
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "a\nb\x1b", NULL, 0);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "bad");
    assert_string_equal(yk_problems_text(problems, 0), "a\\nb\\x1b: error: bad [E0100]\n");
    yk_problems_free(problems);
}

static void lines_end_with_lf_cr_lf_or_cr(void **state)
{
    (void)state;
    check_print("a\r\nb\r\nc", (YkPlace){2, 1, 1}, "m.yaml:2:1: error: bad [E0100]\n    b\n    ^\n");
    check_print("a\rb\rc", (YkPlace){2, 1, 1}, "m.yaml:2:1: error: bad [E0100]\n    b\n    ^\n");
    check_print("a\n\r\nc", (YkPlace){3, 1, 1}, "m.yaml:3:1: error: bad [E0100]\n    c\n    ^\n");
}

static void a_byte_order_mark_is_no_column(void **state)
{
    (void)state;
    check_print("\xef\xbb\xbf"
                "ab",
                (YkPlace){1, 2, 1}, "m.yaml:1:2: error: bad [E0100]\n    ab\n     ^\n");
}

static void places_outside_the_text_quote_what_there_is(void **state)
{
    (void)state;
    check_print("ab\n", (YkPlace){1, 3, 1}, "m.yaml:1:3: error: bad [E0100]\n    ab\n      ^\n");
    check_print("ab\n", (YkPlace){1, 99, 9}, "m.yaml:1:99: error: bad [E0100]\n    ab\n      ^\n");
    check_print("ab\n", (YkPlace){1, 2, 900}, "m.yaml:1:2: error: bad [E0100]\n    ab\n     ^\n");
    check_print("abc\n", (YkPlace){1, 2, UINT32_MAX}, "m.yaml:1:2: error: bad [E0100]\n    abc\n     ^~\n");
    check_print("ab\n", (YkPlace){2, 1, 1}, "m.yaml:2:1: error: bad [E0100]\n"); // an empty line tells nothing
    check_print("ab\n", (YkPlace){7, 1, 1}, "m.yaml:7:1: error: bad [E0100]\n");
    check_print("", (YkPlace){1, 1, 1}, "m.yaml:1:1: error: bad [E0100]\n");
}

// The quoted line and the caret line of one problem in a line of 'a's with an 'X' at `column`.
static void check_window(size_t length, uint32_t column)
{
    char *source = malloc(length + 1);
    memset(source, 'a', length);
    source[column - 1] = 'X';
    source[length] = '\0';
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "m", source, length);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, column, 1}, "bad");
    const char *line = strchr(yk_problems_text(problems, 0), '\n') + 1, *caret_line = strchr(line, '\n') + 1;
    assert_true(caret_line - line <= 4 + 160 + 3 + 1);
    assert_int_equal(strchr(line, 'X') - line, strchr(caret_line, '^') - caret_line);
    assert_int_equal(strncmp(line, "    ...", 7) == 0, column > 120);
    yk_problems_free(problems);
    free(source);
}

static void a_long_line_is_cut_to_a_window_around_the_place(void **state)
{
    (void)state;
    const uint32_t columns[] = {1, 2, 80, 119, 120, 121, 160, 161, 500, 999, 1000};
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++) check_window(1000, columns[i]);
    check_window(160, 160);
    check_window(1000000, 999999);
}

static void many_problems_in_one_line_are_all_quoted(void **state)
{
    (void)state;
    size_t length = 20000;
    char *source = malloc(length + 1);
    memset(source, 'a', length);
    source[length] = '\0';
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "m", source, length);
    for (uint32_t i = 0; i < 150; i++) {
        source[i * 113] = 'X';
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, i * 113 + 1, 1}, "bad");
    }
    yk_problems_set_source(problems, "m", source, length);
    const char *text = yk_problems_text(problems, 0);
    for (int i = 0; i < 150; i++) {
        const char *line = strchr(text, '\n') + 1, *caret_line = strchr(line, '\n') + 1;
        long caret = strchr(caret_line, '^') - caret_line;
        assert_int_equal(line[caret], 'X');
        text = strchr(caret_line, '\n') + 1;
    }
    assert_int_equal(*text, '\0');
    yk_problems_free(problems);
    free(source);
}

static void a_huge_line_is_passed_over_once(void **state)
{
    (void)state;
    size_t length = (size_t)20 << 20;
    char *source = malloc(length);
    memset(source, 'a', length);
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "m", source, length);
    for (uint32_t i = 0; i < 200; i++)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, (uint32_t)length - i, 1}, "bad");
    assert_true(strlen(yk_problems_text(problems, 0)) > 200 * 160);
    yk_problems_free(problems);
    free(source);
}

static void printing_twice_gives_the_same_and_the_source_may_change(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problems_set_source(problems, "one", "abc", 3);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, 1, 0}, "bad");
    char first[200];
    snprintf(first, sizeof first, "%s", yk_problems_text(problems, 0));
    assert_string_equal(yk_problems_text(problems, 0), first);
    yk_problems_set_source(problems, "two", "xyz", 3);
    assert_string_equal(yk_problems_text(problems, 0), "two:1:1: error: bad [E0100]\n    xyz\n    ^\n");
    yk_problems_set_source(problems, NULL, NULL, 0);
    assert_string_equal(yk_problems_text(problems, 0), "line 1, column 1: error: bad [E0100]\n");
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_problem_prints_place_message_code_line_caret_and_hint),
        cmocka_unit_test(a_teller_names_what_has_no_place),
        cmocka_unit_test(colours_surround_words_and_change_nothing_else),
        cmocka_unit_test(what_is_not_known_is_left_out),
        cmocka_unit_test(the_caret_stands_right_after_tabs_wide_and_combining_text),
        cmocka_unit_test(bytes_that_are_no_text_are_escaped_in_the_quoted_line),
        cmocka_unit_test(lines_end_with_lf_cr_lf_or_cr),
        cmocka_unit_test(a_byte_order_mark_is_no_column),
        cmocka_unit_test(places_outside_the_text_quote_what_there_is),
        cmocka_unit_test(a_long_line_is_cut_to_a_window_around_the_place),
        cmocka_unit_test(many_problems_in_one_line_are_all_quoted),
        cmocka_unit_test(a_huge_line_is_passed_over_once),
        cmocka_unit_test(printing_twice_gives_the_same_and_the_source_may_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
