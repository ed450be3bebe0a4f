// The ring of planar mechanics: finite Poisson series with exact coefficients.
// An element is a sum of terms  c * monomial * e^(i phi):
//   c         in Q(i, sqrt 2, sqrt 3), the numbers that hold e^(i k 15 deg); rationals are int64 / int64, overflow is
//   noticed monomial  a product of whole powers, negative ones included, of symbols: parameters, distances, rates,
//   forces, ... phi       a whole-number combination of angles
// Loop equations, energies, Jacobians and equations of motion live here: every vector of the plane is an element, the
// dot product of u and v is real(conj(u) v), the cross product imaginary(conj(u) v). Sorted sums of terms are a
// canonical form, so cos a cos b + sin a sin b *is* cos(a - b), and equality is comparison. Sources: Danby, Deprit, Rom
// 1966 (Poisson series); Biscani 2009 (their arithmetic by hashing).
#ifndef RING_RING_H
#define RING_RING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/vec.h"

typedef struct YkRing YkRing;       // owns symbols and elements; not shared between threads
typedef struct YkPoisson YkPoisson; // an element: constant, lives as long as its ring

// Why an operation has no result. The first failure sticks until yk_ring_clear.
// An operation that fails returns NULL, and so does one that is given NULL: a long derivation is checked once, at its
// end.
typedef enum YkRingStatus {
    YK_RING_OK,
    YK_RING_OVERFLOW,   // a coefficient does not fit 64 bits over 64 bits
    YK_RING_SIZE,       // more terms than the ring allows, in one element (use body angles or the structured form) or
                        // in all together
    YK_RING_POWER,      // a power is beyond +-1,000,000, or not defined
    YK_RING_DIVISOR,    // division by zero or by more than one term
    YK_RING_DERIVATIVE, // the last known derivative of a function was to be differentiated
    YK_RING_NAME,       // not a name, or taken
    YK_RING_NOT_REAL,   // a real element is needed here
    YK_RING_MEMORY,
} YkRingStatus;

enum { YK_RING_TERMS_MAX = 200000 }; // of one element, unless yk_ring_set_limit says otherwise

YkRing *yk_ring_new(void); // NULL when out of memory
void yk_ring_free(YkRing *ring);
YkRingStatus yk_ring_status(const YkRing *ring);
const char *yk_ring_status_text(YkRingStatus status); // a phrase: "a coefficient is too large for exact arithmetic"
// Forgets a failure, for elements that are done without. A ring that ran out of memory remembers it for good, so that
// nobody takes what is missing for what does not exist.
void yk_ring_clear(YkRing *ring);
// Records a failure, unless another was first (want of memory before any other); returns NULL for the caller to return.
const YkPoisson *yk_ring_fail(YkRing *ring, YkRingStatus status);
void yk_ring_set_limit(YkRing *ring, size_t terms); // most terms an element may have; at least 1

// --- Symbols
// ------------------------------------------------------------------------------------------------------------- A class
// says where the reader expects a symbol, in this order within a product.
typedef enum YkRingClass {
    YK_RING_INERTIA,
    YK_RING_MASS,
    YK_RING_CONSTANT,   // lengths and all other parameters
    YK_RING_COORDINATE, // a distance; an angle where it stands outside of cos and sin (a rack's r theta)
    YK_RING_FUNCTION,   // drives, cam laws and their derivatives; spring lengths
    YK_RING_GRAVITY,
    YK_RING_FORCE, // forces, moments, efforts, multipliers
    YK_RING_RATE,
    YK_RING_ACCELERATION,
    YK_RING_CLASSES
} YkRingClass;

