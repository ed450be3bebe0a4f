// An element as the reader sees it: real terms with cos and sin, and the tree of sums and products in which they are
// grouped. For use inside ring/ only.
#ifndef RING_PRINT_SHOWN_H
#define RING_PRINT_SHOWN_H
#include "ring/inside.h"
#include "ring/print/write.h"

typedef enum YkShownFunction { YK_SHOWN_ONE, YK_SHOWN_COS, YK_SHOWN_SIN, YK_SHOWN_EXP } YkShownFunction;

// The factor besides number and monomial: [i] sqrt(surd) function(phase + shift * 15 deg).
typedef struct YkAtom {
    uint32_t phase;
    int8_t shift;
    uint8_t function; // a YkShownFunction
    uint8_t surd;     // YK_UNIT_SQRT2 | YK_UNIT_SQRT3
    bool is_imaginary;
} YkAtom;

// A power in the reader's order: the rank is the class, then the symbol.
typedef struct YkShownPower {
    uint32_t rank;
    int32_t exponent;
} YkShownPower;

// A product of powers as it is printed, in shared memory of the sheet. Powers ascend by rank, so that each class is a
// contiguous piece.
typedef struct YkMonomial {
    const YkShownPower *powers;
    uint32_t count, classes; // a mask of 1 << class, and YK_MAY_BE_BELOW
} YkMonomial;

#define YK_MAY_BE_BELOW ((uint32_t)1 << 31) // if it is not set, no exponent is negative

enum { YK_RANK_BITS = 28 }; // bits for the symbol

static inline YkRingClass yk_rank_class(uint32_t rank)
{
    return (YkRingClass)(rank >> YK_RANK_BITS);
}
static inline int32_t yk_rank_symbol(uint32_t rank)
{
    return (int32_t)(rank & (((uint32_t)1 << YK_RANK_BITS) - 1));
}

// Returns what a power adds to a monomial's classes.
static inline uint32_t yk_shown_class(YkShownPower power)
{
    return (uint32_t)1 << yk_rank_class(power.rank) | (power.exponent < 0 ? YK_MAY_BE_BELOW : 0);
}

typedef struct YkShownTerm {
    YkMonomial monomial;
    YkRatio number;
    YkAtom atom;
} YkShownTerm;

// One printing: its memory and its options.
typedef struct YkSheet {
    YkRing *ring;
    YkArena *arena;
    YkRingFormat format;
    YkRingStyle style;
    bool failed;
} YkSheet;

// Returns the terms of an element, real ones as cos and sin. NULL on failure (memory or overflow, with the ring's
// status).
YkShownTerm *yk_shown_terms(YkSheet *sheet, const YkPoisson *a, size_t *count);

// --- reading_order.c: the reader's order. Monomials: by class, then symbol, higher powers first.
YkMonomial yk_monomial(YkSheet *sheet, uint32_t monomial); // from one of the ring's monomials
bool yk_is_same_monomial(YkMonomial a, YkMonomial b);
int yk_compare_atoms(const YkRing *ring, const YkAtom *a, const YkAtom *b);
typedef enum YkTermOrder { YK_BY_MONOMIAL, YK_BY_ATOM, YK_BY_RATE, YK_BY_ACCELERATION } YkTermOrder;
// Sorts by atom, then by monomial; or by the rates (accelerations) of the monomial alone. Equal terms keep their order.
void yk_sort_terms(YkSheet *sheet, YkShownTerm *terms, size_t count, YkTermOrder order);

// --- common_parts.c: parts of monomials
// Returns whether the monomial contains a symbol of the class.
static inline bool yk_holds(YkMonomial monomial, YkRingClass kind)
{
    return monomial.classes >> kind & 1;
}
// Returns the piece of the classes `from` to `to`, within the same memory.
YkMonomial yk_piece_of(YkMonomial monomial, YkRingClass from, YkRingClass to);
static inline YkMonomial yk_part_of(YkMonomial monomial, YkRingClass from, YkRingClass to)
{
    uint32_t classes = monomial.classes & ~YK_MAY_BE_BELOW, wanted = ((uint32_t)2 << to) - ((uint32_t)1 << from);
    if (!(classes & ~wanted)) return monomial;
    return classes & wanted ? yk_piece_of(monomial, from, to) : (YkMonomial){NULL, 0, 0};
}
YkMonomial yk_quotient(YkSheet *sheet, YkMonomial monomial, YkMonomial divisor);
// Returns the greatest common monomial of all terms with positive powers, and the greatest common rational divisor (>
// 0).
YkMonomial yk_common_monomial(YkSheet *sheet, const YkShownTerm *terms, size_t count);
bool yk_common_number(const YkShownTerm *terms, size_t count, YkRatio *common);
// Divides terms by a monomial and a number, in place.
void yk_divide_terms(YkSheet *sheet, YkShownTerm *terms, size_t count, YkMonomial monomial, YkRatio number);

