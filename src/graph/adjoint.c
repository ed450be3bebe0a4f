// Derivatives of one value by all leaves, from the value backwards through its operands (reverse accumulation).
#include <stdlib.h>
#include "graph/graph.h"

typedef struct Backwards {
    YkGraph *g;
    YkRef *share; // [value]: the derivative of the answer by it, or YK_NONE
    YkRef *first; // [call]: the lowest of its results
    bool fails;
} Backwards;

static void take(Backwards *w, YkRef value, YkRef share)
{
    YkRef *own = &w->share[value];
    *own = *own == YK_NONE ? share : yk_graph_add(w->g, *own, share);
}

static bool is_differentiated(const YkGraph *g, const YkValue *v)
{
    switch (v->op) {
    case YK_VALUE_ANGLE:
    case YK_VALUE_LEAST:
    case YK_VALUE_LARGEST:
        return false;
    case YK_VALUE_RESULT:
        return g->calls[v->a].kind == YK_CALL_SOLVE || (g->calls[v->a].kind == YK_CALL_LAW && v->b < 2);
    default:
        return true;
    }
}

static void hand_on(Backwards *w, YkRef value, YkRef operand)
{
    YkRef slope = yk_graph_partial(w->g, value, operand);
    if (!yk_graph_is_number(w->g, slope, 0)) take(w, operand, yk_graph_multiply(w->g, w->share[value], slope));
}

static void operands_of(Backwards *w, YkRef value)
{
    const YkValue v = w->g->values[value];
    if (v.a >= 0) hand_on(w, value, v.a);
    if (v.b >= 0 && v.b != v.a) hand_on(w, value, v.b);
    if (v.c >= 0 && v.c != v.a && v.c != v.b) hand_on(w, value, v.c);
}

// A X = B: with the shares S of X, A^T L = S; those of B are L, those of A are -L X^T.
static void solution(Backwards *w, int32_t index)
{
    YkGraph *g = w->g;
    const YkCall call = g->calls[index];
    size_t n = (size_t)call.n, m = (size_t)call.m, stride = n + m;
    YkRef *system = YK_NEW(g->arena, YkRef, n * stride + 1), zero = yk_graph_number(g, 0);
    if (!system) {
        w->fails = true;
        return;
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) system[i * stride + k] = call.arguments[k * stride + i];
        for (size_t side = n; side < stride; side++) {
            YkRef result = yk_graph_find(
                g, (YkValue){.op = YK_VALUE_RESULT, .a = index, .b = (YkRef)(i * stride + side), .c = YK_NONE});
            bool has_share = result >= 0 && w->share[result] != YK_NONE;
            system[i * stride + side] = has_share ? w->share[result] : zero;
        }
    }
    int32_t back = yk_graph_call(g, (YkCall){.kind = YK_CALL_SOLVE,
                                             .n = call.n,
                                             .m = call.m,
                                             .arguments = system,
                                             .argument_count = n * stride,
                                             .result_count = n * stride + 1,
                                             .name = "shares"});
    for (size_t side = n; side < stride; side++)
        for (size_t i = 0; i < n; i++) {
            YkRef share = yk_graph_result(g, back, i * stride + side);
            take(w, call.arguments[i * stride + side], share);
            for (size_t k = 0; k < n; k++) {
                YkRef x = yk_graph_result(g, index, k * stride + side);
                take(w, call.arguments[i * stride + k], yk_graph_minus(g, yk_graph_multiply(g, share, x)));
            }
        }
}

static void go_back(Backwards *w, YkRef value)
{
    YkGraph *g = w->g;
    const YkValue v = g->values[value];
    bool is_result = v.op == YK_VALUE_RESULT, is_solved = is_result && g->calls[v.a].kind == YK_CALL_SOLVE;
    if (is_solved && w->first[v.a] == value) solution(w, v.a);
    if (is_solved || w->share[value] == YK_NONE || v.op == YK_VALUE_LEAF || v.op == YK_VALUE_NUMBER) return;
    if (!is_differentiated(g, &v))
        w->fails = true;
    else if (is_result)
        hand_on(w, value, g->calls[v.a].arguments[0]);
    else if (v.op != YK_VALUE_WITNESS)
        operands_of(w, value);
}

bool yk_graph_adjoint(YkGraph *g, YkRef value, const YkRef *leaves, size_t count, YkRef *by_leaf)
{
    size_t values = (size_t)value + 1, calls = g->call_count;
    Backwards w = {.g = g, .share = calloc(values, sizeof *w.share), .first = calloc(calls + 1, sizeof *w.first)};
    bool good = w.share && w.first;
    YkRef zero = yk_graph_number(g, 0), one = yk_graph_number(g, 1);
    for (size_t k = 0; good && k < values; k++) w.share[k] = YK_NONE;
    for (size_t k = values; good && k-- > 0;)
        if (g->values[k].op == YK_VALUE_RESULT) w.first[g->values[k].a] = (YkRef)k;
    if (good) w.share[value] = one;
    for (size_t k = values; good && k-- > 0 && !g->failed && !w.fails;) go_back(&w, (YkRef)k);
    for (size_t k = 0; good && k < count; k++) {
        bool has_share = leaves[k] < (YkRef)values && w.share[leaves[k]] != YK_NONE;
        by_leaf[k] = has_share ? w.share[leaves[k]] : zero;
    }
    free(w.share);
    free(w.first);
    return good && !w.fails && !g->failed;
}
