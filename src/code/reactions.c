// Reactions: Newton's and Euler's equations of every body, with all reactions and efforts unknown, as in free_bodies/:
// a pin transmits two forces, a slide a normal force and a couple, a pin-slot a normal force, a weld all three.
#include "code/balance.h"

static void add_column(YkBalanceSystem *w, size_t joint, int32_t input, YkRefVec force, bool is_couple)
{
    w->columns[w->count++] = (YkUnknown){(int32_t)joint, input, YK_NONE, force, is_couple, 0};
}

static void make_columns(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec x = yk_graph_vec_number(g, 1, 0), y = yk_graph_vec_number(g, 0, 1), none = yk_graph_vec_number(g, 0, 0);
    for (size_t j = 0; j < p->model->joint_count; j++) {
        const YkJoint *joint = &p->model->joints[j];
        const YkPart *part = yk_part(joint->kind);
        if (part->slides) {
            add_column(w, j, YK_NONE, yk_graph_vec_quarter(g, yk_forces_line(p, joint)), false);
        } else {
            add_column(w, j, YK_NONE, x, false);
            add_column(w, j, YK_NONE, y, false);
        }
        if (!part->turns) add_column(w, j, YK_NONE, none, true);
    }
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        YkRefVec line = c->is_distance ? yk_forces_line(p, &p->model->joints[c->joint]) : none;
        add_column(w, (size_t)c->joint, (int32_t)i, line, !c->is_distance);
    }
}

void yk_balance_add(YkBalanceSystem *w, size_t column, int32_t body, YkRefVec force, YkRef moment)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    size_t stride = w->n + w->sides;
    if (body == 0) return;
    YkRef *row = w->system + 3 * (size_t)(body - 1) * stride + column;
    const YkRef parts[] = {force.x, force.y, yk_graph_divide(g, moment, yk_graph_number(g, yk_program_size(p)))};
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

// Enters a joint's wrench on one of its bodies; a couple is taken over the machine's size.
static void enter(YkBalanceSystem *w, size_t column, int32_t body, double sign, YkRefVec point)
{
    YkProgram *p = w->f->program;
    const YkUnknown *c = &w->columns[column];
    YkRefVec none = yk_graph_vec_number(&p->graph, 0, 0);
    if (c->is_couple)
        yk_balance_add(w, column, body, none, yk_graph_number(&p->graph, sign * yk_program_size(p)));
    else
        yk_balance_push(w, column, body, sign, point, c->force);
}

// Enters inertia - weight - loads, with moments over the machine's size as in the rows.
static void enter_right(YkBalanceSystem *w, int32_t body, const YkRates *r, const YkRates *s)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkWrenchRef *load = &w->f->load[body];
    YkRefVec force = yk_graph_vec_scale(g, yk_graph_number(g, -1), load->force);
    YkRef moment = yk_graph_minus(g, load->moment);
    if (p->model->bodies[body].has_mass) {
        YkRefVec a = yk_program_at_accel(p, body, yk_forces_center(p, body), r, s);
        YkRefVec pull = yk_graph_vec_subtract(g, a, w->f->gravity);
        force = yk_graph_vec_add(g, force, yk_graph_vec_scale(g, yk_forces_mass(p, body), pull));
        YkRef spin = s->turn[p->mech->bodies[body].orientation];
        moment = yk_graph_add(g, moment, yk_graph_multiply(g, yk_forces_inertia(p, body), spin));
    }
    yk_balance_add(w, w->n, body, force, moment);
}

static void make_system(YkBalanceSystem *w, const YkRates *r, const YkRates *s)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRef zero = yk_graph_number(g, 0);
    for (size_t k = 0; k < w->n * (w->n + w->sides); k++) w->system[k] = zero;
    for (size_t k = 0; k < w->count; k++) {
        if (w->columns[k].relation != YK_NONE) {
            yk_meshes_enter(w, k);
            continue;
        }
        const YkJoint *joint = &p->model->joints[w->columns[k].joint];
        YkRefVec point = yk_program_at(p, joint->body[1], yk_program_point(p, joint->point[1]));
        enter(w, k, joint->body[0], -1, point);
        enter(w, k, joint->body[1], 1, point);
    }
    for (size_t b = 1; b < p->model->body_count; b++) enter_right(w, (int32_t)b, r, s);
}

// Returns an unknown: that of the balance, less what the radial forces of the teeth add to the loads.
static YkRef value_of(YkBalanceSystem *w, int32_t call, size_t k)
{
    YkGraph *g = &w->f->program->graph;
    size_t stride = w->n + w->sides;
    YkRef value = yk_graph_result(g, call, k * stride + w->n);
    for (size_t c = 0; c < w->count; c++) {
        size_t side = w->columns[c].radial;
        if (side == 0) continue;
        YkRef size = yk_graph_unary(g, YK_VALUE_SIZE, yk_graph_result(g, call, c * stride + w->n));
        YkRef part = yk_graph_multiply(g, size, yk_graph_result(g, call, k * stride + w->n + side));
        value = yk_graph_subtract(g, value, part);
    }
    return value;
}

// Couples are unknown over the machine's size, as the rows of moments are.
static void read_results(YkBalanceSystem *w, int32_t call)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    for (size_t k = 0; k < 3 * p->model->joint_count; k++) w->f->reaction[k] = yk_graph_number(g, 0);
    for (size_t k = 0; k < w->count; k++) {
        const YkUnknown *c = &w->columns[k];
        if (c->input != YK_NONE || c->relation != YK_NONE) continue;
        YkRef value = value_of(w, call, k), *out = w->f->reaction + 3 * c->joint;
        if (c->is_couple) {
            out[2] = yk_graph_multiply(g, value, yk_graph_number(g, yk_program_size(p)));
        } else {
            out[0] = yk_graph_add(g, out[0], yk_graph_multiply(g, value, c->force.x));
            out[1] = yk_graph_add(g, out[1], yk_graph_multiply(g, value, c->force.y));
        }
    }
    w->f->determinant = yk_graph_result(g, call, w->n * (w->n + w->sides));
}

void yk_forces_reactions(YkForces *f, const YkRates *r, const YkRates *s)
{
    YkProgram *p = f->program;
    YkBalanceSystem w = {.f = f, .n = 3 * (p->model->body_count - 1), .sides = 1};
    size_t most = 3 * p->model->joint_count + p->mech->input_count + p->mech->relation_count;
    w.columns = YK_NEW(p->arena, YkUnknown, most + 1);
    if (yk_arena_failed(p->arena)) {
        p->failed = true;
        return;
    }
    yk_graph_section(&p->graph, "Free bodies: three equations each, their reactions and efforts unknown.");
    make_columns(&w);
    yk_meshes_columns(&w);
    if (w.count != w.n) {
        f->why_no_reactions = "constraints repeat others, so that they are not determined";
        return;
    }
    size_t entries = w.n * (w.n + w.sides);
    w.system = YK_NEW(p->arena, YkRef, entries + 1);
    YkRef *reaction = YK_NEW(p->arena, YkRef, 3 * p->model->joint_count + 1);
    if (yk_arena_failed(p->arena)) {
        p->failed = true;
        return;
    }
    f->reaction = reaction;
    make_system(&w, r, s);
    int32_t call = yk_graph_call(&p->graph, (YkCall){.kind = YK_CALL_SOLVE,
                                                     .n = (int32_t)w.n,
                                                     .m = (int32_t)w.sides,
                                                     .arguments = w.system,
                                                     .argument_count = entries,
                                                     .result_count = entries + 1,
                                                     .name = "bodies"});
    read_results(&w, call);
}
