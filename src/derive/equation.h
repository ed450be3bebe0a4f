// Reading an equation: what equation.c (sums, products, powers) and equation_words.c (numbers, names, functions) share.
#ifndef DERIVE_EQUATION_H
#define DERIVE_EQUATION_H
#include "derive/check.h"
#include "derive/frame.h"

typedef struct YkEquationReader {
    YkDerivation *d;
    const char *text;
    size_t length, at;
    YkPlace place;
    YkProblems *problems;
    int depth;
    bool is_right, failed;
    YkEquation *equation; // takes the summands of the sides
} YkEquationReader;

// The next character that is no blank; '\0' at the end.
char yk_equation_peek(YkEquationReader *reader);
// Reports a problem, the first only; returns NULL.
const YkForm *yk_equation_refuse(YkEquationReader *reader, size_t start, const char *message, const char *hint);
const YkForm *yk_equation_bracket(YkEquationReader *reader); // ( ... ) or [ ... ]
// base, or its power where ^ follows. NULL base: NULL.
const YkForm *yk_equation_raised(YkEquationReader *reader, const YkForm *base);
// A bracket, a function, a name, a number with or without a unit.
const YkForm *yk_equation_atom(YkEquationReader *reader);

static inline bool yk_is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static inline bool yk_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

#endif
