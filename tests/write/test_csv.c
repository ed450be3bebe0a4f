// CSV.
#include "check.h"
#include <stdlib.h>
#include "write/csv.h"

static void a_row_has_commas_between_and_a_newline_behind(void **state)
{
    (void)state;
    YkText text = {0};
    YkCsv csv = {.text = &text};
    yk_csv_name(&csv, "t");
    yk_csv_name(&csv, "d5.rate");
    yk_csv_row(&csv);
    yk_csv_number(&csv, 0);
    yk_csv_number(&csv, -0.25);
    yk_csv_row(&csv);
    assert_string_equal(yk_text_get(&text), "t,d5.rate\n0,-0.25\n");
    yk_text_free(&text);
}

static void names_are_quoted_only_where_they_must_be(void **state)
{
    (void)state;
    const char *const cases[][2] = {
        {"plain", "plain"},
        {"a b", "a b"},
        {"a,b", "\"a,b\""},
        {"say \"x\"", "\"say \"\"x\"\"\""},
        {"two\nlines", "\"two\nlines\""},
        {"", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkText text = {0};
        YkCsv csv = {.text = &text};
        yk_csv_name(&csv, cases[i][0]);
        assert_string_equal(yk_text_get(&text), cases[i][1]);
        yk_text_free(&text);
    }
}

static void a_number_that_is_none_is_an_empty_field(void **state)
{
    (void)state;
    YkText text = {0};
    YkCsv csv = {.text = &text};
    yk_csv_number(&csv, 1);
    yk_csv_number(&csv, NAN);
    yk_csv_number(&csv, INFINITY);
    yk_csv_number(&csv, 2);
    yk_csv_row(&csv);
    assert_string_equal(yk_text_get(&text), "1,,,2\n");
    yk_text_free(&text);
}

static void numbers_read_back_to_the_same_double(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 5000; i++) {
        double value = check_uniform(&seed, -1e3, 1e3);
        YkText text = {0};
        YkCsv csv = {.text = &text};
        yk_csv_number(&csv, value);
        assert_true(strtod(yk_text_get(&text), NULL) == value);
        yk_text_free(&text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row_has_commas_between_and_a_newline_behind),
        cmocka_unit_test(names_are_quoted_only_where_they_must_be),
        cmocka_unit_test(a_number_that_is_none_is_an_empty_field),
        cmocka_unit_test(numbers_read_back_to_the_same_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
