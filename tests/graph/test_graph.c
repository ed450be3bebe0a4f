// The graph folds what is constant, finds values again, and its derivatives agree with differences.
#include "graph/graph_check.h"

typedef struct Graph {
    YkGraph g;
    YkArena *arena;
    YkRef x, y, length;
} Graph;

static int set_up(void **state)
{
    static Graph t;
    t.arena = yk_arena_new();
    assert_true(t.arena && yk_graph_start(&t.g, t.arena));
    t.x = yk_graph_leaf(&t.g, YK_LEAF_POSE, "x");
    t.y = yk_graph_leaf(&t.g, YK_LEAF_POSE, "y");
    t.length = yk_graph_leaf(&t.g, YK_LEAF_PARAMETER, "l");
    *state = &t;
    return 0;
}

static int tear_down(void **state)
{
    Graph *t = *state;
    yk_graph_end(&t->g);
    yk_arena_free(t->arena);
    return 0;
}

// The value at x, y and l = 3.
static double value(const Graph *t, YkRef ref, double x, double y)
{
    double *numbers = calloc(t->g.count, sizeof *numbers);
    assert_non_null(numbers);
    numbers[t->x] = x, numbers[t->y] = y, numbers[t->length] = 3;
    graph_evaluate(&t->g, numbers);
    double found = numbers[ref];
    free(numbers);
    return found;
}

static void what_is_constant_is_folded_and_what_is_there_is_found(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    YkRef zero = yk_graph_number(g, 0), one = yk_graph_number(g, 1), two = yk_graph_number(g, 2);
    assert_int_equal(yk_graph_add(g, t->x, zero), t->x);
    assert_int_equal(yk_graph_multiply(g, one, t->x), t->x);
    assert_int_equal(yk_graph_multiply(g, t->x, zero), zero);
    assert_int_equal(yk_graph_subtract(g, t->x, t->x), zero);
    assert_int_equal(yk_graph_add(g, one, one), two);
    assert_int_equal(yk_graph_minus(g, yk_graph_minus(g, t->x)), t->x);
    assert_int_equal(yk_graph_add(g, t->x, t->y), yk_graph_add(g, t->y, t->x));
    assert_int_equal(yk_graph_subtract(g, t->x, yk_graph_minus(g, t->y)), yk_graph_add(g, t->x, t->y));
    assert_int_equal(yk_graph_leaf(g, YK_LEAF_POSE, "x"), t->x);
    YkRef square = yk_graph_multiply(g, t->x, t->x);
    assert_int_equal(g->values[yk_graph_function(g, YK_SQRT, square, -1)].op, YK_VALUE_SIZE);
    assert_true(yk_graph_is_number(g, yk_graph_unit(g, zero).x, 1));
}

static void what_hangs_on_parameters_alone_is_known_as_such(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    YkRef own = yk_graph_multiply(g, t->length, t->length), mixed = yk_graph_multiply(g, t->length, t->x);
    assert_true(g->values[own].of_parameters);
    assert_true(g->values[t->length].of_parameters);
    assert_false(g->values[mixed].of_parameters);
}

static void check_number(const YkGraph *g, YkRef ref, double expected)
{
    assert_int_equal(g->values[ref].op, YK_VALUE_NUMBER);
    CHECK_NEAR(g->values[ref].number, expected, 1e-15 * fabs(expected));
}

