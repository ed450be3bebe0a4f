// Shaking over a cycle: the poses, their inertia, and the input's effort.
#include <math.h>
#include <string.h>
#include <yoke/move.h>
#include <yoke/sweep.h>
#include "design/balancing.h"

// Moves a state to a place of the cycle, in steps from its start.
static YkStatus go_to(const YkCycle *cycle, YkState *state, double steps)
{
    YkMotion goal = {cycle->from + cycle->step * steps, 0, 0};
    YkStatus status = yk_state_move_to(state, &goal, NULL, NULL);
    if (status < 0) return status;
    yk_state_set_input_to(state, 0, goal.position, cycle->rate, 0);
    status = yk_state_solve(state);
    return status >= 0 && !yk_state_has_rates(state) ? YK_BAD_ARGUMENT : status;
}

YkStatus yk_cycle_pose(const YkCycle *cycle, YkState *state, size_t k)
{
    return go_to(cycle, state, (double)k);
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

// The range of the input in which the machine stands. Returns YK_BAD_ARGUMENT if there is none.
static YkStatus find_range(const YkState *state, YkRange *found)
{
    enum { RANGES = 32 };
    YkRange range[RANGES];
    double now = yk_state_input(state, 0).position;
    YkState *probe = yk_state_new(state->mech);
    if (!probe || yk_state_copy(probe, state) < 0) {
        yk_state_free(probe);
        return YK_NO_MEMORY;
    }
    size_t count = yk_closing_ranges(probe, yk_input_coordinate(state->mech, 0), range, RANGES);
    yk_state_free(probe);
    if (count == YK_NOT_FOUND) return YK_NO_MEMORY;
    for (size_t k = 0; k < count && k < RANGES; k++) {
        if (now < range[k].from - 1e-9 || now > range[k].to + 1e-9) continue;
        *found = range[k];
        return range[k].to > range[k].from ? YK_OK : YK_BAD_ARGUMENT;
    }
    return YK_BAD_ARGUMENT;
}

// Values that must repeat: effort, shaking force and moment.
enum { SAMPLES = 8, VALUES = 4 };
typedef struct Repeating {
    double value[YK_TURNS_MAX + 1][SAMPLES][VALUES], size[VALUES];
} Repeating;

// Gives what is nothing but rounding the size of what it is made of.
static void mind_rounding(Repeating *r, double length)
{
    static const double rounding = 1e-4; // of a difference of 1e-11
    double force = fmax(r->size[1], r->size[2]), moment = fmax(fmax(r->size[0], r->size[3]), force * length);
    for (size_t i = 0; i < VALUES; i++)
        r->size[i] = fmax(r->size[i], rounding * (i == 1 || i == 2 ? fmax(force, moment / length) : moment));
}

static void take_values(const YkState *state, YkDynamics *dynamics, double value[VALUES], double size[VALUES])
{
    YkVec force = yk_cycle_shaking(state, &value[3]);
    value[0] = yk_dynamics_effort(dynamics, yk_input_coordinate(state->mech, 0));
    value[1] = force.x;
    value[2] = force.y;
    for (size_t i = 0; i < VALUES; i++) size[i] = fmax(size[i], fabs(value[i]));
}

static bool repeats_after(const Repeating *r, size_t turns)
{
    static const double alike = 1e-7; // over the largest
    for (size_t k = 0; k + turns <= YK_TURNS_MAX; k++)
        for (size_t i = 0; i < SAMPLES * VALUES; i++) {
            double off = r->value[k][i / VALUES][i % VALUES] - r->value[k + turns][i / VALUES][i % VALUES];
            if (!(fabs(off) <= alike * r->size[i % VALUES])) return false;
        }
    return true;
}

YkStatus yk_cycle_repeat(const YkState *state, YkCycle *cycle)
{
    static const double golden = 0.6180339887498949; // samples that no order of a Fourier series meets alike
    Repeating r = {0};
    YkState *moving = yk_state_new(state->mech);
    YkDynamics *dynamics = yk_dynamics_new(state->mech, NULL);
    YkStatus status = moving && dynamics ? yk_state_copy(moving, state) : YK_NO_MEMORY;
    if (dynamics) yk_dynamics_prescribe(dynamics, 0, true);
    YkCycle even = *cycle;
    even.step = 2 * YK_PI * golden / SAMPLES;
    for (size_t k = 0; k < (YK_TURNS_MAX + 1) * SAMPLES && status >= 0; k++) {
        even.from = cycle->from + 2 * YK_PI * (double)(k / SAMPLES);
        status = yk_cycle_pose(&even, moving, k % SAMPLES);
        if (status >= 0) status = yk_dynamics_solve(dynamics, moving, YK_METHOD_REDUCED);
        if (status >= 0) take_values(moving, dynamics, r.value[k / SAMPLES][k % SAMPLES], r.size);
    }
    mind_rounding(&r, state->mech->size);
    for (size_t turns = 1; turns <= YK_TURNS_MAX && status >= 0 && !cycle->repeats; turns++) {
        cycle->repeats = repeats_after(&r, turns);
        if (!cycle->repeats) continue;
        cycle->turns = turns;
        cycle->count *= turns;
    }
    yk_dynamics_free(dynamics);
    yk_state_free(moving);
    return status;
}

YkStatus yk_cycle_find(const YkState *state, size_t steps, YkCycle *cycle)
{
    static const double inset = 0.05; // at a limit of the input velocities grow without end
    YkRange range;
    YkMotion now = yk_state_input(state, 0);
    YkStatus status = find_range(state, &range);
    if (status < 0) return status;
    double span = range.to - range.from;
    bool is_distance = yk_coordinate_info(state->mech, yk_input_coordinate(state->mech, 0)).is_distance;
    bool turns = !is_distance && span > 2 * YK_PI - 1e-9;
    *cycle = (YkCycle){.from = turns ? now.position : range.from + inset * span};
    cycle->step = turns ? 2 * YK_PI / (double)steps : (1 - 2 * inset) * span / (double)steps;
    cycle->rate = now.velocity != 0 ? now.velocity : 1;
    cycle->turns = turns;
    cycle->count = turns ? steps : steps + 1;
    return YK_OK;
}

// --- peaks

enum { PEAKS = 3 }; // of force, moment and effort

// A state that moves through the cycle, with what it measures at a place: the sizes of force, moment and effort.
typedef struct Measure {
    const YkCycle *cycle;
    YkState *state;
    YkDynamics *dynamics;
    YkVec force;
    double torque, size[PEAKS];
    bool ran_out; // of memory
} Measure;

static YkStatus measure(Measure *m, double steps)
{
    double moment = 0;
    YkStatus status = go_to(m->cycle, m->state, steps);
    m->ran_out |= status == YK_NO_MEMORY;
    if (status < 0) return status;
    m->force = yk_cycle_shaking(m->state, &moment);
    status = yk_dynamics_solve(m->dynamics, m->state, YK_METHOD_REDUCED);
    m->ran_out |= status == YK_NO_MEMORY;
    m->torque = yk_dynamics_effort(m->dynamics, yk_input_coordinate(m->state->mech, 0));
    m->size[0] = yk_norm(m->force);
    m->size[1] = fabs(moment);
    m->size[2] = fabs(m->torque);
    return status == YK_SINGULAR ? YK_BAD_ARGUMENT : status;
}

// Goes to the top of a parabola through three values, which are taken ever closer. Returns the largest value met, or 0
// where the machine does not get there.
static double refine(Measure *m, size_t i, double at, double before, double here, double after)
{
    double h = 1;
    for (int round = 0; round < 4; round++, h /= 8) {
        if (round > 0) {
            before = measure(m, at - h) >= 0 ? m->size[i] : 0;
            after = measure(m, at + h) >= 0 ? m->size[i] : 0;
        }
        double bend = before - 2 * here + after, to = at + h * (before - after) / (2 * bend);
        if (!(fabs(to - at) <= h) || measure(m, to) < 0) break;
        if (!(m->size[i] >= here)) continue;
        here = m->size[i];
        at = to;
    }
    return here;
}

// Takes the peaks about the middle one of three poses that follow each other: none exceeds the middle by more than it
// exceeds the lower neighbour. A value that is constant but for rounding has none.
static void take_peaks(Measure *m, double at, double size[3][PEAKS], double *peak)
{
    for (size_t i = 0; i < PEAKS; i++) {
        double before = size[0][i], here = size[1][i], after = size[2][i], rise = here - fmin(before, after);
        if (here < before || here < after || rise <= 1e-9 * here || here + rise <= peak[i]) continue;
        peak[i] = fmax(peak[i], refine(m, i, at, before, here, after));
    }
}

// Measures all poses, and two more where the cycle goes round, so that each has neighbours.
static YkStatus run_cycle(Measure *m, Measure *beside, double *peak, double *torques, YkVec *forces)
{
    size_t count = m->cycle->count;
    double size[3][PEAKS] = {{0}};
    for (size_t k = 0; k < count + (m->cycle->repeats ? 2 : 0); k++) {
        YkStatus status = measure(m, (double)k);
        if (status < 0) return status;
        if (m->cycle->laws && k < count)
            yk_law_watch_look(m->cycle->laws, m->state, m->dynamics, yk_state_input(m->state, 0).position);
        memmove(size, size + 1, 2 * sizeof *size);
        memcpy(size[2], m->size, sizeof *size);
        for (size_t i = 0; i < PEAKS; i++) peak[i] = fmax(peak[i], m->size[i]);
        if (forces && k < count) forces[k] = m->force;
        if (torques && k < count) torques[k] = m->torque;
        if (k < 2) continue;
        if (yk_state_copy(beside->state, m->state) < 0) return YK_NO_MEMORY;
        take_peaks(beside, (double)k - 1, size, peak);
        if (beside->ran_out) return YK_NO_MEMORY;
    }
    return YK_OK;
}

YkStatus yk_cycle_peaks(const YkCycle *cycle, const YkState *state, YkShakingPeaks *peaks, double *torques,
                        YkVec *forces)
{
    Measure m[2] = {{.cycle = cycle}, {.cycle = cycle}};
    double peak[PEAKS] = {0};
    YkStatus status = YK_OK;
    for (size_t k = 0; k < 2; k++) {
        m[k].state = yk_state_new(state->mech);
        m[k].dynamics = yk_dynamics_new(state->mech, NULL);
        bool good = m[k].state && m[k].dynamics && yk_state_copy(m[k].state, state) >= 0;
        if (!good) status = YK_NO_MEMORY;
        if (m[k].dynamics) yk_dynamics_prescribe(m[k].dynamics, 0, true);
    }
    if (status >= 0) status = run_cycle(&m[0], &m[1], peak, torques, forces);
    *peaks = (YkShakingPeaks){peak[0], peak[1], peak[2]};
    for (size_t k = 0; k < 2; k++) {
        yk_dynamics_free(m[k].dynamics);
        yk_state_free(m[k].state);
    }
    return status;
}

// Returns what the integral over a step has gained where its integrand, `here` at the start, `next` at the end and
// `gain` / step on average, passes through zero within the step: the parabola through these three gives the place.
static double gain_at_turn(double here, double next, double gain, double step)
{
    double mean = gain / step, b = 6 * mean - 4 * here - 2 * next, c = 3 * (here + next) - 6 * mean;
    double root = sqrt(fmax(0, b * b - 4 * c * here)), s = 2 * here / (here > 0 ? root - b : -root - b);
    return step * s * (here + s * (b / 2 + s * c / 3));
}

// Returns the integral from at[1] to at[2], a step apart between at[0] and at[3]: of fourth order where the integrand
// bends alike at both ends, else the trapezoid, which is right beside a jump or a corner of a drawn torque.
static double gain_over_step(const double at[4], double step)
{
    double bend = at[0] - 2 * at[1] + at[2], next = at[1] - 2 * at[2] + at[3];
    bool is_smooth = bend * next > 0 && fabs(bend) < 4 * fabs(next) && fabs(next) < 4 * fabs(bend);
    return step * ((at[1] + at[2]) / 2 - (is_smooth ? (bend + next) / 24 : 0));
}

// Finds the swing of the integral once round. Its extremes lie between the poses.
double yk_cycle_swing(const YkCycle *cycle, const double *torques)
{
    size_t n = cycle->count;
    double mean = 0, energy = 0, low = 0, high = 0;
    for (size_t k = 0; k < n; k++) mean += torques[k] / (double)n;
    for (size_t k = 0; k < n; k++) {
        const double at[] = {torques[(k + n - 1) % n] - mean, torques[k] - mean, torques[(k + 1) % n] - mean,
                             torques[(k + 2) % n] - mean};
        double gain = gain_over_step(at, cycle->step);
        if (at[1] * at[2] < 0) {
            double turn = energy + gain_at_turn(at[1], at[2], gain, cycle->step);
            low = fmin(low, turn);
            high = fmax(high, turn);
        }
        energy += gain;
        low = fmin(low, energy);
        high = fmax(high, energy);
    }
    return high - low;
}

// The mean of F e^(-i n theta) is the part that turns with the input at n times its rate; that of F e^(i n theta) turns
// against it.
void yk_cycle_orders(const YkCycle *cycle, const YkVec *forces, YkShakingOrder order[YK_SHAKING_ORDERS])
{
    double part = 1 / (double)cycle->count;
    for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++) {
        YkVec with = yk_vec(0, 0), against = with;
        for (size_t k = 0; k < cycle->count && cycle->repeats; k++) {
            YkVec turn = yk_unit((double)n * (cycle->from + cycle->step * (double)k));
            with = yk_add(with, yk_scale(part, yk_mul(yk_conj(turn), forces[k])));
            against = yk_add(against, yk_scale(part, yk_mul(turn, forces[k])));
        }
        double long_axis = yk_atan2(with.y, with.x) + yk_atan2(against.y, against.x);
        order[n - 1] = (YkShakingOrder){yk_norm(with), yk_norm(against), yk_remainder(long_axis / 2, YK_PI)};
        if (!cycle->repeats) order[n - 1] = (YkShakingOrder){(double)NAN, (double)NAN, (double)NAN};
    }
}
