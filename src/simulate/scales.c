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

double yk_simulation_rate_floor(const YkSimulation *sim)
{
    double fastest = 0;
    for (size_t k = 0; k < sim->free_count; k++) {
        bool is_distance = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].is_distance;
        fastest =
            fmax(fastest, fabs(sim->state->input[3 * sim->free_input[k] + 1]) / (is_distance ? sim->mech->size : 1));
    }
    return 1e-8 * fmax(1e-3, fastest);
}
