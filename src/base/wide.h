// 64 x 64 -> 128 bit products, with and without a compiler that has 128-bit integers.
#ifndef BASE_WIDE_H
#define BASE_WIDE_H
#include <stdint.h>

typedef struct YkWide {
    uint64_t high, low;
} YkWide; // high * 2^64 + low

// Multiplies portably, by four 32-bit products; public so that the tests can compare both ways.
static inline YkWide yk_wide_multiply_halves(uint64_t a, uint64_t b)
{
    uint64_t a1 = a >> 32, a0 = a & 0xffffffffu, b1 = b >> 32, b0 = b & 0xffffffffu;
    uint64_t low = a0 * b0, cross = a1 * b0 + (low >> 32); // cannot overflow: (2^32 - 1)^2 + 2^32 - 1 < 2^64
    uint64_t other = a0 * b1 + (cross & 0xffffffffu);
    return (YkWide){a1 * b1 + (cross >> 32) + (other >> 32), (other << 32) | (low & 0xffffffffu)};
}

static inline YkWide yk_wide_multiply(uint64_t a, uint64_t b)
{
#ifdef __SIZEOF_INT128__
    __extension__ typedef unsigned __int128 Product;
    Product product = (Product)a * b;
    return (YkWide){(uint64_t)(product >> 64), (uint64_t)product};
#else
    return yk_wide_multiply_halves(a, b);
#endif
}

static inline YkWide yk_wide_add(YkWide a, uint64_t b)
{
    uint64_t low = a.low + b;
    return (YkWide){a.high + (low < b), low};
}

#endif
