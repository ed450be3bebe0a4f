// Every elementary function against MPFR, in units of the last place of the exact value: random arguments from ranges
// of every size, all pairs of corners, and the arguments that are hardest to reduce. With YOKE_FULL=1 ten million each.
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>
#include "check.h"
#include "elementary/elementary.h"

#ifndef YOKE_MPFR
int main(void)
{
    puts("not tried: MPFR is not installed");
    return 77;
}
#else
#include <mpfr.h>

enum { BITS = 140, RANGES = 6, GATE = 20000, FULL = 10000000 };

typedef struct Range {
    double low, high;
    bool by_size; // evenly over magnitudes, both signs where low < 0; otherwise evenly
} Range;

typedef int Exact(mpfr_t result, const mpfr_t x, mpfr_rnd_t rounding);
typedef int Exact2(mpfr_t result, const mpfr_t x, const mpfr_t y, mpfr_rnd_t rounding);

// One function of one argument or two; `most` is what it may be off.
typedef struct Subject {
    const char *name;
    double most;
    double (*one)(double);
    Exact *exact;
    double (*two)(double, double);
    Exact2 *exact2;
    Range ranges[RANGES], second[RANGES];
} Subject;

#define ANY                                                                                                            \
    {                                                                                                                  \
        -DBL_MAX, DBL_MAX, true                                                                                        \
    }

static const Subject subjects[] = {
    {"sin", 0.8, .one = yk_sin, .exact = mpfr_sin, .ranges = {{-1, 1}, {-10, 10}, {-1e5, 1e5}, {-1e7, 1e7}, ANY}},
    {"cos", 0.8, .one = yk_cos, .exact = mpfr_cos, .ranges = {{-1, 1}, {-10, 10}, {-1e5, 1e5}, {-1e7, 1e7}, ANY}},
    {"tan", 0.9, .one = yk_tan, .exact = mpfr_tan, .ranges = {{-1, 1}, {-10, 10}, {-1e5, 1e5}, {-1e7, 1e7}, ANY}},
    {"asin", 0.7, .one = yk_asin, .exact = mpfr_asin, .ranges = {{-1, 1}, {-0.6, 0.6}, {0.99, 1}, {-1, 1, true}}},
    {"acos", 0.7, .one = yk_acos, .exact = mpfr_acos, .ranges = {{-1, 1}, {-0.6, 0.6}, {0.99, 1}, {-1, 1, true}}},
    {"atan", 0.7, .one = yk_atan, .exact = mpfr_atan, .ranges = {{-1, 1}, {-10, 10}, {-1e3, 1e3}, ANY}},
    {"exp", 0.51, .one = yk_exp, .exact = mpfr_exp,
     .ranges = {{-1, 1}, {-10, 10}, {-746, 710}, {-746, -707}, {-710, 710, true}}},
    {"exp2", 0.51, .one = yk_exp2, .exact = mpfr_exp2,
     .ranges = {{-1, 1}, {-10, 10}, {-1076, 1024}, {-1076, -1021}, {-1024, 1024, true}}},
    {"log", 0.51, .one = yk_log, .exact = mpfr_log,
     .ranges = {{0, 2}, {0.98, 1.02}, {0, 1e3}, {DBL_TRUE_MIN, DBL_MAX, true}}},
    {"log2", 0.501, .one = yk_log2, .exact = mpfr_log2,
     .ranges = {{0, 2}, {0.98, 1.02}, {0, 1e3}, {DBL_TRUE_MIN, DBL_MAX, true}}},
    {"log10", 0.501, .one = yk_log10, .exact = mpfr_log10,
     .ranges = {{0, 2}, {0.98, 1.02}, {0, 1e3}, {DBL_TRUE_MIN, DBL_MAX, true}}},
    {"sinh", 0.65, .one = yk_sinh, .exact = mpfr_sinh, .ranges = {{-1, 1}, {-10, 10}, {-711, 711}, {-711, 711, true}}},
    {"cosh", 0.51, .one = yk_cosh, .exact = mpfr_cosh, .ranges = {{-1, 1}, {-10, 10}, {-711, 711}, {-711, 711, true}}},
    {"tanh", 0.7, .one = yk_tanh, .exact = mpfr_tanh, .ranges = {{-1, 1}, {-10, 10}, {-25, 25}, {-25, 25, true}}},
    {"erfc", 0.8, .one = yk_erfc, .exact = mpfr_erfc, .ranges = {{-1, 1}, {-6, 6}, {0.4, 4}, {4, 28}, {-28, 28, true}}},
    {"atan2", 0.75, .two = yk_atan2, .exact2 = mpfr_atan2,
     .ranges = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1e-280, 1e-280, true}},
     .second = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1, 1}}},
    {"hypot", 0.51, .two = yk_hypot, .exact2 = mpfr_hypot,
     .ranges = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1e-300, 1e-300, true}},
     .second = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1e-300, 1e-300, true}}},
    {"pow", 0.52, .two = yk_pow, .exact2 = mpfr_pow,
     .ranges = {{0, 2}, {0.98, 1.02}, {0, 1e3}, {DBL_TRUE_MIN, DBL_MAX, true}},
     .second = {{-100, 100}, {-1e5, 1e5}, {-110, 110}, {-1e3, 1e3, true}}},
    {"fmod", 0, .two = yk_fmod, .exact2 = mpfr_fmod, .ranges = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1e300, 1e300, true}},
     .second = {{-1, 1}, {-1e-3, 1e3, true}, ANY, {-1, 1}}},
    {"remainder", 0, .two = yk_remainder, .exact2 = mpfr_remainder,
     .ranges = {{-1, 1}, {-1e3, 1e3, true}, ANY, {-1e300, 1e300, true}},
     .second = {{-1, 1}, {-1e-3, 1e3, true}, ANY, {-1, 1}}},
};

