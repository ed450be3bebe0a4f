// The bits of a double, and what the functions of this room are built of. Basic IEEE operations only.
#ifndef ELEMENTARY_BITS_H
#define ELEMENTARY_BITS_H
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "elementary/kernel.h"

#if FLT_EVAL_METHOD != 0 || DBL_MANT_DIG != 53
#error "doubles must be computed as doubles: on 32-bit x86 use -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__)
#error "the order of operations counts here: no -ffast-math"
#endif

#define YK_SIGN_BIT ((uint64_t)1 << 63)

YK_INLINE uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

YK_INLINE double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

// x with its sign changed where `sign`, a sign bit, is set.
YK_INLINE double flipped(double x, uint64_t sign)
{
    return of_bits(bits_of(x) ^ sign);
}

// 2^e for -1022 <= e <= 1023.
YK_INLINE double power_of_two(int64_t e)
{
    return of_bits((uint64_t)(e + 1023) << 52);
}

// A number that, added to a small one, rounds it to an integer; the integer then stands in the lowest bits of the sum.
#define YK_TO_INTEGER 0x1.8p52

// That integer, of a sum x + YK_TO_INTEGER.
YK_INLINE int64_t integer_in(double sum)
{
    return (int64_t)(bits_of(sum) - bits_of(YK_TO_INTEGER));
}

#endif
