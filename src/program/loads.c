// Loads: the action of gravity, efforts, forces, springs, dampers and viscous friction on the bodies.
#include "program/forces.h"

YkRefVec yk_forces_center(YkProgram *p, int32_t body)
{
    YkGraph *g = &p->graph;
    const YkBody *b = &p->model->bodies[body];
    if (!b->has_mass) return yk_graph_vec_number(g, 0, 0);
    if (b->rod[0] != YK_NONE && b->rod[1] != YK_NONE) {
        YkRefVec first = yk_program_point(p, b->rod[0]),
                 sum = yk_graph_vec_add(g, first, yk_program_point(p, b->rod[1]));
        return yk_graph_vec_scale(g, yk_graph_number(g, 0.5), sum);
    }
    YkRef x = b->center_x ? yk_program_expr(p, b->center_x) : yk_graph_number(g, b->center.x);
    YkRef y = b->center_y ? yk_program_expr(p, b->center_y) : yk_graph_number(g, b->center.y);
    return (YkRefVec){x, y};
}

YkRef yk_forces_mass(YkProgram *p, int32_t body)
{
    const YkBody *b = &p->model->bodies[body];
    return b->mass_expr ? yk_program_expr(p, b->mass_expr) : yk_graph_number(&p->graph, b->mass);
}

YkRef yk_forces_inertia(YkProgram *p, int32_t body)
{
    YkGraph *g = &p->graph;
    const YkBody *b = &p->model->bodies[body];
    if (b->inertia_expr) return yk_program_expr(p, b->inertia_expr);
    if (b->rod[0] == YK_NONE || b->rod[1] == YK_NONE) return yk_graph_number(g, b->inertia);
    YkRefVec end = yk_program_point(p, b->rod[1]), rod = yk_graph_vec_subtract(g, end, yk_program_point(p, b->rod[0]));
    YkRef mass = yk_forces_mass(p, body), twelfth = yk_graph_divide(g, mass, yk_graph_number(g, 12));
    return yk_graph_multiply(g, twelfth, yk_graph_dot(g, rod, rod));
}

bool yk_model_has_forces(const YkModel *m)
{
    bool has = m->effort_count + m->force_count + m->spring_count > 0;
    for (size_t b = 0; b < m->body_count; b++) has = has || m->bodies[b].has_mass;
    for (size_t j = 0; j < m->joint_count; j++) has = has || m->joints[j].has_friction;
    return has;
}

YkRefVec yk_forces_arm(YkProgram *p, int32_t body, YkRefVec at)
{
    YkGraph *g = &p->graph;
    YkRefVec v = yk_graph_vec_subtract(g, at, yk_forces_center(p, body));
    v = yk_graph_vec_multiply(g, p->turn_unit[body], v);
    return yk_graph_vec_multiply(g, p->unit[p->mech->bodies[body].orientation], v);
}

static void push(YkForces *f, int32_t body, YkRefVec arm, YkRefVec force)
{
    YkGraph *g = &f->program->graph;
    YkWrenchRef *load = &f->load[body];
    load->force = yk_graph_vec_add(g, load->force, force);
    load->moment = yk_graph_add(g, load->moment, yk_graph_cross(g, arm, force));
}

static YkRefVec in_world(YkProgram *p, int32_t body, YkRefVec v)
{
    YkGraph *g = &p->graph;
    return yk_graph_vec_multiply(g, p->unit[p->mech->bodies[body].orientation],
                                 yk_graph_vec_multiply(g, p->turn_unit[body], v));
}

YkRefVec yk_forces_line(YkProgram *p, const YkJoint *joint)
{
    YkGraph *g = &p->graph;
    YkRefVec along = joint->along_expr ? yk_graph_unit(g, yk_program_expr(p, joint->along_expr))
                                       : yk_graph_vec_number(g, joint->along.x, joint->along.y);
    return in_world(p, joint->body[0], along);
}

// Returns the way along a joint's line, world axes.
static YkRefVec way_along(YkProgram *p, const YkJoint *joint)
{
    YkRef distance = p->distance[p->mech->joint_distance[joint - p->model->joints]];
    return yk_graph_vec_scale(&p->graph, distance, yk_forces_line(p, joint));
}

