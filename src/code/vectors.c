// Plane vectors of values.
#include "code/dag.h"

YkRefVec yk_dag_vec_number(YkDag *g, double x, double y)
{
    YkRefVec v = {.x = yk_dag_number(g, x)};
    v.y = yk_dag_number(g, y);
    return v;
}

YkRefVec yk_dag_vec_add(YkDag *g, YkRefVec a, YkRefVec b)
{
    YkRefVec v = {.x = yk_dag_add(g, a.x, b.x)};
    v.y = yk_dag_add(g, a.y, b.y);
    return v;
}

YkRefVec yk_dag_vec_subtract(YkDag *g, YkRefVec a, YkRefVec b)
{
    YkRefVec v = {.x = yk_dag_subtract(g, a.x, b.x)};
    v.y = yk_dag_subtract(g, a.y, b.y);
    return v;
}

YkRefVec yk_dag_vec_scale(YkDag *g, YkRef k, YkRefVec a)
{
    YkRefVec v = {.x = yk_dag_multiply(g, k, a.x)};
    v.y = yk_dag_multiply(g, k, a.y);
    return v;
}

YkRefVec yk_dag_vec_multiply(YkDag *g, YkRefVec a, YkRefVec b)
{
    YkRef xx = yk_dag_multiply(g, a.x, b.x), yy = yk_dag_multiply(g, a.y, b.y), x = yk_dag_subtract(g, xx, yy);
    YkRef xy = yk_dag_multiply(g, a.x, b.y), yx = yk_dag_multiply(g, a.y, b.x), y = yk_dag_add(g, xy, yx);
    return (YkRefVec){x, y};
}

YkRefVec yk_dag_vec_conjugate(YkDag *g, YkRefVec a)
{
    return (YkRefVec){a.x, yk_dag_minus(g, a.y)};
}

YkRefVec yk_dag_vec_quarter(YkDag *g, YkRefVec a)
{
    return (YkRefVec){yk_dag_minus(g, a.y), a.x};
}

YkRef yk_dag_dot(YkDag *g, YkRefVec a, YkRefVec b)
{
    YkRef xx = yk_dag_multiply(g, a.x, b.x), yy = yk_dag_multiply(g, a.y, b.y);
    return yk_dag_add(g, xx, yy);
}

YkRef yk_dag_cross(YkDag *g, YkRefVec a, YkRefVec b)
{
    YkRef xy = yk_dag_multiply(g, a.x, b.y), yx = yk_dag_multiply(g, a.y, b.x);
    return yk_dag_subtract(g, xy, yx);
}

bool yk_dag_is_zero_vec(const YkDag *g, YkRefVec v)
{
    return yk_dag_is_number(g, v.x, 0) && yk_dag_is_number(g, v.y, 0);
}
