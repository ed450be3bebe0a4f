// Derivatives by symbols, angles and time; functions of one variable; roots.
#include "ring/ring_check.h"

static Element partial(Fixture *f, const char *text, const char *variable)
{
    return yk_ring_partial(f->ring, read_text(f, text), yk_ring_find(f->ring, variable));
}

static void partial_derivatives_are_those_of_the_books(void **state)
{
    (void)state;
    static const char *const table[][3] = {
        {"l1*cos(theta1)", "theta1", "-l1*sin(theta1)"},
        {"l1*cos(theta1 - 2*theta2)", "theta2", "2*l1*sin(theta1 - 2*theta2)"},
        {"l1^3*lc1^-2", "l1", "3*l1^2/lc1^2"},
        {"l1^3*lc1^-2", "lc1", "-2*l1^3/lc1^3"},
        {"r_2*theta1*sin(theta1)", "theta1", "r_2*sin(theta1) + r_2*theta1*cos(theta1)"},
        {"l1*theta1'^2", "theta1'", "2*l1*theta1'"},
        {"l1*theta1'^2", "theta1", "0"},
        {"s*cos(theta2)", "theta2", "s1*cos(theta2) - s*sin(theta2)"},
        {"s^2", "theta2", "2*s*s1"},
        {"s", "s", "1"},
        {"7", "l1", "0"},
    };
    Fixture f = fixture_new(1);
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        check_same(f.ring, partial(&f, table[i][0], table[i][1]), read_text(&f, table[i][2]));
    yk_ring_free(f.ring);
}

static void time_derivatives_follow_the_chain_of_rates(void **state)
{
    (void)state;
    static const char *const table[][2] = {
        {"l1*cos(theta1)", "-l1*sin(theta1)*theta1'"},
        {"theta1'", "theta1''"},
        {"theta1''", "0"},
        {"l1*m1", "0"},
        {"d3*exp(i*theta1)", "(d3' + i*d3*theta1')*exp(i*theta1)"},
        {"s", "s1*theta2'"},
        {"s1*theta2'", "s2*theta2'^2 + s1*theta2''"},
        {"r_2*theta1", "r_2*theta1'"},
        {"d3^-1", "-d3'/d3^2"},
    };
    Fixture f = fixture_new(2);
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        check_same(f.ring, yk_ring_time_derivative(f.ring, read_text(&f, table[i][0])), read_text(&f, table[i][1]));
    yk_ring_free(f.ring);
}

static void the_last_derivative_of_a_function_cannot_be_differentiated(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    assert_null(partial(&f, "s3*l1", "theta2"));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_DERIVATIVE);
    yk_ring_clear(f.ring);
    assert_null(yk_ring_time_derivative(f.ring, symbol(&f, "s3")));
    yk_ring_clear(f.ring);
    assert_true(yk_ring_is_zero(partial(&f, "s3*l1", "theta1"))); // another variable: it is a constant there
    assert_null(yk_ring_partial(f.ring, symbol(&f, "l1"), 9999));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_NAME);
    yk_ring_free(f.ring);
}

// The derivative of a value is the value of the derivative (central differences of sixth order).
static double slope(Fixture *f, Element a, double *values, int32_t variable)
{
    static const double weights[] = {3.0 / 4, -3.0 / 20, 1.0 / 60};
    double step = 0.01, start = values[variable], sum = 0;
    for (int k = 1; k <= 3; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            values[variable] = start + sign * k * step;
            sum += sign * weights[k - 1] * yk_ring_value(f->ring, a, values).x / step;
        }
    values[variable] = start;
    return sum;
}

static void derivatives_agree_with_differences_of_values(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    for (int i = 0; i < 300; i++) {
        Element a = yk_ring_real(f.ring, random_element(&f, 4));
        int32_t variable = any_symbol(&f);
        if (yk_ring_mentions(f.ring, a, f.lift) || yk_ring_mentions(f.ring, a, f.lift + 1))
            continue; // its values are its own
        double *values = random_values(&f);
        double exact = yk_ring_value(f.ring, yk_ring_partial(f.ring, a, variable), values).x;
        CHECK_NEAR(slope(&f, a, values, variable), exact, 1e-6 * (1 + fabs(exact)) + 1e-3 * fabs(exact));
        free(values);
    }
    yk_ring_free(f.ring);
}

static void a_root_keeps_its_square_through_derivatives(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    Element span = read_text(&f, "l1*exp(i*theta1) - d3 - i*lc1"), square = yk_ring_dot(r, span, span);
    int32_t root = yk_ring_root(r, "L", square);
    Element L = yk_ring_of(r, root), rate = yk_ring_time_derivative(r, L);
    // L L' = span . span'
    assert_true(
        yk_ring_is_equal(r, yk_ring_multiply(r, L, rate), yk_ring_dot(r, span, yk_ring_time_derivative(r, span))));
    assert_true(yk_ring_is_equal(r, yk_ring_power(r, L, 2), square));
    assert_true(yk_ring_is_equal(r, yk_ring_power(r, L, 3), yk_ring_multiply(r, L, square)));
    assert_true(yk_ring_is_equal(r, yk_ring_divide(r, square, L), L));
    assert_false(yk_ring_is_equal(r, L, square));
    assert_false(yk_ring_is_equal(r, L, yk_ring_negate(r, L)));
    // The power of a spring k (L - l1): dV/dt = k (L - l1) L', and twice differentiated either way.
    Element stretch = yk_ring_subtract(r, L, symbol(&f, "l1")),
            V = yk_ring_scale(r, yk_ring_power(r, stretch, 2), 1, 2);
    assert_true(yk_ring_is_equal(r, yk_ring_time_derivative(r, V), yk_ring_multiply(r, stretch, rate)));
    Element by_parts =
        yk_ring_add(r, yk_ring_power(r, rate, 2), yk_ring_multiply(r, L, yk_ring_time_derivative(r, rate)));
    Element twice = yk_ring_scale(r, yk_ring_time_derivative(r, yk_ring_time_derivative(r, square)), 1, 2);
    assert_true(yk_ring_is_equal(r, by_parts, twice));
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
    assert_int_equal(yk_ring_root(r, "M", span), -1);
    assert_int_equal(yk_ring_status(r), YK_RING_NOT_REAL);
    yk_ring_free(r);
}