// An operation of numbers is what it gives; of a number and a leaf it stays, in its order.
static void numbers_alone_are_folded(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    static const double x[] = {-2, -0.5, 0.3, 1.7, 3};
    static const YkValueKind ops[] = {YK_VALUE_LEAST, YK_VALUE_LARGEST, YK_VALUE_ANGLE};
    for (size_t i = 0; i < 5; i++) {
        YkRef a = yk_graph_number(g, x[i]);
        check_number(g, yk_graph_unary(g, YK_VALUE_ROOT, a), sqrt(fmax(x[i], 0)));
        check_number(g, yk_graph_unary(g, YK_VALUE_PER_ROOT, a), x[i] > 0 ? 1 / sqrt(x[i]) : 1e18);
        check_number(g, yk_graph_unary(g, YK_VALUE_SIZE, a), fabs(x[i]));
        check_number(g, yk_graph_unary(g, YK_VALUE_NONZERO, a), fabs(x[i]));
        assert_int_equal(yk_graph_choose(g, a, t->x, t->y), x[i] < 0 ? t->x : t->y);
        for (size_t k = 0; k < 5; k++) {
            YkRef b = yk_graph_number(g, x[k]);
            check_number(g, yk_graph_binary(g, YK_VALUE_LEAST, a, b), fmin(x[i], x[k]));
            check_number(g, yk_graph_binary(g, YK_VALUE_LARGEST, a, b), fmax(x[i], x[k]));
            check_number(g, yk_graph_binary(g, YK_VALUE_ANGLE, a, b), atan2(x[i], x[k]));
            check_number(g, yk_graph_divide(g, a, b), x[i] / x[k]);
            check_number(g, yk_graph_subtract(g, a, b), x[i] - x[k]);
        }
        for (size_t k = 0; k < 3; k++) {
            YkRef first = yk_graph_binary(g, ops[k], a, t->x), last = yk_graph_binary(g, ops[k], t->x, a);
            assert_int_equal(g->values[first].op, ops[k]);
            assert_true(g->values[first].a == a && g->values[first].b == t->x);
            assert_int_equal(g->values[last].op, ops[k]);
            assert_true(g->values[last].a == t->x && g->values[last].b == a);
        }
    }
}

// A power of a number is a product, a quotient or a root where that is the same, and stays a power elsewhere: of a leaf
// too.
static void powers_are_powers(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    static const double exponents[] = {-9, -8, -3, -1, -0.5, 0, 0.5, 1, 1.5, 2, 7, 8, 9};
    for (size_t k = 0; k < sizeof exponents / sizeof *exponents; k++) {
        double e = exponents[k], x = 1.37;
        YkRef number = yk_graph_number(g, e), power = yk_graph_power(g, t->x, number);
        CHECK_NEAR(value(t, power, x, 2), pow(x, e), 1e-14 * pow(x, e));
        bool is_short = (e == rint(e) && fabs(e) <= 8) || e == 0.5;
        assert_int_equal(g->values[power].op == YK_VALUE_POWER, !is_short);
        check_number(g, yk_graph_power(g, yk_graph_number(g, x), number), pow(x, e));
        YkRef other = yk_graph_power(g, number, t->x);
        if (e > 0) CHECK_NEAR(value(t, other, x, 2), pow(e, x), 1e-14 * pow(e, x));
    }
    CHECK_NEAR(value(t, yk_graph_power(g, t->x, t->y), 1.37, 2.2), pow(1.37, 2.2), 1e-14);
}

// Each operation counts once, however often it is used; signs, leaves and what depends on parameters alone cost
// nothing.
static void operations_are_counted_once(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    YkRef product = yk_graph_multiply(g, t->x, t->y), sine = yk_graph_function(g, YK_SIN, product, YK_NONE);
    YkRef sum = yk_graph_add(g, product, sine), minus = yk_graph_minus(g, product);
    YkRef fixed = yk_graph_multiply(g, t->length, t->length), mixed = yk_graph_multiply(g, fixed, t->x);
    YkRef chosen = yk_graph_choose(g, t->x, t->y, mixed);
    assert_int_equal(yk_graph_cost(g, &product, 1), 1);
    assert_int_equal(yk_graph_cost(g, &minus, 1), 1);
    assert_int_equal(yk_graph_cost(g, &sum, 1), 3);
    assert_int_equal(yk_graph_cost(g, &fixed, 1), 0);
    assert_int_equal(yk_graph_cost(g, &chosen, 1), 2);
    assert_int_equal(yk_graph_cost(g, (YkRef[]){sum, product, minus, chosen, t->x}, 5), 5);
}

