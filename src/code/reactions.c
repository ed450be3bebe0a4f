// Reactions: Newton's and Euler's equations of every body, all reactions and efforts unknown, as dynamics/free_bodies
// has them: a pin transmits two forces, a slide a normal force and a couple, a pin-slot a normal force, a weld all
// three.
#include "code/forces.h"

typedef struct Column { // of the equations: a unit wrench on the joint's second body, its opposite on the first
    int32_t joint, input;
    YkRefVec force;
    bool is_couple;
} Column;

typedef struct Work {
    YkForces *f;
    Column *columns;
    size_t count;
    YkRef *system; // [n][n + 1]
    size_t n;
} Work;

static YkRefVec in_world(YkProgram *p, int32_t body, YkRefVec v)
{
    YkDag *g = &p->graph;
    return yk_dag_vec_multiply(g, p->unit[p->mech->bodies[body].orientation],
                               yk_dag_vec_multiply(g, p->turn_unit[body], v));
}

static YkRefVec line_of(YkProgram *p, const YkJoint *joint)
{
    YkDag *g = &p->graph;
    YkRefVec along = joint->along_expr ? yk_dag_unit(g, yk_program_expr(p, joint->along_expr))
                                       : yk_dag_vec_number(g, joint->along.x, joint->along.y);
    return in_world(p, joint->body[0], along);
}

static void add_column(Work *w, size_t joint, int32_t input, YkRefVec force, bool is_couple)
{
    w->columns[w->count++] = (Column){(int32_t)joint, input, force, is_couple};
}

static void make_columns(Work *w)
{
    YkProgram *p = w->f->program;
    YkDag *g = &p->graph;
    YkRefVec x = yk_dag_vec_number(g, 1, 0), y = yk_dag_vec_number(g, 0, 1), none = yk_dag_vec_number(g, 0, 0);
    for (size_t j = 0; j < p->model->joint_count; j++) {
        const YkJoint *joint = &p->model->joints[j];
        const YkPart *part = yk_part(joint->kind);
        if (part->slides) {
            add_column(w, j, YK_NONE, yk_dag_vec_quarter(g, line_of(p, joint)), false);
        } else {
            add_column(w, j, YK_NONE, x, false);
            add_column(w, j, YK_NONE, y, false);
        }
        if (!part->turns) add_column(w, j, YK_NONE, none, true);
    }
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        YkRefVec line = c->is_distance ? line_of(p, &p->model->joints[c->joint]) : none;
        add_column(w, (size_t)c->joint, (int32_t)i, line, !c->is_distance);
    }
}

// One wrench's part of a body's three equations; sign: +1 on the second body.
static void enter(Work *w, size_t column, int32_t body, double sign, YkRefVec point)
{
    YkProgram *p = w->f->program;
    YkDag *g = &p->graph;
    const Column *c = &w->columns[column];
    if (body == 0) return;
    YkRef factor = yk_dag_number(g, sign);
    YkRef *row = w->system + 3 * (size_t)(body - 1) * (w->n + 1) + column;
    if (c->is_couple) {
        row[2 * (w->n + 1)] = factor;
        return;
    }
    YkRefVec center = yk_program_at(p, body, yk_forces_center(p, body)), force = yk_dag_vec_scale(g, factor, c->force);
    YkRefVec arm = yk_dag_vec_subtract(g, point, center);
    row[0] = force.x;
    row[w->n + 1] = force.y;
    row[2 * (w->n + 1)] = yk_dag_divide(g, yk_dag_cross(g, arm, force), yk_dag_number(g, yk_program_size(p)));
}

