// Elements that are linear in some symbols, taken apart.
#include "ring/ring_check.h"

enum { SYMBOLS = 4, ROUNDS = 300 };

static Element without(YkRing *r, Element a, const int32_t *symbols)
{
    for (int k = 0; k < SYMBOLS; k++) a = yk_ring_coefficient(r, a, symbols[k], 0);
    return a;
}

static void what_was_put_together_is_taken_apart(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    YkRing *r = f.ring;
    const int32_t symbols[SYMBOLS] = {f.rate[1], f.force, f.angle[0], f.distance}; // the angle outside of cos and sin
    for (int i = 0; i < ROUNDS; i++) {
        Element rest = without(r, random_element(&f, 5), symbols), a = rest, put[SYMBOLS], taken[SYMBOLS] = {NULL};
        for (int k = 0; k < SYMBOLS; k++) {
            put[k] = without(r, random_element(&f, 3), symbols);
            a = yk_ring_add(r, a, yk_ring_multiply(r, put[k], yk_ring_of(r, symbols[k])));
        }
        check_same(r, yk_ring_split(r, a, symbols, SYMBOLS, taken, SYMBOLS - 1), rest);
        for (int k = 0; k < SYMBOLS - 1; k++) {
            check_same(r, taken[k], put[k]);
            check_same(r, taken[k], yk_ring_coefficient(r, a, symbols[k], 1));
        }
        assert_null(taken[SYMBOLS - 1]); // not wanted
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void what_is_not_linear_is_refused(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    static const char *const not [] = {"F01x^2", "d3 F01x", "2 + m1/F01x"};
    const int32_t symbols[] = {f.force, f.distance};
    Element parts[2];
    for (size_t k = 0; k < sizeof not / sizeof *not ; k++) {
        assert_null(yk_ring_split(r, read_text(&f, not [k]), symbols, 2, parts, 2));
        assert_int_equal(yk_ring_status(r), YK_RING_POWER);
        yk_ring_clear(r);
    }
    Element free_of_them = read_text(&f, "m1 cos(theta1) + d3'");
    assert_ptr_equal(yk_ring_split(r, free_of_them, symbols, 2, parts, 2), free_of_them);
    assert_true(yk_ring_is_zero(parts[0]) && yk_ring_is_zero(parts[1]));
    assert_null(yk_ring_split(r, NULL, symbols, 2, parts, 2));
    yk_ring_free(r);
}

// A symbol that could not be entered, for lack of memory, is negative.
static void what_has_no_symbol_is_not_taken_apart(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    const int32_t symbols[] = {f.force, -1};
    Element parts[2];
    assert_null(yk_ring_split(f.ring, read_text(&f, "2 F01x + d3"), symbols, 2, parts, 2));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_MEMORY);
    yk_ring_free(f.ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_put_together_is_taken_apart),
        cmocka_unit_test(what_is_not_linear_is_refused),
        cmocka_unit_test(what_has_no_symbol_is_not_taken_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
