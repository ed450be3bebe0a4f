// Errors in the grammar: reported in plain words, at their places.
#include "doc_check.h"

static void what_is_not_closed_is_named_with_where_it_opens(void **state)
{
    (void)state;
    check_refused("a: [1, 2\nb: 3\n", YK_CODE_YAML_SYNTAX, 2, 2, "the list opens on line 1, column 4");
    check_refused("a: {x: 1\nb: 3\n", YK_CODE_YAML_SYNTAX, 2, 2, "the map opens on line 1, column 4");
    check_refused("a: [b\n", YK_CODE_YAML_SYNTAX, 1, 6, "the list opens on line 1, column 4");
    check_refused("a: {x: [0, 0}\n", YK_CODE_YAML_SYNTAX, 1, 13, "`]`");
    check_refused("a: \"abc\nb: 3\n", YK_CODE_YAML_SYNTAX, 1, 4, "never closed");
    check_refused("a: 'abc\n---\n", YK_CODE_YAML_SYNTAX, 1, 4, "not closed");
}

static void a_missing_colon_or_key_is_found(void **state)
{
    (void)state;
    check_refused("a: 1\nfoo\nb: 2\n", YK_CODE_YAML_SYNTAX, 2, 1, "no `:`");
    check_refused("a:1\nb: 2\n", YK_CODE_YAML_SYNTAX, 1, 2, "a space after the colon");
    check_refused("x:\n  a:1\n\n  # comment\n  b: 2\n", YK_CODE_YAML_SYNTAX, 2, 4, "a space after the colon");
    check_refused("b: 1\na:1\nc: 2\n", YK_CODE_YAML_SYNTAX, 2, 1, "a space after the colon");
    check_refused("{: 1}\n", YK_CODE_YAML_SYNTAX, 1, 2, "expected a value");
    check_refused(": 1\n", YK_CODE_YAML_SYNTAX, 1, 1, "expected a key");
    check_refused("a: b: c\n", YK_CODE_YAML_SYNTAX, 1, 5, "cannot start here");
    check_refused("a: 1\n b: 2\n", YK_CODE_YAML_SYNTAX, 2, 3, "indentation");
    check_refused("a:\n    b: 1\n  c: 2\n", YK_CODE_YAML_SYNTAX, 3, 3, "starts on line 1, column 1");
    check_refused("- 1\nb: 2\n", YK_CODE_YAML_SYNTAX, 2, 1, "list item");
    check_refused("a: - 1\n", YK_CODE_YAML_SYNTAX, 1, 4, "`[first, second]`");
    check_refused("a: [1,,2]\n", YK_CODE_YAML_SYNTAX, 1, 7, "expected a value");
    check_refused("{a: 1} b\n", YK_CODE_YAML_SYNTAX, 1, 8, "after the end");
    check_refused("a: ? b\n", YK_CODE_YAML_SYNTAX, 1, 4, "cannot start here");
}

static void characters_with_a_meaning_in_yaml_are_explained(void **state)
{
    (void)state;
    check_refused("a: @x\n", YK_CODE_YAML_SYNTAX, 1, 4, "quotes");
    check_refused("a: `x\n", YK_CODE_YAML_SYNTAX, 1, 4, "quotes");
    check_refused("a: %x\n", YK_CODE_YAML_SYNTAX, 1, 4, "quotes");
    check_refused("%FOO x\n---\na: 1\n", YK_CODE_YAML_SYNTAX, 1, 1, "`#`");
    check_refused("%YAML 3.0\n---\na: 1\n", YK_CODE_YAML_SYNTAX, 1, 1, "`%YAML`");
    check_refused("%YAML x\n---\na: 1\n", YK_CODE_YAML_SYNTAX, 1, 1, "version");
    check_refused("a: \"x\\qy\"\n", YK_CODE_YAML_SYNTAX, 1, 6, "single quotes");
    check_refused("a: \"\\xzz\"\n", YK_CODE_YAML_SYNTAX, 1, 7, "hexadecimal");
    check_refused("a: \"\\ud800\"\n", YK_CODE_YAML_SYNTAX, 1, 7, "no character");
    check_refused("a: |x\n", YK_CODE_YAML_SYNTAX, 1, 4, "one line");
    check_refused("a: * 2\n", YK_CODE_YAML_ALIAS, 1, 4, "product");
    check_refused("a: & 2\n", YK_CODE_YAML_ANCHOR, 1, 4, "quotes");
    check_refused("a: !x!y 2\n", YK_CODE_YAML_TAG, 1, 4, "quotes");
    check_refused("a: !<x 2\n", YK_CODE_YAML_TAG, 1, 4, "quotes");
}

static void every_refusal_has_a_place_in_the_text(void **state)
{
    (void)state;
    static const char *const parts[] = {"a",  ": ",    "[",  "]", "{",  "}",        ",",     "\n", "- ",
                                        "? ", "\"",    "'",  "&", "*",  "!",        "%",     "@",  "|",
                                        ">",  "---\n", "  ", "#", "\\", "\xc3\xa9", "...\n", "1"};
    uint64_t seed = 7;
    int refused = 0;
    for (int i = 0; i < 20000; i++) {
        char text[64] = "";
        for (size_t k = check_random(&seed) % 12; k > 0; k--)
            strcat(text, parts[check_random(&seed) % (sizeof parts / sizeof *parts)]);
        Fixture fixture = fixture_of(text);
        size_t lines = 1;
        for (const char *c = text; *c; c++) lines += *c == '\n';
        assert_int_equal(fixture.root == NULL, yk_problems_error_count(fixture.problems) > 0);
        refused += fixture.root == NULL;
        for (size_t p = 0; p < yk_problems_count(fixture.problems); p++) {
            const YkProblem *problem = yk_problems_get(fixture.problems, p);
            assert_in_range(problem->place.line, 1, lines);
            assert_in_range(problem->place.column, 1, strlen(text) + 1);
            if (strstr(problem->message, "this is not YAML:"))
                print_error("untranslated «%s»: %s\n", text, problem->message);
            assert_null(strstr(problem->message, "this is not YAML:"));
        }
        fixture_free(&fixture);
    }
    assert_in_range(refused, 5000, 19999);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_not_closed_is_named_with_where_it_opens),
        cmocka_unit_test(a_missing_colon_or_key_is_found),
        cmocka_unit_test(characters_with_a_meaning_in_yaml_are_explained),
        cmocka_unit_test(every_refusal_has_a_place_in_the_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
