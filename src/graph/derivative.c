// Exact derivatives of values by a leaf.
#include "graph/graph.h"
#include <stdlib.h>
#include <string.h>

typedef struct Work {
    YkGraph *g;
    YkRef leaf;
    uint32_t stamp;
} Work;

// --- memory

static bool fit_stamps(uint32_t **stamps, size_t from, size_t to)
{
    uint32_t *grown = realloc(*stamps, to * sizeof *grown);
    if (!grown) return false;
    memset(grown + from, 0, (to - from) * sizeof *grown);
    *stamps = grown;
    return true;
}

// Makes room for all present values. Stamps begin anew when they would run out.
static bool fit(YkGraph *g)
{
    YkGraphMemo *memo = &g->memo;
    if (memo->newest >= UINT32_MAX - 2) {
        memset(memo->slope_stamp, 0, memo->capacity * sizeof *memo->slope_stamp);
        memset(memo->reach_stamp, 0, memo->capacity * sizeof *memo->reach_stamp);
        memo->newest = memo->reached_stamp = 0;
    }
    if (g->count <= memo->capacity) return true;
    size_t wanted = 2 * g->count;
    YkRef *slope = realloc(memo->slope, wanted * sizeof *slope);
    if (slope) memo->slope = slope;
    if (!slope || !fit_stamps(&memo->slope_stamp, memo->capacity, wanted) ||
        !fit_stamps(&memo->reach_stamp, memo->capacity, wanted))
        return false;
    memo->capacity = wanted;
    return true;
}

// Stamps all values that a value is made of.
static void reach(YkGraph *g, YkRef value)
{
    YkGraphMemo *memo = &g->memo;
    if (value < 0 || memo->reach_stamp[value] == memo->reached_stamp) return;
    const YkValue *v = &g->values[value];
    memo->reach_stamp[value] = memo->reached_stamp;
    if (v->op == YK_VALUE_LEAF || v->op == YK_VALUE_NUMBER) return;
    if (v->op == YK_VALUE_RESULT) {
        const YkCall *call = &g->calls[v->a];
        for (size_t k = 0; k < call->argument_count; k++) reach(g, call->arguments[k]);
        return;
    }
    reach(g, v->a);
    reach(g, v->b);
    reach(g, v->c);
}

static bool is_made_of(YkGraph *g, YkRef value, YkRef leaf)
{
    YkGraphMemo *memo = &g->memo;
    if (memo->reached_stamp == 0 || memo->reached != value) {
        memo->reached = value;
        memo->reached_stamp = ++memo->newest;
        reach(g, value);
    }
    return memo->reach_stamp[leaf] == memo->reached_stamp;
}

// --- rules

static YkRef derive(Work *w, YkRef value);

static YkRef of_function(Work *w, YkValue v)
{
    YkGraph *g = w->g;
    YkRef a = v.a, da = derive(w, a), one = yk_graph_number(g, 1), self = yk_graph_function(g, v.function, v.a, v.b);
    YkRef square = yk_graph_multiply(g, a, a);
    switch (v.function) {
    case YK_SIN:
        return yk_graph_multiply(g, da, yk_graph_function(g, YK_COS, a, YK_NONE));
    case YK_COS:
        return yk_graph_minus(g, yk_graph_multiply(g, da, yk_graph_function(g, YK_SIN, a, YK_NONE)));
    case YK_TAN:
        return yk_graph_multiply(g, da, yk_graph_add(g, one, yk_graph_multiply(g, self, self)));
    case YK_ASIN:
        return yk_graph_divide(g, da, yk_graph_function(g, YK_SQRT, yk_graph_subtract(g, one, square), YK_NONE));
    case YK_ACOS:
        return yk_graph_minus(
            g, yk_graph_divide(g, da, yk_graph_function(g, YK_SQRT, yk_graph_subtract(g, one, square), YK_NONE)));
    case YK_ATAN:
        return yk_graph_divide(g, da, yk_graph_add(g, one, square));
    case YK_ATAN2: { // of y = a, x = b
        YkRef db = derive(w, v.b), length = yk_graph_add(g, square, yk_graph_multiply(g, v.b, v.b));
        YkRef b_da = yk_graph_multiply(g, v.b, da), a_db = yk_graph_multiply(g, a, db),
              top = yk_graph_subtract(g, b_da, a_db);
        return yk_graph_divide(g, top, length);
    }
    case YK_SINH:
        return yk_graph_multiply(g, da, yk_graph_function(g, YK_COSH, a, YK_NONE));
    case YK_COSH:
        return yk_graph_multiply(g, da, yk_graph_function(g, YK_SINH, a, YK_NONE));
    case YK_TANH:
        return yk_graph_multiply(g, da, yk_graph_subtract(g, one, yk_graph_multiply(g, self, self)));
    case YK_SQRT:
        return yk_graph_divide(g, da, yk_graph_multiply(g, yk_graph_number(g, 2), self));
    case YK_EXP:
        return yk_graph_multiply(g, da, self);
    case YK_LOG:
        return yk_graph_divide(g, da, a);
    case YK_LOG10:
        return yk_graph_divide(g, yk_graph_multiply(g, yk_graph_number(g, 0.43429448190325182765), da), a);
    case YK_ABS:
        return yk_graph_choose(g, a, yk_graph_minus(g, da), da);
    case YK_MIN:
    case YK_MAX: {
        YkRef apart = yk_graph_subtract(g, a, v.b), db = derive(w, v.b);
        return v.function == YK_MIN ? yk_graph_choose(g, apart, da, db) : yk_graph_choose(g, apart, db, da);
    }
    default: // sign
        return yk_graph_number(g, 0);
    }
}