// Names are [A-Za-z_][A-Za-z0-9_.]* followed by any number of ' (theta1, A.angle, theta1''). The words cos sin sqrt exp
// pow pi and pi_7 (any number) are taken. All of the following return the symbol, 0, 1, ..., or -1 (and the status
// tells why).
int32_t yk_ring_symbol(YkRing *ring, const char *name, YkRingClass kind);
// An angle theta: e^(i theta) may be used, and theta itself. Both have the same derivatives.
int32_t yk_ring_angle(YkRing *ring, const char *name);
// The names of a coordinate's rate and acceleration, NAME' and NAME'', entered as symbols with their time derivatives:
// coordinate -> rate -> acceleration. Returns the rate; the acceleration is the next symbol. NAME.rate and NAME.accel
// are other names of the same.
int32_t yk_ring_rates(YkRing *ring, int32_t coordinate);
// A function of one variable and its derivatives: names[0](variable), names[1] = d names[0] / d variable, ... The
// derivative of the last is unknown. Returns the first; the others follow.
int32_t yk_ring_function(YkRing *ring, const char *const names[], size_t count, int32_t variable);
// A positive root: L with L^2 = square, a real element (a spring's length). d L = d square / (2 L).
int32_t yk_ring_root(YkRing *ring, const char *name, const YkPoisson *square);
// From now on the symbol is a name for a rational number: at points of the field it has that value.
void yk_ring_set_number(YkRing *ring, int32_t symbol, const YkPoisson *number);
bool yk_ring_alias(YkRing *ring, int32_t symbol, const char *name); // one more name to be read
// Declares the total time derivative of a symbol, and the partial derivative of a dependent symbol by another.
bool yk_ring_set_rate(YkRing *ring, int32_t symbol, const YkPoisson *rate);
bool yk_ring_set_partial(YkRing *ring, int32_t symbol, int32_t variable, const YkPoisson *derivative);
int32_t yk_ring_find(const YkRing *ring, const char *name); // -1 where there is none
size_t yk_ring_symbol_count(const YkRing *ring);
const char *yk_ring_symbol_name(const YkRing *ring, int32_t symbol);
YkRingClass yk_ring_symbol_class(const YkRing *ring, int32_t symbol);
bool yk_ring_is_angle(const YkRing *ring, int32_t symbol);

// --- Elements
// ------------------------------------------------------------------------------------------------------------
const YkPoisson *yk_ring_rational(YkRing *ring, int64_t numerator,
                                  int64_t denominator); // denominator 0 is YK_RING_DIVISOR
// The exact decimal mantissa * 10^exponent (yk_number_read_exact).
const YkPoisson *yk_ring_decimal(YkRing *ring, int64_t mantissa, int32_t exponent);
const YkPoisson *yk_ring_i(YkRing *ring);
const YkPoisson *yk_ring_sqrt(YkRing *ring, int64_t square); // of 2^a 3^b n^2 only; others are YK_RING_POWER
const YkPoisson *yk_ring_of(YkRing *ring, int32_t symbol);  // the symbol as an element; an angle outside of cos and sin
const YkPoisson *yk_ring_unit(YkRing *ring, int32_t angle); // e^(i angle)
// e^(i pi numerator / denominator). Multiples of 15 deg are exact numbers. Any other is a power of the unit of a
// constant angle `pi_7`, a symbol free of relations: what comes out equal is equal, but that 7 times pi_7 is pi is not
// known.
const YkPoisson *yk_ring_turn(YkRing *ring, int64_t numerator, int64_t denominator);
const YkPoisson *yk_ring_pi(YkRing *ring); // pi itself, a constant symbol

// e^(i phi), cos phi and sin phi of an angle phi = sum of factor * angle + pi * numerator / denominator.
typedef struct YkAngleTerm {
    int32_t angle, factor;
} YkAngleTerm;
const YkPoisson *yk_ring_exp(YkRing *ring, const YkAngleTerm *terms, size_t count);
// The same of an angle that stands outside of cos and sin: a sum of whole multiples of angles and of fractions of pi;
// NULL for anything else.
const YkPoisson *yk_ring_exp_of(YkRing *ring, const YkPoisson *angle);
const YkPoisson *yk_ring_cos(YkRing *ring, const YkAngleTerm *terms, size_t count);
const YkPoisson *yk_ring_sin(YkRing *ring, const YkAngleTerm *terms, size_t count);

