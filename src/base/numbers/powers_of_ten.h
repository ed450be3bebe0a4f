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

// 10^e = 10^(YK_TEN_STEP * k) * 10^j, 0 <= j < YK_TEN_STEP: the first 192 bits of the one, from the smallest k on, and
// the 64 bits of the other, which are all. The highest bit of each is set. Written by tools/powers_of_ten.py.
enum { YK_TEN_STEP = 27, YK_TEN_STEP_MIN = -351 };
typedef struct YkTenStep {
    uint64_t high, middle, low;
} YkTenStep;
extern const YkTenStep yk_ten_steps[];
extern const uint64_t yk_small_tens[YK_TEN_STEP];

// Returns 128 bits, the highest of them set: 10^exponent = (bits + f) * 2^(yk_floor_log2_of_ten(exponent) - 127),
// 0 <= f < 1. The tool checks at every exponent that 192 bits of a step are enough.
static inline YkWide yk_power_of_ten(int exponent)
{
    unsigned place = (unsigned)(exponent - YK_TEN_STEP_MIN);
    YkTenStep step = yk_ten_steps[place / YK_TEN_STEP];
    uint64_t small = yk_small_tens[place % YK_TEN_STEP];
    YkWide low = yk_wide_add(yk_wide_multiply(step.middle, small), yk_wide_multiply(step.low, small).high);
    YkWide power = yk_wide_add(yk_wide_multiply(step.high, small), low.high);
    if (power.high >> 63) return power;
    return (YkWide){power.high << 1 | power.low >> 63, power.low << 1 | low.low >> 63};
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
