// The structured form: sums, products and quotients of elements as the model gives them, not multiplied out. Large
// systems are printed and compiled in this form; the ring expands the small pieces, and the prime field compares the
// large ones.
#ifndef RING_PROOF_FORM_H
#define RING_PROOF_FORM_H
#include "ring/proof/field.h"

// A node of a graph; constant, shared freely, lives as long as its ring. Functions return NULL when out of memory (with
// the ring's status) and when given NULL.
typedef struct YkForm YkForm;
typedef enum YkFormKind { YK_FORM_ELEMENT, YK_FORM_SUM, YK_FORM_PRODUCT, YK_FORM_QUOTIENT } YkFormKind;

const YkForm *yk_form_of(YkRing *ring, const YkPoisson *a);
const YkForm *yk_form_add(YkRing *ring, const YkForm *a, const YkForm *b);
const YkForm *yk_form_subtract(YkRing *ring, const YkForm *a, const YkForm *b);
const YkForm *yk_form_multiply(YkRing *ring, const YkForm *a, const YkForm *b);
const YkForm *yk_form_divide(YkRing *ring, const YkForm *over, const YkForm *under);

const YkPoisson *yk_form_element(const YkForm *form); // of YK_FORM_ELEMENT, otherwise NULL
// Return the parts: both of a sum or product, [over, under] of a quotient, none of an element.
size_t yk_form_part_count(const YkForm *form);
const YkForm *yk_form_part(const YkForm *form, size_t index);

// Multiplies out: returns an element of at most `terms` terms, or NULL with the ring's status (YK_RING_SIZE;
// YK_RING_DIVISOR if a divisor is not a single term).
const YkPoisson *yk_form_expand(YkRing *ring, const YkForm *form, size_t terms);
// Computes the value at a point of the prime field, each node once; returns false at a division by zero, or when out of
// memory.
bool yk_form_field(YkRing *ring, const YkForm *form, const YkFieldPoint *point, uint64_t *value);
// Returns the value at completed values (yk_ring_complete); NaN if it has none.
YkVec yk_form_value(YkRing *ring, const YkForm *form, const double *values);
// Returns the scale of rounding errors in that value: the same sums and products of the magnitudes of all terms.
double yk_form_magnitude(YkRing *ring, const YkForm *form, const double *values);

typedef enum YkFormVerdict { YK_FORM_DIFFERENT, YK_FORM_EQUAL, YK_FORM_UNDECIDED } YkFormVerdict;
// Compares at `points` random points (3 are plenty), which are kept for many comparisons. "Different" is certain;
// "equal" is wrong with probability below (degree / 2^64)^points. Undecided when out of memory, or if no point avoids a
// division by zero.
YkFormVerdict yk_form_compare_at(YkRing *ring, const YkForm *a, const YkForm *b, int points, YkFieldPoints *kept);

#endif
