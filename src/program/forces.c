// Computes the forces of a pose: everything that acts on the machine, in order.
#include "program/forces.h"
#include "base/problems.h"

bool yk_forces_start(YkForces *f, YkProgram *p)
{
    *f = (YkForces){.program = p};
    size_t n = p->mech->input_count;
    f->motion = YK_NEW(p->arena, YkMotionRef, p->mech->coordinate_count + 1);
    f->column = YK_NEW(p->arena, YkRates, n + 1);
    f->load = YK_NEW(p->arena, YkWrenchRef, p->model->body_count);
    f->given = YK_NEW(p->arena, YkRef, p->model->effort_count + 1);
    f->mass = YK_NEW(p->arena, YkRef, n * n + 1);
    f->rest = YK_NEW(p->arena, YkRef, n + 1);
    f->effort = YK_NEW(p->arena, YkRef, n + 1);
    f->acceleration = YK_NEW(p->arena, YkRef, n + 1);
    f->dry = YK_NEW(p->arena, YkDryJoint, p->model->joint_count + 1);
    f->is_free = YK_NEW(p->arena, bool, n + 1);
    return !yk_arena_failed(p->arena);
}

static YkRef combine(YkProgram *p, YkRef sum, YkRef column, YkRef rate)
{
    return yk_graph_add(&p->graph, sum, yk_graph_multiply(&p->graph, column, rate));
}

// Makes the columns, and the pose's velocities as their sum.
static void make_columns(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count;
    YkRef *rate = YK_NEW(p->arena, YkRef, n + 1);
    if (!rate) {
        p->failed = true;
        return;
    }
    f->velocities = yk_program_new_rates(p);
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) rate[k] = yk_graph_number(g, k == i ? 1 : 0);
        f->column[i] = yk_program_velocities(p, rate);
    }
    yk_graph_section(g, "Velocities, from the Jacobian and the inputs' rates.");
    for (size_t i = 0; i < n && !p->failed; i++) {
        YkRef w = p->input[i].velocity;
        YkRates *v = &f->velocities, *c = &f->column[i];
        for (size_t k = 0; k < p->mech->slot_count; k++) v->turn[k] = combine(p, v->turn[k], c->turn[k], w);
        for (size_t k = 0; k < p->mech->distance_count; k++) v->slide[k] = combine(p, v->slide[k], c->slide[k], w);
        for (size_t k = 0; k < p->mech->node_count; k++)
            v->node[k] = yk_graph_vec_add(g, v->node[k], yk_graph_vec_scale(g, w, c->node[k]));
    }
}

// Makes the rates of the laws' arguments at the pose's velocities, for the second derivatives.
static void make_bias(YkForces *f)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count;
    YkRef *rate = YK_NEW(p->arena, YkRef, n + 1);
    if (!rate) {
        p->failed = true;
        return;
    }
    for (size_t r = 0; r < p->mech->relation_count + p->mech->derived_count; r++)
        if (p->mech->relations[r].law) p->argument_rate[r] = yk_program_argument_rate(p, r, &f->velocities);
    for (size_t k = 0; k < n; k++) rate[k] = yk_graph_number(&p->graph, 0);
    f->bias = yk_program_accelerations(p, &f->velocities, rate);
}

static void make_motion(YkForces *f)
{
    YkProgram *p = f->program;
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        int32_t input = p->mech->coordinates[k].input;
        f->motion[k].position = yk_program_coordinate(p, k);
        f->motion[k].velocity =
            input == YK_NONE ? yk_program_coordinate_rate(p, k, &f->velocities) : p->input[input].velocity;
    }
}

static void make_kinetic(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count;
    f->kinetic = yk_graph_number(g, 0);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j <= i; j++) {
            YkRef rates = yk_graph_multiply(g, p->input[i].velocity, p->input[j].velocity);
            YkRef half = yk_graph_number(g, i == j ? 0.5 : 1);
            f->kinetic = yk_graph_add(g, f->kinetic,
                                      yk_graph_multiply(g, half, yk_graph_multiply(g, f->mass[i * n + j], rates)));
        }
}

static void make_efforts(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count;
    yk_graph_section(g, "Efforts.");
    for (size_t i = 0; i < n; i++) {
        f->effort[i] = f->rest[i];
        for (size_t j = 0; j < n; j++)
            f->effort[i] = combine(p, f->effort[i], f->mass[i * n + j], p->input[j].acceleration);
    }
}

bool yk_forces_build(YkForces *f, YkProgram *p)
{
    if (p->mech->input_count > YK_FORCES_INPUTS_MAX) {
        yk_problem(p->problems, YK_CODE_NOT_PRINTABLE, (YkPlace){0},
                   "the machine has %z freedoms; forces are printed for at most %d", p->mech->input_count,
                   (int)YK_FORCES_INPUTS_MAX);
        yk_problem_hint(p->problems, "`--kinematics` prints the motion alone");
        p->failed = true;
        return false;
    }
    if (!yk_forces_start(f, p)) return false;
    make_columns(f);
    if (p->failed) return false;
    make_motion(f);
    if (!yk_forces_loads(f)) return false;
    make_bias(f);
    if (!yk_forces_equations(f)) return false;
    make_kinetic(f);
    make_efforts(f);
    yk_forces_accelerations(f);
    return !p->failed;
}
