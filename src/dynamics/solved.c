// Answers about the pose that was solved last: reactions, efforts, energies, balances.
#include "dynamics/holding.h"
#include "elementary/elementary.h"

// The answer for a joint or contact that does not exist.
static const YkReaction no_reaction = {.by = YK_NOT_FOUND,
                                       .on = YK_NOT_FOUND,
                                       .force = {(double)NAN, (double)NAN},
                                       .moment = (double)NAN,
                                       .at = {(double)NAN, (double)NAN}};

YkReaction yk_dynamics_reaction(const YkDynamics *d, size_t joint)
{
    if (joint >= yk_model_joint_count(d->mech->model)) return no_reaction;
    return d->joint[joint];
}

size_t yk_dynamics_contact_count(const YkDynamics *d)
{
    return yk_contact_count(d->mech);
}

const char *yk_dynamics_contact_name(const YkDynamics *d, size_t contact)
{
    if (contact >= yk_dynamics_contact_count(d)) return NULL;
    return yk_contact_name(d->mech, contact);
}

YkReaction yk_dynamics_contact(const YkDynamics *d, size_t contact)
{
    if (contact >= yk_dynamics_contact_count(d)) return no_reaction;
    int32_t relation = yk_contact_relation(d->mech, contact);
    return relation == YK_NONE ? (YkReaction){0} : d->contact[relation];
}

const YkCam *yk_dynamics_loose_cam(const YkDynamics *d, size_t contact)
{
    size_t first = yk_contact_of_cam(d->mech, 0);
    if (contact < first || yk_contact_relation(d->mech, contact) == YK_NONE) return NULL;
    const YkCam *cam = &d->mech->model->cams[contact - first];
    return cam->is_groove || cam->is_conjugate ? NULL : cam;
}

double yk_dynamics_contact_pull(const YkDynamics *d, size_t contact)
{
    const YkCam *cam = yk_dynamics_loose_cam(d, contact);
    if (!cam) return 0;
    YkReaction r = yk_dynamics_contact(d, contact), shaft = d->joint[cam->cam_joint];
    YkVec outwards = {r.at[0] - shaft.at[0], r.at[1] - shaft.at[1]}, force = {r.force[0], r.force[1]};
    // A flat face is pushed along its line, and the force's place on that line has no meaning.
    if (!cam->oscillates) outwards = yk_mul(d->motion[cam->carrier].e, cam->along);
    return -yk_dot(outwards, force) - 1e-9 * yk_norm(outwards) * d->largest_force;
}

bool yk_dynamics_contact_pulls(const YkDynamics *d, size_t contact)
{
    if (contact >= yk_dynamics_contact_count(d)) return false;
    return yk_dynamics_contact_pull(d, contact) > 0;
}

double yk_dynamics_effort(const YkDynamics *d, size_t coordinate)
{
    if (coordinate >= d->mech->coordinate_count) return (double)NAN;
    int32_t law = yk_law_relation(d->mech, coordinate);
    if (law != YK_NONE) return yk_free_bodies_law_effort(d->bodies, (size_t)law);
    int32_t input = d->mech->coordinates[coordinate].input;
    bool is_drive = input != YK_NONE && !d->is_free[input];
    return is_drive ? d->drive[input] : yk_loads_effort(d->loads, (int32_t)coordinate);
}

YkEffortRange yk_dynamics_effort_range(const YkDynamics *d, size_t coordinate)
{
    if (coordinate >= d->mech->coordinate_count) return (YkEffortRange){false, false, -INFINITY, INFINITY};
    int32_t input = d->mech->coordinates[coordinate].input;
    double effort = yk_dynamics_effort(d, coordinate);
    YkEffortRange single = {true, true, effort, effort};
    int32_t law = yk_law_relation(d->mech, coordinate);
    if (law != YK_NONE && !d->contact[law].is_determinate) // a guide that rests in a dwell, say
        return (YkEffortRange){false, false, -(double)INFINITY, (double)INFINITY};
    if (!d->holding || input == YK_NONE || d->is_free[input]) return single;
    YkEffortRange range = yk_holding_range(d->holding, (size_t)input);
    return range.is_single ? single : range;
}

bool yk_dynamics_is_held_by_friction(const YkDynamics *d)
{
    return d->holding && yk_holding_is_open(d->holding);
}

bool yk_dynamics_has_effort(const YkDynamics *d, size_t coordinate)
{
    if (coordinate >= d->mech->coordinate_count) return false;
    int32_t input = d->mech->coordinates[coordinate].input;
    if ((input != YK_NONE && !d->is_free[input]) || yk_law_relation(d->mech, coordinate) != YK_NONE) return true;
    for (size_t k = 0; k < d->loads->item_count; k++)
        if (d->loads->items[k].kind == YK_LOAD_EFFORT && d->loads->items[k].coordinate == (int32_t)coordinate)
            return true;
    return false;
}

