// Well-mixed bits, the same on every machine: splitmix64 (Steele, Lea & Flood 2014).
#ifndef BASE_MIX_H
#define BASE_MIX_H
#include <stdint.h>

#define YK_MIX_STEP UINT64_C(0x9e3779b97f4a7c15) // between successive seeds

static inline uint64_t yk_mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

// Returns the next number of a random sequence.
static inline uint64_t yk_mix_next(uint64_t *seed)
{
    return yk_mix(*seed += YK_MIX_STEP);
}

// Returns the next number as a double from 0 up to but not including 1.
static inline double yk_mix_unit(uint64_t *seed)
{
    return (double)(yk_mix_next(seed) >> 11) * 0x1p-53;
}

#endif