// Evenly in the bits of the magnitude, from the smaller end's or from 2^-1074.
static double drawn(const Range *range, uint64_t *seed)
{
    if (!range->by_size) return check_uniform(seed, range->low, range->high);
    uint64_t low, high;
    double least = fmax(range->low, DBL_TRUE_MIN);
    memcpy(&low, &least, sizeof low);
    memcpy(&high, &range->high, sizeof high);
    uint64_t bits = low + check_random(seed) % (high - low + 1);
    double x;
    memcpy(&x, &bits, sizeof x);
    return range->low < 0 && check_random(seed) % 2 ? -x : x;
}

// The exact value and room to compare; made once.
typedef struct Meter {
    mpfr_t x, y, exact, off;
} Meter;

// By how many units of the last place `got` misses the exact value; infinity counts as 2^1024.
static double units_off(Meter *m, double got)
{
    if (mpfr_nan_p(m->exact) || isnan(got)) return mpfr_nan_p(m->exact) && isnan(got) ? 0 : INFINITY;
    if (mpfr_inf_p(m->exact)) return isinf(got) && signbit(got) == (mpfr_signbit(m->exact) != 0) ? 0 : INFINITY;
    if (mpfr_zero_p(m->exact)) return got == 0 && signbit(got) == (mpfr_signbit(m->exact) != 0) ? 0 : INFINITY;
    if (isinf(got))
        mpfr_set_si_2exp(m->off, got > 0 ? 1 : -1, 1024, MPFR_RNDN);
    else
        mpfr_set_d(m->off, got, MPFR_RNDN);
    if (got == 0 && signbit(got) != (mpfr_signbit(m->exact) != 0)) return INFINITY;
    mpfr_exp_t exponent = mpfr_get_exp(m->exact);
    if (isinf(got) && exponent > 1024) return 0;
    mpfr_sub(m->off, m->off, m->exact, MPFR_RNDN);
    mpfr_mul_2si(m->off, m->off, exponent < -1021 ? 1074 : 53 - exponent, MPFR_RNDN);
    return fabs(mpfr_get_d(m->off, MPFR_RNDN));
}

static double tried(Meter *m, const Subject *subject, double x, double y)
{
    mpfr_set_d(m->x, x, MPFR_RNDN);
    mpfr_set_d(m->y, y, MPFR_RNDN);
    if (subject->one)
        subject->exact(m->exact, m->x, MPFR_RNDN);
    else
        subject->exact2(m->exact, m->x, m->y, MPFR_RNDN);
    return units_off(m, subject->one ? subject->one(x) : subject->two(x, y));
}

typedef struct Worst {
    double off, x, y;
} Worst;

static void keep_worst(Worst *worst, double off, double x, double y)
{
    if (!(off <= worst->off)) *worst = (Worst){off, x, y};
}

static void try_at_random(Meter *m, const Subject *subject, Worst *worst, long count)
{
    uint64_t seed = 20260101;
    size_t ranges = 0;
    while (ranges < RANGES && subject->ranges[ranges].high > subject->ranges[ranges].low) ranges++;
    for (long i = 0; i < count; i++) {
        size_t k = (size_t)i % ranges;
        double x = drawn(&subject->ranges[k], &seed), y = subject->one ? 0 : drawn(&subject->second[k], &seed);
        keep_worst(worst, tried(m, subject, x, y), x, y);
    }
}