YkEnergy yk_dynamics_energy(const YkDynamics *d)
{
    const YkModel *model = d->mech->model;
    YkEnergy energy = {0, d->stored};
    for (size_t b = 1; b < model->body_count; b++) {
        const YkBody *body = &model->bodies[b];
        const YkBodyMotion *m = &d->motion[b];
        energy.kinetic += 0.5 * (body->mass * yk_dot(m->velocity, m->velocity) + body->inertia * m->w * m->w);
        energy.potential -= body->mass * yk_dot(model->gravity, m->at);
    }
    return energy;
}

YkEnergy yk_dynamics_energy_at(YkDynamics *d, const YkState *state)
{
    for (size_t b = 1; b < d->mech->model->body_count; b++)
        if (d->mech->model->bodies[b].has_mass) d->motion[b] = yk_body_motion(d->mech, &state->space, b);
    d->stored = yk_loads_stored(d->loads, state, &state->space);
    return yk_dynamics_energy(d);
}

static YkWrench wrench(YkVec force, double moment)
{
    return (YkWrench){{force.x, force.y}, moment};
}

YkWrench yk_dynamics_shaking(const YkDynamics *d)
{
    return wrench(yk_add(d->load[0].force, d->reaction[0].force), d->load[0].moment + d->reaction[0].moment);
}

YkBalance yk_dynamics_balance(const YkDynamics *d, size_t b)
{
    const YkWrench none = {{(double)NAN, (double)NAN}, (double)NAN};
    if (b >= d->mech->model->body_count) return (YkBalance){none, none, none, (double)NAN};
    const YkBody *body = &d->mech->model->bodies[b];
    const YkBodyMotion *m = &d->motion[b];
    YkBalance balance = {wrench(d->load[b].force, d->load[b].moment),
                         wrench(d->reaction[b].force, d->reaction[b].moment),
                         wrench(yk_scale(body->mass, m->acceleration), body->inertia * m->a), 0};
    if (body->copies > 1) { // the equations have the moments of all
        balance.loads.moment /= body->copies;
        balance.reactions.moment /= body->copies;
        balance.inertia.moment /= body->copies;
    }
    double x = balance.loads.force[0] + balance.reactions.force[0] - balance.inertia.force[0];
    double y = balance.loads.force[1] + balance.reactions.force[1] - balance.inertia.force[1];
    double moment = balance.loads.moment + balance.reactions.moment - balance.inertia.moment;
    double most = fmax(fabs(moment) / d->mech->size, yk_hypot(x, y));
    balance.residual = d->largest_force > 0 ? most / d->largest_force : most;
    return balance;
}

double yk_dynamics_channel(const YkDynamics *d, const YkState *state, YkChannel c)
{
    size_t index = (size_t)c.index;
    size_t joints = d->mech->model->joint_count;
    YkReaction reaction = c.kind > YK_CHANNEL_MOMENT || !yk_channel_needs_forces(c) ? (YkReaction){0}
                          : index < joints                                          ? d->joint[index]
                                           : yk_dynamics_contact(d, index - joints);
    const YkReaction *r = &reaction;
    YkEnergy energy;
    YkWrench shaking;
    YkEffortRange range;
    switch (c.kind) {
    case YK_CHANNEL_FORCE_X:
        return r->force[0];
    case YK_CHANNEL_FORCE_Y:
        return r->force[1];
    case YK_CHANNEL_FORCE:
        return yk_hypot(r->force[0], r->force[1]);
    case YK_CHANNEL_MOMENT:
        return r->moment;
    case YK_CHANNEL_EFFORT:
        return yk_dynamics_effort_range(d, index).is_single ? yk_dynamics_effort(d, index) : (double)NAN;
    case YK_CHANNEL_EFFORT_FROM:
    case YK_CHANNEL_EFFORT_TO:
        range = yk_dynamics_effort_range(d, index);
        return !range.is_known ? (double)NAN : c.kind == YK_CHANNEL_EFFORT_FROM ? range.low : range.high;
    case YK_CHANNEL_ENERGY:
    case YK_CHANNEL_KINETIC:
    case YK_CHANNEL_POTENTIAL:
        energy = yk_dynamics_energy(d);
        return (c.kind != YK_CHANNEL_POTENTIAL ? energy.kinetic : 0) +
               (c.kind != YK_CHANNEL_KINETIC ? energy.potential : 0);
    case YK_CHANNEL_SHAKING_X:
    case YK_CHANNEL_SHAKING_Y:
    case YK_CHANNEL_SHAKING_MOMENT:
        shaking = yk_dynamics_shaking(d);
        return c.kind == YK_CHANNEL_SHAKING_X   ? shaking.force[0]
               : c.kind == YK_CHANNEL_SHAKING_Y ? shaking.force[1]
                                                : shaking.moment;
    default:
        return yk_state_channel(state, c);
    }
}
