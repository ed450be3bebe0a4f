// The inside of the ring; no other room includes it.
#ifndef RING_INSIDE_H
#define RING_INSIDE_H
#include "base/memory.h"
#include "base/names.h"
#include "ring/exact.h"
#include "ring/powers.h"
#include "ring/ring.h"

// The key of a term: phase, monomial and unit in one word. The unit is a product of i, sqrt 2 and sqrt 3, one bit each.
enum { YK_UNIT_I = 1, YK_UNIT_SQRT2 = 2, YK_UNIT_SQRT3 = 4, YK_UNIT_SURD = 6, YK_UNITS = 8 };
enum { YK_UNIT_BITS = 3, YK_MONOMIAL_BITS = 31, YK_PHASE_BITS = 30 };

typedef struct YkRingTerm {
    uint64_t key;
    int64_t number; // over the element's denominator; never 0 or INT64_MIN
} YkRingTerm;

struct YkPoisson {
    size_t count;
    int64_t denominator; // > 0, without a common divisor with all numbers
    YkRingTerm terms[];  // keys ascend
};

static inline uint64_t yk_key(uint32_t phase, uint32_t monomial, unsigned unit)
{
    return (uint64_t)phase << (YK_MONOMIAL_BITS + YK_UNIT_BITS) | (uint64_t)monomial << YK_UNIT_BITS | unit;
}
static inline uint32_t yk_key_phase(uint64_t key)
{
    return (uint32_t)(key >> (YK_MONOMIAL_BITS + YK_UNIT_BITS));
}
static inline uint32_t yk_key_monomial(uint64_t key)
{
    return (uint32_t)(key >> YK_UNIT_BITS) & 0x7fffffffu;
}
static inline unsigned yk_key_unit(uint64_t key)
{
    return (unsigned)key & (YK_UNITS - 1);
}
// The product of two units is a whole number times the unit a ^ b.
static inline int yk_unit_factor(unsigned a, unsigned b)
{
    unsigned both = a & b;
    return (both & YK_UNIT_I ? -1 : 1) * (both & YK_UNIT_SQRT2 ? 2 : 1) * (both & YK_UNIT_SQRT3 ? 3 : 1);
}

// The dependence of a symbol on a variable; derivative is NULL if it is unknown.
typedef struct YkPartial {
    struct YkPartial *next;
    int32_t variable;
    const YkPoisson *derivative;
} YkPartial;

// The meaning of a symbol, which few symbols have.
typedef struct YkRingMeaning {
    YkPartial *partials;
    const YkPoisson *square; // of a root symbol: its square
    const YkPoisson *number; // the number that the symbol names, or NULL
    const YkPoisson *known;  // its derivative by known_variable, made when the ring had known_rules rules
    size_t known_rules;
    int32_t known_variable;
    int64_t pi_over; // the constant angle pi / pi_over; 1 for pi itself; 0 for other symbols
} YkRingMeaning;

// A large machine has many symbols: they are kept small.
typedef struct YkRingSymbol {
    const char *name;
    const YkPoisson *element;     // the symbol itself; made at first use
    const YkPoisson *rate;        // declared total time derivative, or NULL
    const YkRingMeaning *meaning; // never NULL
    uint32_t monomial;            // the symbol as a monomial; 0: not made yet
    int32_t rate_symbol;          // of the symbols with rates: the first of the two; the other follows; 0: none
    uint8_t name_length, kind;    // kind: a YkRingClass
    bool is_angle;
} YkRingSymbol;

// The names of a symbol when typeset.
typedef struct YkTypesetName {
    const char *latex, *c, *mathml;
} YkTypesetName;

// Collects terms by key. As long as keys ascend it neither searches nor sorts.
typedef struct YkGather {
    YkRingTerm *terms;
    size_t count, capacity;
    uint32_t *slots; // term + 1, 0 is free
    size_t slot_count;
    YkRingTerm *sorted; // room for sorting
    size_t sorted_capacity;
    int64_t denominator;
    bool ascends;     // all keys so far ascend; the slots are then unused
    bool is_distinct; // no key comes twice, so none is looked up
    bool failed;
} YkGather;

typedef struct YkPatterns YkPatterns;
// The names in the text that was written last.
typedef struct YkMark {
    size_t at, length; // in the text
    int32_t symbol;
} YkMark;
typedef struct YkMarks {
    YkMark *items;
    size_t count, capacity;
    bool is_wanted; // of what is being written
    bool failed;    // one is missing
} YkMarks;

enum { YK_RING_MADE_MAX = 48000000 }; // terms of all elements of a ring, 768 MB in total

struct YkRing {
    YkRingStatus status;
    size_t limit;
    size_t made; // terms of all elements together
    YkArena *arena;
    YkArena *sheet;    // memory for one printing
    YkArena *passing;  // memory for elements that pass; made at first use
    YkArena *elements; // where elements are made: arena or passing
    size_t depth;      // of calls to yk_ring_begin_passing
    YkRingSymbol *symbols;
    size_t symbol_count, symbol_capacity;
    YkTypesetName *typeset; // of the first symbols, typeset_count
    size_t typeset_count, typeset_capacity;
    YkNames names; // the names of symbols in text, aliases included
    YkNames latex_names, c_names;
    YkPowers monomials, phases;
    YkGather gather;
    const YkPoisson *zero, *one;
    YkRingChanges *changes; // the newest set of changes
    YkPatterns *patterns;   // of elements in print: print/pattern.h; NULL: none yet
    YkMarks marks;
    size_t derivative_names; // names that end in .rate or .accel
    size_t rule_count;       // rates, partial derivatives and roots declared so far
    // Marks of symbols with a rate; marks of symbols whose derivatives are not ready or have a denominator.
    uint64_t moving_marks, dependent_marks;
    size_t form_count; // structured forms made so far
    YkPace *pace;      // of the long calls that it works for, or NULL
};

