// Arithmetic modulo the prime p = 2^64 - 2^32 + 1, where i, sqrt 2 and sqrt 3 exist, and the values of elements of the
// ring in this field. Two forms of the same quantity agree at every point; two different ones agree at a random point
// with probability about degree / p, below 1e-16 (Schwartz 1980, Zippel 1979). So forms are compared without expanding
// either.
#ifndef RING_PROOF_FIELD_H
#define RING_PROOF_FIELD_H
#include "base/wide.h"
#include "ring/ring.h"

#define YK_PRIME 0xffffffff00000001u

static inline uint64_t yk_field_add(uint64_t a, uint64_t b)
{
    uint64_t sum = a + b;
    return sum < a || sum >= YK_PRIME ? sum - YK_PRIME : sum;
}
static inline uint64_t yk_field_subtract(uint64_t a, uint64_t b)
{
    return a >= b ? a - b : a - b + YK_PRIME;
}
static inline uint64_t yk_field_negate(uint64_t a)
{
    return a == 0 ? 0 : YK_PRIME - a;
}
// Multiplies, with 2^64 = 2^32 - 1 and 2^96 = -1 modulo p.
static inline uint64_t yk_field_multiply(uint64_t a, uint64_t b)
{
    YkWide wide = yk_wide_multiply(a, b);
    uint64_t top = wide.high >> 32, middle = wide.high & 0xffffffffu, shifted = (middle << 32) - middle;
    uint64_t low = wide.low >= YK_PRIME ? wide.low - YK_PRIME : wide.low;
    return yk_field_add(yk_field_subtract(low, top), shifted);
}
uint64_t yk_field_power(uint64_t base, uint64_t exponent);
uint64_t yk_field_invert(uint64_t a);           // that of 0 is 0
uint64_t yk_field_of(int64_t value);            // from a whole number
bool yk_field_sqrt(uint64_t a, uint64_t *root); // false if there is none
// Solves A x = b by elimination: row r of A has entries first[r] to first[r + 1], their columns ascending, and b has
// `rows` entries. Free unknowns keep their values in x. Returns the rank, -1 if there is no solution,
// YK_FIELD_NO_MEMORY when out of memory.
enum { YK_FIELD_NO_MEMORY = -2 };
typedef struct YkFieldEntry {
    size_t column;
    uint64_t value;
} YkFieldEntry;
int yk_field_solve(const YkFieldEntry *entries, const size_t *first, const uint64_t *b, size_t rows, size_t columns,
                   uint64_t *x);

// A point: a value for every symbol of a ring, and a unit vector u (its conjugate is 1/u) for every angle.
typedef struct YkFieldPoint YkFieldPoint;
// Draws random values, the same for the same seed. Roots follow from their squares, with either sign, so whatever
// depends on the sign fails at half of all points. The root of a number that is not a square in this field takes any
// value, and the point is *loose*: what is equal at loose points is equal; what differs there may be equal. Returns
// NULL when out of memory, or if the square of an expression has no root at 256 random points. Symbols added to the
// ring later are not in it.
YkFieldPoint *yk_field_point_new(const YkRing *ring, uint64_t seed);
void yk_field_point_free(YkFieldPoint *point);
bool yk_field_point_is_loose(const YkFieldPoint *point);
uint64_t yk_field_point_get(const YkFieldPoint *point, int32_t symbol);
void yk_field_point_set(YkFieldPoint *point, int32_t symbol, uint64_t value);    // for a symbol outside of phases
void yk_field_point_set_unit(YkFieldPoint *point, int32_t angle, uint64_t unit); // not 0
// Points with seeds of their own, made at first use and kept until the ring has more symbols; at most 16.
typedef struct YkFieldPoints YkFieldPoints;
YkFieldPoints *yk_field_points_new(const YkRing *ring, uint64_t seed); // NULL when out of memory
void yk_field_points_free(YkFieldPoints *points);
const YkFieldPoint *yk_field_points_get(YkFieldPoints *points, size_t index); // NULL if it cannot be made

// Returns the value of an element, or with `conjugate` of its conjugate. NULL has the value 0, and so has an element
// that mentions symbols younger than the point.
uint64_t yk_ring_field(const YkRing *ring, const YkPoisson *a, const YkFieldPoint *point, bool conjugate);

#endif
