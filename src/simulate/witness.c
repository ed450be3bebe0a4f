// The witness of a simulation: it receives the poses at the ends of steps, at events and at rows, and refuses what
// cannot be the same configuration.
#include "simulate/simulation.h"

static const char *const jumped = "the motion is proved to have gone over to another configuration; a smaller "
                                  "tolerance, or step, may keep it from that";

void yk_simulation_set_certifier(YkSimulation *sim, YkCertifier *certifier)
{
    sim->witness = (YkWitness *)certifier; // which begins with one
    if (sim->has_begun) yk_simulation_tell_start(sim, NULL);
}

// Keeps the present pose, which is proved.
static void keep_home(YkSimulation *sim)
{
    if (!sim->mech->has_groups) return;
    if (!sim->home) sim->home = yk_state_new(sim->mech);
    if (sim->home) yk_state_take(sim->home, sim->state);
    if (!sim->home) yk_arena_fail(sim->arena);
}

void yk_simulation_tell_start(YkSimulation *sim, const YkState *from)
{
    if (!sim->witness) return;
    sim->witness->change(sim->witness, from, sim->state);
    keep_home(sim); // the first step may have to be taken back too
}

static bool refuse(YkSimulation *sim)
{
    yk_dynamics_fail(sim->dynamics, YK_NOT_CONVERGED, jumped, "", "");
    sim->report = sim->dynamics->report;
    sim->status = YK_NOT_CONVERGED;
    return false;
}

bool yk_simulation_tell(YkSimulation *sim, YkWitnessed kind)
{
    if (!sim->witness) return true;
    if (!sim->witness->step(sim->witness, sim->state, kind)) return refuse(sim);
    if (kind == YK_WITNESS_STEP) keep_home(sim);
    return true;
}

// Returns whether the state has the pose at the end of the last step, as the last evaluation usually leaves it.
static bool is_at_end(const YkSimulation *sim)
{
    const double *y = yk_ode_state(sim->ode);
    for (size_t k = 0; k < sim->free_count; k++)
        if (sim->state->valid_input[3 * sim->free_input[k]] != y[k]) return false;
    return sim->state->time == yk_ode_time(sim->ode);
}

bool yk_simulation_has_jumped(YkSimulation *sim)
{
    if (!sim->witness || !sim->mech->has_groups || !is_at_end(sim)) return false;
    if (!sim->witness->step(sim->witness, sim->state, YK_WITNESS_TRY)) return true;
    if (yk_ode_time(sim->ode) >= sim->redo_until) sim->redone = 0;
    keep_home(sim);
    return false;
}

bool yk_simulation_go_home(YkSimulation *sim)
{
    enum { TRIALS = 5 };
    double from = yk_ode_previous(sim->ode), to = yk_ode_time(sim->ode);
    if (!sim->home || ++sim->redone > TRIALS) return yk_simulation_tell(sim, YK_WITNESS_STEP);
    sim->redo_step = 0.125 * (to - from);
    sim->redo_until = to;
    if (yk_ode_dense(sim->ode, from, sim->y) != YK_ODE_OK) return false;
    yk_state_take(sim->state, sim->home);
    return yk_simulation_pose(sim, from, sim->y);
}
