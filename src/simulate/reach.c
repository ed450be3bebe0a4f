// How long a step may be: no block that is not watched may reach a singular position in it, and no link turn too far.
#include "elementary/elementary.h"
#include "simulate/crossing.h"

#define CLOSE 0.12 // rad from a singular position, inside the watched zone

// Returns how far a block's angle may go before it comes so close to a singular position that it must be watched.
static double way_left(YkDirection d)
{
    double above = d.angle < 0 ? -d.angle : YK_PI - d.angle, gap = d.rate > 0 ? above : YK_PI - above;
    if (yk_sin(gap) * yk_sin(gap) < YK_NEAR_SINE2 && gap < 1) gap += YK_PI; // that one is watched already
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
    if (!is_plain || !(length > 0) || margin < 1.1 * YK_NEAR_SINE2) return false;
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