// What is known of derivatives carries stamps that count up; when they run out, nothing of before is taken for new.
static void derivatives_stay_right_when_their_stamps_begin_anew(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    YkRef product = yk_graph_multiply(g, t->x, t->y), sum = yk_graph_add(g, product, t->length);
    for (int round = 0; round < 3; round++) {
        assert_int_equal(yk_graph_derivative(g, sum, t->x), t->y);
        assert_int_equal(yk_graph_derivative(g, product, t->length), yk_graph_number(g, 0));
        g->memo.newest = UINT32_MAX - 2;
        assert_int_equal(yk_graph_derivative(g, sum, t->y), t->x);
        assert_int_equal(yk_graph_derivative(g, sum, t->length), yk_graph_number(g, 1));
        g->memo.newest = UINT32_MAX - 2;
    }
}

// The argument keeps every function within its range: 0.2 to 0.8.
static void derivatives_agree_with_differences(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    const double x = 0.37, y = 0.81, h = 1e-6;
    YkRef inner = yk_graph_multiply(g, t->x, yk_graph_add(g, t->y, yk_graph_number(g, 0.5)));
    for (int f = 0; f < YK_FUNCTION_COUNT; f++) {
        bool is_binary = f == YK_ATAN2 || f == YK_MIN || f == YK_MAX;
        YkRef value_ref = yk_graph_function(g, (YkFunction)f, inner, is_binary ? yk_graph_multiply(g, t->x, t->y) : -1);
        YkRef slope = yk_graph_derivative(g, value_ref, t->x);
        double difference = (value(t, value_ref, x + h, y) - value(t, value_ref, x - h, y)) / (2 * h);
        CHECK_NEAR(value(t, slope, x, y), difference, 1e-8);
    }
    YkRefVec unit = yk_graph_unit(g, inner);
    YkRef ratio = yk_graph_divide(g, unit.y, yk_graph_add(g, unit.x, t->y));
    YkRef power = yk_graph_power(g, inner, yk_graph_add(g, t->x, t->y)),
          fixed = yk_graph_power(g, inner, yk_graph_number(g, -3));
    const YkRef all[] = {ratio, power, fixed, yk_graph_subtract(g, ratio, yk_graph_minus(g, power)),
                         yk_graph_choose(g, t->x, ratio, power)};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        YkRef slope = yk_graph_derivative(g, all[k], t->x), across = yk_graph_derivative(g, all[k], t->y);
        double by_x = (value(t, all[k], x + h, y) - value(t, all[k], x - h, y)) / (2 * h);
        double by_y = (value(t, all[k], x, y + h) - value(t, all[k], x, y - h)) / (2 * h);
        CHECK_NEAR(value(t, slope, x, y), by_x, 1e-7 * (1 + fabs(by_x)));
        CHECK_NEAR(value(t, across, x, y), by_y, 1e-7 * (1 + fabs(by_y)));
    }
}

