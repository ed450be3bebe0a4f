// Escapes of text that a terminal would act upon.
#include "check.h"
#include "base/escape.h"
#include "base/utf8.h"

static void check_escape(const char *data, size_t length, const char *expected)
{
    YkText text = {0};
    yk_escape(&text, data, length);
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
}

static void printable_text_stays_as_it_is(void **state)
{
    (void)state;
    const char *const cases[] = {"", "crank", "a b~`\"\\", "Käfig θ₁ 曲柄 😀"};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check_escape(cases[i], strlen(cases[i]), cases[i]);
}

static void what_a_terminal_would_act_upon_is_escaped(void **state)
{
    (void)state;
    check_escape("a\nb\tc\rd", 7, "a\\nb\\tc\\rd");
    check_escape("\x1b[31m", 5, "\\x1b[31m");
    check_escape("a\0b", 3, "a\\x00b");
    check_escape("\x7f\xc2\x9b", 3, "\\x7f\\x9b");
    check_escape("\xe2\x80\xae", 3, "\\u{202e}");
    check_escape("\xf3\xa0\x81\x81", 4, "\\u{0e0041}");
    check_escape("\xff\xc3(\xe2\x82", 5, "\\xff\\xc3(\\xe2\\x82");
}

static void the_escape_of_any_bytes_is_printable_utf8(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int i = 0; i < 3000; i++) {
        char data[50];
        size_t length = check_random(&seed) % sizeof data;
        for (size_t k = 0; k < length; k++) data[k] = (char)check_random(&seed);
        YkText text = {0};
        yk_escape(&text, data, length);
        for (size_t k = 0; k < text.length;) {
            uint32_t code;
            size_t size = yk_utf8_decode(text.data + k, text.length - k, &code);
            assert_true(size > 0 && yk_utf8_printable(code));
            k += size;
        }
        yk_text_free(&text);
    }
}

static void columns_count_terminal_columns(void **state)
{
    (void)state;
    static const struct {
        const char *data;
        size_t columns;
    } cases[] = {{"a", 1}, {"ä", 1}, {"曲", 2}, {"\x1b", 4}, {"\xcc\x81", 0}, {"\n", 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkText text = {0};
        size_t columns = 10;
        assert_int_equal(yk_escape_one(&text, cases[i].data, strlen(cases[i].data), &columns), strlen(cases[i].data));
        assert_int_equal(columns, 10 + cases[i].columns);
        yk_text_free(&text);
    }
}

static void check_quoted(const char *string, const char *expected)
{
    YkText text = {0};
    yk_escape_quoted(&text, string);
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
}

static void quoted_text_is_cut_at_80_columns(void **state)
{
    (void)state;
    char string[200], expected[210];
    check_quoted("crank", "`crank`");
    memset(string, 'x', sizeof string);
    string[80] = '\0';
    snprintf(expected, sizeof expected, "`%s`", string);
    check_quoted(string, expected);
    string[80] = 'x';
    string[120] = '\0';
    snprintf(expected, sizeof expected, "`%.80s...`", string);
    check_quoted(string, expected);
    YkText text = {0};
    char wide[3 * 60 + 1] = "";
    for (int i = 0; i < 60; i++) strcat(wide, "曲");
    yk_escape_quoted(&text, wide);
    assert_int_equal(text.length, 2 + 40 * 3 + 3); // 40 of them are 80 columns
    yk_text_free(&text);
}

// What XML reserves is replaced by names, which name it; what XML has no place for, by one sign; the rest stays.
static void any_text_comes_back_from_xml(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        char sign;
    } names[] = {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"\xef\xbf\xbd", '\x01'}};
    uint64_t seed = 5;
    for (int trial = 0; trial < 300; trial++) {
        char data[60], back[60];
        size_t length = check_random(&seed) % (sizeof data - 1), count = 0;
        for (size_t k = 0; k < length; k++) data[k] = "&<>\"'abc\x01 ;#"[check_random(&seed) % 13];
        data[length] = '\0';
        YkText xml = {0};
        yk_escape_xml(&xml, data);
        for (const char *c = yk_text_get(&xml); *c;) {
            char sign = *c;
            size_t size = 1;
            for (size_t k = 0; k < sizeof names / sizeof *names; k++)
                if (strncmp(c, names[k].name, strlen(names[k].name)) == 0)
                    sign = names[k].sign, size = strlen(names[k].name);
            assert_true(size > 1 || (*c >= ' ' && !strchr("&<>\"", *c)));
            back[count++] = sign;
            c += size;
        }
        back[count] = '\0';
        assert_string_equal(back, data);
        yk_text_free(&xml);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(printable_text_stays_as_it_is),
        cmocka_unit_test(what_a_terminal_would_act_upon_is_escaped),
        cmocka_unit_test(the_escape_of_any_bytes_is_printable_utf8),
        cmocka_unit_test(columns_count_terminal_columns),
        cmocka_unit_test(any_text_comes_back_from_xml),
        cmocka_unit_test(quoted_text_is_cut_at_80_columns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
