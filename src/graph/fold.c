// Operations of the graph, each folded where its operands allow it.
#include <math.h>
#include "elementary/elementary.h"
#include "graph/graph.h"

static YkRef operation(YkGraph *g, YkValueKind op, YkRef a, YkRef b, YkRef c)
{
    return yk_graph_intern(g, (YkValue){.op = op, .a = a, .b = b, .c = c});
}

static const YkValue *at(const YkGraph *g, YkRef value)
{
    return &g->values[value];
}

bool yk_graph_is_number(const YkGraph *g, YkRef value, double number)
{
    return at(g, value)->op == YK_VALUE_NUMBER && at(g, value)->number == number;
}

static bool is_number(const YkGraph *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_NUMBER;
}

static bool is_minus(const YkGraph *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_MINUS;
}

// Returns whether sums take its opposite.
static bool is_negative(const YkGraph *g, YkRef value)
{
    return is_minus(g, value) || (g->shares_signs && is_number(g, value) && at(g, value)->number < 0);
}

static void order(YkRef *a, YkRef *b)
{
    if (*a <= *b) return;
    YkRef other = *a;
    *a = *b;
    *b = other;
}

YkRef yk_graph_minus(YkGraph *g, YkRef a)
{
    if (is_number(g, a)) return yk_graph_number(g, -at(g, a)->number);
    if (is_minus(g, a)) return at(g, a)->a;
    if (at(g, a)->op == YK_VALUE_SUBTRACT) return yk_graph_subtract(g, at(g, a)->b, at(g, a)->a);
    return operation(g, YK_VALUE_MINUS, a, YK_NONE, YK_NONE);
}

YkRef yk_graph_add(YkGraph *g, YkRef a, YkRef b)
{
    if (yk_graph_is_number(g, a, 0)) return b;
    if (yk_graph_is_number(g, b, 0)) return a;
    if (is_number(g, a) && is_number(g, b)) return yk_graph_number(g, at(g, a)->number + at(g, b)->number);
    if (is_negative(g, b)) return yk_graph_subtract(g, a, yk_graph_minus(g, b));
    if (is_negative(g, a)) return yk_graph_subtract(g, b, yk_graph_minus(g, a));
    YkRef joined = yk_graph_join(g, a, b, 1);
    if (joined != YK_NONE) return joined;
    order(&a, &b);
    return operation(g, YK_VALUE_ADD, a, b, YK_NONE);
}

YkRef yk_graph_subtract(YkGraph *g, YkRef a, YkRef b)
{
    if (yk_graph_is_number(g, b, 0)) return a;
    if (a == b) return yk_graph_number(g, 0);
    if (is_number(g, a) && is_number(g, b)) return yk_graph_number(g, at(g, a)->number - at(g, b)->number);
    if (yk_graph_is_number(g, a, 0)) return yk_graph_minus(g, b);
    if (is_negative(g, b)) return yk_graph_add(g, a, yk_graph_minus(g, b));
    if (is_negative(g, a)) return yk_graph_minus(g, yk_graph_add(g, yk_graph_minus(g, a), b));
    YkRef joined = yk_graph_join(g, a, b, -1);
    if (joined != YK_NONE) return joined;
    if (g->shares_signs) {
        YkRef opposite = yk_graph_find(g, (YkValue){.op = YK_VALUE_SUBTRACT, .a = b, .b = a, .c = YK_NONE});
        if (opposite != YK_NONE) return operation(g, YK_VALUE_MINUS, opposite, YK_NONE, YK_NONE);
    }
    return operation(g, YK_VALUE_SUBTRACT, a, b, YK_NONE);
}

