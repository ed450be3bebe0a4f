// Singular positions that the motion passes: which blocks are watched, the branch that momentum takes, the passage.
#include "simulate/crossing.h"
#include "elementary/elementary.h"

#define BLIND 1e-4 // sine below which the pose does not determine its own rates well enough

// Returns a block as it was at the last look, or NULL. Both lists ascend by block: `cursor` follows.
static const YkNear *last_look(const YkSimulation *sim, size_t block, size_t *cursor)
{
    while (*cursor < sim->near_count && sim->near[*cursor].block < block) ++*cursor;
    return *cursor < sim->near_count && sim->near[*cursor].block == block ? &sim->near[*cursor] : NULL;
}

// Keeps the prediction where the pose itself does not decide.
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
    if (s->space.margin[0] < YK_NEAR_SINE2 || sim->near_count > 0)
        for (size_t b = 0; b < sim->mech->block_count; b++) {
            const YkNear *old = last_look(sim, b, &cursor);
            bool is_near = yk_has_columns(&sim->mech->blocks[b]) && s->space.block_margin[b] < YK_NEAR_SINE2;
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

// Looks at near blocks again a little before a pose within the last step, or at its end, if it lies so near to a
// singular position that the prediction from the step's start may have the wrong sign.
static void look_closer(YkSimulation *sim, double t)
{
    double at = time_to_look(sim, t);
    if (at == t || yk_ode_dense(sim->ode, at, sim->looked) != YK_ODE_OK) return;
    if (!yk_simulation_stand_at(sim, at, sim->looked)) return;
    YkRun run = yk_state_run(sim->state, &sim->state->space);
    for (size_t k = 0; k < sim->near_count; k++)
        sim->near[k] = known_near(sim, &run, sim->near[k].block, &sim->near[k], at);
    sim->near_time = at;
}

bool yk_simulation_pose(YkSimulation *sim, double t, const double *y)
{
    if (sim->near_count > 0) look_closer(sim, t);
    if (!yk_simulation_stand_at(sim, t, y)) return false;
    if (sim->state->has_rates) yk_state_refer(sim->state); // where branches meet, an angle may be any
    sim->time = t;
    sim->has_forces = false;
    return true;
}
