// Letters and digits of ASCII, in every locale.
#ifndef BASE_LETTERS_H
#define BASE_LETTERS_H
#include <stdbool.h>

static inline bool yk_is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static inline bool yk_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

// Returns whether a name of the file may begin with it.
static inline bool yk_begins_name(char c)
{
    return yk_is_letter(c) || c == '_';
}

#endif
