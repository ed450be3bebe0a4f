// Numbers of the ring and the identities of trigonometry, which hold by construction.
#include "ring/ring_check.h"

static void trigonometric_identities_are_equalities_of_elements(void **state)
{
    (void)state;
    static const char *const identities[][2] = {
        {"cos(theta1) cos(theta2) + sin(theta1) sin(theta2)", "cos(theta1 - theta2)"},
        {"sin(theta1) cos(theta2) + cos(theta1) sin(theta2)", "sin(theta1 + theta2)"},
        {"cos(theta1)^2 + sin(theta1)^2", "1"},
        {"sin(3 theta1)", "3 sin(theta1) - 4 sin(theta1)^3"},
        {"cos(2 theta1)", "2 cos(theta1)^2 - 1"},
        {"sin(theta1 + theta2 + A.angle)", "sin(theta1) cos(theta2) cos(A.angle) + cos(theta1) sin(theta2) "
                                           "cos(A.angle) + cos(theta1) cos(theta2) sin(A.angle)"
                                           " - sin(theta1) sin(theta2) sin(A.angle)"},
        {"cos(pi/3)", "1/2"},
        {"cos(pi/6)", "sqrt(3)/2"},
        {"sin(pi/4) cos(pi/4)", "1/2"},
        {"sin(pi/12)", "(sqrt(6) - sqrt(2))/4"},
        {"cos(pi/12) cos(5 pi/12)", "1/4"},
        {"cos(pi/12)^2", "(2 + sqrt(3))/4"},
        {"cos(theta1 + pi/2)", "-sin(theta1)"},
        {"cos(theta1 - pi)", "-cos(theta1)"},
        {"cos(theta1 + 2 pi)", "cos(theta1)"},
        {"cos(theta1) + cos(theta1 + 2 pi/3) + cos(theta1 + 4 pi/3)", "0"},
        {"sin(theta1 + pi/4)", "(sin(theta1) + cos(theta1))/sqrt(2)"},
        {"exp(i theta1) exp(i theta2)", "exp(i (theta1 + theta2))"},
        {"exp(i pi)", "-1"},
        {"exp(i*pi/7)^7", "exp(i pi/7) exp(i*6*pi/7)"},
    };
    Fixture f = fixture_new(1);
    for (size_t i = 0; i < sizeof identities / sizeof *identities; i++)
        check_same(f.ring, read_text(&f, identities[i][0]), read_text(&f, identities[i][1]));
    check_same(f.ring, yk_ring_cos(f.ring, (const YkAngleTerm[]){{f.angle[0], 2}, {f.angle[1], -1}}, 2),
               read_text(&f, "cos(2*theta1 - theta2)"));
    check_same(f.ring, yk_ring_sin(f.ring, (const YkAngleTerm[]){{f.angle[0], -1}}, 1), read_text(&f, "-sin(theta1)"));
    yk_ring_free(f.ring);
}

static void fractions_of_a_turn_form_a_group(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    for (int over = -50; over <= 50; over++)
        for (int other = 0; other < 24; other++) {
            Element product = yk_ring_multiply(r, yk_ring_turn(r, over, 12), yk_ring_turn(r, other, 12));
            check_same(r, product, yk_ring_turn(r, over + other, 12));
            check_same(r, yk_ring_conjugate(r, yk_ring_turn(r, over, 12)), yk_ring_turn(r, -over, 12));
        }
    assert_int_equal(yk_ring_terms(yk_ring_turn(r, 1, 12)), 4);
    yk_ring_free(r);
}

static void any_turn_has_the_value_of_its_angle(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    for (int under = 1; under <= 30; under++)
        for (int over = -2 * under; over <= 2 * under; over++) {
            Element turn = yk_ring_turn(f.ring, over, under);
            double *values = random_values(&f);
            YkVec value = yk_ring_value(f.ring, turn, values), expected = yk_unit(YK_PI * over / under);
            CHECK_NEAR(value.x, expected.x, 1e-14);
            CHECK_NEAR(value.y, expected.y, 1e-14);
            free(values);
        }
    // Multiples of 15 deg need no symbol, others one for each denominator.
    assert_true(yk_ring_find(f.ring, "pi_12") < 0 && yk_ring_find(f.ring, "pi_7") >= 0);
    assert_true(yk_ring_is_zero(yk_ring_time_derivative(f.ring, yk_ring_turn(f.ring, 1, 7))));
    yk_ring_free(f.ring);
}

