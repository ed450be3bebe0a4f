// The right sides of dry friction in the balance of all bodies.
#include "program/balance.h"

void yk_dry_enter(YkBalanceSystem *w)
{
    YkForces *f = w->f;
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    YkWrenchRef *load = YK_NEW(p->arena, YkWrenchRef, p->model->body_count);
    if (!load) {
        p->failed = true;
        return;
    }
    for (size_t k = 0; k < w->dry_count; k++) {
        const YkDryJoint *dry = &f->dry[k];
        size_t column = w->n + w->first_dry + k;
        yk_forces_unit_effort(f, dry->joint, dry->slides, load);
        for (size_t b = 1; b < p->model->body_count; b++) {
            YkRefVec force = yk_graph_vec_scale(g, yk_graph_number(g, -1), load[b].force);
            YkRef moment = yk_graph_minus(g, load[b].moment);
            for (size_t i = 0; dry->response && i < p->mech->input_count && p->model->bodies[b].has_mass; i++) {
                if (!f->is_free[i]) continue;
                YkRefVec v = yk_program_at_rate(p, (int32_t)b, yk_forces_center(p, (int32_t)b), &f->column[i]);
                YkRef push = yk_graph_multiply(g, yk_forces_mass(p, (int32_t)b), dry->response[i]);
                YkRef spin = f->column[i].turn[p->mech->bodies[b].orientation];
                YkRef turn = yk_graph_multiply(g, yk_forces_inertia(p, (int32_t)b), dry->response[i]);
                force = yk_graph_vec_add(g, force, yk_graph_vec_scale(g, push, v));
                moment = yk_graph_add(g, moment, yk_graph_multiply(g, turn, spin));
            }
            yk_balance_add(w, column, (int32_t)b, force, moment);
        }
    }
}
