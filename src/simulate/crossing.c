// Singular positions that the motion passes: which blocks are watched, the branch that momentum takes, the passage.
#include "simulate/crossing.h"
#include "elementary/elementary.h"

#define NEAR_SINE2 0.06 // sin^2 below which a block is watched
#define CLOSE 0.12      // rad from a singular position, inside the watched zone
#define BLIND 1e-4      // sine below which the pose does not determine its own rates well enough

// Returns a block as it was at the last look, or NULL. Both lists ascend by block: `cursor` follows.
static const YkNear *last_look(const YkSimulation *sim, size_t block, size_t *cursor)
{
    while (*cursor < sim->near_count && sim->near[*cursor].block < block) ++*cursor;
    return *cursor < sim->near_count && sim->near[*cursor].block == block ? &sim->near[*cursor] : NULL;
}

// Keeps the prediction where the pose itself cannot tell.
static YkNear known_near(const YkSimulation *sim, const YkRun *run, size_t block, const YkNear *old, double t)
{
    YkDirection d = yk_between_columns(run, &sim->mech->blocks[block]);
    YkNear near = {block, d.angle, d.rate, d.acceleration};
    double dt = t - sim->near_time;
    if (!old || sim->keeps_apart || fabs(yk_sin(yk_near_angle(old, dt))) >= BLIND) return near;
    near.rate = old->rate + dt * old->acceleration;
    near.acceleration = old->acceleration;
    if (fabs(yk_sin(d.angle)) < 0.1 * BLIND) near.angle = yk_near_angle(old, dt);
    return near;
}

// Returns when the angle passed 0 or half a turn between two looks: on the quintic through angles, rates and
// accelerations.
static double time_of_passage(const YkNear *old, const YkNear *now, double from, double to)
{
    double h = to - from, a = old->angle, b = yk_nearest_turn(now->angle, yk_near_angle(old, h));
    double level = YK_PI * round(0.5 * (a + b) / YK_PI), low = 0, high = 1;
    for (int k = 0; k < 60; k++) {
        double s = 0.5 * (low + high), r = 1 - s;
        double value = r * r * r *
                           ((1 + 3 * s + 6 * s * s) * (a - level) +
                            s * h * ((1 + 3 * s) * old->rate + 0.5 * s * h * old->acceleration)) +
                       s * s * s *
                           ((1 + 3 * r + 6 * r * r) * (b - level) -
                            r * h * ((1 + 3 * r) * now->rate - 0.5 * r * h * now->acceleration));
        *(value * (a - level) > 0 ? &low : &high) = s;
    }
    return from + low * h;
}

static void note_passage(YkSimulation *sim, const YkNear *old, const YkNear *now, double t)
{
    if (!old || yk_begins_flat(sim) || sim->keeps_apart || !(yk_sin(old->angle) * yk_sin(now->angle) < 0)) return;
    double at = time_of_passage(old, now, sim->near_time, t);
    yk_simulation_note(sim, YK_HAPPENING_CHANGE_POINT, at, sim->mech->blocks[now->block].label, 0);
}

void yk_simulation_look_near(YkSimulation *sim, double t)
{
    YkState *s = sim->state;
    size_t count = 0, cursor = 0;
    YkRun run = yk_state_run(s, &s->space);
    if (s->space.margin[0] < NEAR_SINE2 || sim->near_count > 0)
        for (size_t b = 0; b < sim->mech->block_count; b++) {
            const YkNear *old = last_look(sim, b, &cursor);
            bool is_near = yk_has_columns(&sim->mech->blocks[b]) && s->space.block_margin[b] < NEAR_SINE2;
            if (!is_near && !old) continue;
            YkNear now = known_near(sim, &run, b, old, t);
            note_passage(sim, old, &now, t);
            if (is_near) sim->near_next[count++] = now;
        }
    YkNear *spare = sim->near;
    sim->near = sim->near_next;
    sim->near_next = spare;
    sim->near_count = count;
    sim->near_time = t;
    if (count == 0) sim->keeps_apart = false;
}

// Returns the time, in the last step, from which to predict a near block's angle at t: a little before or after.
// Returns t if it is known well enough.
static double time_to_look(const YkSimulation *sim, double t)
{
    const double SMALL = 0.05, LITTLE = 0.08; // rad
    double dt = t - sim->near_time;
    for (size_t k = 0; k < sim->near_count && !sim->keeps_apart; k++) {
        const YkNear *near = &sim->near[k];
        double way = LITTLE / fabs(near->rate + dt * near->acceleration);
        if (!(fabs(yk_sin(yk_near_angle(near, dt))) < SMALL) || !(fabs(dt) > 1.5 * way)) continue;
        return dt > 0 ? t - way : t + way;
    }
    return t;
}