// inertia - weight - loads, moments over the machine's size as in the rows.
static void enter_right(Work *w, int32_t body, const YkRates *r, const YkRates *s)
{
    YkProgram *p = w->f->program;
    YkDag *g = &p->graph;
    YkRef *row = w->system + 3 * (size_t)(body - 1) * (w->n + 1) + w->n;
    const YkWrenchRef *load = &w->f->load[body];
    YkRefVec force = yk_dag_vec_scale(g, yk_dag_number(g, -1), load->force);
    YkRef moment = yk_dag_minus(g, load->moment);
    if (p->model->bodies[body].has_mass) {
        YkRefVec a = yk_program_at_accel(p, body, yk_forces_center(p, body), r, s);
        YkRefVec pull = yk_dag_vec_subtract(g, a, w->f->gravity);
        force = yk_dag_vec_add(g, force, yk_dag_vec_scale(g, yk_forces_mass(p, body), pull));
        YkRef spin = s->turn[p->mech->bodies[body].orientation];
        moment = yk_dag_add(g, moment, yk_dag_multiply(g, yk_forces_inertia(p, body), spin));
    }
    row[0] = force.x;
    row[w->n + 1] = force.y;
    row[2 * (w->n + 1)] = yk_dag_divide(g, moment, yk_dag_number(g, yk_program_size(p)));
}

static void make_system(Work *w, const YkRates *r, const YkRates *s)
{
    YkProgram *p = w->f->program;
    YkDag *g = &p->graph;
    for (size_t k = 0; k < w->n * (w->n + 1); k++) w->system[k] = yk_dag_number(g, 0);
    for (size_t k = 0; k < w->count; k++) {
        const YkJoint *joint = &p->model->joints[w->columns[k].joint];
        YkRefVec point = yk_program_at(p, joint->body[1], yk_program_point(p, joint->point[1]));
        enter(w, k, joint->body[0], -1, point);
        enter(w, k, joint->body[1], 1, point);
    }
    for (size_t b = 1; b < p->model->body_count; b++) enter_right(w, (int32_t)b, r, s);
}

// Couples are unknown over the machine's size, as the moments' rows are.
static void read_results(Work *w, int32_t call)
{
    YkProgram *p = w->f->program;
    YkDag *g = &p->graph;
    for (size_t k = 0; k < 3 * p->model->joint_count; k++) w->f->reaction[k] = yk_dag_number(g, 0);
    for (size_t k = 0; k < w->count; k++) {
        const Column *c = &w->columns[k];
        YkRef value = yk_dag_result(g, call, k * (w->n + 1) + w->n), *out = w->f->reaction + 3 * c->joint;
        if (c->input != YK_NONE) continue;
        if (c->is_couple) {
            out[2] = yk_dag_multiply(g, value, yk_dag_number(g, yk_program_size(p)));
        } else {
            out[0] = yk_dag_add(g, out[0], yk_dag_multiply(g, value, c->force.x));
            out[1] = yk_dag_add(g, out[1], yk_dag_multiply(g, value, c->force.y));
        }
    }
    w->f->determinant = yk_dag_result(g, call, w->n * (w->n + 1));
}

void yk_forces_reactions(YkForces *f, const YkRates *r, const YkRates *s)
{
    YkProgram *p = f->program;
    Work w = {.f = f, .n = 3 * (p->model->body_count - 1)};
    w.columns = YK_NEW(p->arena, Column, 3 * p->model->joint_count + p->mech->input_count + 1);
    w.system = YK_NEW(p->arena, YkRef, w.n * (w.n + 1) + 1);
    YkRef *reaction = YK_NEW(p->arena, YkRef, 3 * p->model->joint_count + 1);
    if (yk_arena_failed(p->arena)) {
        p->failed = true;
        return;
    }
    yk_dag_section(&p->graph, "Free bodies: three equations each, their reactions and efforts unknown.");
    make_columns(&w);
    if (w.count != w.n) {
        f->why_no_reactions = "constraints repeat others, so that they are not determined";
        return;
    }
    f->reaction = reaction;
    make_system(&w, r, s);
    int32_t call = yk_dag_call(&p->graph, (YkCall){.kind = YK_CALL_SOLVE,
                                                   .n = (int32_t)w.n,
                                                   .m = 1,
                                                   .arguments = w.system,
                                                   .argument_count = w.n * (w.n + 1),
                                                   .result_count = w.n * (w.n + 1) + 1,
                                                   .name = "bodies"});
    read_results(&w, call);
}
