// Exact whole numbers of 63 bits and a sign: every operation says whether its result fits. INT64_MIN counts as too
// large, so that every number has a negative.
#ifndef RING_EXACT_H
#define RING_EXACT_H
#include <stdbool.h>
#include <stdint.h>
#include "base/wide.h"

static inline uint64_t yk_magnitude(int64_t a)
{
    return a < 0 ? (uint64_t)0 - (uint64_t)a : (uint64_t)a;
}

static inline bool yk_exact_add(int64_t a, int64_t b, int64_t *sum)
{
    if (b > 0 ? a > INT64_MAX - b : a < -INT64_MAX - b) return false;
    *sum = a + b;
    return true;
}

static inline bool yk_is_short(int64_t a) // fits 31 bits and a sign
{
    return a == (int32_t)a;
}

static inline bool yk_exact_multiply(int64_t a, int64_t b, int64_t *product)
{
    if (yk_is_short(a) && yk_is_short(b)) {
        *product = a * b;
        return true;
    }
    YkWide wide = yk_wide_multiply(yk_magnitude(a), yk_magnitude(b));
    if (wide.high != 0 || wide.low > INT64_MAX) return false;
    *product = (a < 0) != (b < 0) ? -(int64_t)wide.low : (int64_t)wide.low;
    return true;
}

// Returns the greatest common divisor; that of 0 and b is b.
static inline uint64_t yk_gcd(uint64_t a, uint64_t b)
{
    while (b > 1) { // most of ours end at 1, without a division
        uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return b == 1 ? 1 : a;
}

// A rational number in lowest terms, denominator > 0.
typedef struct YkRatio {
    int64_t over, under;
} YkRatio;

// Reduces over / under, under != 0, to lowest terms; returns false when that does not fit.
static inline bool yk_ratio_make(int64_t over, int64_t under, YkRatio *ratio)
{
    if (over == INT64_MIN || under == INT64_MIN || under == 0) return false;
    if (under == 1) {
        *ratio = (YkRatio){over, 1};
        return true;
    }
    int64_t divisor = (int64_t)yk_gcd(yk_magnitude(over), yk_magnitude(under));
    if (under < 0) divisor = -divisor;
    *ratio = (YkRatio){over / divisor, under / divisor};
    return true;
}

static inline bool yk_ratio_multiply(YkRatio a, YkRatio b, YkRatio *product)
{
    YkRatio left, right;
    return yk_ratio_make(a.over, b.under, &left) && yk_ratio_make(b.over, a.under, &right) &&
           yk_exact_multiply(left.over, right.over, &product->over) &&
           yk_exact_multiply(left.under, right.under, &product->under);
}

static inline bool yk_ratio_divide(YkRatio a, YkRatio b, YkRatio *quotient)
{
    return b.over != 0 &&
           yk_ratio_multiply(a, b.over < 0 ? (YkRatio){-b.under, -b.over} : (YkRatio){b.under, b.over}, quotient);
}

static inline bool yk_ratio_is(YkRatio a, int64_t whole)
{
    return a.over == whole && a.under == 1;
}

#endif
