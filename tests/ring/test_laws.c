// The ring is a ring, with a conjugation and derivations: laws on random elements.
#include "ring/ring_check.h"

enum { CASES = 3000 };

static void addition_and_multiplication_commute_associate_and_distribute(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    YkRing *r = f.ring;
    for (int i = 0; i < CASES; i++) {
        Element a = random_element(&f, below(&f, 5)), b = random_element(&f, below(&f, 5)),
                c = random_element(&f, below(&f, 4));
        check_same(r, yk_ring_add(r, a, b), yk_ring_add(r, b, a));
        check_same(r, yk_ring_multiply(r, a, b), yk_ring_multiply(r, b, a));
        check_same(r, yk_ring_add(r, yk_ring_add(r, a, b), c), yk_ring_add(r, a, yk_ring_add(r, b, c)));
        Element ab = yk_ring_multiply(r, a, b), bc = yk_ring_multiply(r, b, c);
        check_same(r, yk_ring_multiply(r, ab, c), yk_ring_multiply(r, a, bc));
        check_same(r, yk_ring_multiply(r, yk_ring_add(r, a, b), c), yk_ring_add(r, yk_ring_multiply(r, a, c), bc));
        assert_true(yk_ring_is_zero(yk_ring_subtract(r, ab, ab)));
        check_same(r, yk_ring_subtract(r, a, b), yk_ring_add(r, a, yk_ring_negate(r, b)));
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void many_parts_sum_and_multiply_as_one_after_another(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    for (int i = 0; i < 300; i++) {
        Element parts[8], sum = number(&f, 0, 1), product = number(&f, 1, 1);
        size_t count = (size_t)below(&f, 9);
        for (size_t k = 0; k < count; k++) {
            parts[k] = random_element(&f, below(&f, 6));
            sum = yk_ring_add(r, sum, parts[k]);
        }
        check_same(r, yk_ring_sum(r, parts, count), sum);
        count = count > 3 ? 3 : count;
        for (size_t k = 0; k < count; k++) product = yk_ring_multiply(r, product, parts[k]);
        check_same(r, yk_ring_product(r, parts, count), product);
    }
    yk_ring_free(r);
}

static void conjugation_is_an_involution_that_respects_products(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    YkRing *r = f.ring;
    for (int i = 0; i < CASES; i++) {
        Element a = random_element(&f, below(&f, 6)), b = random_element(&f, below(&f, 6)), i_unit = yk_ring_i(r);
        Element a_bar = yk_ring_conjugate(r, a), b_bar = yk_ring_conjugate(r, b);
        check_same(r, yk_ring_conjugate(r, a_bar), a);
        check_same(r, yk_ring_conjugate(r, yk_ring_multiply(r, a, b)), yk_ring_multiply(r, a_bar, b_bar));
        Element re = yk_ring_real(r, a), im = yk_ring_imaginary(r, a);
        check_same(r, yk_ring_add(r, re, yk_ring_multiply(r, i_unit, im)), a);
        assert_true(yk_ring_is_real(r, re) && yk_ring_is_real(r, im));
        assert_true(yk_ring_is_real(r, a) == yk_ring_is_zero(im));
        // dot and cross: conj(a) b = a . b + i a x b
        Element both = yk_ring_add(r, yk_ring_dot(r, a, b), yk_ring_multiply(r, i_unit, yk_ring_cross(r, a, b)));
        check_same(r, both, yk_ring_multiply(r, a_bar, b));
    }
    yk_ring_free(r);
}

static void derivatives_are_linear_obey_leibniz_and_commute(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    for (int i = 0; i < CASES; i++) {
        Element a = random_element(&f, below(&f, 4)), b = random_element(&f, below(&f, 4)),
                ab = yk_ring_multiply(r, a, b);
        int32_t x = any_symbol(&f), y = any_symbol(&f);
        Element da = yk_ring_partial(r, a, x), db = yk_ring_partial(r, b, x);
        check_same(r, yk_ring_partial(r, yk_ring_add(r, a, b), x), yk_ring_add(r, da, db));
        Element leibniz = yk_ring_add(r, yk_ring_multiply(r, da, b), yk_ring_multiply(r, a, db));
        check_same(r, yk_ring_partial(r, ab, x), leibniz);
        // Two independent variables: by a function's derivative and by its variable it depends on the order.
        bool independent = x < f.lift && y < f.lift;
        if (independent) check_same(r, yk_ring_partial(r, da, y), yk_ring_partial(r, yk_ring_partial(r, a, y), x));
        Element ta = yk_ring_time_derivative(r, a), tb = yk_ring_time_derivative(r, b);
        leibniz = yk_ring_add(r, yk_ring_multiply(r, ta, b), yk_ring_multiply(r, a, tb));
        check_same(r, yk_ring_time_derivative(r, ab), leibniz);
        check_same(r, yk_ring_conjugate(r, ta), yk_ring_time_derivative(r, yk_ring_conjugate(r, a)));
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void powers_multiply_and_divide(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    for (int i = 0; i < CASES; i++) {
        Element a = random_element(&f, 1 + below(&f, 3)), product = number(&f, 1, 1), term = random_term(&f, true);
        int power = below(&f, 5);
        for (int k = 0; k < power; k++) product = yk_ring_multiply(r, product, a);
        check_same(r, yk_ring_power(r, a, power), product);
        if (yk_ring_is_zero(term)) continue;
        check_same(r, yk_ring_multiply(r, yk_ring_divide(r, a, term), term), a);
        check_same(r, yk_ring_divide(r, yk_ring_multiply(r, a, term), term), a);
        check_same(r, yk_ring_multiply(r, yk_ring_power(r, term, -power), yk_ring_power(r, term, power)),
                   number(&f, 1, 1));
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void scaling_is_multiplication_by_a_rational(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    YkRing *r = f.ring;
    for (int i = 0; i < 1000; i++) {
        Element a = random_element(&f, below(&f, 6));
        int64_t over = below(&f, 40) - 20, under = below(&f, 2) ? 1 + below(&f, 30) : -1 - below(&f, 30);
        check_same(r, yk_ring_scale(r, a, over, under), yk_ring_multiply(r, a, number(&f, over, under)));
    }
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(addition_and_multiplication_commute_associate_and_distribute),
        cmocka_unit_test(many_parts_sum_and_multiply_as_one_after_another),
        cmocka_unit_test(conjugation_is_an_involution_that_respects_products),
        cmocka_unit_test(derivatives_are_linear_obey_leibniz_and_commute),
        cmocka_unit_test(powers_multiply_and_divide),
        cmocka_unit_test(scaling_is_multiplication_by_a_rational),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
