// DXF: pairs of code and value, sections in order, coordinates as given.
#include "check.h"
#include <stdlib.h>
#include "picture/dxf.h"

// Counts pairs whose code and value are these.
static int count_pairs(const char *text, int code, const char *value)
{
    int count = 0;
    while (*text) {
        int read = 0, own = (int)strtol(text, NULL, 10);
        const char *line = strchr(text, '\n');
        assert_non_null(line);
        const char *end = strchr(++line, '\n');
        assert_non_null(end);
        read = own == code && (size_t)(end - line) == strlen(value) && strncmp(line, value, strlen(value)) == 0;
        count += read;
        text = end + 1;
    }
    return count;
}

static YkText drawing(void)
{
    static const char *const layers[] = {"surface", "base"};
    const YkVec corners[] = {{0, 0}, {10.5, 0}, {10.5, -1e-12}, {1.0 / 3, 4}};
    YkText dxf = {0};
    yk_dxf_begin(&dxf, layers, 2);
    yk_dxf_outline(&dxf, "surface", corners, 4);
    yk_dxf_circle(&dxf, "base", yk_vec(1, 2), 7.25);
    yk_dxf_line(&dxf, "base", yk_vec(-1, 0), yk_vec(1, 0));
    yk_dxf_end(&dxf);
    assert_false(dxf.failed);
    return dxf;
}

static void sections_open_and_close(void **state)
{
    (void)state;
    YkText dxf = drawing();
    const char *text = yk_text_get(&dxf);
    assert_int_equal(count_pairs(text, 0, "SECTION"), 3);
    assert_int_equal(count_pairs(text, 0, "ENDSEC"), 3);
    assert_int_equal(count_pairs(text, 0, "EOF"), 1);
    assert_int_equal(count_pairs(text, 1, "AC1009"), 1);
    assert_int_equal(count_pairs(text, 0, "LAYER"), 2);
    assert_true(strcmp(text + dxf.length - strlen("0\nEOF\n"), "0\nEOF\n") == 0);
    yk_text_free(&dxf);
}

static void an_outline_is_a_closed_polyline(void **state)
{
    (void)state;
    YkText dxf = drawing();
    const char *text = yk_text_get(&dxf);
    assert_int_equal(count_pairs(text, 0, "POLYLINE"), 1);
    assert_int_equal(count_pairs(text, 0, "VERTEX"), 4);
    assert_int_equal(count_pairs(text, 0, "SEQEND"), 1);
    assert_int_equal(count_pairs(text, 66, "1"), 1);
    assert_int_equal(count_pairs(text, 10, "10.500000000"), 2);
    assert_int_equal(count_pairs(text, 10, "0.333333333"), 1);
    assert_null(strstr(text, "-0.000000000")); // what rounds to nothing has no sign
    assert_null(strstr(text, "e-"));           // no exponents: some readers know none
    yk_text_free(&dxf);
}

static void circles_and_lines_stand_on_their_layers(void **state)
{
    (void)state;
    YkText dxf = drawing();
    const char *text = yk_text_get(&dxf);
    assert_int_equal(count_pairs(text, 0, "CIRCLE"), 1);
    assert_int_equal(count_pairs(text, 40, "7.250000000"), 1);
    assert_int_equal(count_pairs(text, 0, "LINE"), 1);
    assert_int_equal(count_pairs(text, 11, "1.000000000"), 1);
    assert_int_equal(count_pairs(text, 8, "base"), 2);
    assert_int_equal(count_pairs(text, 8, "surface"), 6);
    yk_text_free(&dxf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sections_open_and_close),
        cmocka_unit_test(an_outline_is_a_closed_polyline),
        cmocka_unit_test(circles_and_lines_stand_on_their_layers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
