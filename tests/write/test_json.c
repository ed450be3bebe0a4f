// JSON.
#include "check.h"
#include <float.h>
#include <stdlib.h>
#include "base/number.h"
#include "write/json.h"

// Runs one writer call inside a list and compares the text of its single member.
#define CHECK_MEMBER(call, expected)                                                                                   \
    do {                                                                                                               \
        YkText text = {0};                                                                                             \
        YkJson json = {.text = &text};                                                                                 \
        yk_json_list(&json, NULL, YK_JSON_INLINE);                                                                     \
        call;                                                                                                          \
        yk_json_end(&json);                                                                                            \
        assert_string_equal(yk_text_get(&text), "[" expected "]\n");                                                   \
        yk_text_free(&text);                                                                                           \
    } while (0)

static void strings_are_escaped_as_rfc_8259_says(void **state)
{
    (void)state;
    CHECK_MEMBER(yk_json_string(&json, NULL, "plain"), "\"plain\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, ""), "\"\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, "a\"b\\c"), "\"a\\\"b\\\\c\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, "tab\tline\nbell\a"), "\"tab\\u0009line\\u000abell\\u0007\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, "\x1f\x7f"), "\"\\u001f\\u007f\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, "Kurbel \xc3\xbc \xe2\x82\xac"), "\"Kurbel \xc3\xbc \xe2\x82\xac\"");
    CHECK_MEMBER(yk_json_string(&json, NULL, NULL), "null");
}

static void numbers_that_are_none_become_null(void **state)
{
    (void)state;
    CHECK_MEMBER(yk_json_number(&json, NULL, NAN), "null");
    CHECK_MEMBER(yk_json_number(&json, NULL, INFINITY), "null");
    CHECK_MEMBER(yk_json_number(&json, NULL, -INFINITY), "null");
}

// Independent reader: strtod.
static void numbers_read_back_to_the_same_double(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 20000; i++) {
        uint64_t bits = check_random(&seed);
        double value;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value)) continue;
        YkText text = {0};
        YkJson json = {.text = &text};
        yk_json_number(&json, NULL, value);
        assert_true(strtod(yk_text_get(&text), NULL) == value);
        assert_null(strpbrk(yk_text_get(&text), "nNiI"));
        yk_text_free(&text);
    }
}

static void integers_reach_both_ends_of_their_range(void **state)
{
    (void)state;
    CHECK_MEMBER(yk_json_integer(&json, NULL, 0), "0");
    CHECK_MEMBER(yk_json_integer(&json, NULL, -1), "-1");
    CHECK_MEMBER(yk_json_integer(&json, NULL, INT64_MAX), "9223372036854775807");
    CHECK_MEMBER(yk_json_integer(&json, NULL, INT64_MIN), "-9223372036854775808");
}

static void words_of_the_language_are_bare(void **state)
{
    (void)state;
    CHECK_MEMBER(yk_json_bool(&json, NULL, true), "true");
    CHECK_MEMBER(yk_json_bool(&json, NULL, false), "false");
    CHECK_MEMBER(yk_json_null(&json, NULL), "null");
}

static void members_are_parted_by_commas_one_a_line(void **state)
{
    (void)state;
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", "M");
    yk_json_list(&json, "rows", YK_JSON_LINES);
    for (int row = 0; row < 2; row++) {
        yk_json_list(&json, NULL, YK_JSON_INLINE);
        yk_json_number(&json, NULL, row);
        yk_json_number(&json, NULL, 0.5);
        yk_json_end(&json);
    }
    yk_json_end(&json);
    yk_json_end(&json);
    assert_string_equal(yk_text_get(&text),
                        "{\n  \"model\": \"M\",\n  \"rows\": [\n    [0, 0.5],\n    [1, 0.5]\n  ]\n}\n");
    yk_text_free(&text);
}

static void what_is_inside_an_inline_object_stays_on_its_line(void **state)
{
    (void)state;
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_object(&json, "a", YK_JSON_LINES);
    yk_json_integer(&json, "b", 1);
    yk_json_end(&json);
    yk_json_end(&json);
    assert_string_equal(yk_text_get(&text), "{\"a\": {\"b\": 1}}\n");
    yk_text_free(&text);
}

static void empty_objects_and_lists_are_closed_at_once(void **state)
{
    (void)state;
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_list(&json, "events", YK_JSON_LINES);
    yk_json_end(&json);
    yk_json_end(&json);
    assert_string_equal(yk_text_get(&text), "{\n  \"events\": []\n}\n");
    yk_text_free(&text);
}

static void too_deep_nesting_marks_the_text_as_failed(void **state)
{
    (void)state;
    YkText text = {0};
    YkJson json = {.text = &text};
    for (int i = 0; i < YK_JSON_DEPTH; i++) yk_json_list(&json, NULL, YK_JSON_INLINE);
    assert_false(text.failed);
    yk_json_list(&json, NULL, YK_JSON_INLINE);
    assert_true(text.failed);
    yk_text_free(&text);
}

static void an_end_too_many_changes_nothing(void **state)
{
    (void)state;
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_list(&json, NULL, YK_JSON_INLINE);
    yk_json_end(&json);
    yk_json_end(&json);
    assert_string_equal(yk_text_get(&text), "[]\n");
    yk_text_free(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strings_are_escaped_as_rfc_8259_says),
        cmocka_unit_test(numbers_that_are_none_become_null),
        cmocka_unit_test(numbers_read_back_to_the_same_double),
        cmocka_unit_test(integers_reach_both_ends_of_their_range),
        cmocka_unit_test(words_of_the_language_are_bare),
        cmocka_unit_test(members_are_parted_by_commas_one_a_line),
        cmocka_unit_test(what_is_inside_an_inline_object_stays_on_its_line),
        cmocka_unit_test(empty_objects_and_lists_are_closed_at_once),
        cmocka_unit_test(too_deep_nesting_marks_the_text_as_failed),
        cmocka_unit_test(an_end_too_many_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
