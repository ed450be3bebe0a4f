// The bytes before the grammar.
#include "doc_check.h"
#include "doc/reader.h"

static void bad_bytes_get_line_and_column(void **state)
{
    (void)state;
    check_refused("a: 1\nb: \xff\n", YK_CODE_YAML_UTF8, 2, 4, "UTF-8");
    check_refused("\xc3\xa9: \xe9\n", YK_CODE_YAML_UTF8, 1, 4, "UTF-8");
    check_refused("a: \xc0\x80", YK_CODE_YAML_UTF8, 1, 4, NULL);         // an overlong zero
    check_refused("a: \xed\xa0\x80", YK_CODE_YAML_UTF8, 1, 4, NULL);     // a surrogate
    check_refused("a: \xf4\x90\x80\x80", YK_CODE_YAML_UTF8, 1, 4, NULL); // beyond U+10FFFF
    check_refused("a: \xe2\x82", YK_CODE_YAML_UTF8, 1, 4, NULL);         // cut off at the end
    check_refused("# \x80\n", YK_CODE_YAML_UTF8, 1, 3, NULL);            // in a comment too
    check_refused_bytes("\xff\xfe"
                        "a\0",
                        4, YK_CODE_YAML_UTF8, 1, 1, "UTF-8"); // UTF-16
}

static void control_characters_are_named(void **state)
{
    (void)state;
    check_refused_bytes("a: \0", 4, YK_CODE_YAML_CONTROL, 1, 4, "U+0000");
    check_refused("a: 1\n\x1b[31m\n", YK_CODE_YAML_CONTROL, 2, 1, "U+001B");
    check_refused("a\x7f", YK_CODE_YAML_CONTROL, 1, 2, "U+007F");
    check_refused("a: 1\rb: 2\n", YK_CODE_YAML_CONTROL, 1, 5, "U+000D");
    check_refused("a: 1\r", YK_CODE_YAML_CONTROL, 1, 5, "U+000D");
    check_refused("a: \xc2\x85", YK_CODE_YAML_CONTROL, 1, 4, "U+0085");
    check_refused("a: \xe2\x80\xa8", YK_CODE_YAML_CONTROL, 1, 4, "U+2028");
    check_refused("a: \xe2\x80\xae", YK_CODE_YAML_CONTROL, 1, 4, "U+202E");
    check_refused("a: \xef\xbb\xbf", YK_CODE_YAML_CONTROL, 1, 4, "U+FEFF");
    check_refused("a: \xef\xbf\xbf", YK_CODE_YAML_CONTROL, 1, 4, "U+FFFF");
}

static void tabs_are_refused_in_the_indentation_only(void **state)
{
    (void)state;
    check_refused("a:\n\tb: 1\n", YK_CODE_YAML_TAB, 2, 1, "spaces");
    check_refused("a:\n  \tb: 1\n", YK_CODE_YAML_TAB, 2, 3, "spaces");
    check_refused("\t# comment\n", YK_CODE_YAML_TAB, 1, 1, "spaces");
    check_tree("a: 1\t# comment\twith tabs\n", 0, "{a: 1}");
}

static void allowed_text_is_all_that_is_visible(void **state)
{
    (void)state;
    assert_true(yk_doc_is_allowed('a') && yk_doc_is_allowed(' ') && yk_doc_is_allowed(0xe9) &&
                yk_doc_is_allowed(0x200d));
    assert_true(yk_doc_is_allowed(0x3b8) && yk_doc_is_allowed(0x1f600) && yk_doc_is_allowed(0xfffd));
    assert_false(yk_doc_is_allowed('\t') || yk_doc_is_allowed('\n') || yk_doc_is_allowed(0x7f) ||
                 yk_doc_is_allowed(0x9f));
    assert_false(yk_doc_is_allowed(0x2029) || yk_doc_is_allowed(0x2066) || yk_doc_is_allowed(0xfdd0) ||
                 yk_doc_is_allowed(0x1fffe));
}

static void places_count_lines_and_code_points(void **state)
{
    (void)state;
    const char *text = "ab\n\xc3\xa9"
                       "cd\n";
    const unsigned expected[][2] = {{1, 1}, {1, 2}, {1, 3}, {2, 1}};
    for (size_t i = 0; i < 4; i++) {
        YkPlace place = yk_doc_place_of(text, i);
        assert_int_equal(place.line, expected[i][0]);
        assert_int_equal(place.column, expected[i][1]);
    }
    assert_int_equal(yk_doc_place_of(text, 5).column, 2); // after the two bytes of one letter
    assert_int_equal(yk_doc_place_of(text, 8).line, 3);
}

static void every_single_byte_is_accepted_or_refused_with_a_place(void **state)
{
    (void)state;
    for (int byte = 0; byte < 256; byte++) {
        char text[] = {'a', ' ', (char)byte, 'b'};
        YkProblems *problems = yk_problems_new();
        bool fine = yk_doc_guard(text, sizeof text, problems);
        bool expected = (byte >= 0x20 && byte < 0x7f) || byte == '\n' || byte == '\t';
        assert_int_equal(fine, expected);
        assert_int_equal(yk_problems_count(problems), !expected);
        if (!fine) assert_int_equal(yk_problems_get(problems, 0)->place.column, 3);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_bytes_get_line_and_column),
        cmocka_unit_test(control_characters_are_named),
        cmocka_unit_test(tabs_are_refused_in_the_indentation_only),
        cmocka_unit_test(allowed_text_is_all_that_is_visible),
        cmocka_unit_test(places_count_lines_and_code_points),
        cmocka_unit_test(every_single_byte_is_accepted_or_refused_with_a_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
