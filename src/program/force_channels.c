// Channels of forces and energies as values, from the solved balance of all bodies.
#include "program/balance.h"

static size_t unknown_of_relation(const YkBalanceSystem *w, int32_t relation)
{
    size_t k = 0;
    while (w->columns[k].relation != relation) k++;
    return k;
}

YkRefVec yk_balance_contact(YkBalanceSystem *w, size_t k)
{
    YkGraph *g = &w->f->program->graph;
    const YkUnknown *c = &w->columns[k];
    const YkRelation *r = &w->f->program->mech->relations[c->relation];
    int32_t copies = r->kind == YK_RELATION_GEAR ? w->f->program->model->gears[r->index].copies : 0;
    YkRefVec force = yk_graph_vec_scale(g, yk_balance_value(w, k), c->force);
    if (c->radial != 0) {
        YkRef size = yk_graph_unary(g, YK_VALUE_SIZE, yk_balance_value(w, k));
        force = yk_graph_vec_add(g, force, yk_graph_vec_scale(g, size, w->radial[c->radial]));
    }
    return copies > 1 ? yk_graph_vec_scale(g, yk_graph_number(g, 1.0 / copies), force) : force;
}

// index: of a joint, or the number of joints plus that of a contact.
static YkRef transmitted(YkBalanceSystem *w, YkChannel c)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    size_t joints = p->model->joint_count, index = (size_t)c.index;
    bool is_joint = index < joints;
    size_t k = is_joint ? 0 : unknown_of_relation(w, (int32_t)(index - joints));
    const YkRef *r = w->f->reaction + 3 * index;
    if (c.kind == YK_CHANNEL_MOMENT)
        return is_joint ? r[2] : yk_graph_multiply(g, yk_balance_value(w, k), w->columns[k].moment);
    YkRefVec force = is_joint ? (YkRefVec){r[0], r[1]} : yk_balance_contact(w, k);
    return c.kind == YK_CHANNEL_FORCE_X   ? force.x
           : c.kind == YK_CHANNEL_FORCE_Y ? force.y
                                          : yk_graph_vec_length(g, force);
}

// Returns whether an unknown is what makes the coordinate follow another by a law.
static bool is_law_of(const YkProgram *p, const YkUnknown *unknown, size_t coordinate)
{
    const YkRelation *r = unknown->relation == YK_NONE ? NULL : &p->mech->relations[unknown->relation];
    if (!r || r->kind != YK_RELATION_LAW) return false;
    const YkCoordinate *own = &p->model->coordinates[p->model->follows[r->index].coordinate];
    return yk_tree_coordinate(p->mech, own->joint, own->is_distance) == (int32_t)coordinate;
}

// Returns the effort that an input or a law's drive needs, or what `efforts:` gives along another coordinate.
static YkRef effort(YkBalanceSystem *w, size_t coordinate)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    int32_t input = p->mech->coordinates[coordinate].input;
    YkRef sum = yk_graph_number(g, 0);
    for (size_t k = 0; k < w->count; k++)
        if (is_law_of(p, &w->columns[k], coordinate)) {
            const YkFollow *follow = &p->model->follows[p->mech->relations[w->columns[k].relation].index];
            YkRef unit = yk_graph_number(g, p->model->coordinates[follow->coordinate].is_distance ? 1 : w->unit);
            return yk_graph_multiply(g, yk_balance_value(w, k), unit);
        }
    for (size_t k = 0; k < w->count && input != YK_NONE; k++)
        if (w->columns[k].relation == YK_NONE && w->columns[k].input == input) {
            YkRef unit = yk_graph_number(g, w->columns[k].is_couple ? w->unit : 1);
            return yk_graph_multiply(g, yk_balance_value(w, k), unit);
        }
    for (size_t k = 0; k < p->model->effort_count; k++) {
        const YkCoordinate *c = &p->model->coordinates[p->model->efforts[k].coordinate];
        if (yk_tree_coordinate(p->mech, c->joint, c->is_distance) == (int32_t)coordinate)
            sum = yk_graph_add(g, sum, w->f->given[k]);
    }
    return sum;
}

