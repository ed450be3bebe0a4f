// Plane vectors of values.
#include "code/dag.h"

YkRefVec yk_dag_vec_number(YkDag *g, double x, double y)
{
    return (YkRefVec){yk_dag_number(g, x), yk_dag_number(g, y)};
}

YkRefVec yk_dag_vec_add(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_add(g, a.x, b.x), yk_dag_add(g, a.y, b.y)};
}

YkRefVec yk_dag_vec_subtract(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_subtract(g, a.x, b.x), yk_dag_subtract(g, a.y, b.y)};
}

YkRefVec yk_dag_vec_scale(YkDag *g, YkRef k, YkRefVec a)
{
    return (YkRefVec){yk_dag_multiply(g, k, a.x), yk_dag_multiply(g, k, a.y)};
}

YkRefVec yk_dag_vec_multiply(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_subtract(g, yk_dag_multiply(g, a.x, b.x), yk_dag_multiply(g, a.y, b.y)),
                      yk_dag_add(g, yk_dag_multiply(g, a.x, b.y), yk_dag_multiply(g, a.y, b.x))};
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
    return yk_dag_add(g, yk_dag_multiply(g, a.x, b.x), yk_dag_multiply(g, a.y, b.y));
}

YkRef yk_dag_cross(YkDag *g, YkRefVec a, YkRefVec b)
{
    return yk_dag_subtract(g, yk_dag_multiply(g, a.x, b.y), yk_dag_multiply(g, a.y, b.x));
}

bool yk_dag_is_zero_vec(const YkDag *g, YkRefVec v)
{
    return yk_dag_is_number(g, v.x, 0) && yk_dag_is_number(g, v.y, 0);
}
