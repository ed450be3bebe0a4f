// A stage of the stepper: the inputs of the state, with the branches of near blocks, and the power of every load.
#include <string.h>
#include "elementary/elementary.h"
#include "simulate/crossing.h"

// Sets the branches of near blocks, as predicted for time t.
static void set_signs(YkSimulation *sim, double t)
{
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *near = &sim->near[k];
        double angle = sim->keeps_apart ? near->angle : yk_near_angle(near, t - sim->near_time);
        sim->state->branch[near->block] = yk_sin(angle) < 0 ? -1 : 1;
    }
}

bool yk_simulation_set(YkSimulation *sim, double t, const double *y)
{
    YkState *s = sim->state;
    bool ok = true;
    if (sim->has_drives)
        ok = yk_simulation_set_time(sim, s, t, NULL) >= 0;
    else
        s->time = t;
    for (size_t k = 0; k < sim->free_count; k++) {
        double *input = s->input + 3 * sim->free_input[k];
        input[0] = y[k];
        input[1] = y[sim->free_count + k];
        input[2] = 0;
    }
    if (sim->near_count > 0) set_signs(sim, t);
    return ok;
}

void yk_simulation_powers(YkSimulation *sim, double *power)
{
    YkDynamics *d = sim->dynamics;
    power[sim->work_count - 1] = 0; // stops take energy only in impacts
    if (sim->options.pulls > 0) power[sim->work_count - 2] = d->loads->handle_power;
    if (sim->item_count > 0) memcpy(power, d->power, sim->item_count * sizeof *power);
    if (!sim->has_drives) return;
    // The reduced equations then lack the efforts of contacts.
    bool by_bodies = sim->contact_count > 0 || d->loads->has_dry;
    if (by_bodies && !d->loads->has_dry) yk_dynamics_apply(d, sim->state);
    if (!by_bodies) yk_reduced_solve(d->reduced, d->acceleration, true);
    size_t at = sim->item_count;
    for (size_t i = 0; i < sim->mech->input_count; i++) {
        if (d->is_free[i]) continue;
        double effort = by_bodies ? d->drive[i] : yk_reduced_effort(d->reduced, i);
        power[at++] = effort * sim->state->input[3 * i + 1];
    }
}