// a^b = exp(b log a)
static YkRef of_power(Work *w, YkValue v)
{
    YkGraph *g = w->g;
    YkRef da = derive(w, v.a), db = derive(w, v.b), less = yk_graph_subtract(g, v.b, yk_graph_number(g, 1));
    YkRef by_base = yk_graph_multiply(g, yk_graph_multiply(g, v.b, yk_graph_power(g, v.a, less)), da);
    if (yk_graph_is_number(g, db, 0)) return by_base;
    YkRef log = yk_graph_function(g, YK_LOG, v.a, YK_NONE), self = yk_graph_power(g, v.a, v.b);
    return yk_graph_add(g, by_base, yk_graph_multiply(g, self, yk_graph_multiply(g, log, db)));
}

static YkRef find(Work *w, YkRef value)
{
    YkGraph *g = w->g;
    YkValue v = g->values[value];
    switch (v.op) {
    case YK_VALUE_LEAF:
        return yk_graph_number(g, value == w->leaf ? 1 : 0);
    case YK_VALUE_ADD: {
        YkRef da = derive(w, v.a);
        return yk_graph_add(g, da, derive(w, v.b));
    }
    case YK_VALUE_SUBTRACT: {
        YkRef da = derive(w, v.a);
        return yk_graph_subtract(g, da, derive(w, v.b));
    }
    case YK_VALUE_MULTIPLY: {
        YkRef da_b = yk_graph_multiply(g, derive(w, v.a), v.b), a_db = yk_graph_multiply(g, v.a, derive(w, v.b));
        return yk_graph_add(g, da_b, a_db);
    }
    case YK_VALUE_DIVIDE: {
        YkRef slope = yk_graph_multiply(g, value, derive(w, v.b));
        return yk_graph_divide(g, yk_graph_subtract(g, derive(w, v.a), slope), v.b);
    }
    case YK_VALUE_MINUS:
        return yk_graph_minus(g, derive(w, v.a));
    case YK_VALUE_FUNCTION:
        return of_function(w, v);
    case YK_VALUE_POWER:
        return of_power(w, v);
    case YK_VALUE_SINE: {
        YkRef da = derive(w, v.a);
        return yk_graph_multiply(g, da, yk_graph_unit(g, v.a).x);
    }
    case YK_VALUE_COSINE: {
        YkRef da = derive(w, v.a);
        return yk_graph_minus(g, yk_graph_multiply(g, da, yk_graph_unit(g, v.a).y));
    }
    case YK_VALUE_CHOOSE: {
        YkRef db = derive(w, v.b);
        return yk_graph_choose(g, v.a, db, derive(w, v.c));
    }
    case YK_VALUE_NONZERO:
    case YK_VALUE_SIZE: {
        YkRef da = derive(w, v.a);
        return yk_graph_choose(g, v.a, yk_graph_minus(g, da), da);
    }
    case YK_VALUE_RESULT: { // of a law: the next derivative
        const YkCall *call = &g->calls[v.a];
        if (call->kind != YK_CALL_LAW || v.b > 1) return yk_graph_number(g, 0);
        YkRef argument = call->arguments[0], slope = yk_graph_result(g, v.a, (size_t)v.b + 1);
        return yk_graph_multiply(g, slope, derive(w, argument));
    }
    case YK_VALUE_ROOT:
        return yk_graph_divide(g, derive(w, v.a), yk_graph_multiply(g, yk_graph_number(g, 2), value));
    case YK_VALUE_PER_ROOT: {
        YkRef half = yk_graph_multiply(g, yk_graph_number(g, -0.5), derive(w, v.a));
        return yk_graph_multiply(g, half, yk_graph_multiply(g, value, yk_graph_multiply(g, value, value)));
    }
    case YK_VALUE_NEAREST: // but for whole turns
        return derive(w, v.a);
    default: // numbers, and values that are never differentiated
        return yk_graph_number(g, 0);
    }
}

static YkRef derive(Work *w, YkRef value)
{
    if (value < w->leaf) return yk_graph_number(w->g, 0); // an older value cannot depend on it
    YkGraphMemo *memo = &w->g->memo;
    if (memo->slope_stamp[value] == w->stamp) return memo->slope[value];
    YkRef found = find(w, value);
    memo->slope_stamp[value] = w->stamp;
    memo->slope[value] = found;
    return found;
}

YkRef yk_graph_derivative(YkGraph *g, YkRef value, YkRef leaf)
{
    if (!fit(g)) {
        g->failed = true;
        return value;
    }
    if (!is_made_of(g, value, leaf)) return yk_graph_number(g, 0);
    Work w = {g, leaf, ++g->memo.newest};
    return derive(&w, value);
}

// The same with the wanted operand as the leaf: its derivative, and those of the other operands, are noted beforehand.
YkRef yk_graph_partial(YkGraph *g, YkRef value, YkRef operand)
{
    if (!fit(g)) {
        g->failed = true;
        return value;
    }
    const YkValue v = g->values[value];
    Work w = {g, operand, ++g->memo.newest};
    const YkRef operands[] = {v.a, v.b, v.c}, zero = yk_graph_number(g, 0), one = yk_graph_number(g, 1);
    for (size_t k = 0; k < 3 && v.op != YK_VALUE_RESULT; k++) {
        if (operands[k] < 0) continue;
        g->memo.slope_stamp[operands[k]] = w.stamp;
        g->memo.slope[operands[k]] = zero;
    }
    g->memo.slope_stamp[operand] = w.stamp;
    g->memo.slope[operand] = one;
    return find(&w, value);
}
