// Lumped constants: every polynomial in constants under one name, and back.
#include "ring/ring_check.h"

enum { LUMPS_MAX = 64 };
typedef struct Lumps {
    YkRing *ring;
    int32_t symbols[LUMPS_MAX];
    Element values[LUMPS_MAX];
    int count;
    bool refuses; // leaves everything as it is
} Lumps;

static int32_t symbol_of(void *context, Element lump)
{
    Lumps *lumps = context;
    char name[16];
    if (lumps->refuses) return -1;
    for (int k = 0; k < lumps->count; k++)
        if (yk_ring_is_same(lumps->values[k], lump)) return lumps->symbols[k];
    assert_true(lumps->count < LUMPS_MAX);
    snprintf(name, sizeof name, "p%d", lumps->count + 1);
    lumps->values[lumps->count] = lump;
    lumps->symbols[lumps->count] = yk_ring_symbol(lumps->ring, name, YK_RING_CONSTANT);
    return lumps->symbols[lumps->count++];
}

static Element put_back(const Lumps *lumps, Element a)
{
    YkRingChange changes[LUMPS_MAX];
    for (int k = 0; k < lumps->count; k++) changes[k] = (YkRingChange){lumps->symbols[k], lumps->values[k], NULL};
    return yk_ring_substitute(lumps->ring, a, changes, (size_t)lumps->count);
}

static void equal_polynomials_share_a_name_whatever_their_factor(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    Lumps lumps = {.ring = f.ring};
    Element a =
        read_text(&f, "(m1*l1 + 2*m2*lc1)*cos(theta1) - 3/2*(m1*l1 + 2*m2*lc1)*sin(theta2)*theta1'^2 + I1*theta1''");
    Element lumped = yk_ring_lump(f.ring, a, symbol_of, &lumps);
    assert_int_equal(lumps.count, 2);
    check_same(f.ring, lumped, read_text(&f, "p2*cos(theta1) - 3/2*p2*sin(theta2)*theta1'^2 + p1*theta1''"));
    check_same(f.ring, put_back(&lumps, lumped), a);
    yk_ring_free(f.ring);
}

static void what_moves_and_what_pushes_is_no_constant(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    Lumps lumps = {.ring = f.ring};
    Element a = read_text(&f, "2*d3*theta1' + F01x*cos(theta1) + 5 + s*theta1");
    check_same(f.ring, yk_ring_lump(f.ring, a, symbol_of, &lumps), a);
    assert_int_equal(lumps.count, 0);
    yk_ring_free(f.ring);
}

static void gravity_belongs_to_the_constants(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    Lumps lumps = {.ring = f.ring};
    yk_ring_lump(f.ring, read_text(&f, "(m1*lc1 + m2*l1)*g*sin(theta1)"), symbol_of, &lumps);
    assert_int_equal(lumps.count, 1);
    check_same(f.ring, lumps.values[0], read_text(&f, "(m1*lc1 + m2*l1)*g"));
    yk_ring_free(f.ring);
}

static void who_refuses_a_name_keeps_the_polynomial(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    Lumps lumps = {.ring = f.ring, .refuses = true};
    for (int k = 0; k < 200; k++) {
        Element a = random_element(&f, 6);
        check_same(f.ring, yk_ring_lump(f.ring, a, symbol_of, &lumps), a);
    }
    yk_ring_free(f.ring);
}

static void lumps_put_back_give_the_element(void **state)
{
    (void)state;
    for (uint64_t seed = 10; seed < 210; seed++) {
        Fixture f = fixture_new(seed);
        Lumps lumps = {.ring = f.ring};
        Element a = random_element(&f, 8);
        check_same(f.ring, put_back(&lumps, yk_ring_lump(f.ring, a, symbol_of, &lumps)), a);
        yk_ring_free(f.ring);
    }
}

static void nothing_is_lumped_of_nothing(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    Lumps lumps = {.ring = f.ring};
    assert_null(yk_ring_lump(f.ring, NULL, symbol_of, &lumps));
    assert_true(yk_ring_is_zero(yk_ring_lump(f.ring, number(&f, 0, 1), symbol_of, &lumps)));
    yk_ring_free(f.ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_polynomials_share_a_name_whatever_their_factor),
        cmocka_unit_test(what_moves_and_what_pushes_is_no_constant),
        cmocka_unit_test(gravity_belongs_to_the_constants),
        cmocka_unit_test(who_refuses_a_name_keeps_the_polynomial),
        cmocka_unit_test(lumps_put_back_give_the_element),
        cmocka_unit_test(nothing_is_lumped_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