void yk_simulation_look_closer(YkSimulation *sim, double t)
{
    double at = time_to_look(sim, t);
    if (at == t || yk_ode_dense(sim->ode, at, sim->looked) != YK_ODE_OK) return;
    if (!yk_simulation_stand_at(sim, at, sim->looked)) return;
    YkRun run = yk_state_run(sim->state, &sim->state->space);
    for (size_t k = 0; k < sim->near_count; k++)
        sim->near[k] = known_near(sim, &run, sim->near[k].block, &sim->near[k], at);
    sim->near_time = at;
}

// Returns how far a block's angle may go before it comes so close to a singular position that it must be watched.
static double way_left(YkDirection d)
{
    double above = d.angle < 0 ? -d.angle : YK_PI - d.angle, gap = d.rate > 0 ? above : YK_PI - above;
    if (yk_sin(gap) * yk_sin(gap) < NEAR_SINE2 && gap < 1) gap += YK_PI; // that one is watched already
    return gap - CLOSE;
}

// Returns when it will have gone that way. A drive alone may get faster without any error that the stepper would see.
static double time_left(const YkSimulation *sim, YkDirection d)
{
    double way = way_left(d), bend = sim->guide ? fabs(d.acceleration) * fmax(way, 0) : 0;
    return isfinite(bend) ? 2 * way / (fabs(d.rate) + sqrt(d.rate * d.rate + 2 * bend)) : way / fabs(d.rate);
}

// Limits the turn in a step. Now and then the error estimates of DOP853 miss a step of most of a radian with an error a
// thousand times larger than requested; half a radian at a tolerance of 1e-9 is typical of good steps of turning links.
static double longest_turn(const YkSimulation *sim)
{
    double fastest = 0;
    if (sim->options.integrator != YK_INTEGRATOR_DOP853) return HUGE_VAL;
    for (size_t k = 0; k < sim->free_count; k++) {
        bool is_distance = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].is_distance;
        if (!is_distance) fastest = fmax(fastest, fabs(sim->state->input[3 * sim->free_input[k] + 1]));
    }
    double eighth = sqrt(sqrt(sqrt(sim->options.tolerance * 1e9)));
    return fastest > 0 ? 0.5 * eighth / fastest : HUGE_VAL;
}

// Returns whether a block is so far from a singular position, at the rates that stand, that a step of `length` does not
// lead there. Does not find the angle between its columns, which is at least the root of the margin away.
static bool is_far(const YkSimulation *sim, size_t block, double length)
{
    const YkBlock *b = &sim->mech->blocks[block];
    const YkSpace *space = &sim->state->space;
    bool is_plain = b->kind == YK_BLOCK_RRR && b->arm_is_constant[0] && b->arm_is_constant[1];
    double margin = space->block_margin[block];
    if (!is_plain || !(length > 0) || margin < 1.1 * NEAR_SINE2) return false;
    double rate = yk_space_turn(space, b->column[1].index).w[0] - yk_space_turn(space, b->column[0].index).w[0];
    return sqrt(margin) - CLOSE > length * fabs(rate);
}

double yk_simulation_reach(YkSimulation *sim)
{
    double reach = HUGE_VAL, length = sim->guide ? 0 : 1.1 * yk_ode_length(sim->ode); // steps are stretched by less
    YkRun run = yk_state_run(sim->state, &sim->state->space);
    for (size_t b = 0; b < sim->mech->block_count; b++) {
        if (!yk_has_columns(&sim->mech->blocks[b]) || is_far(sim, b, length)) continue;
        YkDirection d = yk_between_columns(&run, &sim->mech->blocks[b]);
        if (d.rate != 0 && isfinite(d.rate) && isfinite(d.angle)) reach = fmin(reach, time_left(sim, d));
    }
    return fmin(fmin(reach, longest_turn(sim)), yk_simulation_reach_apart(sim));
}

void yk_simulation_set_signs(YkSimulation *sim, double t)
{
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *near = &sim->near[k];
        double angle = sim->keeps_apart ? near->angle : yk_near_angle(near, t - sim->near_time);
        sim->state->branch[near->block] = yk_sin(angle) < 0 ? -1 : 1;
    }
}
