// Letters and digits of ASCII, in every locale; endings of names.
#ifndef BASE_LETTERS_H
#define BASE_LETTERS_H
#include <stdbool.h>
#include <string.h>

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

// Returns whether a name has this ending, and something before it.
static inline bool yk_has_ending(const char *name, const char *ending)
{
    size_t length = strlen(name), own = strlen(ending);
    return length > own && strcmp(name + length - own, ending) == 0;
}

// Removes the ending from the name; returns false if it ends differently.
static inline bool yk_cut_ending(char *name, const char *ending)
{
    if (!yk_has_ending(name, ending)) return false;
    name[strlen(name) - strlen(ending)] = 0;
    return true;
}

#endif