// Adds an effort along a joint's freedom: on its second body, and its opposite at the same place on the first.
static void push_along(YkForces *f, int32_t joint, bool is_distance, YkRef effort)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    const YkJoint *j = &p->model->joints[joint], *first = yk_joint_end(p->model, (size_t)joint, 0),
                  *last = yk_joint_end(p->model, (size_t)joint, 1);
    int32_t from = first->body[0], on = last->body[1];
    if (!is_distance) {
        f->load[on].moment = yk_graph_add(g, f->load[on].moment, effort);
        f->load[from].moment = yk_graph_subtract(g, f->load[from].moment, effort);
        return;
    }
    YkRefVec force = yk_graph_vec_scale(g, effort, yk_forces_line(p, j));
    YkRefVec arm = yk_forces_arm(p, from, yk_program_point(p, first->point[0]));
    arm = yk_graph_vec_add(g, arm, way_along(p, first));
    if (first != last) arm = yk_graph_vec_add(g, arm, way_along(p, last)); // past a free joint's carriage
    push(f, on, yk_forces_arm(p, on, yk_program_point(p, last->point[1])), force);
    push(f, from, arm, yk_graph_vec_scale(g, yk_graph_number(g, -1), force));
}

// Returns an expression of the file or a law of it. own: the length and the rate of the spring that it is of, or NULL.
static YkRef strength_of(YkForces *f, const YkStrength *strength, const YkRef *own)
{
    YkProgram *p = f->program;
    YkRef value = yk_program_expr_of(p, strength->expr, f->motion, own);
    if (strength->law == YK_NONE) return value;
    return yk_graph_result(&p->graph, yk_program_call_law(p, strength->law, value), 0);
}

static void add_efforts(YkForces *f)
{
    YkProgram *p = f->program;
    for (size_t k = 0; k < p->model->effort_count; k++) {
        const YkEffort *e = &p->model->efforts[k];
        const YkCoordinate *c = &p->model->coordinates[e->coordinate];
        YkRef value = strength_of(f, &e->strength, NULL);
        push_along(f, c->joint, c->is_distance, value);
        f->given[k] = value;
    }
}

static void add_forces(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    for (size_t k = 0; k < p->model->force_count; k++) {
        const YkForce *force = &p->model->forces[k];
        YkRefVec v = {.x = strength_of(f, &force->x, NULL)};
        v.y = strength_of(f, &force->y, NULL);
        if (force->in_body_axes) v = in_world(p, force->body, v);
        push(f, force->body, yk_forces_arm(p, force->body, yk_program_point(p, force->point)), v);
        YkRef *moment = &f->load[force->body].moment;
        *moment = yk_graph_add(g, *moment, strength_of(f, &force->moment, NULL));
    }
}

static YkRef value_of(YkProgram *p, const YkExpr *expr, double value)
{
    return expr ? yk_program_expr(p, expr) : yk_graph_number(&p->graph, value);
}

static void store(YkForces *f, YkRef stiffness, YkRef stretch)
{
    YkGraph *g = &f->program->graph;
    YkRef square = yk_graph_multiply(g, stiffness, yk_graph_multiply(g, stretch, stretch));
    f->potential = yk_graph_add(g, f->potential, yk_graph_multiply(g, yk_graph_number(g, 0.5), square));
}

// Between ends that a joint holds together, only rounding is left, and no direction.
static double no_length(const YkProgram *p)
{
    return (p->is_single ? 1e-5 : 1e-14) * yk_program_size(p);
}

static void add_spring(YkForces *f, const YkSpring *s)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    YkRef stiffness = value_of(p, s->stiffness_expr, s->stiffness), free = value_of(p, s->length_expr, s->length);
    YkRef damping = value_of(p, s->damping_expr, s->damping);
    if (s->coordinate != YK_NONE) {
        const YkCoordinate *c = &p->model->coordinates[s->coordinate];
        int32_t coordinate = yk_tree_coordinate(p->mech, c->joint, c->is_distance);
        YkRef stretch = yk_graph_subtract(g, f->motion[coordinate].position, free);
        YkRef spring = yk_graph_multiply(g, stiffness, stretch);
        YkRef damper = yk_graph_multiply(g, damping, f->motion[coordinate].velocity);
        YkRef pull = yk_graph_add(g, spring, yk_graph_add(g, damper, strength_of(f, &s->force, NULL)));
        store(f, stiffness, stretch);
        push_along(f, c->joint, c->is_distance, yk_graph_minus(g, pull));
        return;
    }
    YkRefVec at[2], rate[2], arm[2];
    for (int k = 0; k < 2; k++) {
        YkRefVec point = yk_program_point(p, s->point[k]);
        at[k] = yk_program_at(p, s->body[k], point);
        rate[k] = yk_program_at_rate(p, s->body[k], point, &f->velocities);
        arm[k] = yk_forces_arm(p, s->body[k], point);
    }
    YkRefVec line = yk_graph_vec_subtract(g, at[1], at[0]);
    YkRef length = yk_graph_vec_length(g, line);
    yk_graph_name(g, length, "%s_length", s->name);
    YkRef per = yk_graph_inverse(g, yk_graph_unary(g, YK_VALUE_NONZERO, length));
    YkRef stretch = yk_graph_subtract(g, length, free);
    YkRef speed = yk_graph_multiply(g, yk_graph_dot(g, yk_graph_vec_subtract(g, rate[1], rate[0]), line), per);
    YkRef spring = yk_graph_multiply(g, stiffness, stretch);
    YkRef damper = yk_graph_multiply(g, damping, speed), own[] = {length, speed};
    YkRef pull = yk_graph_add(g, spring, yk_graph_add(g, damper, strength_of(f, &s->force, own)));
    YkRef joined = yk_graph_subtract(g, length, yk_graph_number(g, no_length(p)));
    YkRefVec force =
        yk_graph_vec_scale(g, yk_graph_choose(g, joined, stiffness, yk_graph_multiply(g, pull, per)), line);
    store(f, stiffness, stretch);
    push(f, s->body[0], arm[0], force);
    push(f, s->body[1], arm[1], yk_graph_vec_scale(g, yk_graph_number(g, -1), force));
}

