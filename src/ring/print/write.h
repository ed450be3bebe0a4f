// Elements of the ring in print, and back.
#ifndef RING_PRINT_WRITE_H
#define RING_PRINT_WRITE_H
#include "base/problems.h"
#include "base/text.h"
#include "ring/ring.h"

typedef enum YkRingFormat {
    YK_RING_TEXT,   // l1*cos(theta1) - d3*cos(theta2), rates as theta1'
    YK_RING_BOOK,   // the same with a space for the product: m2 l1 lc2 sin(theta2) theta2'
    YK_RING_LATEX,  // inside of $ $; article and amsmath are enough
    YK_RING_MATHML, // the inside of <math>, presentation
    YK_RING_C,      // an expression in doubles, real elements only; symbols by yk_ring_c_name
    YK_RING_FORMATS
} YkRingFormat;

typedef enum YkRingStyle {
    YK_RING_TEXTBOOK, // accelerations first, one bracket each; then products of rates, gravity, the rest; factored for
                      // the reader
    YK_RING_BRACKETS, // products of rates with one bracket each, too, as in T = 1/2 (...) theta1'^2 + ...
    YK_RING_EXPANDED, // every term by itself
    YK_RING_STYLES
} YkRingStyle;

// Adds the element to text, and returns whether it did; on failure (no memory, YK_RING_NOT_REAL for C) the ring's
// status tells. Every term is there with its exact coefficient: what is written reads back as the identical element.
// The order depends on the order of the symbols alone.
bool yk_ring_write(YkRing *ring, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text);
// Half of it, where that has no fraction and no denominator, but for those of pi, when it is written term by term; else
// NULL.
const YkPoisson *yk_ring_half_if_whole(YkRing *ring, const YkPoisson *a);
// A symbol as it is named in a format; the C name is an identifier of its own, MathML an element. As in text where
// memory is short, with the ring's status.
const char *yk_ring_name_in(YkRing *ring, int32_t symbol, YkRingFormat format);

// Reads what a hand or yk_ring_write has written, in TEXT and BOOK (either may be in the other's style), LATEX and C:
// + - * / ^, products by juxtaposition, parentheses, names, decimal numbers (exact), cos sin of whole combinations of
// angles and rational multiples of pi, exp(i ...), sqrt of 2^a 3^b n^2, the imaginary unit as `i` where no symbol is
// called so and as `1i` always. NULL with problems (which may be NULL) on a mistake; the ring's status stays as it was.
const YkPoisson *yk_ring_read(YkRing *ring, YkRingFormat format, const char *text, size_t length, YkPlace place,
                              YkProblems *problems);

#endif
