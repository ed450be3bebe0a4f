// Finds the reactions and efforts at a pose, under dry friction that is known.
#include <string.h>
#include "dynamics/dynamics.h"

// Finds all loads including gravity, and the motion of every body.
static YkStatus find_loads(YkDynamics *d, const YkState *state)
{
    const YkModel *model = d->mech->model;
    size_t culprit;
    memset(d->load, 0, model->body_count * sizeof *d->load);
    for (size_t b = 1; b < model->body_count; b++) {
        d->load[b].force = yk_scale(model->bodies[b].mass, model->gravity);
        d->motion[b] = yk_body_motion(d->mech, &state->space, b);
    }
    d->motion[0] = (YkBodyMotion){.e = {1, 0}};
    d->stored = yk_loads_stored(d->loads, state, &state->space);
    if (yk_loads_add(d->loads, state, &state->space, d->load, d->power, &culprit)) return YK_OK;
    return yk_dynamics_fail_at_load(d, culprit);
}

static YkVec joint_point(const YkDynamics *d, size_t joint)
{
    const YkJoint *j = &d->mech->model->joints[joint];
    const YkBodyMotion *m = &d->motion[j->body[1]];
    return yk_add(m->at, yk_mul(m->e, yk_sub(j->at[1], yk_reference_point(d->mech->model, (size_t)j->body[1]))));
}

static void push(YkDynamics *d, int32_t body, YkVec at, YkVec force, double moment)
{
    YkLoad *r = &d->reaction[body];
    r->force = yk_add(r->force, force);
    r->moment += moment + yk_cross(yk_sub(at, d->motion[body].at), force);
}

// Returns the force of a pin on its second body. The equations have one planet's mass, but the teeth of all N planets:
// of the force F in them, a planet's own pin bears (F - m (a - g))/N for the teeth and m (a - g) for the mass.
static YkVec own_force(const YkDynamics *d, const YkJoint *pin, YkVec whole)
{
    if (pin->copies < 2) return whole;
    int32_t planet = pin->body[pin->copied_side];
    double others = 1 - 1.0 / pin->copies, mass = d->mech->model->bodies[planet].mass;
    YkVec pull = yk_sub(d->motion[planet].acceleration, d->mech->model->gravity);
    double sign = pin->copied_side == 1 ? 1 : -1;
    return yk_add(yk_scale(1.0 / pin->copies, whole), yk_scale(sign * others * mass, pull));
}

static void take_joint(YkDynamics *d, size_t joint)
{
    const YkJoint *j = &d->mech->model->joints[joint];
    YkJointForce f = yk_free_bodies_joint(d->bodies, joint);
    YkVec at = joint_point(d, joint);
    size_t by = (size_t)yk_joint_end(d->mech->model, joint, 0)->body[0],
           on = (size_t)yk_joint_end(d->mech->model, joint, 1)->body[1];
    if (j->is_free) { // it transmits nothing
        d->joint[joint] = (YkReaction){by, on, {0, 0}, 0, {at.x, at.y}, true};
        d->whole[joint] = yk_vec(0, 0);
        return;
    }
    YkVec own = own_force(d, j, f.force);
    d->whole[joint] = f.force;
    d->joint[joint] = (YkReaction){by, on, {own.x, own.y}, f.moment, {at.x, at.y}, f.is_determinate};
    push(d, j->body[1], at, f.force, f.moment);
    push(d, j->body[0], at, yk_scale(-1, f.force), -f.moment);
    d->largest_force = fmax(d->largest_force, fmax(yk_norm(f.force), fabs(f.moment) / d->mech->size));
}

static void take_contact(YkDynamics *d, const YkState *state, size_t relation)
{
    YkMeshForce f = yk_free_bodies_mesh(d->bodies, &state->space, relation);
    double moment = f.is_couple ? f.moment : 0;
    const YkRelation *r = &d->mech->relations[relation];
    int32_t copies = r->kind == YK_RELATION_GEAR ? d->mech->model->gears[r->index].copies : 0;
    if (copies > 1) f.force = yk_scale(1.0 / copies, f.force);
    d->contact[relation] =
        (YkReaction){(size_t)f.body[0], (size_t)f.body[1], {f.force.x, f.force.y}, moment, {f.at.x, f.at.y}, true};
    d->largest_force = fmax(d->largest_force, yk_norm(f.force));
}

// Takes reactions, drives and sums from the results of the free bodies.
static void take_results(YkDynamics *d, const YkState *state)
{
    const YkModel *model = d->mech->model;
    d->largest_force = 0;
    for (size_t b = 1; b < model->body_count; b++) d->largest_force = fmax(d->largest_force, yk_norm(d->load[b].force));
    for (size_t i = 0; i < d->mech->input_count; i++) {
        const YkTreeCoordinate *c = &d->mech->coordinates[d->mech->inputs[i]];
        d->drive[i] = d->is_free[i] ? 0 : yk_free_bodies_effort(d->bodies, i);
        if (d->drive[i] != 0)
            yk_loads_add_effort(d->mech, &state->space, c->joint, c->is_distance, d->drive[i], d->load);
    }
    memset(d->reaction, 0, model->body_count * sizeof *d->reaction);
    for (size_t j = 0; j < model->joint_count; j++) take_joint(d, j);
    for (size_t k = 0; k < d->mech->relation_count; k++) take_contact(d, state, k);
    yk_free_bodies_meshes(d->bodies, d->reaction);
}

