// Lists of problems.
#include "check.h"
#include <stdlib.h>
#include "base/problems.h"

static void an_empty_list_has_nothing(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    assert_int_equal(yk_problems_count(problems), 0);
    assert_int_equal(yk_problems_error_count(problems), 0);
    assert_null(yk_problems_get(problems, 0));
    yk_problem_hint(problems, "hint for nothing");
    yk_problems_free(problems);
}

static void no_list_is_no_danger(void **state)
{
    (void)state;
    yk_problem(NULL, YK_CODE_OUT_OF_MEMORY, (YkPlace){1, 1, 1}, "lost %d", 1);
    yk_problem_hint(NULL, "lost");
    yk_problems_set_source(NULL, "a", "b", 1);
    assert_int_equal(yk_problems_count(NULL), 0);
    assert_int_equal(yk_problems_error_count(NULL), 0);
    assert_null(yk_problems_get(NULL, 0));
    assert_string_equal(yk_problems_text(NULL, 0), "");
    yk_problems_free(NULL);
}

static void problems_are_read_in_order_of_place_and_of_arrival(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    uint64_t seed = 31;
    for (int i = 0; i < YK_PROBLEMS_MAX; i++) {
        YkPlace place = {(uint32_t)(check_random(&seed) % 8), (uint32_t)(check_random(&seed) % 4), 0};
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, place, "%d", i);
    }
    assert_int_equal(yk_problems_count(problems), YK_PROBLEMS_MAX);
    for (size_t i = 1; i < YK_PROBLEMS_MAX; i++) {
        const YkProblem *a = yk_problems_get(problems, i - 1), *b = yk_problems_get(problems, i);
        assert_true(a->place.line <= b->place.line);
        if (a->place.line != b->place.line) continue;
        assert_true(a->place.column <= b->place.column);
        if (a->place.column == b->place.column) assert_true(atoi(a->message) < atoi(b->message));
    }
    assert_int_equal(yk_problems_get(problems, 0)->place.line, 0);
    yk_problems_free(problems);
}

static void a_problem_stays_where_it_is_when_others_come(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){5, 1, 0}, "five");
    const YkProblem *five = yk_problems_get(problems, 0);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){2, 1, 0}, "two");
    assert_string_equal(five->message, "five");
    assert_ptr_equal(yk_problems_get(problems, 1), five);
    yk_problems_free(problems);
}

static void severity_and_code_come_from_the_table(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "a");
    yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){0}, "b");
    assert_int_equal(yk_problems_get(problems, 0)->severity, YK_SEVERITY_ERROR);
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_OUT_OF_MEMORY);
    assert_int_equal(yk_problems_get(problems, 1)->severity, YK_SEVERITY_NOTE);
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
}

static void a_hint_goes_to_the_problem_added_last(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){9, 1, 0}, "late");
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){3, 1, 0}, "early");
    yk_problem_hint(problems, "did you mean %q?", "mass");
    assert_string_equal(yk_problems_get(problems, 0)->hint, "did you mean `mass`?");
    assert_null(yk_problems_get(problems, 1)->hint);
    yk_problems_free(problems);
}

static void control_characters_of_messages_are_escaped(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "bad %s", "\x1b[2J\n\xff");
    yk_problem_hint(problems, "%s", "\a");
    assert_string_equal(yk_problems_get(problems, 0)->message, "bad \\x1b[2J\\n\\xff");
    assert_string_equal(yk_problems_get(problems, 0)->hint, "\\x07");
    yk_problems_free(problems);
}

// After the maximum, one last entry says so; it is as severe as the worst that was left out.
static void fill(YkProblems *problems)
{
    for (int i = 0; i < YK_PROBLEMS_MAX; i++) yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){1, 1, 0}, "%d", i);
}

static void the_list_ends_with_a_word_that_there_are_more(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    fill(problems);
    assert_int_equal(yk_problems_count(problems), YK_PROBLEMS_MAX);
    for (int i = 0; i < 5; i++) yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){0}, "left out");
    yk_problem_hint(problems, "for a problem left out");
    assert_int_equal(yk_problems_count(problems), YK_PROBLEMS_MAX + 1);
    const YkProblem *last = yk_problems_get(problems, YK_PROBLEMS_MAX);
    assert_int_equal(last->code, YK_CODE_MORE_PROBLEMS);
    assert_string_equal(last->message, "there are more problems than these");
    assert_string_not_equal(last->hint, "for a problem left out");
    assert_null(yk_problems_get(problems, YK_PROBLEMS_MAX - 1)->hint);
    assert_null(yk_problems_get(problems, YK_PROBLEMS_MAX + 1));
    yk_problems_free(problems);
}

static void an_error_left_out_still_counts(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    fill(problems);
    yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){0}, "a note");
    assert_int_equal(yk_problems_error_count(problems), 0);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "an error");
    yk_problem(problems, YK_CODE_MORE_PROBLEMS, (YkPlace){0}, "a note");
    assert_int_equal(yk_problems_error_count(problems), 1);
    assert_int_equal(yk_problems_get(problems, YK_PROBLEMS_MAX)->severity, YK_SEVERITY_ERROR);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_list_has_nothing),
        cmocka_unit_test(no_list_is_no_danger),
        cmocka_unit_test(problems_are_read_in_order_of_place_and_of_arrival),
        cmocka_unit_test(a_problem_stays_where_it_is_when_others_come),
        cmocka_unit_test(severity_and_code_come_from_the_table),
        cmocka_unit_test(a_hint_goes_to_the_problem_added_last),
        cmocka_unit_test(control_characters_of_messages_are_escaped),
        cmocka_unit_test(the_list_ends_with_a_word_that_there_are_more),
        cmocka_unit_test(an_error_left_out_still_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