void yk_forces_unit_effort(YkForces *f, int32_t joint, bool is_distance, YkWrenchRef *load)
{
    YkGraph *g = &f->program->graph;
    YkWrenchRef *before = f->load;
    YkRef zero = yk_graph_number(g, 0);
    for (size_t b = 0; b < f->program->model->body_count; b++) load[b] = (YkWrenchRef){{zero, zero}, zero};
    f->load = load;
    push_along(f, joint, is_distance, yk_graph_number(g, 1));
    f->load = before;
}

// Returns whether a joint has dry friction, or has some for other parameters.
static bool may_be_dry(const YkProgram *p, const YkFriction *friction)
{
    bool may = friction->coulomb != 0;
    for (size_t k = 0; k < p->model->parameter_count && friction->coulomb_expr && !may; k++)
        may = yk_expr_mentions(friction->coulomb_expr, p->model->parameters[k].name);
    return may;
}

static void add_friction(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    for (size_t j = 0; j < p->model->joint_count; j++) {
        const YkJoint *joint = &p->model->joints[j];
        if (!joint->has_friction) continue;
        bool slides = yk_part(joint->kind)->slides;
        YkRef viscous = value_of(p, joint->friction.viscous_expr, joint->friction.viscous);
        YkRef rate = yk_program_joint_rate(p, (int32_t)j, slides, &f->velocities);
        push_along(f, (int32_t)j, slides, yk_graph_minus(g, yk_graph_multiply(g, viscous, rate)));
        if (!may_be_dry(p, &joint->friction)) continue;
        YkRef limit = value_of(p, joint->friction.coulomb_expr, joint->friction.coulomb);
        if (!slides)
            limit = yk_graph_multiply(g, limit, value_of(p, joint->friction.radius_expr, joint->friction.radius));
        f->dry[f->dry_count++] = (YkDryJoint){.joint = (int32_t)j, .slides = slides, .limit = limit};
    }
}

static void make_gravity(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    f->gravity = yk_graph_vec_number(g, 0, 0);
    if (!p->model->has_gravity) return;
    f->gravity.x = value_of(p, p->model->gravity_x, p->model->gravity.x);
    f->gravity.y = value_of(p, p->model->gravity_y, p->model->gravity.y);
    for (size_t b = 1; b < p->model->body_count; b++) {
        if (!p->model->bodies[b].has_mass) continue;
        YkRefVec weight = yk_graph_vec_scale(g, yk_forces_mass(p, (int32_t)b), f->gravity);
        YkRefVec at = yk_program_at(p, (int32_t)b, yk_forces_center(p, (int32_t)b));
        f->potential = yk_graph_subtract(g, f->potential, yk_graph_dot(g, weight, at));
    }
}

bool yk_forces_loads(YkForces *f)
{
    YkProgram *p = f->program;
    YkRef zero = yk_graph_number(&p->graph, 0);
    for (size_t b = 0; b < p->model->body_count; b++) f->load[b] = (YkWrenchRef){{zero, zero}, zero};
    f->potential = zero;
    yk_graph_section(&p->graph, "Loads on the bodies: forces at, and moments about, their centres of mass.");
    make_gravity(f);
    add_efforts(f);
    add_forces(f);
    for (size_t k = 0; k < p->model->spring_count; k++) add_spring(f, &p->model->springs[k]);
    add_friction(f);
    return !p->failed;
}