static YkRef kinetic(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRef twice = yk_graph_number(g, 0);
    for (size_t b = 1; b < p->model->body_count; b++) {
        if (!p->model->bodies[b].has_mass) continue;
        YkRefVec v = yk_program_at_rate(p, (int32_t)b, yk_forces_center(p, (int32_t)b), &w->velocities);
        YkRef spin = w->velocities.turn[p->mech->bodies[b].orientation], mass = yk_forces_mass(p, (int32_t)b);
        YkRef inertia = yk_forces_inertia(p, (int32_t)b), square = yk_graph_multiply(g, spin, spin);
        YkRef turning = yk_graph_multiply(g, inertia, square),
              moving = yk_graph_multiply(g, mass, yk_graph_dot(g, v, v));
        twice = yk_graph_add(g, twice, yk_graph_add(g, moving, turning));
    }
    return yk_graph_multiply(g, yk_graph_number(g, 0.5), twice);
}

static YkRef energy(YkBalanceSystem *w, YkChannelKind kind)
{
    YkGraph *g = &w->f->program->graph;
    YkRef potential = kind == YK_CHANNEL_KINETIC ? yk_graph_number(g, 0) : w->f->potential;
    return kind == YK_CHANNEL_POTENTIAL ? potential : yk_graph_add(g, kinetic(w), potential);
}

// Returns what acts on the frame: by the balance of the whole machine, all loads less the inertia of all bodies. Forces
// between bodies cancel.
static YkWrenchRef shaking(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkWrenchRef sum = w->f->load[0];
    for (size_t b = 1; b < p->model->body_count; b++) {
        YkWrenchRef own = w->f->load[b];
        YkRefVec center = yk_forces_center(p, (int32_t)b), at = yk_program_at(p, (int32_t)b, center);
        if (p->model->bodies[b].has_mass) {
            YkRefVec a = yk_program_body_accel(p, (int32_t)b, center, &w->velocities, &w->accelerations);
            YkRefVec pull = yk_graph_vec_subtract(g, w->f->gravity, a);
            YkRef turn = w->accelerations.turn[p->mech->bodies[b].orientation];
            own.force = yk_graph_vec_add(g, own.force, yk_graph_vec_scale(g, yk_forces_mass(p, (int32_t)b), pull));
            own.moment = yk_graph_subtract(g, own.moment, yk_graph_multiply(g, yk_forces_inertia(p, (int32_t)b), turn));
        }
        sum.force = yk_graph_vec_add(g, sum.force, own.force);
        YkRef moment = yk_graph_add(g, own.moment, yk_graph_cross(g, at, own.force));
        sum.moment = yk_graph_add(g, sum.moment, moment);
    }
    return sum;
}

YkRef yk_balance_channel(YkBalanceSystem *w, YkChannel c)
{
    switch (c.kind) {
    case YK_CHANNEL_FORCE_X:
    case YK_CHANNEL_FORCE_Y:
    case YK_CHANNEL_FORCE:
    case YK_CHANNEL_MOMENT:
        return transmitted(w, c);
    case YK_CHANNEL_EFFORT:
    case YK_CHANNEL_EFFORT_FROM: // the ends of an interval that only dry friction opens
    case YK_CHANNEL_EFFORT_TO:
        return effort(w, (size_t)c.index);
    case YK_CHANNEL_ENERGY:
    case YK_CHANNEL_KINETIC:
    case YK_CHANNEL_POTENTIAL:
        return energy(w, c.kind);
    case YK_CHANNEL_SHAKING_X:
        return shaking(w).force.x;
    case YK_CHANNEL_SHAKING_Y:
        return shaking(w).force.y;
    case YK_CHANNEL_SHAKING_MOMENT:
        return shaking(w).moment;
    default:
        return YK_NONE;
    }
}
