// Sums and products without loss: a number as the unevaluated sum of two doubles, good for about 100 bits.
//
// Sources: Dekker 1971, "A floating-point technique for extending the available precision"; Knuth, "The Art of Computer
// Programming" 2, 4.2.2. Factors are split by cutting bits off instead of by a multiplication; what the product of the
// two lower halves may lose is below 2^-106 of the product.
#ifndef ELEMENTARY_DOUBLE_DOUBLE_H
#define ELEMENTARY_DOUBLE_DOUBLE_H
#include "elementary/bits.h"

typedef struct DoubleDouble {
    double high, low;
} DoubleDouble;

// a + b where |a| >= |b|, or where a is 0.
YK_INLINE DoubleDouble dd_ordered_sum(double a, double b)
{
    double sum = a + b;
    return (DoubleDouble){sum, (a - sum) + b};
}

YK_INLINE DoubleDouble dd_sum(double a, double b)
{
    double sum = a + b, part = sum - a;
    return (DoubleDouble){sum, (a - (sum - part)) + (b - part)};
}

// The upper 26 bits of x.
YK_INLINE double upper_half(double x)
{
    return of_bits(bits_of(x) & ~(((uint64_t)1 << 27) - 1));
}

// a b, for products between about 2^-960 and 2^1020.
YK_INLINE DoubleDouble dd_product(double a, double b)
{
    double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1, product = a * b;
    return (DoubleDouble){product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

YK_INLINE DoubleDouble dd_square(double a)
{
    double a1 = upper_half(a), a2 = a - a1, square = a * a;
    return (DoubleDouble){square, ((a1 * a1 - square) + 2 * (a1 * a2)) + a2 * a2};
}

YK_INLINE DoubleDouble dd_times(DoubleDouble a, DoubleDouble b)
{
    DoubleDouble product = dd_product(a.high, b.high);
    return dd_ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

// a / b, the lower part for its size alone.
YK_INLINE DoubleDouble dd_quotient(DoubleDouble a, DoubleDouble b)
{
    double quotient = a.high / b.high;
    DoubleDouble back = dd_product(quotient, b.high);
    return (DoubleDouble){quotient, (((a.high - back.high) - back.low) + (a.low - quotient * b.low)) / b.high};
}

// a 2^exponent with one rounding, also where it is subnormal or infinite; for a from 2^-1000 to 2^1000.
double yk_scaled(DoubleDouble a, int64_t exponent);

YK_INLINE double dd_value(DoubleDouble a)
{
    return a.high + a.low;
}

#endif
