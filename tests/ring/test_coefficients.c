// Substitution, coefficients, content; limits and failures.
#include "ring/inside.h"
#include "ring/ring_check.h"

static void substitution_is_a_homomorphism(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    YkRing *r = f.ring;
    for (int i = 0; i < 500; i++) {
        Element a = random_element(&f, 4), b = random_element(&f, 3);
        // Values of single terms, so that negative powers exist; the angle turns by 15 deg times something, too.
        YkRingChange changes[] = {{f.parameter[1], random_term(&f, true), NULL},
                                  {f.parameter[3], random_term(&f, true), NULL},
                                  {f.angle[0], random_term(&f, true),
                                   yk_ring_multiply(r, random_unit(&f), yk_ring_turn(r, below(&f, 24), 12))}};
        if (yk_ring_is_zero(changes[0].value) || yk_ring_is_zero(changes[1].value) || yk_ring_is_zero(changes[2].value))
            continue;
        Element a_new = yk_ring_substitute(r, a, changes, 3), b_new = yk_ring_substitute(r, b, changes, 3);
        check_same(r, yk_ring_substitute(r, yk_ring_add(r, a, b), changes, 3), yk_ring_add(r, a_new, b_new));
        check_same(r, yk_ring_substitute(r, yk_ring_multiply(r, a, b), changes, 3), yk_ring_multiply(r, a_new, b_new));
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void symbols_are_replaced_all_at_once(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    const YkRingChange swap[] = {{f.parameter[1], symbol(&f, "m2"), NULL}, {f.parameter[2], symbol(&f, "m1"), NULL}};
    check_same(r, yk_ring_substitute(r, read_text(&f, "m1^2 + 3 m2 l1"), swap, 2), read_text(&f, "m2^2 + 3 m1 l1"));
    const YkRingChange sum = {f.parameter[3], read_text(&f, "lc1 + m1"), NULL};
    check_same(r, yk_ring_substitute(r, read_text(&f, "l1^2 cos(theta1)"), &sum, 1),
               read_text(&f, "(lc1^2 + 2 lc1 m1 + m1^2) cos(theta1)"));
    check_same(r, yk_ring_substitute(r, read_text(&f, "l1"), NULL, 0), read_text(&f, "l1"));
    assert_null(yk_ring_substitute(r, read_text(&f, "1/l1"), &sum, 1)); // 1/(a sum)
    assert_int_equal(yk_ring_status(r), YK_RING_DIVISOR);
    yk_ring_clear(r);
    const YkRingChange nowhere = {-1, number(&f, 1, 1), NULL};
    assert_null(yk_ring_substitute(r, number(&f, 1, 1), &nowhere, 1));
    yk_ring_free(r);
}

static void body_angles_become_sums_of_joint_angles(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    YkRing *r = f.ring;
    const YkAngleTerm both[] = {{f.angle[0], 1}, {f.angle[1], 1}};
    Element sum = read_text(&f, "theta1 + theta2");
    const YkRingChange body = {f.angle[1], sum, yk_ring_exp(r, both, 2)};
    check_same(r, yk_ring_substitute(r, read_text(&f, "cos(theta2 - theta1) + r_2*theta2"), &body, 1),
               read_text(&f, "cos(theta2) + r_2*theta1 + r_2*theta2"));
    const YkRingChange bent = {f.angle[1], NULL,
                               yk_ring_multiply(r, yk_ring_unit(r, f.angle[0]), yk_ring_turn(r, 1, 3))};
    check_same(r, yk_ring_substitute(r, read_text(&f, "sin(theta2) + theta2"), &bent, 1),
               read_text(&f, "sin(theta1 + pi/3) + theta2"));
    yk_ring_free(r);
}

static void coefficients_put_together_are_the_element(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    for (int i = 0; i < 500; i++) {
        Element a = random_element(&f, 1 + below(&f, 6)), sum = number(&f, 0, 1);
        int32_t variable = any_symbol(&f), lowest = 0, highest = -1;
        if (!yk_ring_powers(r, a, variable, &lowest, &highest)) assert_true(yk_ring_is_zero(a));
        for (int32_t power = lowest; power <= highest; power++) {
            Element part = yk_ring_coefficient(r, a, variable, power);
            if (!yk_ring_is_angle(r, variable)) assert_false(yk_ring_mentions(r, part, variable));
            sum = yk_ring_add(r, sum, yk_ring_multiply(r, part, yk_ring_power(r, yk_ring_of(r, variable), power)));
        }
        check_same(r, sum, a);
    }
    yk_ring_free(r);
}

static void symbols_of_an_element_come_in_order(void **state)
{
    (void)state;
    Fixture f = fixture_new(8);
    YkRing *r = f.ring;
    for (int i = 0; i < 500; i++) {
        Element a = random_element(&f, below(&f, 6));
        int32_t found = yk_ring_next_symbol(r, a, -1);
        for (int32_t s = 0; s < (int32_t)yk_ring_symbol_count(r); s++) {
            if (!yk_ring_mentions(r, a, s)) continue;
            assert_int_equal(found, s);
            found = yk_ring_next_symbol(r, a, found);
        }
        assert_int_equal(found, -1);
    }
    assert_int_equal(yk_ring_next_symbol(r, NULL, -1), -1);
    yk_ring_free(r);
}

static void content_divides_and_leaves_nothing_common(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    for (int i = 0; i < 500; i++) {
        Element a = random_element(&f, 1 + below(&f, 5)), content = yk_ring_content(r, a);
        if (yk_ring_is_zero(a)) continue;
        Element rest = yk_ring_divide(r, a, content);
        check_same(r, yk_ring_multiply(r, rest, content), a);
        check_same(r, yk_ring_content(r, rest), number(&f, 1, 1));
    }
    // A cosine has two terms: its coefficient counts by halves.
    check_same(r, yk_ring_content(r, read_text(&f, "4 m1 l1^2/3 + 2 m1 l1 lc1 cos(theta1)")),
               read_text(&f, "1/3 m1 l1"));
    check_same(r, yk_ring_content(r, read_text(&f, "1/l1 + 1/l1^2")), read_text(&f, "1/l1^2"));
    assert_true(yk_ring_is_zero(yk_ring_content(r, number(&f, 0, 1))));
    yk_ring_free(r);
}

static void a_coefficient_too_large_is_noticed(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    YkRing *r = f.ring;
    Element large = number(&f, INT64_MAX, 1), small = number(&f, 1, INT64_MAX);
    check_same(r, yk_ring_multiply(r, large, small), number(&f, 1, 1));
    check_same(r, yk_ring_subtract(r, large, large), number(&f, 0, 1));
    Element (*const operations[])(YkRing *, Element, Element) = {yk_ring_add, yk_ring_multiply};
    for (size_t i = 0; i < 2; i++) {
        assert_null(operations[i](r, large, large));
        assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
        assert_null(operations[i](r, small, yk_ring_scale(r, small, 2, 3)));
        yk_ring_clear(r);
    }
    assert_null(yk_ring_power(r, number(&f, 10, 1), 19));
    assert_null(yk_ring_add(r, NULL, large)); // a failure travels
    assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
    yk_ring_clear(r);
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void a_sum_too_long_is_noticed(void **state)
{
    (void)state;
    Fixture f = fixture_new(7);
    YkRing *r = f.ring;
    yk_ring_set_limit(r, 20);
    Element a = read_text(&f, "l1 + lc1 + m1 + m2 + I1");
    assert_int_equal(yk_ring_terms(yk_ring_power(r, a, 2)), 15);
    assert_null(yk_ring_power(r, a, 3));
    assert_int_equal(yk_ring_status(r), YK_RING_SIZE);
    yk_ring_clear(r);
    Element powers = number(&f, 0, 1);
    for (int i = 0; i < 20; i++) powers = yk_ring_add(r, powers, yk_ring_power(r, symbol(&f, "l1"), i));
    assert_int_equal(yk_ring_terms(powers), 20);
    assert_null(yk_ring_add(r, powers, symbol(&f, "m1")));
    assert_int_equal(yk_ring_status(r), YK_RING_SIZE);
    yk_ring_free(r);
}

static void powers_have_a_range(void **state)
{
    (void)state;
    Fixture f = fixture_new(8);
    YkRing *r = f.ring;
    Element l1 = symbol(&f, "l1"), most = yk_ring_power(r, l1, 1000000);
    check_same(r, yk_ring_multiply(r, most, yk_ring_power(r, l1, -1000000)), number(&f, 1, 1));
    assert_null(yk_ring_multiply(r, most, l1));
    assert_int_equal(yk_ring_status(r), YK_RING_POWER);
    yk_ring_clear(r);
    assert_null(yk_ring_power(r, l1, 1000001));
    assert_null(yk_ring_power(r, l1, INT32_MIN));
    yk_ring_clear(r);
    assert_null(yk_ring_divide(r, l1, number(&f, 0, 1)));
    assert_int_equal(yk_ring_status(r), YK_RING_DIVISOR);
    yk_ring_free(r);
}

// Conjugates that change nothing are left out: the numbers grow no further than the result asks.
static void a_reciprocal_overflows_only_where_it_must(void **state)
{
    (void)state;
    Fixture f = fixture_new(9);
    YkRing *r = f.ring;
    static const char *const terms[] = {"1000000000", "1000000000 + 1000000000 i", "30000 + 30000 sqrt(2)",
                                        "20000 sqrt(3) - 10000", "100 i sqrt(6)"};
    for (size_t i = 0; i < sizeof terms / sizeof *terms; i++) {
        Element a = read_text(&f, terms[i]);
        check_same(r, yk_ring_multiply(r, a, yk_ring_divide(r, number(&f, 1, 1), a)), number(&f, 1, 1));
    }
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    yk_ring_free(r);
}

static void all_elements_of_a_ring_have_a_limit_together(void **state)
{
    (void)state;
    Fixture f = fixture_new(10);
    YkRing *r = f.ring;
    Element a = read_text(&f, "l1 + lc1 + m1"), one = symbol(&f, "m2");
    r->made = YK_RING_MADE_MAX - 8;
    assert_non_null(yk_ring_add(r, a, one)); // four terms each
    assert_int_equal(r->made, YK_RING_MADE_MAX - 4);
    assert_non_null(yk_ring_subtract(r, a, one));
    assert_null(yk_ring_add(r, one, symbol(&f, "I1")));
    assert_int_equal(yk_ring_status(r), YK_RING_SIZE);
    yk_ring_free(r);
}

// b = k a is found with its k; where one key or one number differs there is none.
static void multiples_are_found_and_nothing_else(void **state)
{
    (void)state;
    Fixture f = fixture_new(11);
    YkRing *r = f.ring;
    for (int i = 0; i < 300; i++) {
        Element a = random_element(&f, 1 + below(&f, 4));
        int64_t over = 1 + below(&f, 30), under = 1 + below(&f, 30), p = 0, q = 0;
        if (below(&f, 2)) over = -over;
        bool is_zero = yk_ring_is_zero(a);
        assert_int_equal(yk_ring_is_multiple(yk_ring_scale(r, a, over, under), a, &p, &q), !is_zero);
        if (is_zero) continue;
        assert_true(p * under == q * over && q > 0);
        Element other = yk_ring_multiply(r, a, symbol(&f, "l1")), more = yk_ring_add(r, a, random_term(&f, true));
        assert_false(yk_ring_is_multiple(a, other, &p, &q));
        if (!yk_ring_is_zero(more) && yk_ring_is_multiple(more, a, &p, &q))
            check_same(r, more, yk_ring_scale(r, a, p, q));
    }
    int64_t p, q;
    assert_false(yk_ring_is_multiple(read_text(&f, "l1 + m1"), read_text(&f, "l1 + 2 m1"), &p, &q));
    assert_false(yk_ring_is_multiple(read_text(&f, "l1 + m1"), read_text(&f, "l1 - m1"), &p, &q));
    assert_false(yk_ring_is_multiple(read_text(&f, "l1"), read_text(&f, "m1"), &p, &q));
    assert_false(yk_ring_is_multiple(NULL, read_text(&f, "m1"), &p, &q)); // a failure travels
    assert_false(yk_ring_is_multiple(read_text(&f, "m1"), NULL, &p, &q));
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(substitution_is_a_homomorphism),
        cmocka_unit_test(symbols_are_replaced_all_at_once),
        cmocka_unit_test(body_angles_become_sums_of_joint_angles),
        cmocka_unit_test(coefficients_put_together_are_the_element),
        cmocka_unit_test(symbols_of_an_element_come_in_order),
        cmocka_unit_test(content_divides_and_leaves_nothing_common),
        cmocka_unit_test(a_coefficient_too_large_is_noticed),
        cmocka_unit_test(a_sum_too_long_is_noticed),
        cmocka_unit_test(powers_have_a_range),
        cmocka_unit_test(a_reciprocal_overflows_only_where_it_must),
        cmocka_unit_test(all_elements_of_a_ring_have_a_limit_together),
        cmocka_unit_test(multiples_are_found_and_nothing_else),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
