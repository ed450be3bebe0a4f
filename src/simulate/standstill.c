// Explains a failure: the pose at which the motion stopped, and why no step was small enough.
#include <math.h>
#include <string.h>
#include "base/text.h"
#include "simulate/simulation.h"

void yk_simulation_stand_still(YkSimulation *sim)
{
    size_t n = sim->free_count;
    sim->has_forces = false;
    if (!sim->state || !sim->y) return;
    yk_simulation_set(sim, sim->time, sim->y);
    bool has_rate = sim->ode && yk_ode_time(sim->ode) == sim->time;
    for (size_t k = 0; k < n && has_rate; k++)
        sim->state->input[3 * sim->free_input[k] + 2] = yk_ode_rate(sim->ode)[n + k];
    if (yk_state_solve(sim->state) >= 0) yk_state_refer(sim->state);
    memcpy(sim->work, sim->y + 2 * n, sim->work_count * sizeof *sim->work);
}

// --- the reason

static const double NEAR = YK_PI / 180; // transmission angle, rad

// Returns the block nearest to a dead point, if it is near; or -1.
static int block_near_dead_point(const YkSimulation *sim, double *angle)
{
    int nearest = -1;
    *angle = NEAR;
    for (size_t b = 0; b < yk_block_count(sim->mech); b++) {
        double own = yk_state_transmission(sim->state, b);
        if (yk_state_branch(sim->state, b) == 0 || !(own < *angle)) continue;
        *angle = own;
        nearest = (int)b;
    }
    return nearest;
}

// Returns the coordinate whose rate is largest, in radians or in machine sizes per second.
static size_t fastest(const YkSimulation *sim)
{
    double most = 0, size = yk_mechanism_size(sim->mech);
    size_t found = 0;
    for (size_t c = 0; c < yk_coordinate_count(sim->mech); c++) {
        double rate = fabs(yk_state_coordinate(sim->state, c).velocity);
        if (yk_coordinate_info(sim->mech, c).is_distance) rate /= size > 0 ? size : 1;
        if (!(rate > most)) continue;
        most = rate;
        found = c;
    }
    return found;
}

void yk_simulation_explain(YkSimulation *sim)
{
    YkText text = {0};
    double angle;
    int block = block_near_dead_point(sim, &angle);
    bool is_near = block >= 0;
    if (is_near) {
        yk_text_format(&text,
                       "no step is small enough so near to a dead point: joint %q has a transmission angle of %e deg",
                       yk_block_info(sim->mech, (size_t)block).label, angle * 180 / YK_PI);
    } else if (yk_coordinate_count(sim->mech) > 0) {
        size_t c = fastest(sim);
        YkCoordinateInfo info = yk_coordinate_info(sim->mech, c);
        yk_text_format(&text,
                       "the step size fell below 1e-14 of the span: something changes too fast (%q moves at %e %s)",
                       info.name, yk_state_coordinate(sim->state, c).velocity, info.is_distance ? "m/s" : "rad/s");
    }
    yk_dynamics_fail(sim->dynamics, is_near ? YK_SINGULAR : sim->status, yk_text_get(&text), "", "");
    sim->report = sim->dynamics->report;
    sim->report.block = block;
    yk_text_free(&text);
}
