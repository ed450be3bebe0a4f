// Small pieces of the page: what is written as an image decodes to what it was, and words are escaped.
#include "report/html.h"
#include "check.h"

static int digit_of(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(digits, c);
    return at && c ? (int)(at - digits) : -1;
}

// Decodes base 64 (RFC 4648) up to the quote; returns the number of bytes.
static size_t decode(const char *text, unsigned char *bytes)
{
    uint32_t bits = 0;
    size_t count = 0, digits = 0, length = 0;
    for (; text[length] != '"'; length++) {
        if (text[length] == '=') continue;
        assert_true(digit_of(text[length]) >= 0);
        bits = bits << 6 | (uint32_t)digit_of(text[length]);
        digits++;
        if (digits % 4 != 1) bytes[count++] = (unsigned char)(bits >> (6 - 2 * ((digits + 3) % 4)));
    }
    assert_int_equal(length % 4, 0);
    return count;
}

static void images_decode_to_what_they_were(void **state)
{
    (void)state;
    uint64_t seed = 14;
    for (size_t length = 0; length <= 70; length++) {
        char svg[71];
        unsigned char back[80];
        YkText html = {0};
        for (size_t k = 0; k < length; k++) svg[k] = (char)check_random(&seed); // any bytes
        yk_html_image(&html, svg, length, "a \"drawing\"", "below");
        const char *text = yk_text_get(&html), *data = strstr(text, "base64,");
        assert_non_null(data);
        assert_int_equal(decode(data + 7, back), length);
        assert_memory_equal(back, svg, length);
        assert_non_null(strstr(text, "alt=\"a &quot;drawing&quot;\""));
        assert_non_null(strstr(text, "below"));
        yk_text_free(&html);
    }
}

// The drawing's own title makes way for the description; nothing else of it is lost.
static void pictures_are_described_once(void **state)
{
    (void)state;
    static const char *const drawings[] = {"<svg width=\"3\"><title>own</title><g id=\"a\"/></svg>\n",
                                           "<svg width=\"3\"><g id=\"a\"/></svg>\n"};
    for (size_t k = 0; k < 2; k++) {
        YkText html = {0};
        yk_html_picture(&html, drawings[k], "a four-bar & its path", "below");
        const char *text = yk_text_get(&html);
        assert_null(strstr(text, "<title>"));
        assert_non_null(strstr(text, "aria-label=\"a four-bar &amp; its path\""));
        assert_non_null(strstr(text, "width=\"3\">"));
        assert_non_null(strstr(text, "<g id=\"a\"/></svg>"));
        assert_non_null(strstr(text, "below"));
        yk_text_free(&html);
    }
}

static void elements_are_escaped(void **state)
{
    (void)state;
    YkText html = {0};
    yk_html_element(&html, "p", "a < b & c");
    assert_string_equal(yk_text_get(&html), "<p>a &lt; b &amp; c</p>\n");
    yk_text_free(&html);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_decode_to_what_they_were),
        cmocka_unit_test(pictures_are_described_once),
        cmocka_unit_test(elements_are_escaped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
