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

// Returns what the integral over a step has gained where its integrand, `here` at the start, `next` at the end and `gain` / step
// on average, passes through zero within the step: the parabola through these three gives the place.
static double gain_at_turn(double here, double next, double gain, double step)
{
    double mean = gain / step, b = 6 * mean - 4 * here - 2 * next, c = 3 * (here + next) - 6 * mean;
    double root = sqrt(fmax(0, b * b - 4 * c * here)), s = 2 * here / (here > 0 ? root - b : -root - b);
    return step * s * (here + s * (b / 2 + s * c / 3));
}

// The integral is of fourth order, once round, and its extremes lie between the poses: to six digits with 360 of them.
double yk_cycle_swing(const YkCycle *cycle, const double *torques)
{
    size_t n = cycle->count;
    double mean = 0, energy = 0, low = 0, high = 0;
    for (size_t k = 0; k < n; k++) mean += torques[k] / (double)n;
    for (size_t k = 0; k < n; k++) {
        double here = torques[k] - mean, next = torques[(k + 1) % n] - mean;
        double around = torques[(k + n - 1) % n] + torques[(k + 2) % n] - 2 * mean;
        double gain = cycle->step * (13 * (here + next) - around) / 24;
        if (here * next < 0) {
            double turn = energy + gain_at_turn(here, next, gain, cycle->step);
            low = fmin(low, turn);
            high = fmax(high, turn);
        }
        energy += gain;
        low = fmin(low, energy);
        high = fmax(high, energy);
    }
    return high - low;
}
