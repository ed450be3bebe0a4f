// The ring of planar mechanics: finite Poisson series with exact coefficients.
// An element is a sum of terms c * monomial * e^(i phi):
// - c is in Q(i, sqrt 2, sqrt 3), the numbers that contain e^(i k 15 deg); rationals are int64 / int64, overflow is
// noticed;
// - monomial is a product of whole powers, negative ones included, of symbols: parameters, distances, rates, forces,
// ...;
// - phi is a whole-number combination of angles.
// Loop equations, energies, Jacobians and equations of motion are built from it: every vector of the plane is an
// element, the dot product of u and v is real(conj(u) v), the cross product imaginary(conj(u) v). Sorted sums of terms
// are a canonical form, so cos a cos b + sin a sin b *is* cos(a - b), and equality is comparison. Sources: Danby,
// Deprit, Rom 1966 (Poisson series); Biscani 2009 (their arithmetic by hashing).
#ifndef RING_RING_H
#define RING_RING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/pace.h"
#include "base/vec.h"

typedef struct YkRing YkRing;       // owns symbols and elements; must not be shared between threads
typedef struct YkPoisson YkPoisson; // an element: constant, lives as long as its ring

// The reason why an operation has no result. The first failure stays until yk_ring_clear. An operation that fails, or
// is given NULL, returns NULL: a long derivation is checked once, at its end.
typedef enum YkRingStatus {
    YK_RING_OK,
    YK_RING_OVERFLOW,   // a coefficient does not fit 64 bits over 64 bits
    YK_RING_SIZE,       // more terms than the ring allows, in one element (use body angles or the structured form) or
                        // in all together
    YK_RING_POWER,      // a power is beyond +-1,000,000, or not defined
    YK_RING_DIVISOR,    // division by zero or by more than one term
    YK_RING_DERIVATIVE, // the last known derivative of a function would have to be differentiated
    YK_RING_NAME,       // not a name, or taken
    YK_RING_NOT_REAL,   // a real element is needed here
    YK_RING_STOPPED,    // by the caller of the long call that it works for; the ring is spent
    YK_RING_MEMORY,
} YkRingStatus;

enum { YK_RING_TERMS_MAX = 200000 }; // in one element, unless yk_ring_set_limit says otherwise

YkRing *yk_ring_new(void); // NULL when out of memory
void yk_ring_free(YkRing *ring);
// Lets the ring take memory from the system in pieces of at least this size.
void yk_ring_reserve(YkRing *ring, size_t bytes);
YkRingStatus yk_ring_status(const YkRing *ring);
const char *yk_ring_status_text(YkRingStatus status); // a phrase: "a coefficient is too large for exact arithmetic"
// Forgets a failure, so that the caller can do without the elements. A ring that ran out of memory, or was stopped,
// remembers it for good: what is missing must not look like what does not exist.
void yk_ring_clear(YkRing *ring);
// Records a failure, unless another came first (out of memory precedes any other, then a stop); returns NULL for the
// caller to return.
const YkPoisson *yk_ring_fail(YkRing *ring, YkRingStatus status);
// The pace of long calls that the ring works for; it must outlive the ring.
void yk_ring_set_pace(YkRing *ring, YkPace *pace);
YkPace *yk_ring_pace(const YkRing *ring); // or NULL
// Counts work that is done with the ring's elements. Returns false once the call was stopped: the ring has then failed.
bool yk_ring_spend(YkRing *ring, size_t work);
void yk_ring_set_limit(YkRing *ring, size_t terms); // sets the most terms an element may have; at least 1

// --- Symbols
// A class says where the reader expects a symbol within a product, in this order.
typedef enum YkRingClass {
    YK_RING_INERTIA,
    YK_RING_MASS,
    YK_RING_CONSTANT,   // lengths and all other parameters
    YK_RING_COORDINATE, // a distance; an angle outside of cos and sin (a rack's r theta)
    YK_RING_FUNCTION,   // drives, cam laws and their derivatives; spring lengths
    YK_RING_GRAVITY,
    YK_RING_FORCE, // forces, moments, efforts, multipliers
    YK_RING_RATE,
    YK_RING_ACCELERATION,
    YK_RING_CLASSES
} YkRingClass;

