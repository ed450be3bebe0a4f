// The results of a simulation: the present pose, happenings, energies and works.
#include "simulate/simulation.h"

double yk_simulation_time(const YkSimulation *sim)
{
    return sim->time;
}
YkState *yk_simulation_state(YkSimulation *sim)
{
    return sim->state;
}
const YkReport *yk_simulation_report(const YkSimulation *sim)
{
    return &sim->report;
}

YkDynamics *yk_simulation_dynamics(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    if (sim->has_forces) return d;
    for (size_t k = 0; k < sim->free_count; k++)
        d->acceleration[sim->free_input[k]] = sim->state->input[3 * sim->free_input[k] + 2];
    YkStatus status = yk_dynamics_apply(d, sim->state);
    d->ran_out |= status == YK_NO_MEMORY;
    sim->has_forces = true;
    sim->forces_are_known = status >= 0 && status != YK_SINGULAR;
    return d;
}

// Returns whether a channel is known. On a change point itself the loops do not give the rates; those of the inputs are
// known, and at the start the kinetic energy.
static bool is_known(const YkSimulation *sim, YkChannel channel)
{
    bool is_energy = channel.kind >= YK_CHANNEL_ENERGY && channel.kind <= YK_CHANNEL_POTENTIAL;
    if (sim->state->has_rates || channel.kind == YK_CHANNEL_TIME || (is_energy && sim->is_flat)) return true;
    bool is_input = channel.kind == YK_CHANNEL_COORDINATE && sim->mech->coordinates[channel.index].input != YK_NONE;
    return is_input || (channel.order == 0 && channel.kind < YK_CHANNEL_POINT_SPEED) ||
           channel.kind == YK_CHANNEL_TRANSMISSION;
}

static YkEnergy energy_here(const YkSimulation *sim)
{
    YkEnergy e = yk_dynamics_energy_at(sim->dynamics, sim->state);
    if (sim->is_flat && !sim->state->has_rates && sim->time == sim->options.start) e.kinetic = sim->flat_kinetic;
    return e;
}

double yk_simulation_channel(YkSimulation *sim, YkChannel channel)
{
    bool is_gone = channel.kind == YK_CHANNEL_TRANSMISSION && (size_t)channel.index >= sim->mech->block_count;
    if (is_gone) return 0; // other coordinates make other blocks
    if (!is_known(sim, channel)) return (double)NAN;
    if (!yk_channel_needs_forces(channel)) return yk_state_channel(sim->state, channel);
    if (channel.kind >= YK_CHANNEL_ENERGY && channel.kind <= YK_CHANNEL_POTENTIAL) {
        YkEnergy e = energy_here(sim);
        return (channel.kind != YK_CHANNEL_POTENTIAL ? e.kinetic : 0) +
               (channel.kind != YK_CHANNEL_KINETIC ? e.potential : 0);
    }
    const YkDynamics *dynamics = yk_simulation_dynamics(sim);
    return sim->forces_are_known ? yk_dynamics_channel(dynamics, sim->state, channel) : (double)NAN;
}

size_t yk_simulation_happening_count(const YkSimulation *sim)
{
    return sim->happening_count;
}
YkHappening yk_simulation_happening(const YkSimulation *sim, size_t index)
{
    if (index >= sim->happening_count) return (YkHappening){.time = (double)NAN, .value = (double)NAN};
    return sim->happenings[index];
}

// --- energies and works

void yk_simulation_count_energy(YkSimulation *sim)
{
    YkEnergy e = energy_here(sim);
    YkSimulationSummary *s = &sim->summary;
    double total = e.kinetic + e.potential, works = 0;
    for (size_t k = 0; k < sim->work_count; k++) works += sim->work[k];
    if (!sim->has_energy) {
        s->energy_start = total;
        sim->energy_low = sim->energy_high = e.potential;
        sim->has_energy = true;
    }
    s->energy_end = total;
    sim->energy_low = fmin(sim->energy_low, e.potential);
    sim->energy_high = fmax(sim->energy_high, e.potential);
    sim->kinetic_high = fmax(sim->kinetic_high, e.kinetic);
    sim->energy_off = fmax(sim->energy_off, fabs(total - s->energy_start - works));
    s->worst_residual = fmax(s->worst_residual, yk_state_gap(sim->state));
}

static double energy_span(const YkSimulation *sim)
{
    return sim->kinetic_high + (sim->energy_high - sim->energy_low);
}

bool yk_simulation_has_lost_energy(const YkSimulation *sim)
{
    double most = fmax(1e-3, 1e3 * sim->options.tolerance) * energy_span(sim);
    double rounding = 1e-6 * yk_simulation_energy_scale(sim); // a machine that has hardly begun to move
    return sim->options.integrator != YK_INTEGRATOR_RK4 && sim->energy_off > fmax(most, rounding);
}

YkSimulationSummary yk_simulation_summary(const YkSimulation *sim)
{
    YkSimulationSummary s = sim->summary;
    YkOdeCounts c = sim->ode ? yk_ode_counts(sim->ode) : (YkOdeCounts){0};
    s.steps = c.steps + sim->counts.steps;
    s.rejected = c.rejected + sim->counts.rejected;
    s.evaluations = c.evaluations + sim->counts.evaluations;
    double span = energy_span(sim);
    s.energy_error = span > 0 ? sim->energy_off / span : sim->energy_off;
    return s;
}

// Returns the number of works. Works that only change the potential are left out: the first `item_count` may take or
// give energy.
size_t yk_simulation_work_count(const YkSimulation *sim)
{
    return sim->work_count;
}

const char *yk_simulation_work_name(const YkSimulation *sim, size_t index)
{
    if (index >= sim->work_count) return NULL;
    if (index < sim->item_count) return sim->dynamics->loads->items[index].name;
    if (index + 1 == sim->work_count) return "stops";
    if (sim->options.pulls > 0 && index + 2 == sim->work_count) return "pulls";
    size_t at = sim->item_count;
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (!sim->dynamics->is_free[i] && at++ == index) return sim->mech->coordinates[sim->mech->inputs[i]].name;
    return "";
}

double yk_simulation_work(const YkSimulation *sim, size_t index)
{
    return index < sim->work_count ? sim->work[index] : (double)NAN;
}
