// Texts that grow, and texts that failed.
#include "check.h"
#include <limits.h>
#include <stdlib.h>
#include "base/escape.h"
#include "base/memory.h"
#include "base/problems.h"
#include "base/text.h"

static void an_empty_text_is_an_empty_string(void **state)
{
    (void)state;
    YkText text = {0};
    assert_string_equal(yk_text_get(&text), "");
    yk_text_clear(&text);
    yk_text_puts(&text, "");
    assert_string_equal(yk_text_get(&text), "");
    assert_false(text.failed);
    yk_text_free(&text);
    yk_text_free(&text);
}

static void pieces_add_up_to_any_length(void **state)
{
    (void)state;
    YkText text = {0};
    char expected[9001] = "";
    for (size_t i = 0; i < 3000; i++) {
        yk_text_add(&text, &"abcdef"[i % 4], 3);
        memcpy(expected + 3 * i, &"abcdef"[i % 4], 3);
    }
    assert_int_equal(text.length, 9000);
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
    assert_null(text.data);
}

static void clearing_keeps_the_memory(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_repeat(&text, 'x', 1000);
    size_t capacity = text.capacity;
    yk_text_clear(&text);
    assert_string_equal(yk_text_get(&text), "");
    assert_int_equal(text.capacity, capacity);
    yk_text_repeat(&text, 'y', 3);
    assert_string_equal(yk_text_get(&text), "yyy");
    yk_text_free(&text);
}

static void an_impossible_length_fails_for_good(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "crank");
    yk_text_repeat(&text, 'x', SIZE_MAX);
    assert_true(text.failed);
    yk_text_repeat(&text, 'x', SIZE_MAX / 2 - 100);
    yk_text_puts(&text, " lever"); // after a hole nothing more is added
    assert_int_equal(text.length, 5);
    assert_ptr_equal(yk_text_get(&text), yk_text_lost);
    yk_text_clear(&text);
    yk_text_puts(&text, "rod");
    assert_true(text.failed);
    assert_ptr_equal(yk_text_get(&text), yk_text_lost);
    yk_text_free(&text);
    yk_text_puts(&text, "rod");
    assert_string_equal(yk_text_get(&text), "rod");
    yk_text_free(&text);
}

