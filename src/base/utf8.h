// UTF-8: one code point at a time, strictly, and how it shows on a terminal.
#ifndef BASE_UTF8_H
#define BASE_UTF8_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Decodes the code point at text[0..length), length > 0. Returns its bytes (1..4), or 0 when the bytes are not UTF-8;
// overlong forms, surrogates and values beyond U+10FFFF count as not UTF-8.
size_t yk_utf8_decode(const char *text, size_t length, uint32_t *code);
// False for control characters, for those that reorder or hide text, and for line and paragraph separators.
bool yk_utf8_printable(uint32_t code);
// Returns the columns on a terminal: 0 combining, 2 East Asian wide and most emoji, 1 otherwise; approximate, by
// blocks.
int yk_utf8_width(uint32_t code);

#endif
