// The inside of number.h: doubles taken apart, and doubles as decimal digits.
#ifndef BASE_DECIMAL_H
#define BASE_DECIMAL_H
#include <stdint.h>
#include <string.h>

typedef struct YkBinary {
    uint64_t mantissa;
    int exponent;
} YkBinary; // mantissa * 2^exponent
typedef struct YkDecimal {
    uint64_t digits;
    int exponent;
} YkDecimal; // digits * 10^exponent

static inline uint64_t yk_double_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}
static inline double yk_double_from_bits(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
// Returns the magnitude of a finite double from its bits; ignores the sign.
static inline YkBinary yk_binary_from_bits(uint64_t bits)
{
    uint64_t fraction = bits & 0xfffffffffffffu;
    int field = (int)(bits >> 52 & 0x7ff);
    return field == 0 ? (YkBinary){fraction, -1074} : (YkBinary){fraction | (uint64_t)1 << 52, field - 1075};
}

// Returns how far to shift value != 0 to the left until its highest bit is set.
static inline int yk_leading_zeros(uint64_t value)
{
    int zeros = 0;
    for (int step = 32; step > 0; step /= 2)
        if (value >> (64 - step) == 0) {
            zeros += step;
            value <<= step;
        }
    return zeros;
}

// Returns the shortest decimal in the rounding interval of a finite double > 0; among several, the nearest. Its digits
// may end in zeros. Source: Giulietti 2020, "The Schubfach way to render doubles".
YkDecimal yk_decimal_shortest(double value);
// Rounds a finite double > 0 correctly (ties to even) to `count` digits, 1..17: 10^(count-1) <= digits < 10^count.
YkDecimal yk_decimal_rounded(double value, int count);

#endif
