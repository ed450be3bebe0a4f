// Channels of forces and energies as values, from the solved balance of all bodies.
#include "program/balance.h"

// index: of a joint, or the number of joints plus that of a contact.
static YkRef transmitted(YkBalanceSystem *w, YkChannel c)
{
    YkGraph *g = &w->f->program->graph;
    size_t joints = w->f->program->model->joint_count, index = (size_t)c.index;
    const YkRef *r = w->f->reaction + 3 * index;
    const YkContactRef *contact = index < joints ? NULL : &w->f->contact[index - joints];
    YkRefVec force = contact ? contact->force : (YkRefVec){r[0], r[1]};
    switch (c.kind) {
    case YK_CHANNEL_MOMENT:
        return contact ? contact->moment : r[2];
    case YK_CHANNEL_FORCE_X:
        return force.x;
    case YK_CHANNEL_FORCE_Y:
        return force.y;
    default:
        return yk_graph_vec_length(g, force);
    }
}

// Returns the unknown of the input's drive; w->count if there is none.
static size_t unknown_of(const YkBalanceSystem *w, int32_t input)
{
    size_t k = 0;
    while (k < w->count && (input == YK_NONE || w->columns[k].relation != YK_NONE || w->columns[k].input != input)) k++;
    return k;
}

// Returns the effort that an input or a law's drive needs, or what `efforts:` gives along another coordinate.
static YkRef effort(YkBalanceSystem *w, size_t coordinate)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkTreeCoordinate *own = &p->mech->coordinates[coordinate];
    int32_t law = yk_law_relation(p->mech, coordinate);
    size_t unknown = unknown_of(w, own->input);
    YkRef sum = yk_graph_number(g, 0);
    if (law != YK_NONE) return w->f->contact[law].moment;
    if (unknown < w->count) // couples are over the unit
        return yk_graph_multiply(g, yk_balance_value(w, unknown), yk_graph_number(g, own->is_distance ? 1 : w->unit));
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