static YkStatus set_accelerations(YkDynamics *d, YkState *state)
{
    for (size_t i = 0; i < d->mech->input_count; i++)
        if (d->is_free[i]) state->input[3 * i + 2] = d->acceleration[i];
    YkStatus status = yk_state_solve_unless_clear(state);
    d->report = state->report;
    if (status >= 0 && state->has_rates && yk_state_blurs_forces(state))
        return yk_dynamics_fail(d, YK_SINGULAR, "a change point is so close that rounding decides the forces", "", "");
    return status >= 0 && !state->has_rates ? YK_SINGULAR : status;
}

static YkStatus run_out(YkDynamics *d)
{
    return yk_dynamics_fail(d, YK_NO_MEMORY, "out of memory", "", "");
}

YkStatus yk_dynamics_apply(YkDynamics *d, YkState *state)
{
    YkStatus status = set_accelerations(d, state);
    if (status < 0 || status == YK_SINGULAR) return status;
    status = find_loads(d, state);
    if (status >= 0) status = yk_free_bodies_inverse(d->bodies, &state->space, d->load, state->is_regular);
    if (status >= 0 && status != YK_SINGULAR && yk_free_bodies_radial(d->bodies, d->load, 1)) {
        status = yk_free_bodies_inverse(d->bodies, &state->space, d->load, state->is_regular);
        yk_free_bodies_radial(d->bodies, d->load, -1); // they are reported as forces of the mesh, not as loads
    }
    if (status >= 0 && status != YK_SINGULAR) take_results(d, state);
    return status == YK_NO_MEMORY ? run_out(d) : status;
}

static YkStatus solve_reduced(YkDynamics *d, YkState *state)
{
    bool has_free = false;
    for (size_t i = 0; i < d->mech->input_count; i++) has_free = has_free || d->is_free[i];
    YkStatus status = has_free ? yk_dynamics_reduce(d, state) : YK_OK;
    return status < 0 || status == YK_SINGULAR ? status : yk_dynamics_apply(d, state);
}

static YkStatus solve_bodies(YkDynamics *d, YkState *state)
{
    int culprit = -1;
    YkStatus status = yk_state_solve(state);
    if (status < 0 || !state->has_rates) {
        d->report = state->report;
        return status;
    }
    if (find_loads(d, state) < 0) return d->report.status;
    bool *is_prescribed = d->prescribed;
    for (size_t i = 0; i < d->mech->input_count; i++) {
        is_prescribed[i] = !d->is_free[i];
        d->acceleration[i] = state->input[3 * i + 2];
    }
    status = yk_free_bodies_forward(d->bodies, &state->space, d->load, is_prescribed, d->acceleration, &culprit);
    if (status == YK_SINGULAR) return yk_dynamics_fail_at_input(d, culprit);
    if (status < 0) return status == YK_NO_MEMORY ? run_out(d) : status;
    if (yk_free_bodies_radial(d->bodies, d->load, 1)) {
        status = yk_free_bodies_forward(d->bodies, &state->space, d->load, is_prescribed, d->acceleration, &culprit);
        yk_free_bodies_radial(d->bodies, d->load, -1);
    }
    YkStatus again = set_accelerations(d, state);
    for (size_t b = 1; b < d->mech->model->body_count; b++) d->motion[b] = yk_body_motion(d->mech, &state->space, b);
    take_results(d, state);
    return again < 0 || again == YK_SINGULAR ? again : status;
}

double yk_dynamics_dry_limit(const YkDynamics *d, const YkLoadItem *item)
{
    const YkReaction *r = &d->joint[item->joint];
    return item->coulomb * item->radius * sqrt(r->force[0] * r->force[0] + r->force[1] * r->force[1]);
}

double yk_dynamics_dry_tolerance(int round)
{
    return round < YK_DRY_ROUNDS / 4 ? 1e-13 : 1e-10; // reactions of machines near a dead point are noisy
}

bool yk_dynamics_find_dry(YkDynamics *d, const YkState *state, int round)
{
    double tolerance = yk_dynamics_dry_tolerance(round),
           share = round < YK_DRY_ROUNDS / 4 ? 1 : 0.5; // against oscillation
    bool stands = true;
    for (size_t k = 0; k < d->loads->item_count; k++) {
        YkLoadItem *item = &d->loads->items[k];
        if (item->kind != YK_LOAD_COULOMB || item->is_held) continue;
        double rate = item->direction, limit = yk_dynamics_dry_limit(d, item);
        if (rate == 0) rate = yk_joint_rate(d->mech, &state->space, item->joint, item->is_distance);
        double dry = rate > 0 ? -limit : rate < 0 ? limit : 0;
        double sum = fabs(dry) + fabs(item->dry); // infinite where it grew beyond all numbers: it does not stand there
        stands = stands && sum < (double)INFINITY && fabs(dry - item->dry) <= tolerance * sum;
        item->dry += share * (dry - item->dry);
    }
    return stands;
}

void yk_dynamics_forget_dry(YkDynamics *d)
{
    for (size_t k = 0; k < d->loads->item_count; k++)
        if (d->loads->items[k].kind == YK_LOAD_COULOMB) d->loads->items[k].dry = 0;
}

YkStatus yk_dynamics_fail_at_dry(YkDynamics *d)
{
    yk_dynamics_forget_dry(d); // it may have grown without bound
    return yk_dynamics_fail(d, YK_NOT_CONVERGED, "dry friction does not settle: the joints jam at this pose", "", "");
}

YkStatus yk_dynamics_solve_once(YkDynamics *d, YkState *state, YkMethod method)
{
    bool is_clear = state->is_clear && yk_state_is_up_to_date(state); // the bodies' own equations would blur it again
    return method == YK_METHOD_REDUCED || is_clear ? solve_reduced(d, state) : solve_bodies(d, state);
}
