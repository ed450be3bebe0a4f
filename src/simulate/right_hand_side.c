// The right-hand side: rates and accelerations of the independent coordinates, and the present pose with them.
#include <string.h>
#include "simulate/crossing.h"

// Evaluates an open tree, which needs no pose.
static int move_lean(YkSimulation *sim, double t, const double *y, double *dydt)
{
    YkDynamics *d = sim->dynamics;
    size_t n = sim->free_count, culprit;
    for (size_t k = 0; k < n; k++) dydt[k] = y[n + k];
    dydt[2 * n + sim->work_count - 1] = 0;
    if (sim->item_count > 0) {
        if (d->loads->varies || !sim->is_lean) yk_simulation_set(sim, t, y);
        if (!yk_loads_efforts(d->loads, sim->state, y + n, d->effort, dydt + 2 * n, &culprit)) {
            yk_dynamics_fail_at_load(d, culprit);
            sim->report = d->report;
            return 1;
        }
    }
    int failed = yk_tree_accelerate(d->tree, y, y + n, sim->item_count > 0 ? d->effort : NULL, dydt + n);
    if (failed < 0) return 0;
    yk_dynamics_fail_at_input(d, failed);
    sim->report = d->report;
    return 1;
}

int yk_simulation_motion(void *context, double t, const double *y, double *dydt)
{
    YkSimulation *sim = context;
    size_t n = sim->free_count;
    if (sim->dynamics->tree && sim->contact_count == 0 && !sim->dynamics->loads->has_dry)
        return move_lean(sim, t, y, dydt);
    if (sim->guide && yk_simulation_moves_with_guide(sim, t, dydt, true)) return 0;
    if (sim->near_count > 0 && yk_simulation_in_zone(sim, t)) {
        YkInterpolation found = yk_simulation_interpolate(sim, t, y, dydt);
        // A drive that turns back so near to a limit leaves no poses on both sides to interpolate between.
        if (found == YK_INTERPOLATION_FAILED && sim->guide && yk_simulation_moves_with_guide(sim, t, dydt, false))
            return 0;
        if (found != YK_INTERPOLATION_LEFT) return found == YK_INTERPOLATION_DONE ? 0 : 1;
    }
    if (!yk_simulation_set(sim, t, y)) return 1;
    YkStatus status = yk_simulation_accelerate(sim);
    if (status < 0 || status == YK_SINGULAR) {
        sim->report = sim->dynamics->report;
        return 1;
    }
    memcpy(dydt, y + n, n * sizeof *dydt);
    for (size_t k = 0; k < n; k++) dydt[n + k] = sim->dynamics->acceleration[sim->free_input[k]];
    yk_simulation_powers(sim, dydt + 2 * n);
    return 0;
}

bool yk_simulation_stand_at(YkSimulation *sim, double t, const double *y)
{
    YkState *s = sim->state;
    size_t n = sim->free_count;
    double *rate = sim->rate;
    if (sim->guide && yk_simulation_stands_with_guide(sim, t, true)) return true;
    bool ok = yk_simulation_motion(sim, t, y, rate) == 0;
    bool is_summed = ok && yk_simulation_sum_poses(sim, t, y, rate + n);
    ok = yk_simulation_set(sim, t, y) && ok;
    for (size_t k = 0; k < n; k++) s->input[3 * sim->free_input[k] + 2] = rate[n + k];
    YkStatus status = yk_state_solve(s);
    if (status >= 0 && is_summed) ok = yk_simulation_take_sum(sim) && ok;
    if (ok && status >= 0) return true;
    if (sim->guide && yk_simulation_stands_with_guide(sim, t, false)) return true;
    sim->status = status < 0 ? status : YK_NOT_CONVERGED;
    if (status < 0) sim->report = s->report;
    return false;
}