size_t yk_ring_terms(const YkPoisson *a);                     // 0 of zero and of NULL
bool yk_ring_is_zero(const YkPoisson *a);                     // exactly zero, as free symbols; false of NULL
bool yk_ring_is_same(const YkPoisson *a, const YkPoisson *b); // of one ring; false when either is NULL
// Equal when roots are what they are (L^2 = square): the difference times a power of each root is reduced and is zero.
bool yk_ring_is_equal(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
bool yk_ring_is_real(YkRing *ring, const YkPoisson *a);
bool yk_ring_is_rational(const YkPoisson *a, int64_t *numerator, int64_t *denominator); // a rational number, and which
// Is a = over / under * b, with a rational number? b not 0.
bool yk_ring_is_multiple(const YkPoisson *a, const YkPoisson *b, int64_t *over, int64_t *under);

// --- Operations. Cost: O(terms) or O(products of terms) hash steps, then a sort.
// ------------------------------------------
const YkPoisson *yk_ring_add(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_subtract(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_sum(YkRing *ring, const YkPoisson *const *parts, size_t count);
const YkPoisson *yk_ring_multiply(YkRing *ring, const YkPoisson *a, const YkPoisson *b);
const YkPoisson *yk_ring_product(YkRing *ring, const YkPoisson *const *parts, size_t count);
const YkPoisson *yk_ring_scale(YkRing *ring, const YkPoisson *a, int64_t numerator, int64_t denominator);
const YkPoisson *yk_ring_negate(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_power(YkRing *ring, const YkPoisson *a, int32_t exponent);       // below 0: of a single term
const YkPoisson *yk_ring_divide(YkRing *ring, const YkPoisson *a, const YkPoisson *term); // by a single term
const YkPoisson *yk_ring_conjugate(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_real(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_imaginary(YkRing *ring, const YkPoisson *a);
const YkPoisson *yk_ring_dot(YkRing *ring, const YkPoisson *u, const YkPoisson *v);   // real(conj(u) v)
const YkPoisson *yk_ring_cross(YkRing *ring, const YkPoisson *u, const YkPoisson *v); // imaginary(conj(u) v)

const YkPoisson *yk_ring_partial(YkRing *ring, const YkPoisson *a, int32_t variable);
const YkPoisson *yk_ring_time_derivative(YkRing *ring, const YkPoisson *a);

// Replaces symbols, all at once. For an angle, `unit` replaces e^(i angle) and is of modulus 1 (a body's angle by joint
// angles: yk_ring_exp), `value` replaces the angle where it stands outside; NULL leaves it as it is.
typedef struct YkRingChange {
    int32_t symbol;
    const YkPoisson *value, *unit;
} YkRingChange;
const YkPoisson *yk_ring_substitute(YkRing *ring, const YkPoisson *a, const YkRingChange *changes, size_t count);
// The same for many elements: the changes are kept with what is found out about them. They live as long as the ring.
typedef struct YkRingChanges YkRingChanges;
YkRingChanges *yk_ring_changes(YkRing *ring, const YkRingChange *changes, size_t count);
const YkPoisson *yk_ring_change(YkRing *ring, const YkPoisson *a, YkRingChanges *changes);

// a = sum over k of coefficient_k * symbol^k: the range of k, and one coefficient. false for zero and NULL.
bool yk_ring_powers(const YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t *lowest, int32_t *highest);
const YkPoisson *yk_ring_coefficient(YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t power);
// a = rest + sum over k of coefficients[k] * symbols[k], for an element that is linear in symbols: in no term stands
// more than one of them, and each by power 1; otherwise NULL with YK_RING_POWER. Returns the rest. The first `wanted`
// coefficients are made. Cost O(terms + count).
const YkPoisson *yk_ring_split(YkRing *ring, const YkPoisson *a, const int32_t *symbols, size_t count,
                               const YkPoisson **coefficients, size_t wanted);
// The symbols that stand in an element, outside or in a phase, one after the other: the least that is greater than
// `after` (-1: the first); -1 after the last. Cost O(terms).
int32_t yk_ring_next_symbol(const YkRing *ring, const YkPoisson *a, int32_t after);
bool yk_ring_mentions(const YkRing *ring, const YkPoisson *a, int32_t symbol); // outside or in a phase
// The greatest rational number times symbols' powers that divides every term: a = content * (a / content), where the
// quotient has whole coefficients without common divisor and no symbol in all terms. 0 of 0.
const YkPoisson *yk_ring_content(YkRing *ring, const YkPoisson *a);
// The same that divides every term of both; of 0 and a the content of a.
const YkPoisson *yk_ring_common_content(YkRing *ring, const YkPoisson *a, const YkPoisson *b);

// Lumped constants: every polynomial in inertias, masses, lengths, gravity and other constants becomes a rational
// number times symbol_of(lump): the same symbol for the same lump, or -1 to leave it as it is.
typedef int32_t (*YkLumpSymbol)(void *context, const YkPoisson *lump);
const YkPoisson *yk_ring_lump(YkRing *ring, const YkPoisson *a, YkLumpSymbol symbol_of, void *context);

// --- Values
// --------------------------------------------------------------------------------------------------------------
// values[symbol count]: what each symbol stands for; those of roots and constant angles are computed first and written
// there. Roots of negative squares are NaN.
void yk_ring_complete(YkRing *ring, double *values);
// The value of an element at completed values.
YkVec yk_ring_value(const YkRing *ring, const YkPoisson *a, const double *values);
// The sum of the sizes of its terms: what rounding in its value is measured by.
double yk_ring_magnitude(const YkRing *ring, const YkPoisson *a, const double *values);

#endif
