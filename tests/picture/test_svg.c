// SVG elements.
#include "base/escape.h"
#include "check.h"
#include "picture/svg.h"

static void numbers_have_two_decimals_at_most_and_no_negative_zero(void **state)
{
    (void)state;
    const struct {
        double value;
        const char *text;
    } cases[] = {
        {0, "0"},         {-0.0, "0"},  {-0.001, "0"},     {1, "1"},       {1.5, "1.5"},
        {-2.25, "-2.25"}, {100, "100"}, {3.14159, "3.14"}, {10.996, "11"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkText svg = {0};
        yk_svg_number(&svg, cases[i].value);
        assert_string_equal(yk_text_get(&svg), cases[i].text);
        yk_text_free(&svg);
    }
}

static void what_xml_reserves_is_escaped(void **state)
{
    (void)state;
    YkText svg = {0};
    yk_escape_xml(&svg, "a<b & \"c\">\x01");
    assert_string_equal(yk_text_get(&svg), "a&lt;b &amp; &quot;c&quot;&gt;\xef\xbf\xbd");
    yk_text_free(&svg);
}

static void elements_are_written_with_their_attributes(void **state)
{
    (void)state;
    const YkVec corners[] = {{0, 0}, {1, 0}, {0.5, 2}};
    YkText svg = {0};
    yk_svg_line(&svg, corners[0], corners[2], "stroke=\"red\"");
    yk_svg_circle(&svg, corners[1], 3, "");
    yk_svg_polygon(&svg, corners, 3, "");
    yk_svg_polyline(&svg, corners, 2, "fill=\"none\"");
    yk_svg_word(&svg, corners[1], "A&B", "fill=\"black\"");
    assert_string_equal(yk_text_get(&svg), "<line x1=\"0\" y1=\"0\" x2=\"0.5\" y2=\"2\" stroke=\"red\"/>\n"
                                           "<circle cx=\"1\" cy=\"0\" r=\"3\"/>\n"
                                           "<polygon points=\"0,0 1,0 0.5,2\"/>\n"
                                           "<polyline points=\"0,0 1,0\" fill=\"none\"/>\n"
                                           "<text x=\"1\" y=\"0\" fill=\"black\">A&amp;B</text>\n");
    yk_text_free(&svg);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_have_two_decimals_at_most_and_no_negative_zero),
        cmocka_unit_test(what_xml_reserves_is_escaped),
        cmocka_unit_test(elements_are_written_with_their_attributes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
