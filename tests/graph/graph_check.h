// The values of a graph in numbers: the tests' way, beside the printed C.
#ifndef TESTS_GRAPH_CHECK_H
#define TESTS_GRAPH_CHECK_H
#include "check.h"
#include <stdlib.h>
#include "graph/graph.h"

static inline double graph_function(YkFunction function, double a, double b)
{
    const double of[] = {
        [YK_SIN] = sin(a),     [YK_COS] = cos(a),        [YK_TAN] = tan(a),   [YK_ASIN] = asin(a),
        [YK_ACOS] = acos(a),   [YK_ATAN] = atan(a),      [YK_SINH] = sinh(a), [YK_COSH] = cosh(a),
        [YK_TANH] = tanh(a),   [YK_SQRT] = sqrt(a),      [YK_EXP] = exp(a),   [YK_LOG] = log(a),
        [YK_LOG10] = log10(a), [YK_ATAN2] = atan2(a, b), [YK_ABS] = fabs(a),  [YK_SIGN] = (a > 0) - (a < 0),
        [YK_MIN] = fmin(a, b), [YK_MAX] = fmax(a, b)};
    return of[function];
}

// NaN of witnesses and results of calls.
static inline double graph_operate(const YkValue *v, double a, double b, double c)
{
    switch (v->op) {
    case YK_VALUE_NUMBER:
        return v->number;
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
    case YK_VALUE_NONZERO:
        return fabs(a) + 1e-200;
    case YK_VALUE_SIZE:
        return fabs(a);
    case YK_VALUE_CHOOSE:
        return a < 0 ? b : c;
    case YK_VALUE_ROOT:
        return sqrt(fmax(a, 0));
    case YK_VALUE_PER_ROOT:
        return 1 / sqrt(fmax(a, 1e-36));
    case YK_VALUE_LEAST:
        return fmin(a, b);
    case YK_VALUE_LARGEST:
        return fmax(a, b);
    case YK_VALUE_ANGLE:
        return atan2(a, b);
    case YK_VALUE_NEAREST:
        return a + 2 * 3.141592653589793 * rint((b - a) / (2 * 3.141592653589793));
    case YK_VALUE_FUNCTION:
        return graph_function(v->function, a, b);
    default:
        return (double)NAN;
    }
}

// numbers[count] of all values; those of leaves are given in it.
static inline void graph_evaluate(const YkGraph *graph, double *numbers)
{
    for (size_t k = 0; k < graph->count; k++) {
        const YkValue *v = &graph->values[k];
        if (v->op == YK_VALUE_LEAF) continue;
        double a = v->a >= 0 ? numbers[v->a] : 0, b = v->b >= 0 ? numbers[v->b] : 0;
        numbers[k] = graph_operate(v, a, b, v->c >= 0 ? numbers[v->c] : 0);
    }
}
#endif
