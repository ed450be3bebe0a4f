// Lanes: how a kernel's loop is written once and runs on any instruction set with the same bits.
//
// A kernel is a body that is inlined into one function per instruction set; the public function chooses at run time.
// Every operation is IEEE basic arithmetic in a fixed order (no fused operations, no reassociation), so that all of
// them, and one lane or many, give the same bits. This file is the only place that knows about instruction sets.
#ifndef ELEMENTARY_KERNEL_H
#define ELEMENTARY_KERNEL_H
#include <stdbool.h>
#include <stddef.h>
// A function that must vanish into its caller, to be compiled for its instruction set; not where branches are counted.
#if defined(__GNUC__) && !defined(YOKE_COVERAGE)
#define YK_INLINE static inline __attribute__((always_inline))
#define YK_APART static __attribute__((noinline))
#else
#define YK_INLINE static inline
#define YK_APART static
#endif

// Before a loop over lanes: no lane depends on another one.
// YK_ONE_PASS: whether a loop that both places and differentiates is worth it; clang 14 vectorises the two only apart.
#if defined(__clang__)
#define YK_ONE_PASS false
#pragma clang diagnostic ignored "-Wpass-failed" // a loop that stays scalar is slower, not wrong
#define YK_EACH_LANE _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define YK_ONE_PASS true
#define YK_EACH_LANE _Pragma("GCC ivdep")
#else
#define YK_ONE_PASS true
#define YK_EACH_LANE
#endif

// YK_UNROLL: behind that, for loops of so few operations that counting costs as much.
#if defined(__GNUC__) && !defined(__clang__)
#define YK_UNROLL _Pragma("GCC unroll 4")
#else
#define YK_UNROLL
#endif

// YK_KERNEL(name, parameters, arguments) defines the public function `name` from the body name##_body; the last
// parameter is the count n, which the arguments leave out. One lane takes a copy without a loop; few lanes take the
// plain copy, since for them the call costs more than the width gains.
#define YK_SPREAD(...) __VA_ARGS__
// YK_KNOWS_BLOCKS: whether loops of a length that the compiler knows are worth their room.
#if defined(__GNUC__) && defined(__x86_64__) && !defined(YK_PLAIN_LANES) && !defined(YOKE_COVERAGE)
#define YK_KNOWS_BLOCKS true
#define YK_FEW_LANES 8
#define YK_HAS_WIDE_LANES (__builtin_cpu_supports("avx512f") != 0) // vectors of eight
#define YK_KERNEL(name, parameters, arguments)                                                                         \
    __attribute__((target("avx512f"), noinline)) static void name##_avx512 parameters                                  \
    {                                                                                                                  \
        name##_body(YK_SPREAD arguments, n);                                                                           \
    }                                                                                                                  \
    __attribute__((target("avx2"), noinline)) static void name##_avx2 parameters                                       \
    {                                                                                                                  \
        name##_body(YK_SPREAD arguments, n);                                                                           \
    }                                                                                                                  \
    YK_APART void name##_plain parameters                                                                              \
    {                                                                                                                  \
        name##_body(YK_SPREAD arguments, n);                                                                           \
    }                                                                                                                  \
    void name parameters                                                                                               \
    {                                                                                                                  \
        if (n == 1)                                                                                                    \
            name##_body(YK_SPREAD arguments, 1);                                                                       \
        else if (n >= YK_FEW_LANES && __builtin_cpu_supports("avx512f"))                                               \
            name##_avx512(YK_SPREAD arguments, n);                                                                     \
        else if (n >= YK_FEW_LANES && __builtin_cpu_supports("avx2"))                                                  \
            name##_avx2(YK_SPREAD arguments, n);                                                                       \
        else                                                                                                           \
            name##_plain(YK_SPREAD arguments, n);                                                                      \
    }
#else
#ifdef YOKE_COVERAGE // counts what the others run
#define YK_KNOWS_BLOCKS true
#else
#define YK_KNOWS_BLOCKS false
#endif
#define YK_HAS_WIDE_LANES false
#define YK_KERNEL(name, parameters, arguments)                                                                         \
    void name parameters                                                                                               \
    {                                                                                                                  \
        name##_body(YK_SPREAD arguments, n);                                                                           \
    }
#endif

#endif
