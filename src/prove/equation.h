// Reading an equation: what equation.c (sums, products, powers) and equation_words.c (numbers, names, functions) share.
#ifndef PROVE_EQUATION_H
#define PROVE_EQUATION_H
#include "prove/quantities.h"
#include "base/letters.h"
#include "base/units/units.h"
#include "derive/inside.h"
#include "prove/check.h"

// The physical dimension of what was read.
typedef enum YkEquationSizeKind {
    YK_SIZE_OPEN, // not known
    YK_SIZE_BARE, // contains numbers without a unit: fits any dimension
    YK_SIZE_KNOWN
} YkEquationSizeKind;
typedef struct YkEquationSize {
    YkEquationSizeKind kind;
    YkDimension dimension;
    bool has_unit; // a unit is written in it
} YkEquationSize;

typedef struct YkEquationReader {
    YkDerivation *d;
    const char *text;
    size_t length, at;
    YkPlace place;
    YkProblems *problems;
    int depth;
    bool is_right, failed;
    YkEquationSize size;  // of the latest part
    YkEquation *equation; // takes the summands of the sides
} YkEquationReader;

// Returns the next character that is not a blank; '\0' at the end.
char yk_equation_peek(YkEquationReader *reader);
// Reports a problem, but only the first. Returns NULL.
const YkForm *yk_equation_refuse(YkEquationReader *reader, size_t start, const char *message, const char *hint);
const YkForm *yk_equation_bracket(YkEquationReader *reader); // ( ... ) or [ ... ]
// Reads a bracket, a function, a name, or a number with or without a unit.
const YkForm *yk_equation_atom(YkEquationReader *reader);

// --- equation_sizes.c
YkEquationSize yk_equation_size_of(const YkDerivation *d, int32_t symbol);
YkEquationSize yk_equation_size_of_quantity(const YkDerivation *d, const char *name); // of yk_derive_quantity
YkEquationSize yk_equation_size_times(YkEquationSize a, YkEquationSize b, int power); // a b^power, power 1 or -1
YkEquationSize yk_equation_size_power(YkEquationSize a, int exponent);
YkEquationSize yk_equation_size_root(YkEquationSize a);
// Does the same for a sum; reports what does not fit, where b begins at `start`.
YkEquationSize yk_equation_size_sum(YkEquationReader *reader, size_t start, YkEquationSize a, YkEquationSize b);
void yk_equation_compare_sides(YkEquationReader *reader, size_t start, YkEquationSize left, YkEquationSize right);
bool yk_equation_size_is_angle(YkEquationReader *reader, size_t start, YkEquationSize size); // or reported

// --- equation_angles.c
// Returns e^(i angle) of any angle.
const YkPoisson *yk_equation_unit(YkDerivation *d, const YkPoisson *angle);
// Returns whether the element contains an angle or root of which nothing can be proved.
bool yk_equation_has_own(const YkDerivation *d, const YkPoisson *a);
const YkPoisson *yk_equation_root(YkDerivation *d, const YkPoisson *square); // positive
// Returns whether the element contains a symbol, in such angles too.
bool yk_equation_mentions(const YkDerivation *d, const YkPoisson *a, int32_t symbol);

// --- equation_laws.c
// Reads the bracket behind a law's name if it is an argument. Otherwise returns NULL and leaves the reader where it
// was.
const YkForm *yk_equation_call(YkEquationReader *reader, int32_t symbol);

// --- equation_pages.c
// Returns the symbol with this name, even if only sections have it on their pages; -1 if there is none. Its meaning is
// what it stands for.
int32_t yk_equation_find(YkDerivation *d, const char *name);
const YkForm *yk_equation_meaning(YkDerivation *d, int32_t symbol);
bool yk_equation_speaks_of(const YkDerivation *d, const YkForm *form, int32_t symbol);
// Finds the elements that must lie in 0 to 1 for the equation to hold, if it is about a segment of a motion program.
// Returns their count.
size_t yk_equation_segments(YkDerivation *d, const YkEquation *equation, const YkPoisson **within, size_t most);

#endif