// Every way from one text into another.
static void what_is_made_of_a_failed_text_fails(void **state)
{
    (void)state;
    YkText lost = {0};
    yk_text_puts(&lost, "two words");
    yk_text_fail(&lost);
    for (int way = 0; way < 8; way++) {
        YkText text = {0};
        const char *words = yk_text_get(&lost);
        yk_text_puts(&text, "before");
        if (way == 0) yk_text_puts(&text, words);
        if (way == 1) yk_text_add(&text, words, lost.length);
        if (way == 2) yk_text_join(&text, &lost);
        if (way == 3) yk_text_format(&text, "[%s]", words);
        if (way == 4) yk_text_format(&text, "[%q]", words);
        if (way == 5) yk_escape(&text, words, lost.length);
        if (way == 6) yk_text_add(&text, words, 0);
        if (way == 7) yk_text_puts(&text, NULL);
        assert_true(text.failed);
        assert_ptr_equal(yk_text_get(&text), yk_text_lost);
        yk_text_free(&text);
    }
    YkArena *arena = yk_arena_new();
    assert_null(yk_arena_copy(arena, yk_text_get(&lost), lost.length));
    assert_true(yk_arena_failed(arena));
    yk_arena_free(arena);
    YkProblems *problems = yk_problems_new();
    yk_problem(problems, YK_CODE_EXPR_UNIT, (YkPlace){0}, "a warning about %q", yk_text_get(&lost));
    assert_true(yk_problems_ran_out(problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_OUT_OF_MEMORY);
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
    yk_text_free(&lost);
}

// Formats with ours and with the C library, where both have the conversion.
#define CHECK_SAME(theirs, ours, ...)                                                                                  \
    do {                                                                                                               \
        char expected[300];                                                                                            \
        YkText text = {0};                                                                                             \
        snprintf(expected, sizeof expected, theirs, __VA_ARGS__);                                                      \
        yk_text_format(&text, ours, __VA_ARGS__);                                                                      \
        assert_string_equal(yk_text_get(&text), expected);                                                             \
        assert_int_equal(text.length, strlen(expected));                                                               \
        yk_text_free(&text);                                                                                           \
    } while (0)

static void a_text_is_moved_into_a_buffer_that_may_be_too_small(void **state)
{
    (void)state;
    YkText text = {0};
    char room[6] = "#####";
    yk_text_move(&text, room, sizeof room); // an empty one
    assert_string_equal(room, "");
    for (size_t size = 1; size <= sizeof room; size++) {
        memset(room, '#', sizeof room);
        yk_text_puts(&text, "four");
        yk_text_move(&text, room, size);
        assert_int_equal(strlen(room), size <= 4 ? size - 1 : 4);
        assert_memory_equal(room, "four", strlen(room));
        assert_null(text.data);
        for (size_t k = size < 5 ? size : 5; k < sizeof room; k++) assert_int_equal(room[k], '#');
    }
    yk_text_puts(&text, "lost");
    yk_text_fail(&text);
    yk_text_move(&text, room, sizeof room);
    assert_string_equal(room, "");
    assert_false(text.failed);
}

static void integers_strings_and_characters_are_formatted_as_by_printf(void **state)
{
    (void)state;
    const int ints[] = {0, 1, -1, 9, 10, -10, 12345, INT_MAX, INT_MIN};
    for (size_t i = 0; i < sizeof ints / sizeof *ints; i++) CHECK_SAME("<%d>", "<%d>", ints[i]);
    CHECK_SAME("%u %u", "%u %u", 0u, UINT_MAX);
    CHECK_SAME("%zu%zu", "%z%z", (size_t)7, SIZE_MAX);
    CHECK_SAME("%s: %c%c %d%%", "%s: %c%c %d%%", "load", 'a', '-', 50);
    CHECK_SAME("%s%s%s", "%s%s%s", "", "x", "");
}

static void doubles_are_written_shortest_or_to_six_digits(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_format(&text, "%g %e %g %e", 0.1, 1.0 / 3, 1e-7, 123456789.0);
    assert_string_equal(yk_text_get(&text), "0.1 0.333333 1e-7 123457000");
    yk_text_free(&text);
}

static void a_null_string_is_empty(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_format(&text, "[%s][%q]", (const char *)NULL, (const char *)NULL);
    assert_string_equal(yk_text_get(&text), "[][``]");
    yk_text_free(&text);
}

static void unknown_conversions_are_shown_and_take_no_argument(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_format(&text, "%y %d %", 3);
    assert_string_equal(yk_text_get(&text), "%y 3 %");
    yk_text_free(&text);
}

static void formats_add_to_what_is_there(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "loop ");
    yk_text_format(&text, "%d: %q", 2, "A");
    yk_text_format(&text, ".");
    assert_string_equal(yk_text_get(&text), "loop 2: `A`.");
    yk_text_free(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_text_is_an_empty_string),
        cmocka_unit_test(pieces_add_up_to_any_length),
        cmocka_unit_test(clearing_keeps_the_memory),
        cmocka_unit_test(an_impossible_length_fails_for_good),
        cmocka_unit_test(what_is_made_of_a_failed_text_fails),
        cmocka_unit_test(a_text_is_moved_into_a_buffer_that_may_be_too_small),
        cmocka_unit_test(integers_strings_and_characters_are_formatted_as_by_printf),
        cmocka_unit_test(doubles_are_written_shortest_or_to_six_digits),
        cmocka_unit_test(a_null_string_is_empty),
        cmocka_unit_test(unknown_conversions_are_shown_and_take_no_argument),
        cmocka_unit_test(formats_add_to_what_is_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
