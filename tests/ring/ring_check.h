// Shared by the tests of the ring: a ring with symbols of every kind, random elements, and elements as text.
#ifndef TESTS_RING_CHECK_H
#define TESTS_RING_CHECK_H
#include "check.h"
#include <stdbool.h>
#include <stdlib.h>
#include "ring/print/write.h"
#include "ring/proof/field.h"
#include "ring/ring.h"

typedef const YkPoisson *Element;

enum { ANGLES = 3, PARAMETERS = 6 };
typedef struct Fixture {
    YkRing *ring;
    int32_t angle[ANGLES], rate[ANGLES], parameter[PARAMETERS], distance, distance_rate, lift, gravity, force;
    uint64_t seed;
} Fixture;

static inline Fixture fixture_new(uint64_t seed)
{
    static const char *const parameters[] = {"I1", "m1", "m2", "l1", "lc1", "r_2"}, *const lift[] = {"s", "s1", "s2",
                                                                                                     "s3"};
    static const YkRingClass kinds[] = {YK_RING_INERTIA,  YK_RING_MASS,     YK_RING_MASS,
                                        YK_RING_CONSTANT, YK_RING_CONSTANT, YK_RING_CONSTANT};
    static const char *const angles[] = {"theta1", "theta2", "A.angle"};
    Fixture f = {.ring = yk_ring_new(), .seed = seed};
    assert_non_null(f.ring);
    for (int i = 0; i < PARAMETERS; i++) f.parameter[i] = yk_ring_symbol(f.ring, parameters[i], kinds[i]);
    f.gravity = yk_ring_symbol(f.ring, "g", YK_RING_GRAVITY);
    f.force = yk_ring_symbol(f.ring, "F01x", YK_RING_FORCE);
    for (int i = 0; i < ANGLES; i++) f.angle[i] = yk_ring_angle(f.ring, angles[i]);
    for (int i = 0; i < ANGLES; i++) f.rate[i] = yk_ring_rates(f.ring, f.angle[i]);
    f.distance = yk_ring_symbol(f.ring, "d3", YK_RING_COORDINATE);
    f.distance_rate = yk_ring_rates(f.ring, f.distance);
    f.lift = yk_ring_function(f.ring, lift, 4, f.angle[1]);
    assert_int_equal(yk_ring_status(f.ring), YK_RING_OK);
    return f;
}

static inline int below(Fixture *f, int limit)
{
    return (int)(check_random(&f->seed) % (uint64_t)limit);
}

static inline Element symbol(Fixture *f, const char *name)
{
    return yk_ring_of(f->ring, yk_ring_find(f->ring, name));
}

static inline Element number(Fixture *f, int64_t over, int64_t under)
{
    return yk_ring_rational(f->ring, over, under);
}

// Any symbol but the last derivative of the lift, whose derivative is unknown, and constant angles.
static inline int32_t any_symbol(Fixture *f)
{
    for (;;) {
        int32_t index = below(f, (int)yk_ring_symbol_count(f->ring));
        if (index < f->lift + 2 && strncmp(yk_ring_symbol_name(f->ring, index), "pi", 2) != 0) return index;
    }
}

static inline Element random_unit(Fixture *f)
{
    YkAngleTerm terms[2];
    for (int i = 0; i < 2; i++) terms[i] = (YkAngleTerm){f->angle[below(f, ANGLES)], below(f, 5) - 2};
    return yk_ring_exp(f->ring, terms, (size_t)below(f, 3));
}

// One term; of every fifth the coefficient holds a multiple of 15 deg.
static inline Element random_term(Fixture *f, bool negative_powers)
{
    YkRing *ring = f->ring;
    int under = 1 + below(f, 6);
    Element term = number(f, below(f, 21) - 10, under);
    for (int i = below(f, 4); i > 0; i--) {
        int power = 1 + below(f, 2);
        if (negative_powers && below(f, 4) == 0) power = -power;
        term = yk_ring_multiply(ring, term, yk_ring_power(ring, yk_ring_of(ring, any_symbol(f)), power));
    }
    term = yk_ring_multiply(ring, term, random_unit(f));
    if (below(f, 3) == 0) term = yk_ring_multiply(ring, term, yk_ring_i(ring));
    if (below(f, 5) == 0) term = yk_ring_multiply(ring, term, yk_ring_turn(ring, below(f, 24), 12));
    return term;
}

static inline Element random_element(Fixture *f, int terms)
{
    Element sum = number(f, 0, 1);
    for (int i = 0; i < terms; i++) sum = yk_ring_add(f->ring, sum, random_term(f, true));
    assert_non_null(sum);
    return sum;
}

static inline Element read_as(YkRing *ring, YkRingFormat format, const char *text)
{
    YkProblems *problems = yk_problems_new();
    Element a = yk_ring_read(ring, format, text, strlen(text), (YkPlace){1, 1, 0}, problems);
    if (!a) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    return a;
}

static inline Element read_text(Fixture *f, const char *text)
{
    Element a = read_as(f->ring, YK_RING_TEXT, text);
    assert_non_null(a);
    return a;
}

static inline void check_written(YkRing *ring, Element a, YkRingFormat format, YkRingStyle style, const char *expected)
{
    YkText text = {0};
    assert_true(yk_ring_write(ring, a, format, style, &text));
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
}

static inline void check_same(YkRing *ring, Element a, Element b)
{
    if (yk_ring_is_same(a, b)) return;
    YkText text = {0};
    yk_ring_write(ring, a, YK_RING_TEXT, YK_RING_EXPANDED, &text);
    yk_text_puts(&text, "\nis not\n");
    yk_ring_write(ring, b, YK_RING_TEXT, YK_RING_EXPANDED, &text);
    print_error("%s\n%s\n", yk_text_get(&text), yk_ring_status_text(yk_ring_status(ring)));
    yk_text_free(&text);
    fail();
}

// Values for all symbols, away from zero.
static inline double *random_values(Fixture *f)
{
    double *values = malloc((yk_ring_symbol_count(f->ring) + 1) * sizeof *values);
    assert_non_null(values);
    for (size_t i = 0; i < yk_ring_symbol_count(f->ring); i++) values[i] = check_uniform(&f->seed, 0.4, 1.9);
    yk_ring_complete(f->ring, values);
    return values;
}
#endif
