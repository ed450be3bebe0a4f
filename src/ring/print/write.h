// Writes elements of the ring, and reads them back.
#ifndef RING_PRINT_WRITE_H
#define RING_PRINT_WRITE_H
#include "base/problems.h"
#include "base/text.h"
#include "ring/ring.h"

typedef enum YkRingFormat {
    YK_RING_TEXT,   // l1*cos(theta1) - d3*cos(theta2), rates as theta1'
    YK_RING_BOOK,   // the same with a space for products: m2 l1 lc2 sin(theta2) theta2'
    YK_RING_LATEX,  // for use inside $ $; article and amsmath suffice
    YK_RING_MATHML, // presentation MathML, for use inside <math>
    YK_RING_C,      // an expression in doubles, real elements only; symbols named by yk_ring_c_name
    YK_RING_FORMATS
} YkRingFormat;

typedef enum YkRingStyle {
    YK_RING_TEXTBOOK, // accelerations first, one bracket each; then products of rates, gravity, the rest; factored for
                      // the reader
    YK_RING_BRACKETS, // one bracket for each product of rates as well, as in T = 1/2 (...) theta1'^2 + ...
    YK_RING_EXPANDED, // every term by itself
    YK_RING_STYLES
} YkRingStyle;

// An element that is worked out where it is needed: what `of` becomes by the changes, or x or y of that.
typedef enum YkRingSide { YK_RING_WHOLE, YK_RING_X, YK_RING_Y } YkRingSide;
typedef struct YkRingView {
    const YkPoisson *of;
    YkRingChanges *changes; // NULL: none
    YkRingSide side;
} YkRingView;
static inline YkRingView yk_ring_as_is(const YkPoisson *a)
{
    return (YkRingView){a, NULL, YK_RING_WHOLE};
}
const YkPoisson *yk_ring_view(YkRing *ring, const YkRingView *view);

// Adds the element to text and returns whether it did. If not (no memory, YK_RING_NOT_REAL for C), the ring's status
// says why. Every term is written with its exact coefficient: what is written reads back as the identical element. The
// order depends only on the order of the symbols.
bool yk_ring_write(YkRing *ring, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text);
// Does the same without making the element, if one that is alike - that differs in its symbols' names alone - was
// written before.
bool yk_ring_write_view(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text);
// Returns half of an element if, written term by term, the half has no fraction and no denominator except those of pi;
// otherwise NULL.
const YkPoisson *yk_ring_half_if_whole(YkRing *ring, const YkPoisson *a);
// Returns a symbol's name in a format; the C name is a unique identifier, the MathML name an element. When out of
// memory returns the name in text, and sets the ring's status.
const char *yk_ring_name_in(YkRing *ring, int32_t symbol, YkRingFormat format);

// Reads an element as a person or yk_ring_write writes it, in TEXT and BOOK (each accepts the style of the other),
// LATEX and C: + - * / ^, products by juxtaposition, parentheses, names, decimal numbers (exact), cos sin of whole
// combinations of angles and rational multiples of pi, exp(i ...), sqrt of 2^a 3^b n^2, the imaginary unit always as
// `1i`, and as `i` if no symbol has that name. On a mistake returns NULL with problems (which may be NULL); the ring's
// status does not change.
const YkPoisson *yk_ring_read(YkRing *ring, YkRingFormat format, const char *text, size_t length, YkPlace place,
                              YkProblems *problems);

#endif