// Names are [A-Za-z_][A-Za-z0-9_.]* followed by any number of ' (theta1, A.angle, theta1''). The words cos sin sqrt exp
// pow pi and pi_7 (any number) are reserved. All of the following return the symbol, 0, 1, ..., or -1 with the status.
int32_t yk_ring_symbol(YkRing *ring, const char *name, YkRingClass kind);
// Adds an angle theta: both e^(i theta) and theta itself may be used. Both have the same derivatives.
int32_t yk_ring_angle(YkRing *ring, const char *name);
// Enters the rate and acceleration of a coordinate, NAME' and NAME'', as symbols with their time derivatives:
// coordinate -> rate -> acceleration. Returns the rate; the acceleration is the next symbol. NAME.rate and NAME.accel
// are other names for them.
int32_t yk_ring_rates(YkRing *ring, int32_t coordinate);
// Adds a function of one variable and its derivatives: names[0](variable), names[1] = d names[0] / d variable, ... The
// derivative of the last is unknown. Returns the first; the others follow.
int32_t yk_ring_function(YkRing *ring, const char *const names[], size_t count, int32_t variable);
// Adds a positive root: L with L^2 = square, a real element (a spring's length). d L = d square / (2 L).
int32_t yk_ring_root(YkRing *ring, const char *name, const YkPoisson *square);
// Makes the symbol a name for a rational number from now on: it has that value at points of the field.
void yk_ring_set_number(YkRing *ring, int32_t symbol, const YkPoisson *number);
bool yk_ring_alias(YkRing *ring, int32_t symbol, const char *name); // one more name for reading
// Declares the total time derivative of a symbol, and the partial derivative of a dependent symbol by another.
bool yk_ring_set_rate(YkRing *ring, int32_t symbol, const YkPoisson *rate);
bool yk_ring_set_partial(YkRing *ring, int32_t symbol, int32_t variable, const YkPoisson *derivative);
int32_t yk_ring_find(const YkRing *ring, const char *name); // -1 if there is none
size_t yk_ring_symbol_count(const YkRing *ring);
const char *yk_ring_symbol_name(const YkRing *ring, int32_t symbol);
YkRingClass yk_ring_symbol_class(const YkRing *ring, int32_t symbol);
bool yk_ring_is_angle(const YkRing *ring, int32_t symbol);

// --- Elements
const YkPoisson *yk_ring_rational(YkRing *ring, int64_t numerator,
                                  int64_t denominator); // denominator 0 is YK_RING_DIVISOR
// Returns the exact decimal mantissa * 10^exponent (yk_number_read_exact).
const YkPoisson *yk_ring_decimal(YkRing *ring, int64_t mantissa, int32_t exponent);
const YkPoisson *yk_ring_i(YkRing *ring);
const YkPoisson *yk_ring_sqrt(YkRing *ring, int64_t square); // of 2^a 3^b n^2 only; others fail with YK_RING_POWER
const YkPoisson *yk_ring_of(YkRing *ring, int32_t symbol); // the symbol as an element; an angle outside of cos and sin
const YkPoisson *yk_ring_vector(YkRing *ring, int32_t x, int32_t y); // x + i y
const YkPoisson *yk_ring_unit(YkRing *ring, int32_t angle);          // e^(i angle)
// Returns e^(i pi numerator / denominator). Multiples of 15 deg are exact numbers. Any other is a power of the unit of
// a constant angle `pi_7`, a symbol without relations: elements that come out equal are equal, but the ring does not
// know that 7 times pi_7 is pi.
const YkPoisson *yk_ring_turn(YkRing *ring, int64_t numerator, int64_t denominator);
const YkPoisson *yk_ring_pi(YkRing *ring); // pi itself, a constant symbol

// e^(i phi), cos phi and sin phi of an angle phi = sum of factor * angle + pi * numerator / denominator.
typedef struct YkAngleTerm {
    int32_t angle, factor;
} YkAngleTerm;
const YkPoisson *yk_ring_exp(YkRing *ring, const YkAngleTerm *terms, size_t count);
// Do the same for an angle outside of cos and sin: a sum of whole multiples of angles and of fractions of pi; return
// NULL for anything else.
const YkPoisson *yk_ring_exp_of(YkRing *ring, const YkPoisson *angle);
const YkPoisson *yk_ring_cos(YkRing *ring, const YkAngleTerm *terms, size_t count);
const YkPoisson *yk_ring_sin(YkRing *ring, const YkAngleTerm *terms, size_t count);

