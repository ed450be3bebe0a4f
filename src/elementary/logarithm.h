// log x in parts: the exponent, an entry of a table, a short polynomial.
//
// Source: Tang 1990, "Table-driven implementation of the logarithm function in IEEE floating-point arithmetic", ACM
// TOMS 16. The reciprocals 1/c of the table have 11 bits (Wong & Goto 1994), so that z/c - 1 is known without loss.
#ifndef ELEMENTARY_LOGARITHM_H
#define ELEMENTARY_LOGARITHM_H
#include "elementary/coefficients.h"
#include "elementary/double_double.h"
#include "elementary/tables.h"

// log x = high + low + log(1 + r + r_low); high ends at 2^-42.
typedef struct Logarithm {
    double high, low, r, r_low;
} Logarithm;

// Takes a positive, finite x.
YK_INLINE Logarithm logarithm(double x)
{
    uint64_t bits = bits_of(x);
    int64_t subnormal = 0;
    if (bits < (uint64_t)1 << 52) bits = bits_of(x * 0x1p54), subnormal = 54;
    uint64_t past = bits - bits_of(0x1.6p-1);
    int64_t exponent = (int64_t)(past >> 52) - (past >> 63 ? 4096 : 0);
    const YkLogStep *step = &yk_log_steps[past >> 45 & 127];
    bits -= (uint64_t)exponent << 52;
    double z = of_bits(bits), upper = of_bits(bits & ~(uint64_t)0xfff), n = (double)(exponent - subnormal);
    double first = upper * step->per - 1, second = (z - upper) * step->per, r = first + second;
    return (Logarithm){n * LN_2_HIGH + step->high, n * LN_2_LOW + step->low, r, (first - r) + second};
}

// log(1 + r) - r + r^2 / 2.
YK_INLINE double logarithm_cubic(double r)
{
    double r2 = r * r;
    return r * r2 * ((LOG_0 + r * LOG_1) + r2 * ((LOG_2 + r * LOG_3) + r2 * ((LOG_4 + r * LOG_5) + r2 * LOG_6)));
}

// log x to about 2^-67 of itself.
YK_INLINE DoubleDouble logarithm_pair(Logarithm l)
{
    double part = upper_half(l.r), half = 0.5 * part * part; // exact; what r^2 / 2 has more is in the tail
    DoubleDouble sum = dd_ordered_sum(l.high, l.r), more = dd_ordered_sum(sum.high, -half);
    double tail = (l.r_low - l.r * l.r_low - 0.5 * ((l.r - part) * (l.r + part))) + logarithm_cubic(l.r);
    return dd_ordered_sum(more.high, more.low + (sum.low + (l.low + tail)));
}

// Returns whether x has no logarithm to compute: zero, negative, infinite, NaN.
YK_INLINE bool logarithm_is_rare(double x)
{
    return !(x > 0 && x < (double)INFINITY);
}

YK_INLINE double rare_logarithm(double x)
{
    return x == 0 ? -(double)INFINITY : x > 0 ? x : (double)NAN;
}

#endif
