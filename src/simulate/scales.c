// Scales of a simulation: those of its inputs, energies and rates, and how near it is to a limit.
#include <math.h>
#include "simulate/simulation.h"

double yk_simulation_input_scale(const YkSimulation *sim, size_t free)
{
    return yk_input_unit(sim->mech, (size_t)sim->free_input[free]);
}

double yk_simulation_margin(const YkSimulation *sim)
{
    return sim->state->space.margin[0];
}

double yk_simulation_energy_scale(const YkSimulation *sim)
{
    double inertia = 0;
    for (size_t b = 1; b < sim->model->body_count; b++)
        inertia += sim->model->bodies[b].mass * sim->mech->size * sim->mech->size + sim->model->bodies[b].inertia;
    return inertia > 0 ? inertia : 1;
}

// Returns the rate of the fastest of the free inputs, at a state of the stepper.
static double fastest_of(const YkSimulation *sim, const double *y)
{
    double fastest = 0;
    for (size_t k = 0; k < sim->free_count; k++)
        fastest = fmax(fastest, fabs(y[sim->free_count + k]) / yk_simulation_input_scale(sim, k));
    return fastest;
}

double yk_simulation_rate_floor(const YkSimulation *sim)
{
    return 1e-8 * fmax(1e-3 * sim->pace, fastest_of(sim, sim->y));
}

void yk_simulation_take_pace(YkSimulation *sim)
{
    sim->pace = fmax(sim->pace, fastest_of(sim, yk_ode_state(sim->ode)));
    yk_ode_set_pace(sim->ode, 0.1 * sim->pace);
}
