// Enters wrenches into the equations of the bodies.
#include "program/balance.h"

void yk_balance_add(YkBalanceSystem *w, size_t column, int32_t body, YkRefVec force, YkRef moment)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    size_t stride = w->n + w->sides;
    if (body == 0) return;
    YkRef *row = w->system + 3 * (size_t)(body - 1) * stride + column;
    const YkRef parts[] = {force.x, force.y, yk_graph_divide(g, moment, yk_graph_number(g, w->unit))};
    for (size_t k = 0; k < 3; k++) row[k * stride] = yk_graph_add(g, row[k * stride], parts[k]);
}

void yk_balance_push(YkBalanceSystem *w, size_t column, int32_t body, double sign, YkRefVec place, YkRefVec force)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec center = yk_program_at(p, body, yk_forces_center(p, body)), arm = yk_graph_vec_subtract(g, place, center);
    force = yk_graph_vec_scale(g, yk_graph_number(g, sign), force);
    yk_balance_add(w, column, body, force, yk_graph_cross(g, arm, force));
}

void yk_balance_couples(YkBalanceSystem *w, size_t column, const int32_t *bodies, const YkRef *couples)
{
    YkRefVec none = yk_graph_vec_number(&w->f->program->graph, 0, 0);
    w->columns[column].moment = couples[1];
    for (int k = 0; k < 3; k++) yk_balance_add(w, column, bodies[k], none, couples[k]);
}

YkRefVec *yk_balance_force_of(YkBalanceSystem *w, size_t column)
{
    return column < w->n ? &w->columns[column].force : &w->radial[column - w->n];
}

// Adds a force on the second body at a place of the world, and its opposite on the first.
void yk_balance_force(YkBalanceSystem *w, size_t column, const int32_t *bodies, YkRefVec place, YkRefVec force)
{
    *yk_balance_force_of(w, column) = force;
    yk_balance_push(w, column, bodies[0], -1, place, force);
    yk_balance_push(w, column, bodies[1], 1, place, force);
}
