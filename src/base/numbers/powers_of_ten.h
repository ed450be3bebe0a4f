// Powers of ten to 128 bits, which reading and writing numbers share.
#ifndef BASE_POWERS_OF_TEN_H
#define BASE_POWERS_OF_TEN_H
#include <stdbool.h>
#include <stdint.h>
#include "base/wide.h"

enum {
    YK_TEN_MIN = -342, // below this, no 19-digit integer times the power reaches half the smallest double
    YK_TEN_MAX = 341   // 17 digits of the smallest double need 10^340
};

// 10^(YK_TEN_MIN + i) = (entry + f) * 2^(yk_floor_log2_of_ten(..) - 127), 0 <= f < 1, the entry's highest bit set.
// Written by tools/powers_of_ten.py.
extern const YkWide yk_powers_of_ten[YK_TEN_MAX - YK_TEN_MIN + 1];

static inline YkWide yk_power_of_ten(int exponent)
{
    return yk_powers_of_ten[exponent - YK_TEN_MIN];
}
// 5^55 is the last power of five below 2^128: there f = 0.
static inline bool yk_power_of_ten_is_exact(int exponent)
{
    return exponent >= 0 && exponent <= 55;
}

// floor(log2(10^e)) for |e| <= 1233 and floor(log10(2^e)) for |e| <= 1650: fixed-point products, checked by the tool.
// The shift of a negative number is arithmetic on every compiler we build with.
static inline int yk_floor_log2_of_ten(int e)
{
    return (e * 1741647) >> 19;
}
static inline int yk_floor_log10_of_two(int e)
{
    return (e * 1262611) >> 22;
}

#endif
