// An element as the reader sees it: real terms with cos and sin, and the tree of sums and products in which they are
// grouped. Inside of ring/.
#ifndef RING_SHOWN_H
#define RING_SHOWN_H
#include "ring/inside.h"
#include "ring/write.h"

typedef enum YkShownFunction { YK_SHOWN_ONE, YK_SHOWN_COS, YK_SHOWN_SIN, YK_SHOWN_EXP } YkShownFunction;

// What stands beside number and monomial: [i] sqrt(surd) function(phase + shift * 15 deg).
typedef struct YkAtom {
    YkShownFunction function;
    bool is_imaginary;
    unsigned surd; // YK_UNIT_SQRT2 | YK_UNIT_SQRT3
    uint32_t phase;
    int shift;
} YkAtom;

typedef struct YkShownTerm {
    uint32_t monomial;
    YkRatio number;
    YkAtom atom;
} YkShownTerm;

// One printing: its memory, and what is wanted.
typedef struct YkSheet {
    YkRing *ring;
    YkArena *arena;
    YkRingFormat format;
    YkRingStyle style;
    bool failed;
} YkSheet;

// Terms of an element, real ones as cos and sin. NULL on failure (memory or overflow, with the ring's status).
YkShownTerm *yk_shown_terms(YkSheet *sheet, const YkPoisson *a, size_t *count);

// The order of the reader. Monomials: by class, then symbol, higher powers first.
int yk_compare_monomials(const YkRing *ring, uint32_t a, uint32_t b);
int yk_compare_atoms(const YkRing *ring, const YkAtom *a, const YkAtom *b);
void yk_sort_by_monomial(const YkSheet *sheet, YkShownTerm *terms, size_t count);
void yk_sort_by_atom(const YkSheet *sheet, YkShownTerm *terms, size_t count); // then by monomial

// --- the tree: sums of products, whose factors are leaves or sums
typedef enum YkShowKind {
    YK_SHOW_NUMBER,
    YK_SHOW_SYMBOL,
    YK_SHOW_I,
    YK_SHOW_SQRT,     // of `number`
    YK_SHOW_FUNCTION, // of an atom
    YK_SHOW_SUM,
    YK_SHOW_PRODUCT,
} YkShowKind;

typedef struct YkShow YkShow;
struct YkShow {
    YkShowKind kind;
    bool negative;    // its sign as a summand
    int32_t exponent; // of a factor; below 0 it stands in the denominator
    YkRatio number;   // > 0
    int32_t symbol;
    YkAtom atom;
    YkShow *first, *last, *next; // parts, siblings
};

// All of the following give NULL and set sheet->failed when out of memory, and take NULL.
YkShow *yk_show(YkSheet *sheet, YkShowKind kind);
// Adds a part; products within products and sums within sums (their signs turned where the inner one is negative)
// become one.
void yk_show_append(YkShow *whole, YkShow *part);
// |number| * surd * constants of the monomial * function * rates and accelerations, with the number's sign; atom may be
// NULL.
YkShow *yk_show_term(YkSheet *sheet, YkRatio number, uint32_t monomial, const YkAtom *atom);
size_t yk_show_count(const YkShow *whole);
// A sum with one part is that part.
YkShow *yk_show_simplest(YkShow *sum);

// --- grouping
enum { YK_CLASSES_OF_MASS = 1 << YK_RING_INERTIA | 1 << YK_RING_MASS };
// The part of a monomial whose symbols are of the classes (a mask of 1 << class). YK_NO_PRODUCT and sheet->failed on
// failure.
uint32_t yk_part_of_classes(YkSheet *sheet, uint32_t monomial, unsigned classes);
uint32_t yk_quotient(YkSheet *sheet, uint32_t monomial, uint32_t divisor);
// Of all terms: the greatest common monomial with positive powers, and the greatest common rational divisor (> 0).
uint32_t yk_common_monomial(YkSheet *sheet, const YkShownTerm *terms, size_t count);
bool yk_common_number(const YkShownTerm *terms, size_t count, YkRatio *common);

// Products of rates as perfect squares or a common rate times a linear form, one for each monomial of the rest. Terms
// sorted by monomial; NULL where one of them has no such form (or *count is 0).
typedef struct YkRateProduct {
    uint32_t monomial; // of the rest
    YkRatio number;
    YkShow *rates;
} YkRateProduct;
YkRateProduct *yk_rate_products(YkSheet *sheet, const YkShownTerm *terms, size_t count, size_t *products);
// Adds a polynomial (all atoms alike, left out) to a sum, grouped by inertias and masses.
void yk_show_polynomial(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count);
// Adds terms grouped by their atoms, constants first.
void yk_show_by_atom(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count);
// The whole element in the sheet's style: a sum.
YkShow *yk_show_element(YkSheet *sheet, YkShownTerm *terms, size_t count);

// --- writing the tree
void yk_write_linear(const YkSheet *sheet, const YkShow *sum, YkText *text); // TEXT, BOOK, LATEX, C
void yk_write_mathml(const YkSheet *sheet, const YkShow *sum, YkText *text);
// The angle of a function: its terms in order, each with sign and multiple, pi among them.
typedef struct YkAngleShown {
    bool negative;
    int64_t factor; // > 0
    int32_t symbol; // an angle, or -1 for pi / pi_over
    int64_t pi_over;
} YkAngleShown;
uint32_t yk_constant_angles(const YkRing *ring, uint32_t phase); // how many, such as pi_7
// The k-th term of the angle, false after the last.
bool yk_angle_shown(const YkSheet *sheet, const YkAtom *atom, uint32_t k, YkAngleShown *shown);

#endif
