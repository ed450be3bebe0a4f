// Tables for people.
#include "check.h"
#include "write/table.h"

static void numbers_stand_by_their_decimal_points(void **state)
{
    (void)state;
    YkText text = {0};
    YkTable *table = yk_table_new(2);
    yk_table_head(table, "name", NULL);
    yk_table_head(table, "x", "mm");
    const double values[] = {1.5, -12.25, 100, 0.001};
    for (int i = 0; i < 4; i++) {
        yk_table_word(table, "p");
        yk_table_number(table, values[i], 6);
    }
    assert_true(yk_table_write(table, 2, &text));
    assert_string_equal(yk_text_get(&text), "  name   x [mm]\n"
                                            "  p       1.5\n"
                                            "  p     -12.25\n"
                                            "  p     100\n"
                                            "  p       0.001\n");
    yk_table_free(table);
    yk_text_free(&text);
}

static void what_is_not_a_number_is_a_dash_and_zero_has_no_sign(void **state)
{
    (void)state;
    YkText text = {0};
    YkTable *table = yk_table_new(1);
    yk_table_head(table, "v", NULL);
    yk_table_number(table, NAN, 6);
    yk_table_number(table, INFINITY, 6);
    yk_table_number(table, -0.0, 6);
    assert_true(yk_table_write(table, 0, &text));
    assert_string_equal(yk_text_get(&text), "v\n-\n-\n0\n");
    yk_table_free(table);
    yk_text_free(&text);
}

static void names_beyond_ascii_are_measured_in_columns(void **state)
{
    (void)state;
    YkText text = {0};
    YkTable *table = yk_table_new(2);
    yk_table_head(table, "k", NULL);
    yk_table_head(table, "v", NULL);
    yk_table_word(table, "\xc3\xbc\xc3\xbc"); // two letters, four bytes
    yk_table_word(table, "a");
    yk_table_word(table, "bbb");
    yk_table_word(table, "c");
    assert_true(yk_table_write(table, 0, &text));
    assert_string_equal(yk_text_get(&text), "k    v\n\xc3\xbc\xc3\xbc   a\nbbb  c\n");
    assert_int_equal(yk_text_columns("e\xcc\x81", 3), 1); // e and a combining accent
    yk_table_free(table);
    yk_text_free(&text);
}

static void no_line_ends_in_blanks_and_all_columns_line_up(void **state)
{
    (void)state;
    uint64_t seed = 3;
    YkText text = {0};
    YkTable *table = yk_table_new(4);
    for (int c = 0; c < 4; c++) yk_table_head(table, c ? "head" : "", NULL);
    for (int i = 0; i < 100; i++) {
        yk_table_word(table, i % 3 ? "word" : "");
        yk_table_number(table, floor(check_uniform(&seed, -999, 999)) + 0.25, 6); // always with a point
        yk_table_number(table, check_uniform(&seed, -1, 1) * 1e-7, 3);
        yk_table_word(table, i % 2 ? "x" : "");
    }
    assert_true(yk_table_write(table, 1, &text));
    size_t lines = 0, point = 0;
    for (const char *line = yk_text_get(&text), *end; (end = strchr(line, '\n')) != NULL; line = end + 1, lines++) {
        assert_true(end == line || end[-1] != ' ');
        const char *dot = memchr(line, '.', (size_t)(end - line));
        if (lines == 0 || !dot) continue;
        if (point == 0) point = (size_t)(dot - line);
        assert_int_equal(dot - line, point); // the first number's point, in every row
    }
    assert_int_equal(lines, 101);
    yk_table_free(table);
    yk_text_free(&text);
}

static void a_text_that_failed_makes_its_table_and_what_it_is_written_to_fail(void **state)
{
    (void)state;
    YkText lost = {0}, text = {0}, html = {0};
    YkTable *table = yk_table_new(1);
    yk_text_fail(&lost);
    assert_false(yk_table_failed(table));
    yk_table_word(table, yk_text_get(&lost));
    assert_true(yk_table_failed(table));
    assert_false(yk_table_write(table, 0, &text));
    assert_false(yk_table_write_html(table, "of one word", &html));
    assert_true(text.failed && html.failed);
    yk_table_free(table);
    yk_text_free(&lost);
    yk_text_free(&text);
    yk_text_free(&html);
}

static void a_table_without_memory_or_cells_is_harmless(void **state)
{
    (void)state;
    YkText text = {0};
    yk_table_head(NULL, "x", NULL);
    yk_table_number(NULL, 1, 6);
    assert_false(yk_table_write(NULL, 0, &text));
    assert_true(text.failed); // what should stand there does not
    yk_text_free(&text);
    YkTable *table = yk_table_new(3);
    assert_true(yk_table_write(table, 0, &text));
    assert_string_equal(yk_text_get(&text), "");
    yk_table_free(table);
    yk_table_free(NULL);
    yk_text_free(&text);
}

static void html_has_heads_and_escapes(void **state)
{
    (void)state;
    YkTable *table = yk_table_new(2);
    YkText html = {0};
    assert_int_equal(yk_table_rows(table), 0);
    yk_table_head(table, "joint", NULL);
    yk_table_head(table, "size", "N");
    assert_int_equal(yk_table_rows(table), 0);
    yk_table_word(table, "A<B");
    yk_table_number(table, 1.5, 6);
    assert_int_equal(yk_table_rows(table), 1);
    assert_true(yk_table_write_html(table, "a & b", &html));
    assert_string_equal(
        yk_text_get(&html),
        "<table>\n<caption>a &amp; b</caption>\n"
        "<thead><tr><th scope=\"col\">joint</th><th scope=\"col\" class=\"n\">size [N]</th></tr></thead>\n"
        "<tbody>\n<tr><th scope=\"row\">A&lt;B</th><td class=\"n\">1.5</td></tr>\n</tbody>\n</table>\n");
    yk_text_free(&html);
    yk_table_free(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(html_has_heads_and_escapes),
        cmocka_unit_test(numbers_stand_by_their_decimal_points),
        cmocka_unit_test(what_is_not_a_number_is_a_dash_and_zero_has_no_sign),
        cmocka_unit_test(names_beyond_ascii_are_measured_in_columns),
        cmocka_unit_test(no_line_ends_in_blanks_and_all_columns_line_up),
        cmocka_unit_test(a_text_that_failed_makes_its_table_and_what_it_is_written_to_fail),
        cmocka_unit_test(a_table_without_memory_or_cells_is_harmless),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
