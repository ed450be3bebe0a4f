// The equations of motion in the inputs, M q'' + rest = efforts: body by body, or by lumped constants if that takes
// fewer operations.
#include "program/forces.h"

// Adds all loads except weight.
static void add_loads(YkForces *f, YkEquations *out)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    for (size_t b = 1; b < p->model->body_count; b++) {
        const YkWrenchRef *load = &f->load[b];
        bool has_force = !yk_graph_is_zero_vec(g, load->force);
        if (!has_force && yk_graph_is_number(g, load->moment, 0)) continue;
        YkRefVec at = yk_forces_center(p, (int32_t)b);
        for (size_t i = 0; i < p->mech->input_count; i++) {
            YkRef part = yk_graph_multiply(g, load->moment, f->column[i].turn[p->mech->bodies[b].orientation]);
            YkRefVec v = yk_program_at_rate(p, (int32_t)b, at, &f->column[i]);
            if (has_force) part = yk_graph_add(g, yk_graph_dot(g, load->force, v), part);
            out->rest[i] = yk_graph_subtract(g, out->rest[i], part);
        }
    }
}

// Adds a body's part of M and, with its weight, of the rest.
static void add_body(YkForces *f, int32_t body, YkEquations *out)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count;
    YkRefVec at = yk_forces_center(p, body);
    int32_t o = p->mech->bodies[body].orientation;
    YkRef m = yk_forces_mass(p, body), inertia = yk_forces_inertia(p, body);
    YkRefVec bias = yk_program_at_accel(p, body, at, &f->velocities, &f->bias);
    YkRefVec force = yk_graph_vec_scale(g, m, yk_graph_vec_subtract(g, bias, f->gravity));
    YkRef moment = yk_graph_multiply(g, inertia, f->bias.turn[o]);
    for (size_t i = 0; i < n; i++) {
        YkRefVec v = yk_program_at_rate(p, body, at, &f->column[i]);
        YkRef w = f->column[i].turn[o];
        YkRef pushed = yk_graph_dot(g, force, v), part = yk_graph_add(g, pushed, yk_graph_multiply(g, moment, w));
        out->rest[i] = yk_graph_add(g, out->rest[i], part);
        for (size_t j = 0; j <= i; j++) {
            YkRefVec u = yk_program_at_rate(p, body, at, &f->column[j]);
            YkRef linear = yk_graph_multiply(g, m, yk_graph_dot(g, v, u));
            YkRef angular = yk_graph_multiply(g, inertia, yk_graph_multiply(g, w, f->column[j].turn[o]));
            out->mass[i * n + j] = yk_graph_add(g, out->mass[i * n + j], yk_graph_add(g, linear, angular));
        }
    }
}

static bool start(YkForces *f, YkEquations *e)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count;
    e->mass = YK_NEW(p->arena, YkRef, n * n + 1);
    e->rest = YK_NEW(p->arena, YkRef, n + 1);
    if (yk_arena_failed(p->arena)) return false;
    for (size_t k = 0; k < n * n; k++) e->mass[k] = yk_graph_number(&p->graph, 0);
    for (size_t k = 0; k < n; k++) e->rest[k] = yk_graph_number(&p->graph, 0);
    return true;
}

static size_t cost_of(const YkForces *f, const YkEquations *e)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count, count = 0;
    YkRef *roots = YK_NEW(p->arena, YkRef, n * (n + 1) + 1);
    if (!roots) return 0;
    for (size_t i = 0; i < n; i++) {
        roots[count++] = e->rest[i];
        for (size_t j = 0; j <= i; j++) roots[count++] = e->mass[i * n + j];
    }
    return yk_graph_cost(&p->graph, roots, count);
}

// Names the values, and fills the other half of M.
static void keep(YkForces *f, const YkEquations *e)
{
    YkGraph *g = &f->program->graph;
    size_t n = f->program->mech->input_count;
    for (size_t i = 0; i < n; i++) {
        f->rest[i] = yk_graph_name(g, e->rest[i], "rest%d", (int)i + 1);
        for (size_t j = 0; j <= i; j++) {
            yk_graph_name(g, e->mass[i * n + j], "M%d%s%d", (int)i + 1, n > 9 ? "_" : "", (int)j + 1);
            f->mass[i * n + j] = f->mass[j * n + i] = e->mass[i * n + j];
        }
    }
}

bool yk_forces_equations(YkForces *f)
{
    YkProgram *p = f->program;
    YkEquations bodies, lumped;
    if (!start(f, &bodies) || !start(f, &lumped)) return false;
    yk_graph_section(&p->graph, "Equations of motion: M q'' + rest = efforts, from the masses lumped on each arm.");
    bool is_lumped = yk_forces_lumped(f, &lumped);
    if (is_lumped) add_loads(f, &lumped);
    yk_graph_section(&p->graph, "Equations of motion: M q'' + rest = efforts, body by body.");
    for (size_t b = 1; b < p->model->body_count; b++)
        if (p->model->bodies[b].has_mass) add_body(f, (int32_t)b, &bodies);
    add_loads(f, &bodies);
    is_lumped = is_lumped && cost_of(f, &lumped) <= cost_of(f, &bodies);
    keep(f, is_lumped ? &lumped : &bodies);
    return !p->failed;
}
