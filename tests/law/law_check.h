// Shared by the tests of laws: a law under construction with its arena, and derivatives by differences.
#ifndef TESTS_LAW_CHECK_H
#define TESTS_LAW_CHECK_H
#include "check.h"
#include "base/vec.h"
#include "law/build.h"

typedef struct Bench {
    YkArena *arena;
    YkLawBuilder *builder;
    YkLaw *law;
} Bench;

static inline Bench bench_new(double from, double value)
{
    Bench bench = {.arena = yk_arena_new(), .builder = yk_law_builder_new(from, value)};
    assert_non_null(bench.arena);
    assert_non_null(bench.builder);
    return bench;
}

static inline const YkLaw *bench_finish(Bench *bench, double period)
{
    assert_int_equal(yk_law_finish(bench->builder, period, bench->arena, &bench->law), YK_LAW_OK);
    assert_non_null(bench->law);
    return bench->law;
}

static inline void bench_free(Bench *bench)
{
    yk_law_builder_free(bench->builder);
    yk_arena_free(bench->arena);
}

static inline double law_value(const YkLaw *law, double x, int order)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(law, x, d);
    return d[order];
}

// What holds just before x.
static inline double law_before(const YkLaw *law, double x, int order)
{
    return law_value(law, nextafter(x, -INFINITY), order);
}

// The derivative of this order by central differences of the one below, to the sixth order of h. x +- 3 h must lie
// within one piece.
static inline double law_difference(const YkLaw *law, double x, int order, double h)
{
    static const double weight[3] = {45.0 / 60, -9.0 / 60, 1.0 / 60};
    double sum = 0;
    for (int k = 1; k <= 3; k++)
        sum += weight[k - 1] * (law_value(law, x + k * h, order - 1) - law_value(law, x - k * h, order - 1));
    return sum / h;
}

#endif
