// Operations of the graph, each folded where its operands allow it.
#include <math.h>
#include "base/vec.h"
#include "code/dag.h"
#include "elementary/elementary.h"
#include "expr/formula.h"

enum { NOTHING = -1 };

static YkRef operation(YkDag *g, YkValueKind op, YkRef a, YkRef b, YkRef c)
{
    return yk_dag_intern(g, (YkValue){.op = op, .a = a, .b = b, .c = c});
}

static const YkValue *at(const YkDag *g, YkRef value)
{
    return &g->values[value];
}

bool yk_dag_is_number(const YkDag *g, YkRef value, double number)
{
    return at(g, value)->op == YK_VALUE_NUMBER && at(g, value)->number == number;
}

static bool is_number(const YkDag *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_NUMBER;
}

static bool is_minus(const YkDag *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_MINUS;
}

static void order(YkRef *a, YkRef *b)
{
    if (*a <= *b) return;
    YkRef other = *a;
    *a = *b;
    *b = other;
}

YkRef yk_dag_minus(YkDag *g, YkRef a)
{
    if (is_number(g, a)) return yk_dag_number(g, -at(g, a)->number);
    if (is_minus(g, a)) return at(g, a)->a;
    if (at(g, a)->op == YK_VALUE_SUBTRACT) return yk_dag_subtract(g, at(g, a)->b, at(g, a)->a);
    return operation(g, YK_VALUE_MINUS, a, NOTHING, NOTHING);
}

YkRef yk_dag_add(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, a, 0)) return b;
    if (yk_dag_is_number(g, b, 0)) return a;
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number + at(g, b)->number);
    if (is_minus(g, b)) return yk_dag_subtract(g, a, at(g, b)->a);
    if (is_minus(g, a)) return yk_dag_subtract(g, b, at(g, a)->a);
    order(&a, &b);
    return operation(g, YK_VALUE_ADD, a, b, NOTHING);
}

YkRef yk_dag_subtract(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, b, 0)) return a;
    if (a == b) return yk_dag_number(g, 0);
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number - at(g, b)->number);
    if (yk_dag_is_number(g, a, 0)) return yk_dag_minus(g, b);
    if (is_minus(g, b)) return yk_dag_add(g, a, at(g, b)->a);
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_add(g, at(g, a)->a, b));
    return operation(g, YK_VALUE_SUBTRACT, a, b, NOTHING);
}

YkRef yk_dag_multiply(YkDag *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number * at(g, b)->number);
    if (is_number(g, b)) {
        YkRef other = a;
        a = b;
        b = other;
    }
    if (yk_dag_is_number(g, a, 0)) return a;
    if (yk_dag_is_number(g, a, 1)) return b;
    if (yk_dag_is_number(g, a, -1)) return yk_dag_minus(g, b);
    if (is_number(g, a) && at(g, a)->number < 0)
        return yk_dag_minus(g, yk_dag_multiply(g, yk_dag_number(g, -at(g, a)->number), b));
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_multiply(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_dag_minus(g, yk_dag_multiply(g, a, at(g, b)->a));
    order(&a, &b);
    return operation(g, YK_VALUE_MULTIPLY, a, b, NOTHING);
}

YkRef yk_dag_divide(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, b, 1)) return a;
    if (yk_dag_is_number(g, b, -1)) return yk_dag_minus(g, a);
    if (is_number(g, a) && is_number(g, b) && at(g, b)->number != 0)
        return yk_dag_number(g, at(g, a)->number / at(g, b)->number);
    if (yk_dag_is_number(g, a, 0) && !is_number(g, b)) return a;
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_divide(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_dag_minus(g, yk_dag_divide(g, a, at(g, b)->a));
    return operation(g, YK_VALUE_DIVIDE, a, b, NOTHING);
}

YkRef yk_dag_inverse(YkDag *g, YkRef a)
{
    return yk_dag_divide(g, yk_dag_number(g, 1), a);
}