// A sum that joins terms has the value of one that does not, and takes fewer operations.
static void terms_are_joined(void **state)
{
    Graph *t = *state;
    YkGraph *g = &t->g;
    YkRef c = yk_graph_leaf(g, YK_LEAF_POSE, "c"), s = yk_graph_leaf(g, YK_LEAF_POSE, "s");
    YkRefVec e = {c, s}, arm = yk_graph_vec_scale(g, yk_graph_number(g, 0.036), e);
    g->joins_terms = true;
    yk_graph_is_unit(g, e);
    assert_true(yk_graph_is_number(g, yk_graph_cross(g, arm, yk_graph_vec_scale(g, t->x, e)), 0));
    YkRefVec unit = yk_graph_vec_scale(g, yk_graph_inverse(g, yk_graph_vec_length(g, arm)), arm);
    assert_true(unit.x == c && unit.y == s);
    assert_true(yk_graph_dot(g, yk_graph_vec_scale(g, t->x, e), yk_graph_vec_scale(g, t->y, e)) ==
                yk_graph_multiply(g, t->x, t->y));
    // What turns with e: 3 m from the axis, with an acceleration of x along e and of y across.
    YkRefVec along = yk_graph_vec_scale(g, t->x, e), across = yk_graph_vec_scale(g, t->y, yk_graph_vec_quarter(g, e));
    YkRefVec push = yk_graph_vec_scale(g, yk_graph_number(g, 5), yk_graph_vec_add(g, along, across));
    YkRef moment = yk_graph_cross(g, yk_graph_vec_scale(g, yk_graph_number(g, 3), e), push);
    assert_true(moment == yk_graph_multiply(g, yk_graph_number(g, 15), t->y));
    // Terms that are added to one of a longer sum; what is no unit vector stays.
    YkRef sum = yk_graph_subtract(g, yk_graph_add(g, t->x, t->length), t->y);
    CHECK_NEAR(value(t, yk_graph_subtract(g, sum, t->length), 7, 2), 5, 0);
    assert_true(yk_graph_subtract(g, sum, t->length) == yk_graph_subtract(g, t->x, t->y));
    YkRefVec other = {t->x, t->y};
    CHECK_NEAR(value(t, yk_graph_dot(g, other, other), 7, 2), 53, 0);
    YkRef unequal = yk_graph_add(g, yk_graph_multiply(g, c, c),
                                 yk_graph_multiply(g, yk_graph_number(g, 2), yk_graph_multiply(g, s, s)));
    assert_true(g->values[unequal].op == YK_VALUE_ADD);
    // 10 (3 x + 2) + 5 x is one multiple of x and a number.
    YkRef line = yk_graph_add(g, yk_graph_multiply(g, yk_graph_number(g, 3), t->x), yk_graph_number(g, 2));
    YkRef steep = yk_graph_add(g, yk_graph_multiply(g, yk_graph_number(g, 10), line),
                               yk_graph_multiply(g, yk_graph_number(g, 5), t->x));
    YkRef parts[] = {g->values[steep].a, g->values[steep].b};
    CHECK_NEAR(value(t, steep, 7, 2), 265, 0);
    assert_true(yk_graph_is_number(g, parts[0], 20) || yk_graph_is_number(g, parts[1], 20));
    YkRef product = yk_graph_multiply(g, yk_graph_number(g, 10), yk_graph_add(g, t->x, t->y));
    assert_true(g->values[product].op == YK_VALUE_MULTIPLY);
    // Multiplied out, these would take one operation more.
    YkRef two = yk_graph_number(g, 2), ten = yk_graph_number(g, 10), area = yk_graph_multiply(g, t->x, t->y);
    YkRef far[] = {yk_graph_add(g, area, two), yk_graph_add(g, t->x, two), yk_graph_subtract(g, two, area)};
    for (size_t k = 0; k < 3; k++) {
        YkRef whole = yk_graph_multiply(g, ten, far[k]);
        assert_true(g->values[whole].op == YK_VALUE_MULTIPLY);
        assert_int_equal(yk_graph_cost(g, &whole, 1), yk_graph_cost(g, &far[k], 1) + 1);
    }
    // A force of 7 along a normal, from its part across: the length of the normal cancels.
    YkRef per = yk_graph_inverse(g, yk_graph_vec_length(g, other));
    YkRefVec normal = yk_graph_vec_scale(g, per, other);
    YkRef force = yk_graph_divide(g, yk_graph_number(g, 7), normal.x), aside = yk_graph_multiply(g, normal.y, force);
    assert_true(aside == yk_graph_multiply(g, t->y, yk_graph_divide(g, yk_graph_number(g, 7), t->x)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_is_constant_is_folded_and_what_is_there_is_found, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_hangs_on_parameters_alone_is_known_as_such, set_up, tear_down),
        cmocka_unit_test_setup_teardown(numbers_alone_are_folded, set_up, tear_down),
        cmocka_unit_test_setup_teardown(derivatives_stay_right_when_their_stamps_begin_anew, set_up, tear_down),
        cmocka_unit_test_setup_teardown(powers_are_powers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(operations_are_counted_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(derivatives_agree_with_differences, set_up, tear_down),
        cmocka_unit_test_setup_teardown(terms_are_joined, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