static const double corners[] = {0.0,
                                 0x1p-1074,
                                 0x1p-1073,
                                 0x0.8p-1022,
                                 0x0.fffffffffffffp-1022,
                                 0x1p-1022,
                                 1e-300,
                                 0x1p-400,
                                 1e-100,
                                 1e-20,
                                 0x1p-54,
                                 0x1p-30,
                                 1e-8,
                                 1e-3,
                                 0.1,
                                 0.25,
                                 0.41421356237309503,
                                 1. / 3,
                                 0x1.fffffffffffffp-2,
                                 0.5,
                                 0x1.0000000000001p-1,
                                 0x1.6p-1,
                                 0.75,
                                 0x1.fffffffffffffp-1,
                                 1,
                                 0x1.0000000000001p0,
                                 1.5,
                                 2,
                                 3,
                                 4,
                                 5,
                                 6,
                                 7,
                                 8,
                                 10,
                                 20,
                                 22,
                                 25,
                                 26.5,
                                 27.2,
                                 28,
                                 33,
                                 100,
                                 101,
                                 709.78,
                                 709.79,
                                 710.47,
                                 710.48,
                                 744.4,
                                 745.13,
                                 745.14,
                                 746,
                                 1000,
                                 1023,
                                 1024,
                                 1074,
                                 1075,
                                 1076,
                                 99999.9,
                                 100000.1,
                                 102943.7,
                                 102945,
                                 1e6,
                                 0x1p31,
                                 0x1.1p32,
                                 1e10,
                                 1e15,
                                 0x1.fffffffffffffp52,
                                 0x1p53,
                                 0x1.fffffffffffffp53,
                                 0x1p54,
                                 1e22,
                                 1e100,
                                 0x1p400,
                                 0x1p500,
                                 1e300,
                                 0x1.6ac5b262ca1ffp+849,
                                 DBL_MAX,
                                 INFINITY,
                                 NAN};
enum { CORNERS = sizeof corners / sizeof *corners };

static void try_corners(Meter *m, const Subject *subject, Worst *worst)
{
    for (size_t i = 0; i < 2 * (size_t)CORNERS; i++)
        for (size_t j = 0; j < (subject->one ? 1 : 2 * (size_t)CORNERS); j++) {
            double x = (i % 2 ? -1 : 1) * corners[i / 2], y = (j % 2 ? -1 : 1) * corners[j / 2];
            keep_worst(worst, tried(m, subject, x, y), x, y);
        }
}

// Doubles next to k pi/2 for k up to 2^20 and next to 2^e pi/2: the reduction loses most bits there.
static void try_quarter_turns(Meter *m, const Subject *subject, Worst *worst)
{
    for (int i = 0; i < 30000 + 1000; i++) {
        mpfr_const_pi(m->x, MPFR_RNDN);
        mpfr_mul_d(m->x, m->x, i < 30000 ? (double)(i < 15000 ? i : 37 * (i - 15000)) : (double)(2 * (i % 7) + 1),
                   MPFR_RNDN);
        mpfr_div_2ui(m->x, m->x, 1, MPFR_RNDN);
        if (i >= 30000) mpfr_mul_2ui(m->x, m->x, (unsigned long)(i - 30000), MPFR_RNDN);
        double x = mpfr_get_d(m->x, MPFR_RNDN);
        keep_worst(worst, tried(m, subject, x, 0), x, 0);
        x = nextafter(-x, -INFINITY);
        keep_worst(worst, tried(m, subject, x, 0), x, 0);
    }
}

// Powers that are exact, and numbers whose logarithm is.
static void try_exact(Meter *m, const Subject *subject, Worst *worst)
{
    for (int i = -323; i <= 308; i++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", i);
        double x = strtod(text, NULL), p = ldexp(1, i * 3);
        for (int j = -12; j <= 12; j++) {
            keep_worst(worst, tried(m, subject, x, j), x, j);
            keep_worst(worst, tried(m, subject, p, 0.5 * j), p, 0.5 * j);
            keep_worst(worst, tried(m, subject, i, j), i, j);
        }
    }
}

static void every_function_is_within_its_bound(void **state)
{
    (void)state;
    const char *only = getenv("YOKE_ONLY");
    long count = getenv("YOKE_FULL") ? FULL : (long)check_cases(GATE);
    int wrong = 0;
    Meter m;
    mpfr_inits2(BITS, m.x, m.y, m.exact, m.off, (mpfr_ptr)0);
    for (size_t i = 0; i < sizeof subjects / sizeof *subjects; i++) {
        const Subject *subject = &subjects[i];
        if (only && strcmp(only, subject->name) != 0) continue;
        Worst worst = {0, 0, 0};
        try_corners(&m, subject, &worst);
        try_exact(&m, subject, &worst);
        if (i < 3) try_quarter_turns(&m, subject, &worst);
        try_at_random(&m, subject, &worst, count);
        printf("%-9s %ld arguments, at most %.4f units off, at (%a, %a)\n", subject->name, count, worst.off, worst.x,
               worst.y);
        wrong += !(worst.off <= subject->most);
    }
    mpfr_clears(m.x, m.y, m.exact, m.off, (mpfr_ptr)0);
    mpfr_free_cache();
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_function_is_within_its_bound)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
#endif