// --- the tree: sums of products, whose factors are terms and sums
typedef enum YkShowKind { YK_SHOW_TERM, YK_SHOW_SUM, YK_SHOW_PRODUCT } YkShowKind;

typedef struct YkShow YkShow;
struct YkShow {
    YkShowKind kind;
    bool negative;    // its sign as a summand
    bool has_number;  // of a term: whether its number is written
    int32_t exponent; // of a sum as a factor
    // |number| * i sqrt(surd) * constants of the monomial * function * rates and accelerations
    YkShownTerm term;
    YkShow *first, *last, *next; // parts, siblings
};

// All of the following return NULL and set sheet->failed when out of memory, and accept NULL.
YkShow *yk_show(YkSheet *sheet, YkShowKind kind);
// Adds a part to a sum or product; flattens products within products and sums within sums (turning signs if the inner
// sum is negative). A product takes the sign of its terms.
void yk_show_append(YkShow *whole, YkShow *part);
// Returns a term with its sign; writes a 1 that stands alone. atom may be NULL.
YkShow *yk_show_term(YkSheet *sheet, YkRatio number, YkMonomial monomial, const YkAtom *atom);
// Returns a product that begins with this part.
YkShow *yk_show_product(YkSheet *sheet, YkShow *part);
// Returns the sum, or its part if it has only one.
YkShow *yk_show_simplest(YkShow *sum);

// Return the parts of a sum or product in turn; a term is its own only part.
static inline const YkShow *yk_show_first(const YkShow *whole)
{
    return whole->kind == YK_SHOW_TERM ? whole : whole->first;
}
static inline const YkShow *yk_show_next(const YkShow *whole, const YkShow *part)
{
    return whole->kind == YK_SHOW_TERM ? NULL : part->next;
}
// Returns how many powers stand below the line; *high: whether one exceeds the first power.
size_t yk_show_below(const YkShow *product, bool *high);

// --- grouping
// Products of rates as perfect squares or a common rate times a linear form, one for each monomial of the rest. Terms
// must be sorted by monomial; NULL if one of them has no such form (or *count is 0).
typedef struct YkRateProduct {
    YkMonomial monomial; // of the rest
    YkRatio number;
    YkShow *rates;
} YkRateProduct;
YkRateProduct *yk_rate_products(YkSheet *sheet, const YkShownTerm *terms, size_t count, size_t *products);
// Adds terms grouped by their atoms, constants first.
void yk_show_by_atom(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count);
// Shows the whole element in the sheet's style: a sum or a term.
YkShow *yk_show_element(YkSheet *sheet, YkShownTerm *terms, size_t count);

// --- writing the tree
static inline int64_t yk_surd_square(unsigned surd) // 2, 3 or 6
{
    return (surd & YK_UNIT_SQRT2 ? 2 : 1) * (surd & YK_UNIT_SQRT3 ? 3 : 1);
}
// Writes a symbol's name.
static inline void yk_write_name(YkRing *ring, int32_t symbol, YkRingFormat format, YkText *text)
{
    const YkRingSymbol *named = &ring->symbols[symbol];
    if (format == YK_RING_TEXT || format == YK_RING_BOOK)
        yk_text_add_padded(text, named->name, named->name_length); // an arena's memory comes in multiples of 16 bytes
    else
        yk_text_puts(text, yk_ring_name_in(ring, symbol, format));
}
void yk_write_mathml(const YkSheet *sheet, const YkShow *sum, YkText *text);
// The angle of a function: its terms in order, each with sign and multiple, including pi.
typedef struct YkAngleShown {
    bool negative;
    int64_t factor; // > 0
    int32_t symbol; // an angle, or -1 for pi / pi_over
    int64_t pi_over;
} YkAngleShown;
uint32_t yk_constant_angles(const YkRing *ring, uint32_t phase); // how many such as pi_7 the phase has
// Returns the k-th term of the angle, false after the last.
bool yk_angle_shown(const YkSheet *sheet, const YkAtom *atom, uint32_t k, YkAngleShown *shown);

#endif
