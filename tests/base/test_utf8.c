// UTF-8: decoding, printable characters, widths.
#include "check.h"
#include <stdlib.h>
#include "base/utf8.h"

static size_t encode(uint32_t code, char out[4])
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    size_t size = code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (size_t i = size - 1; i > 0; i--, code >>= 6) out[i] = (char)(0x80 | (code & 0x3f));
    out[0] = (char)((0xf00u >> size & 0xf0u) | code);
    return size;
}

static void every_code_point_decodes_to_itself_and_surrogates_do_not(void **state)
{
    (void)state;
    for (uint32_t code = 0; code <= 0x10ffff; code++) {
        char bytes[4];
        uint32_t back = 0;
        size_t size = encode(code, bytes), read = yk_utf8_decode(bytes, size, &back);
        if (code >= 0xd800 && code <= 0xdfff) {
            assert_int_equal(read, 0);
        } else {
            assert_int_equal(read, size);
            assert_int_equal(back, code);
        }
    }
}

static void a_cut_sequence_does_not_decode(void **state)
{
    (void)state;
    const uint32_t codes[] = {0x80, 0x7ff, 0x800, 0xffff, 0x10000, 0x10ffff};
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++) {
        char bytes[4];
        uint32_t back;
        size_t size = encode(codes[i], bytes);
        for (size_t cut = 1; cut < size; cut++) {
            char *heap = malloc(cut); // on the heap, where reading on would be seen
            memcpy(heap, bytes, cut);
            assert_int_equal(yk_utf8_decode(heap, cut, &back), 0);
            free(heap);
        }
    }
}

static void overlong_and_impossible_bytes_do_not_decode(void **state)
{
    (void)state;
    const char *const cases[] = {"\x80",
                                 "\xbf",
                                 "\xc0\x80",
                                 "\xc1\xbf",
                                 "\xe0\x80\x80",
                                 "\xe0\x9f\xbf",
                                 "\xf0\x80\x80\x80",
                                 "\xf0\x8f\xbf\xbf",
                                 "\xf4\x90\x80\x80",
                                 "\xf5\x80\x80\x80",
                                 "\xfe",
                                 "\xff",
                                 "\xc3(",
                                 "\xe2\x82(",
                                 "\xf0\x9f\x98("};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        uint32_t code;
        assert_int_equal(yk_utf8_decode(cases[i], strlen(cases[i]), &code), 0);
    }
}

static void control_and_reordering_characters_are_not_printable(void **state)
{
    (void)state;
    const uint32_t hidden[] = {0,    7,      '\t',   '\n',   0x1b,   0x7f,   0x85,   0x9b,
                               0xad, 0x200b, 0x200e, 0x2028, 0x202e, 0x2066, 0xfeff, 0xe0041};
    const uint32_t shown[] = {' ', '~', 'a', 0xa0, 0xe9, 0x3b8, 0x2010, 0x2030, 0x4e2d, 0x1f600};
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++) assert_false(yk_utf8_printable(hidden[i]));
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++) assert_true(yk_utf8_printable(shown[i]));
}

static void widths_are_those_of_a_terminal(void **state)
{
    (void)state;
    const uint32_t narrow[] = {'a', 0xe9, 0x3b8, 0x416, 0x5d0, 0xff61};
    const uint32_t wide[] = {0x1100, 0x3042, 0x4e2d, 0xac00, 0xff21, 0x1f600, 0x20000};
    const uint32_t none[] = {0x301, 0x20d7, 0xfe0f};
    for (size_t i = 0; i < sizeof narrow / sizeof *narrow; i++) assert_int_equal(yk_utf8_width(narrow[i]), 1);
    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++) assert_int_equal(yk_utf8_width(wide[i]), 2);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) assert_int_equal(yk_utf8_width(none[i]), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_code_point_decodes_to_itself_and_surrogates_do_not),
        cmocka_unit_test(a_cut_sequence_does_not_decode),
        cmocka_unit_test(overlong_and_impossible_bytes_do_not_decode),
        cmocka_unit_test(control_and_reordering_characters_are_not_printable),
        cmocka_unit_test(widths_are_those_of_a_terminal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