YkRef yk_graph_multiply(YkGraph *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_graph_number(g, at(g, a)->number * at(g, b)->number);
    if (is_number(g, b)) {
        YkRef other = a;
        a = b;
        b = other;
    }
    if (yk_graph_is_number(g, a, 0)) return a;
    if (yk_graph_is_number(g, a, 1)) return b;
    if (yk_graph_is_number(g, a, -1)) return yk_graph_minus(g, b);
    if (is_number(g, a) && at(g, a)->number < 0)
        return yk_graph_minus(g, yk_graph_multiply(g, yk_graph_number(g, -at(g, a)->number), b));
    if (is_minus(g, a)) return yk_graph_minus(g, yk_graph_multiply(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_graph_minus(g, yk_graph_multiply(g, a, at(g, b)->a));
    YkRef joined = is_number(g, a) ? yk_graph_join_numbers(g, a, b) : yk_graph_cancel(g, a, b);
    if (joined == YK_NONE) joined = yk_graph_cancel(g, b, a);
    if (joined != YK_NONE) return joined;
    order(&a, &b);
    return operation(g, YK_VALUE_MULTIPLY, a, b, YK_NONE);
}

YkRef yk_graph_divide(YkGraph *g, YkRef a, YkRef b)
{
    if (yk_graph_is_number(g, b, 1)) return a;
    if (yk_graph_is_number(g, b, -1)) return yk_graph_minus(g, a);
    if (is_number(g, a) && is_number(g, b) && at(g, b)->number != 0)
        return yk_graph_number(g, at(g, a)->number / at(g, b)->number);
    if (yk_graph_is_number(g, a, 0) && !is_number(g, b)) return a;
    if (is_minus(g, a)) return yk_graph_minus(g, yk_graph_divide(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_graph_minus(g, yk_graph_divide(g, a, at(g, b)->a));
    return operation(g, YK_VALUE_DIVIDE, a, b, YK_NONE);
}

YkRef yk_graph_inverse(YkGraph *g, YkRef a)
{
    return yk_graph_divide(g, yk_graph_number(g, 1), a);
}

// Whole powers up to this are products.
enum { POWER_MAX = 8 };

YkRef yk_graph_power(YkGraph *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_graph_number(g, yk_pow(at(g, a)->number, at(g, b)->number));
    if (is_number(g, b)) {
        double exponent = at(g, b)->number;
        if (exponent == 0.5) return yk_graph_function(g, YK_SQRT, a, YK_NONE);
        if (exponent == rint(exponent) && fabs(exponent) <= POWER_MAX) {
            YkRef product = yk_graph_number(g, 1);
            for (int k = 0; k < (int)fabs(exponent); k++) product = yk_graph_multiply(g, product, a);
            return exponent < 0 ? yk_graph_inverse(g, product) : product;
        }
    }
    return operation(g, YK_VALUE_POWER, a, b, YK_NONE);
}

YkRef yk_graph_function(YkGraph *g, YkFunction function, YkRef a, YkRef b)
{
    bool has_second = b != YK_NONE;
    if (is_number(g, a) && (!has_second || is_number(g, b)))
        return yk_graph_number(g, yk_function_value(function, at(g, a)->number, has_second ? at(g, b)->number : 0));
    if (function == YK_SQRT && at(g, a)->op == YK_VALUE_MULTIPLY && at(g, a)->a == at(g, a)->b)
        return yk_graph_unary(g, YK_VALUE_SIZE, at(g, a)->a);
    return yk_graph_intern(g, (YkValue){.op = YK_VALUE_FUNCTION, .a = a, .b = b, .c = YK_NONE, .function = function});
}

YkRef yk_graph_unary(YkGraph *g, YkValueKind op, YkRef a)
{
    if (is_number(g, a)) {
        double x = at(g, a)->number;
        if (op == YK_VALUE_ROOT) return yk_graph_number(g, sqrt(x > 0 ? x : 0));
        if (op == YK_VALUE_PER_ROOT) return yk_graph_number(g, 1 / sqrt(x > 1e-36 ? x : 1e-36));
        if (op == YK_VALUE_NONZERO) return yk_graph_number(g, fabs(x) + 1e-200);
        if (op == YK_VALUE_SIZE) return yk_graph_number(g, fabs(x));
        if (op == YK_VALUE_WITNESS) return yk_graph_number(g, 0);
    }
    if (op == YK_VALUE_SIZE && (is_minus(g, a) || at(g, a)->op == YK_VALUE_SIZE)) a = at(g, a)->a;
    return operation(g, op, a, YK_NONE, YK_NONE);
}

YkRef yk_graph_binary(YkGraph *g, YkValueKind op, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) {
        double x = at(g, a)->number, y = at(g, b)->number;
        if (op == YK_VALUE_LEAST) return yk_graph_number(g, x < y ? x : y);
        if (op == YK_VALUE_LARGEST) return yk_graph_number(g, x > y ? x : y);
        if (op == YK_VALUE_ANGLE) return yk_graph_number(g, yk_atan2(x, y));
    }
    return operation(g, op, a, b, YK_NONE);
}

YkRef yk_graph_choose(YkGraph *g, YkRef sign, YkRef negative, YkRef otherwise)
{
    if (is_number(g, sign)) return at(g, sign)->number < 0 ? negative : otherwise;
    return negative == otherwise ? negative : operation(g, YK_VALUE_CHOOSE, sign, negative, otherwise);
}
