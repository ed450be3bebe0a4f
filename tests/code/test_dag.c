// The graph folds what is constant, finds values again, and its derivatives agree with differences.
#include "check.h"
#include "code/dag.h"

typedef struct Graph {
    YkDag g;
    YkArena *arena;
    YkRef x, y, length;
} Graph;

static int set_up(void **state)
{
    static Graph t;
    t.arena = yk_arena_new();
    assert_true(t.arena && yk_dag_start(&t.g, t.arena));
    t.x = yk_dag_leaf(&t.g, YK_LEAF_POSE, "x");
    t.y = yk_dag_leaf(&t.g, YK_LEAF_POSE, "y");
    t.length = yk_dag_leaf(&t.g, YK_LEAF_PARAMETER, "l");
    *state = &t;
    return 0;
}

static int tear_down(void **state)
{
    Graph *t = *state;
    yk_dag_end(&t->g);
    yk_arena_free(t->arena);
    return 0;
}

// The value at x, y and l = 3.
static double value(const Graph *t, YkRef ref, double x, double y)
{
    const YkValue *v = &t->g.values[ref];
    double a = v->op != YK_VALUE_LEAF && v->a >= 0 ? value(t, v->a, x, y) : 0;
    double b = v->op != YK_VALUE_LEAF && v->b >= 0 ? value(t, v->b, x, y) : 0;
    double c = v->op != YK_VALUE_LEAF && v->c >= 0 ? value(t, v->c, x, y) : 0;
    switch (v->op) {
    case YK_VALUE_NUMBER:
        return v->number;
    case YK_VALUE_LEAF:
        return ref == t->x ? x : ref == t->y ? y : 3;
    case YK_VALUE_ADD:
        return a + b;
    case YK_VALUE_SUBTRACT:
        return a - b;
    case YK_VALUE_MULTIPLY:
        return a * b;
    case YK_VALUE_DIVIDE:
        return a / b;
    case YK_VALUE_MINUS:
        return -a;
    case YK_VALUE_POWER:
        return pow(a, b);
    case YK_VALUE_SINE:
        return sin(a);
    case YK_VALUE_COSINE:
        return cos(a);
    case YK_VALUE_SIZE:
        return fabs(a);
    case YK_VALUE_CHOOSE:
        return a < 0 ? b : c;
    case YK_VALUE_FUNCTION: {
        const double of[] = {[YK_SIN] = sin(a),        [YK_COS] = cos(a),    [YK_TAN] = tan(a),
                             [YK_ASIN] = asin(a),      [YK_ACOS] = acos(a),  [YK_ATAN] = atan(a),
                             [YK_SINH] = sinh(a),      [YK_COSH] = cosh(a),  [YK_TANH] = tanh(a),
                             [YK_SQRT] = sqrt(a),      [YK_EXP] = exp(a),    [YK_LOG] = log(a),
                             [YK_ATAN2] = atan2(a, b), [YK_ABS] = fabs(a),   [YK_SIGN] = (a > 0) - (a < 0),
                             [YK_MIN] = fmin(a, b),    [YK_MAX] = fmax(a, b)};
        return of[v->function];
    }
    default:
        fail_msg("an operation that no derivative has");
        return 0;
    }
}

static void what_is_constant_is_folded_and_what_is_there_is_found(void **state)
{
    Graph *t = *state;
    YkDag *g = &t->g;
    YkRef zero = yk_dag_number(g, 0), one = yk_dag_number(g, 1), two = yk_dag_number(g, 2);
    assert_int_equal(yk_dag_add(g, t->x, zero), t->x);
    assert_int_equal(yk_dag_multiply(g, one, t->x), t->x);
    assert_int_equal(yk_dag_multiply(g, t->x, zero), zero);
    assert_int_equal(yk_dag_subtract(g, t->x, t->x), zero);
    assert_int_equal(yk_dag_add(g, one, one), two);
    assert_int_equal(yk_dag_minus(g, yk_dag_minus(g, t->x)), t->x);
    assert_int_equal(yk_dag_add(g, t->x, t->y), yk_dag_add(g, t->y, t->x));
    assert_int_equal(yk_dag_subtract(g, t->x, yk_dag_minus(g, t->y)), yk_dag_add(g, t->x, t->y));
    assert_int_equal(yk_dag_leaf(g, YK_LEAF_POSE, "x"), t->x);
    YkRef square = yk_dag_multiply(g, t->x, t->x);
    assert_int_equal(g->values[yk_dag_function(g, YK_SQRT, square, -1)].op, YK_VALUE_SIZE);
    assert_true(yk_dag_is_number(g, yk_dag_unit(g, zero).x, 1));
}

static void what_hangs_on_parameters_alone_is_known_as_such(void **state)
{
    Graph *t = *state;
    YkDag *g = &t->g;
    YkRef own = yk_dag_multiply(g, t->length, t->length), mixed = yk_dag_multiply(g, t->length, t->x);
    assert_true(g->values[own].of_parameters);
    assert_true(g->values[t->length].of_parameters);
    assert_false(g->values[mixed].of_parameters);
}

// The argument keeps every function within its range: 0.2 to 0.8.
static void derivatives_agree_with_differences(void **state)
{
    Graph *t = *state;
    YkDag *g = &t->g;
    const double x = 0.37, y = 0.81, h = 1e-6;
    YkRef inner = yk_dag_multiply(g, t->x, yk_dag_add(g, t->y, yk_dag_number(g, 0.5)));
    for (int f = 0; f < YK_FUNCTION_COUNT; f++) {
        bool is_binary = f == YK_ATAN2 || f == YK_MIN || f == YK_MAX;
        YkRef value_ref = yk_dag_function(g, (YkFunction)f, inner, is_binary ? yk_dag_multiply(g, t->x, t->y) : -1);
        YkRef slope = yk_dag_derivative(g, value_ref, t->x);
        double difference = (value(t, value_ref, x + h, y) - value(t, value_ref, x - h, y)) / (2 * h);
        CHECK_NEAR(value(t, slope, x, y), difference, 1e-8);
    }
    YkRefVec unit = yk_dag_unit(g, inner);
    YkRef ratio = yk_dag_divide(g, unit.y, yk_dag_add(g, unit.x, t->y));
    YkRef power = yk_dag_power(g, inner, yk_dag_add(g, t->x, t->y)),
          fixed = yk_dag_power(g, inner, yk_dag_number(g, -3));
    const YkRef all[] = {ratio, power, fixed, yk_dag_subtract(g, ratio, yk_dag_minus(g, power)),
                         yk_dag_choose(g, t->x, ratio, power)};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        YkRef slope = yk_dag_derivative(g, all[k], t->x), across = yk_dag_derivative(g, all[k], t->y);
        double by_x = (value(t, all[k], x + h, y) - value(t, all[k], x - h, y)) / (2 * h);
        double by_y = (value(t, all[k], x, y + h) - value(t, all[k], x, y - h)) / (2 * h);
        CHECK_NEAR(value(t, slope, x, y), by_x, 1e-7 * (1 + fabs(by_x)));
        CHECK_NEAR(value(t, across, x, y), by_y, 1e-7 * (1 + fabs(by_y)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_is_constant_is_folded_and_what_is_there_is_found, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_hangs_on_parameters_alone_is_known_as_such, set_up, tear_down),
        cmocka_unit_test_setup_teardown(derivatives_agree_with_differences, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