// Whole powers up to this are products.
enum { POWER_MAX = 8 };

YkRef yk_dag_power(YkDag *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, yk_pow(at(g, a)->number, at(g, b)->number));
    if (is_number(g, b)) {
        double exponent = at(g, b)->number;
        if (exponent == 0.5) return yk_dag_function(g, YK_SQRT, a, NOTHING);
        if (exponent == rint(exponent) && fabs(exponent) <= POWER_MAX) {
            YkRef product = yk_dag_number(g, 1);
            for (int k = 0; k < (int)fabs(exponent); k++) product = yk_dag_multiply(g, product, a);
            return exponent < 0 ? yk_dag_inverse(g, product) : product;
        }
    }
    return operation(g, YK_VALUE_POWER, a, b, NOTHING);
}

YkRef yk_dag_function(YkDag *g, YkFunction function, YkRef a, YkRef b)
{
    bool has_second = b != NOTHING;
    if (is_number(g, a) && (!has_second || is_number(g, b)))
        return yk_dag_number(g, yk_function_value(function, at(g, a)->number, has_second ? at(g, b)->number : 0));
    if (function == YK_SQRT && at(g, a)->op == YK_VALUE_MULTIPLY && at(g, a)->a == at(g, a)->b)
        return yk_dag_unary(g, YK_VALUE_SIZE, at(g, a)->a);
    return yk_dag_intern(g, (YkValue){.op = YK_VALUE_FUNCTION, .a = a, .b = b, .c = NOTHING, .function = function});
}

YkRef yk_dag_unary(YkDag *g, YkValueKind op, YkRef a)
{
    if (is_number(g, a)) {
        double x = at(g, a)->number;
        if (op == YK_VALUE_ROOT) return yk_dag_number(g, sqrt(x > 0 ? x : 0));
        if (op == YK_VALUE_PER_ROOT) return yk_dag_number(g, 1 / sqrt(x > 1e-36 ? x : 1e-36));
        if (op == YK_VALUE_NONZERO) return yk_dag_number(g, fabs(x) + 1e-200);
        if (op == YK_VALUE_SIZE) return yk_dag_number(g, fabs(x));
        if (op == YK_VALUE_WITNESS) return yk_dag_number(g, 0);
    }
    if (op == YK_VALUE_SIZE && (is_minus(g, a) || at(g, a)->op == YK_VALUE_SIZE)) a = at(g, a)->a;
    return operation(g, op, a, NOTHING, NOTHING);
}

YkRef yk_dag_binary(YkDag *g, YkValueKind op, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) {
        double x = at(g, a)->number, y = at(g, b)->number;
        if (op == YK_VALUE_LEAST) return yk_dag_number(g, x < y ? x : y);
        if (op == YK_VALUE_LARGEST) return yk_dag_number(g, x > y ? x : y);
        if (op == YK_VALUE_ANGLE) return yk_dag_number(g, yk_atan2(x, y));
    }
    return operation(g, op, a, b, NOTHING);
}

YkRef yk_dag_choose(YkDag *g, YkRef sign, YkRef negative, YkRef otherwise)
{
    if (is_number(g, sign)) return at(g, sign)->number < 0 ? negative : otherwise;
    return negative == otherwise ? negative : operation(g, YK_VALUE_CHOOSE, sign, negative, otherwise);
}

YkRefVec yk_dag_unit(YkDag *g, YkRef angle)
{
    if (is_number(g, angle)) {
        YkVec e = yk_unit(at(g, angle)->number);
        return yk_dag_vec_number(g, e.x, e.y);
    }
    if (is_minus(g, angle)) return yk_dag_vec_conjugate(g, yk_dag_unit(g, at(g, angle)->a));
    YkRef sine = operation(g, YK_VALUE_SINE, angle, NOTHING, NOTHING);
    return (YkRefVec){operation(g, YK_VALUE_COSINE, angle, sine, NOTHING), sine};
}
