// Shaking over a cycle: the poses, their inertia, and the input's effort.
#include <math.h>
#include <stdlib.h>
#include <yoke/move.h>
#include <yoke/sweep.h>
#include "design/balancing.h"

YkStatus yk_cycle_find(const YkState *state, size_t steps, YkCycle *cycle)
{
    enum { RANGES = 32 };
    static const double inset = 0.05; // at a limit of the input velocities grow without end
    YkRange range[RANGES];
    size_t coordinate = yk_input_coordinate(state->mech, 0);
    YkMotion now = yk_state_input(state, 0);
    YkState *probe = yk_state_new(state->mech);
    if (!probe || yk_state_copy(probe, state) < 0) {
        yk_state_free(probe);
        return YK_NO_MEMORY;
    }
    size_t count = yk_closing_ranges(probe, coordinate, range, RANGES);
    yk_state_free(probe);
    if (count == YK_NOT_FOUND) return YK_NO_MEMORY;
    for (size_t k = 0; k < count && k < RANGES; k++) {
        if (now.position < range[k].from - 1e-9 || now.position > range[k].to + 1e-9) continue;
        double span = range[k].to - range[k].from;
        cycle->turns = !yk_coordinate_info(state->mech, coordinate).is_distance && span > 2 * YK_PI - 1e-9;
        cycle->from = cycle->turns ? now.position : range[k].from + inset * span;
        cycle->step = cycle->turns ? 2 * YK_PI / (double)steps : (1 - 2 * inset) * span / (double)steps;
        cycle->count = cycle->turns ? steps : steps + 1;
        cycle->rate = now.velocity != 0 ? now.velocity : 1;
        return span > 0 ? YK_OK : YK_BAD_ARGUMENT;
    }
    return YK_BAD_ARGUMENT;
}

YkStatus yk_cycle_pose(const YkCycle *cycle, YkState *state, size_t k)
{
    YkMotion goal = {cycle->from + cycle->step * (double)k, 0, 0};
    YkStatus status = yk_state_move_to(state, &goal, NULL, NULL);
    if (status < 0) return status;
    yk_state_set_input_to(state, 0, goal.position, cycle->rate, 0);
    status = yk_state_solve(state);
    return status >= 0 && !yk_state_has_rates(state) ? YK_BAD_ARGUMENT : status;
}

YkVec yk_cycle_pivot(const YkState *state)
{
    size_t coordinate = yk_input_coordinate(state->mech, 0);
    const YkJoint *joint = &state->mech->model->joints[yk_coordinate_info(state->mech, coordinate).joint];
    YkBodyMotion ground = yk_body_motion(state->mech, &state->space, 0);
    return joint->body[0] == 0 ? yk_add(ground.at, yk_mul(ground.e, joint->at[0])) : yk_vec(0, 0);
}

YkVec yk_cycle_shaking(const YkState *state, double *moment)
{
    const YkModel *model = state->mech->model;
    YkVec force = yk_vec(0, 0), pivot = yk_cycle_pivot(state);
    *moment = 0;
    for (size_t b = 1; b < model->body_count; b++) {
        const YkBody *body = &model->bodies[b];
        if (!body->has_mass) continue;
        YkBodyMotion m = yk_body_motion(state->mech, &state->space, b);
        YkVec own = yk_scale(-body->mass, m.acceleration);
        force = yk_add(force, own);
        *moment += yk_cross(yk_sub(m.at, pivot), own) - body->inertia * m.a;
    }
    return force;
}

static void add_shaking(const YkState *state, YkShakingPeaks *peaks)
{
    double moment;
    YkVec force = yk_cycle_shaking(state, &moment);
    peaks->force = fmax(peaks->force, yk_norm(force));
    peaks->moment = fmax(peaks->moment, fabs(moment));
}

YkStatus yk_cycle_peaks(const YkCycle *cycle, const YkState *state, YkShakingPeaks *peaks, double *torques)
{
    YkState *moving = yk_state_new(state->mech);
    YkDynamics *dynamics = yk_dynamics_new(state->mech, NULL);
    YkStatus status = moving && dynamics ? yk_state_copy(moving, state) : YK_NO_MEMORY;
    *peaks = (YkShakingPeaks){0};
    if (dynamics) yk_dynamics_prescribe(dynamics, 0, true);
    for (size_t k = 0; k < cycle->count && status >= 0; k++) {
        status = yk_cycle_pose(cycle, moving, k);
        if (status < 0) break;
        add_shaking(moving, peaks);
        status = yk_dynamics_solve(dynamics, moving, YK_METHOD_REDUCED);
        double torque = yk_dynamics_effort(dynamics, yk_input_coordinate(state->mech, 0));
        peaks->torque = fmax(peaks->torque, fabs(torque));
        if (torques) torques[k] = torque;
        if (status == YK_SINGULAR) status = YK_BAD_ARGUMENT;
    }
    yk_dynamics_free(dynamics);
    yk_state_free(moving);
    return status;
}

double yk_cycle_swing(const YkCycle *cycle, const double *torques)
{
    double mean = 0, energy = 0, low = 0, high = 0;
    for (size_t k = 0; k < cycle->count; k++) mean += torques[k] / (double)cycle->count;
    for (size_t k = 0; k < cycle->count; k++) { // trapezoids, once round
        double here = torques[k], next = torques[(k + 1) % cycle->count];
        energy += ((here + next) / 2 - mean) * cycle->step;
        low = fmin(low, energy);
        high = fmax(high, energy);
    }
    return high - low;
}