// A root of a root: both are reduced.
static void roots_may_be_nested(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    YkRing *r = f.ring;
    Element L = yk_ring_of(r, yk_ring_root(r, "L", read_text(&f, "1 + l1^2")));
    Element M = yk_ring_of(r, yk_ring_root(r, "M", yk_ring_add(r, L, symbol(&f, "m1"))));
    Element M4 = yk_ring_power(r, M, 4), expected = read_text(&f, "1 + l1^2 + 2 L m1 + m1^2");
    assert_true(yk_ring_is_equal(r, M4, expected));
    assert_false(yk_ring_is_equal(r, M4, read_text(&f, "1 + l1^2 - 2 L m1 + m1^2")));
    Element slope_of_M = yk_ring_partial(r, M, yk_ring_find(r, "l1"));
    assert_true(yk_ring_is_equal(r, yk_ring_product(r, (Element[]){slope_of_M, M, L}, 3), read_text(&f, "l1/2")));
    yk_ring_free(r);
}

static void declared_partial_derivatives_chain(void **state)
{
    (void)state;
    Fixture f = fixture_new(7);
    YkRing *r = f.ring;
    int32_t psi = yk_ring_angle(r, "psi"), theta1 = yk_ring_find(r, "theta1");
    assert_true(yk_ring_set_partial(r, psi, theta1, symbol(&f, "r_2"))); // a gear of symbolic ratio: psi = r_2 theta1
    check_same(r, partial(&f, "sin(psi)", "theta1"), read_text(&f, "r_2*cos(psi)"));
    check_same(r, yk_ring_time_derivative(r, read_text(&f, "sin(psi)")), read_text(&f, "r_2*cos(psi)*theta1'"));
    int32_t loop = yk_ring_symbol(r, "loop", YK_RING_FUNCTION); // a symbol that depends on itself never ends
    assert_true(yk_ring_set_partial(r, loop, loop, number(&f, 1, 1)));
    assert_null(yk_ring_time_derivative(r, yk_ring_of(r, loop)));
    assert_int_equal(yk_ring_status(r), YK_RING_DERIVATIVE);
    yk_ring_free(r);
}

static void a_rule_that_is_added_later_counts(void **state)
{
    (void)state;
    Fixture f = fixture_new(9);
    YkRing *r = f.ring;
    int32_t made = yk_ring_symbol(r, "made", YK_RING_FUNCTION), x = f.parameter[3], y = f.parameter[4];
    Element square = yk_ring_power(r, yk_ring_of(r, made), 2), twice = yk_ring_scale(r, yk_ring_of(r, made), 2, 1);
    assert_true(yk_ring_set_partial(r, made, x, number(&f, 3, 1)));
    check_same(r, yk_ring_partial(r, square, x), yk_ring_scale(r, twice, 3, 1));
    assert_true(yk_ring_is_zero(yk_ring_partial(r, square, y)));
    check_same(r, yk_ring_partial(r, square, x), yk_ring_scale(r, twice, 3, 1)); // from memory
    assert_true(yk_ring_set_partial(r, made, y, symbol(&f, "m1")));
    check_same(r, yk_ring_partial(r, square, y), yk_ring_multiply(r, twice, symbol(&f, "m1")));
    assert_true(yk_ring_set_rate(r, x, symbol(&f, "m2")));
    check_same(r, yk_ring_time_derivative(r, square),
               yk_ring_multiply(r, twice, yk_ring_scale(r, symbol(&f, "m2"), 3, 1)));
    assert_true(yk_ring_set_rate(r, x, number(&f, 1, 1)));
    check_same(r, yk_ring_time_derivative(r, square), yk_ring_scale(r, twice, 3, 1));
    assert_true(yk_ring_set_rate(r, x, number(&f, 2, 15)) && yk_ring_set_rate(r, y, number(&f, 1, 6)));
    Element product = yk_ring_multiply(r, yk_ring_of(r, x), yk_ring_of(r, y));
    check_same(r, yk_ring_time_derivative(r, product), read_text(&f, "2/15 lc1 + 1/6 l1"));
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(partial_derivatives_are_those_of_the_books),
        cmocka_unit_test(time_derivatives_follow_the_chain_of_rates),
        cmocka_unit_test(the_last_derivative_of_a_function_cannot_be_differentiated),
        cmocka_unit_test(derivatives_agree_with_differences_of_values),
        cmocka_unit_test(a_root_keeps_its_square_through_derivatives),
        cmocka_unit_test(roots_may_be_nested),
        cmocka_unit_test(declared_partial_derivatives_chain),
        cmocka_unit_test(a_rule_that_is_added_later_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