static void roots_of_two_and_three_are_exact(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    static const int64_t squares[] = {
        0, 1, 2, 3, 4, 6, 8, 9, 12, 18, 24, 25, 27, 50, 75, 147, 150, 1000000, 4611686018427387904};
    for (size_t i = 0; i < sizeof squares / sizeof *squares; i++) {
        Element root = yk_ring_sqrt(r, squares[i]);
        check_same(r, yk_ring_multiply(r, root, root), number(&f, squares[i], 1));
    }
    static const int64_t others[] = {5, 7, 10, 14, 15, 21, -1, -4, INT64_MAX};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        assert_null(yk_ring_sqrt(r, others[i]));
        assert_int_equal(yk_ring_status(r), YK_RING_POWER);
        yk_ring_clear(r);
    }
    yk_ring_free(r);
}

static void numbers_divide_even_when_they_hold_roots(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    check_same(r, read_text(&f, "1/(1 + sqrt(2))"), read_text(&f, "sqrt(2) - 1"));
    check_same(r, read_text(&f, "1/(sqrt(2) + sqrt(3))"), read_text(&f, "sqrt(3) - sqrt(2)"));
    check_same(r, read_text(&f, "2/(1 + i)"), read_text(&f, "1 - i"));
    for (int i = 0; i < 200; i++) {
        int under = 1 + below(&f, 9);
        Element a = number(&f, 1 + below(&f, 9), under);
        for (int k = 0; k < 3; k++) {
            int times = 1 + below(&f, 4);
            a = yk_ring_add(r, a, yk_ring_scale(r, yk_ring_turn(r, below(&f, 24), 12), times, 1));
        }
        if (!yk_ring_is_zero(a)) check_same(r, yk_ring_multiply(r, yk_ring_power(r, a, -1), a), number(&f, 1, 1));
    }
    yk_ring_free(r);
}

static void decimals_are_exact(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    check_same(f.ring, yk_ring_decimal(f.ring, 3, -1), number(&f, 3, 10));
    check_same(f.ring, yk_ring_decimal(f.ring, 6, 1), number(&f, 60, 1));
    check_same(f.ring, yk_ring_decimal(f.ring, 25, -3), number(&f, 1, 40));
    check_same(f.ring, yk_ring_decimal(f.ring, -1, -18), number(&f, -1, 1000000000000000000));
    check_same(f.ring, yk_ring_decimal(f.ring, 0, 500), number(&f, 0, 1));
    assert_null(yk_ring_decimal(f.ring, 1, -19));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_OVERFLOW);
    assert_null(yk_ring_decimal(f.ring, 1, 19));
    yk_ring_free(f.ring);
}

static void rationals_are_in_lowest_terms(void **state)
{
    (void)state;
    Fixture f = fixture_new(7);
    int64_t over, under;
    assert_true(yk_ring_is_rational(number(&f, 6, -4), &over, &under));
    assert_true(over == -3 && under == 2);
    assert_true(yk_ring_is_rational(number(&f, 0, -4), &over, &under));
    assert_true(over == 0 && under == 1);
    assert_false(yk_ring_is_rational(symbol(&f, "m1"), &over, &under));
    assert_false(yk_ring_is_rational(yk_ring_i(f.ring), &over, &under));
    assert_false(yk_ring_is_rational(NULL, &over, &under));
    assert_null(number(&f, 1, 0));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_DIVISOR);
    assert_null(number(&f, INT64_MIN, 1));
    yk_ring_free(f.ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trigonometric_identities_are_equalities_of_elements),
        cmocka_unit_test(fractions_of_a_turn_form_a_group),
        cmocka_unit_test(any_turn_has_the_value_of_its_angle),
        cmocka_unit_test(roots_of_two_and_three_are_exact),
        cmocka_unit_test(numbers_divide_even_when_they_hold_roots),
        cmocka_unit_test(decimals_are_exact),
        cmocka_unit_test(rationals_are_in_lowest_terms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
