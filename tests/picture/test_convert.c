// SVG converted to PDF and PNG.
#include "check.h"
#include <stdlib.h>
#include "base/codes.h"
#include "picture/convert.h"

static const char picture[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"30\">"
                              "<circle cx=\"20\" cy=\"15\" r=\"10\"/></svg>";

// Converts; false, with the code checked, where the program is not installed.
static bool convert(YkFileKind kind, YkText *output)
{
    YkProblems *problems = yk_problems_new();
    bool good = yk_convert_svg(picture, kind, output, problems);
    if (!good) assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_PROGRAM_MISSING);
    if (!good) assert_non_null(yk_problems_get(problems, 0)->hint);
    yk_problems_free(problems);
    return good;
}

static void svg_stays_what_it_is(void **state)
{
    (void)state;
    YkText output = {0};
    assert_true(convert(YK_FILE_SVG, &output));
    assert_string_equal(yk_text_get(&output), picture);
    yk_text_free(&output);
}

static void pdf_is_a_pdf(void **state)
{
    (void)state;
    YkText output = {0};
    if (convert(YK_FILE_PDF, &output)) assert_memory_equal(yk_text_get(&output), "%PDF-", 5);
    yk_text_free(&output);
}

// The size stands in the first chunk (PNG specification, 11.2.2): twice that of the drawing.
static void png_has_two_pixels_for_one(void **state)
{
    (void)state;
    static const unsigned char head[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    YkText output = {0};
    if (convert(YK_FILE_PNG, &output)) {
        assert_true(output.length > 24);
        assert_memory_equal(output.data, head, sizeof head);
        assert_int_equal((unsigned char)output.data[19], 80);
        assert_int_equal((unsigned char)output.data[23], 60);
    }
    yk_text_free(&output);
}

static void without_the_program_the_message_says_what_to_install(void **state)
{
    (void)state;
    char *path = getenv("PATH"), kept[4096];
    snprintf(kept, sizeof kept, "%s", path ? path : "");
    setenv("PATH", "/no/such/folder", 1);
    YkText output = {0};
    assert_false(convert(YK_FILE_PDF, &output));
    setenv("PATH", kept, 1);
    yk_text_free(&output);
}

static void a_picture_that_is_none_is_refused_with_the_programs_words(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkText output = {0};
    assert_false(yk_convert_svg("this is no svg", YK_FILE_PNG, &output, problems));
    int code = yk_problems_get(problems, 0)->code;
    assert_true(code == YK_CODE_PROGRAM_FAILED || code == YK_CODE_PROGRAM_MISSING);
    yk_problems_free(problems);
    yk_text_free(&output);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(svg_stays_what_it_is),
        cmocka_unit_test(pdf_is_a_pdf),
        cmocka_unit_test(png_has_two_pixels_for_one),
        cmocka_unit_test(without_the_program_the_message_says_what_to_install),
        cmocka_unit_test(a_picture_that_is_none_is_refused_with_the_programs_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
