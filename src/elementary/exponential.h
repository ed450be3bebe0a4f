// e^x in parts: a power of two, an entry of a table, a short polynomial.
//
// Source: Tang 1989, "Table-driven implementation of the exponential function in IEEE floating-point arithmetic", ACM
// TOMS 15; ours has 128 steps to an octave.
#ifndef ELEMENTARY_EXPONENTIAL_H
#define ELEMENTARY_EXPONENTIAL_H
#include "elementary/coefficients.h"
#include "elementary/double_double.h"
#include "elementary/tables.h"

// value (1 + rest) 2^exponent, 1 <= value < 2, |rest| < 0.003.
typedef struct Exponential {
    double value, rest;
    int64_t exponent;
} Exponential;

// 2^(k/128) e^r for |r| <= ln 2 / 256.
YK_INLINE Exponential exponential_step(int64_t k, double r)
{
    const YkPowerOfTwo *power = &yk_powers_of_two[k & 127];
    double r2 = r * r, rest = r + (power->rest + r2 * ((EXP_0 + r * EXP_1) + r2 * (EXP_2 + r * EXP_3)));
    return (Exponential){power->value, rest, (k - (k & 127)) / 128};
}

// e^(x + low) for |x| up to about 1400 and a low that is tiny beside 1.
YK_INLINE Exponential exponential(double x, double low)
{
    double shifted = x * PER_STEP + YK_TO_INTEGER, k = shifted - YK_TO_INTEGER;
    return exponential_step(integer_in(shifted), (x - k * STEP_HIGH) - (k * STEP_LOW - low));
}

YK_INLINE DoubleDouble exponential_pair(Exponential e)
{
    return dd_ordered_sum(e.value, e.value * e.rest);
}

// Its value, rounded once.
YK_INLINE double exponential_value(Exponential e)
{
    if (e.exponent < -950 || e.exponent > 1022) return yk_scaled((DoubleDouble){e.value, e.value * e.rest}, e.exponent);
    double scale = of_bits(bits_of(e.value) + ((uint64_t)e.exponent << 52));
    return scale + scale * e.rest;
}

#endif