// Work, for the pace: of entering a symbol, of making an element, of one of its terms, of a product of two terms, of a
// term in print, of a term's value.
enum {
    YK_WORK_SYMBOL = 1000,
    YK_WORK_ELEMENT = 30,
    YK_WORK_TERM = 12,
    YK_WORK_PRODUCT = 50,
    YK_WORK_PRINT = 2000,
    YK_WORK_VALUE = 30
};

// --- symbols.c: returns the symbol of pi / pi_over, `pi_7`; enters it if it is new; -1 on failure.
int32_t yk_ring_constant_angle(YkRing *ring, int64_t pi_over);
// Returns what a symbol stands for, to be changed; NULL when out of memory.
YkRingMeaning *yk_ring_meaning(YkRing *ring, int32_t symbol);
// Returns whether this is one of the ring's symbols, and makes the ring fail if not.
bool yk_ring_has_symbol(YkRing *ring, int32_t symbol);

// --- print/typeset.c: makes names in LaTeX (l_{c1}, \dot{\theta}_{1}), MathML and C (theta1_rate), unique in their
// ring, for all symbols that have none yet. Returns false with the status when out of memory.
bool yk_ring_typeset(YkRing *ring);

// --- substitute.c
// Returns what happens to a symbol, or NULL.
const YkRingChange *yk_ring_change_of(const YkRingChanges *changes, int32_t symbol);
void yk_ring_free_all_changes(YkRing *ring);

// --- keys.c: products of keys. They return YK_NO_PRODUCT with the status on failure.
uint32_t yk_ring_make_monomial(YkRing *ring, uint32_t a, uint32_t b, int32_t times);
uint32_t yk_ring_make_phase(YkRing *ring, uint32_t a, uint32_t b, int32_t times);
static inline uint32_t yk_ring_monomial(YkRing *ring, uint32_t a, uint32_t b, int32_t times) // a * b^times
{
    uint32_t product;
    bool at_hand = yk_powers_at_hand(&ring->monomials, a, b, times, &product);
    return at_hand ? product : yk_ring_make_monomial(ring, a, b, times);
}
static inline uint32_t yk_ring_phase(YkRing *ring, uint32_t a, uint32_t b, int32_t times)
{
    uint32_t product;
    bool at_hand = yk_powers_at_hand(&ring->phases, a, b, times, &product);
    return at_hand ? product : yk_ring_make_phase(ring, a, b, times);
}
uint32_t yk_ring_common_monomial(YkRing *ring, uint32_t a, uint32_t b); // the lower exponent of each symbol
uint32_t yk_ring_opposite(YkRing *ring, uint32_t phase);                // -phase
unsigned yk_ring_classes(YkRing *ring, uint32_t monomial);              // classes of its symbols: a mask of 1 << class
uint32_t yk_ring_monomial_of(YkRing *ring, int32_t symbol, int32_t exponent);
// Returns the part of a monomial whose symbols are wanted.
uint32_t yk_ring_part(YkRing *ring, uint32_t monomial, bool (*is_wanted)(const void *context, int32_t symbol),
                      const void *context);
uint32_t yk_ring_phase_of(YkRing *ring, int32_t angle, int32_t factor);
// Multiplies keys a and b except their units: the caller multiplies by yk_unit_factor. Returns false on failure.
static inline bool yk_ring_key_product(YkRing *ring, uint64_t a, uint64_t b, uint64_t *product)
{
    uint32_t monomial = yk_ring_monomial(ring, yk_key_monomial(a), yk_key_monomial(b), 1);
    uint32_t phase = yk_ring_phase(ring, yk_key_phase(a), yk_key_phase(b), 1);
    *product = yk_key(phase, monomial, yk_key_unit(a) ^ yk_key_unit(b));
    return monomial != YK_NO_PRODUCT && phase != YK_NO_PRODUCT;
}

// --- print/lumped_constants.c: returns whether a symbol is an inertia, a mass or another parameter that nothing
// changes. Splits a monomial into the product of such symbols and the rest; false on failure.
bool yk_ring_is_constant(const YkRing *ring, int32_t symbol);
bool yk_ring_split_constants(YkRing *ring, uint32_t monomial, uint32_t *constant, uint32_t *rest);

// --- collect_terms.c: begin, add any terms over one denominator, end. Call no other operation of the ring in between.
void yk_gather_begin(YkRing *ring, int64_t denominator);
void yk_gather_begin_distinct(YkRing *ring, int64_t denominator); // for keys that are all different
bool yk_gather_add(YkRing *ring, uint64_t key, int64_t number);
bool yk_gather_add_product(YkRing *ring, const YkRingTerm *a, const YkRingTerm *b, int64_t factor); // factor * a * b
const YkPoisson *yk_gather_end(YkRing *ring);
void yk_gather_free(YkGather *gather);
bool yk_gather_room(YkRing *ring, size_t count); // makes room for this number in gather.terms

// --- element.c: makes the element of sorted terms, zeros among them allowed, over a denominator.
const YkPoisson *yk_poisson_make(YkRing *ring, const YkRingTerm *terms, size_t count, int64_t denominator);
const YkPoisson *yk_poisson_term(YkRing *ring, uint64_t key, int64_t number, int64_t denominator);
uint64_t yk_poisson_content(const YkPoisson *a, uint64_t divisor); // common to its numbers and another one, 0 for none

// Finds the least common multiple of denominators, *all; returns false on overflow.
bool yk_common_denominator(int64_t a, int64_t b, int64_t *all);

#endif
