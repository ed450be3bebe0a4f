// Shared by all tests: cmocka, one tolerance helper, one seeded random generator.
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define IS_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define IS_SANITIZED 1
#endif

// Returns how many of a test's random cases to run: all, or a tenth under the sanitizers, which look for faults of
// memory and of arithmetic, not of answers, and find them in the first cases or not at all, and where branches are
// counted.
static inline uint64_t check_cases(uint64_t all)
{
#if defined(IS_SANITIZED) || defined(YOKE_COVERAGE)
    return (all + 9) / 10;
#else
    return all;
#endif
}

// Ends a test here under the sanitizers, where it would take long in code that shorter tests reach as well;
// `tools/test full` runs it.
static inline void check_without_sanitizers(void)
{
#if defined(IS_SANITIZED)
    if (!getenv("YOKE_EVERY")) skip();
#endif
}

// Fails unless |a - b| <= tolerance (NaN fails).
#define CHECK_NEAR(a, b, tolerance)                                                                                    \
    do {                                                                                                               \
        double check_a = (a), check_b = (b), check_t = (tolerance);                                                    \
        if (!(fabs(check_a - check_b) <= check_t)) {                                                                   \
            print_error("%s = %.17g, expected %.17g, off by %.3g (allowed %.3g)\n", #a, check_a, check_b,              \
                        fabs(check_a - check_b), check_t);                                                             \
            fail();                                                                                                    \
        }                                                                                                              \
    } while (0)

// splitmix64: seeded, the same everywhere. Print the seed when a test fails.
static inline uint64_t check_random(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
static inline double check_uniform(uint64_t *seed, double low, double high)
{
    return low + (high - low) * (double)(check_random(seed) >> 11) * 0x1p-53;
}
#endif