size_t yk_ring_terms(const YkPoisson *a);                     // 0 for zero and for NULL
bool yk_ring_is_zero(const YkPoisson *a);                     // exactly zero, as free symbols; false for NULL
bool yk_ring_is_same(const YkPoisson *a, const YkPoisson *b); // both of one ring; false when either is NULL
// Returns whether a and b are equal given that L^2 = square for roots: reduces their difference times a power of each
// root.
bool yk_ring_is_equal(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
bool yk_ring_is_real(YkRing *ring, const YkPoisson *a);
bool yk_ring_is_rational(const YkPoisson *a, int64_t *numerator, int64_t *denominator); // a rational number, and which
// Returns whether a = over / under * b, with a rational number. b must not be 0.
bool yk_ring_is_multiple(const YkPoisson *a, const YkPoisson *b, int64_t *over, int64_t *under);

// --- Elements that pass. Those made between these calls are discarded at the end, except the result. Whoever wants one
// of them later keeps what yk_ring_keep returns. Calls may nest: the outermost end discards.
void yk_ring_begin_passing(YkRing *ring);
const YkPoisson *yk_ring_end_passing(YkRing *ring, const YkPoisson *result);
const YkPoisson *yk_ring_keep(YkRing *ring, const YkPoisson *a);

// --- Operations. Cost: O(terms) or O(products of terms) hash steps, then a sort.
const YkPoisson *yk_ring_add(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_subtract(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_sum(YkRing *ring, const YkPoisson *const *parts, size_t count);
const YkPoisson *yk_ring_multiply(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_product(YkRing *ring, const YkPoisson *const *parts, size_t count);
const YkPoisson *yk_ring_scale(YkRing *ring, const YkPoisson *a, int64_t numerator, int64_t denominator);
const YkPoisson *yk_ring_negate(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_power(YkRing *ring, const YkPoisson *a, int32_t exponent); // below 0: for a single term only
const YkPoisson *yk_ring_divide(YkRing *ring, const YkPoisson *a, const YkPoisson *term); // by a single term
const YkPoisson *yk_ring_conjugate(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_real(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_imaginary(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_dot(YkRing *ring, const YkPoisson *u, const YkPoisson *v);   // real(conj(u) v)
const YkPoisson *yk_ring_cross(YkRing *ring, const YkPoisson *u, const YkPoisson *v); // imaginary(conj(u) v)

const YkPoisson *yk_ring_partial(YkRing *ring, const YkPoisson *a, int32_t variable);
const YkPoisson *yk_ring_time_derivative(YkRing *ring, const YkPoisson *a);

// Replaces symbols, all at once. For an angle, `unit` replaces e^(i angle) and must have modulus 1 (a body's angle by
// joint angles: yk_ring_exp), and `value` replaces the angle outside of cos and sin; NULL leaves either unchanged.
typedef struct YkRingChange {
    int32_t symbol;
    const YkPoisson *value, *unit;
} YkRingChange;
const YkPoisson *yk_ring_substitute(YkRing *ring, const YkPoisson *a, const YkRingChange *changes, size_t count);
// A set of changes for many elements, kept with what is found out about it. It lives as long as the ring.
typedef struct YkRingChanges YkRingChanges;
YkRingChanges *yk_ring_changes(YkRing *ring, const YkRingChange *changes, size_t count);
const YkPoisson *yk_ring_change(YkRing *ring, const YkPoisson *a, YkRingChanges *changes);

// Finds a = sum over k of coefficient_k * symbol^k: the range of k, and one coefficient. Returns false for zero and
// NULL.
bool yk_ring_powers(const YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t *lowest, int32_t *highest);
const YkPoisson *yk_ring_coefficient(YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t power);
// Splits a = rest + sum over k of coefficients[k] * symbols[k], for an element that is linear in symbols: no term
// contains more than one of them, and only to the power 1; otherwise NULL with YK_RING_POWER. Returns the rest. Makes
// the first `wanted` coefficients. Cost O(terms + count).
const YkPoisson *yk_ring_split(YkRing *ring, const YkPoisson *a, const int32_t *symbols, size_t count,
                               const YkPoisson **coefficients, size_t wanted);
// Returns the symbols of an element, outside or in a phase, one after the other: the least that is greater than `after`
// (-1: the first); -1 after the last. Cost O(terms).
int32_t yk_ring_next_symbol(const YkRing *ring, const YkPoisson *a, int32_t after);
bool yk_ring_mentions(const YkRing *ring, const YkPoisson *a, int32_t symbol); // outside or in a phase
// Returns the greatest rational number times powers of symbols that divides every term: a = content * (a / content),
// where the quotient has whole coefficients without a common divisor, and no symbol is in all its terms. The content of
// 0 is 0.
const YkPoisson *yk_ring_content(YkRing *ring, const YkPoisson *a);
// Returns the greatest that divides every term of both; for 0 and a, the content of a.
const YkPoisson *yk_ring_common_content(YkRing *ring, const YkPoisson *a, const YkPoisson *b);

// Lumps constants: every polynomial in inertias, masses, lengths, gravity and other constants becomes a rational number
// times symbol_of(lump): the same symbol for the same lump, or -1 to leave it unchanged.
typedef int32_t (*YkLumpSymbol)(void *context, const YkPoisson *lump);
const YkPoisson *yk_ring_lump(YkRing *ring, const YkPoisson *a, YkLumpSymbol symbol_of, void *context);

// --- Values
// Completes values[symbol count], the value of each symbol: computes those of roots and constant angles first and
// writes them there. Roots of negative squares are NaN.
void yk_ring_complete(YkRing *ring, double *values);
// Returns the value of an element at completed values.
YkVec yk_ring_value(const YkRing *ring, const YkPoisson *a, const double *values);
// Returns the sum of the magnitudes of its terms: the scale of rounding errors in its value.
double yk_ring_magnitude(const YkRing *ring, const YkPoisson *a, const double *values);

#endif
