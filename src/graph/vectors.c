// Plane vectors of values.
#include "elementary/elementary.h"
#include "graph/graph.h"

YkRefVec yk_graph_vec_number(YkGraph *g, double x, double y)
{
    YkRefVec v = {.x = yk_graph_number(g, x)};
    v.y = yk_graph_number(g, y);
    return v;
}

YkRefVec yk_graph_vec_add(YkGraph *g, YkRefVec a, YkRefVec b)
{
    YkRefVec v = {.x = yk_graph_add(g, a.x, b.x)};
    v.y = yk_graph_add(g, a.y, b.y);
    return v;
}

YkRefVec yk_graph_vec_subtract(YkGraph *g, YkRefVec a, YkRefVec b)
{
    YkRefVec v = {.x = yk_graph_subtract(g, a.x, b.x)};
    v.y = yk_graph_subtract(g, a.y, b.y);
    return v;
}

YkRefVec yk_graph_vec_scale(YkGraph *g, YkRef k, YkRefVec a)
{
    YkRefVec v = {.x = yk_graph_multiply(g, k, a.x)};
    v.y = yk_graph_multiply(g, k, a.y);
    return v;
}

YkRefVec yk_graph_vec_multiply(YkGraph *g, YkRefVec a, YkRefVec b)
{
    YkRef xx = yk_graph_multiply(g, a.x, b.x), yy = yk_graph_multiply(g, a.y, b.y), x = yk_graph_subtract(g, xx, yy);
    YkRef xy = yk_graph_multiply(g, a.x, b.y), yx = yk_graph_multiply(g, a.y, b.x), y = yk_graph_add(g, xy, yx);
    return (YkRefVec){x, y};
}

YkRefVec yk_graph_vec_conjugate(YkGraph *g, YkRefVec a)
{
    return (YkRefVec){a.x, yk_graph_minus(g, a.y)};
}

YkRefVec yk_graph_vec_quarter(YkGraph *g, YkRefVec a)
{
    return (YkRefVec){yk_graph_minus(g, a.y), a.x};
}

YkRef yk_graph_dot(YkGraph *g, YkRefVec a, YkRefVec b)
{
    YkRef xx = yk_graph_multiply(g, a.x, b.x), yy = yk_graph_multiply(g, a.y, b.y);
    return yk_graph_add(g, xx, yy);
}

YkRef yk_graph_cross(YkGraph *g, YkRefVec a, YkRefVec b)
{
    YkRef xy = yk_graph_multiply(g, a.x, b.y), yx = yk_graph_multiply(g, a.y, b.x);
    return yk_graph_subtract(g, xy, yx);
}

void yk_graph_is_unit(YkGraph *g, YkRefVec v)
{
    if (g->values[v.x].op == YK_VALUE_NUMBER || g->values[v.y].op == YK_VALUE_NUMBER) return;
    g->values[v.x].sine = v.y;
    g->values[v.y].sine = v.x;
}

bool yk_graph_is_zero_vec(const YkGraph *g, YkRefVec v)
{
    return yk_graph_is_number(g, v.x, 0) && yk_graph_is_number(g, v.y, 0);
}

YkRef yk_graph_vec_length(YkGraph *g, YkRefVec a)
{
    return yk_graph_function(g, YK_SQRT, yk_graph_dot(g, a, a), YK_NONE);
}

YkRefVec yk_graph_unit(YkGraph *g, YkRef angle)
{
    const YkValue *value = &g->values[angle];
    if (value->op == YK_VALUE_NUMBER) {
        double x = value->number;
        return yk_graph_vec_number(g, yk_cos(x), yk_sin(x));
    }
    if (value->op == YK_VALUE_MINUS) return yk_graph_vec_conjugate(g, yk_graph_unit(g, value->a));
    YkRef sine = yk_graph_intern(g, (YkValue){.op = YK_VALUE_SINE, .a = angle, .b = YK_NONE, .c = YK_NONE});
    YkValue cosine = {.op = YK_VALUE_COSINE, .a = angle, .b = sine, .c = YK_NONE};
    YkRefVec e = {yk_graph_intern(g, cosine), sine};
    yk_graph_is_unit(g, e);
    return e;
}
