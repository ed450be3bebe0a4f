// Solves a pose for accelerations, or for all forces: with the present values, and dry friction that slides or holds.
#include <string.h>
#include "dynamics/holding.h"

YkStatus yk_dynamics_accelerate(YkDynamics *d, YkState *state, double *accelerations)
{
    if (!yk_dynamics_follow(d)) return yk_dynamics_fail(d, YK_NO_MEMORY, "out of memory", "", "");
    if (!d->is_stale && d->tree) return yk_dynamics_reduce_tree(d, state, accelerations);
    YkStatus status = yk_dynamics_find_accelerations(d, state);
    if (status >= 0) memcpy(accelerations, d->acceleration, d->mech->input_count * sizeof *accelerations);
    return status;
}

// Solves with all joints with dry friction sliding, repeatedly until the friction settles.
static YkStatus solve_sliding(YkDynamics *d, YkState *state, YkMethod method)
{
    for (int round = 0; round < YK_DRY_ROUNDS; round++) {
        YkStatus status = yk_dynamics_solve_once(d, state, method);
        if (status < 0) return round > 0 ? yk_dynamics_fail_at_dry(d) : status;
        if (status == YK_SINGULAR || !d->loads->has_dry || yk_dynamics_find_dry(d, state, round)) return status;
    }
    return yk_dynamics_fail_at_dry(d);
}

// Returns whether joints with dry friction are at rest at the state's inputs.
static bool stands_dry(YkDynamics *d, YkState *state)
{
    if (!d->holding) return false;
    yk_holding_clear(d->holding);
    return yk_state_solve_unless_clear(state) >= 0 && state->has_rates && yk_holding_is_needed(d->holding, d, state);
}

YkStatus yk_dynamics_solve(YkDynamics *d, YkState *state, YkMethod method)
{
    if (!yk_dynamics_follow(d)) return yk_dynamics_fail(d, YK_NO_MEMORY, "out of memory", "", "");
    if (yk_state_has_limits(state)) // they stay
        return yk_dynamics_fail(d, YK_CHANGE_POINT, "a change point: the pose does not determine the forces", "", "");
    YkStatus status =
        stands_dry(d, state) ? yk_holding_find(d->holding, d, state, method) : solve_sliding(d, state, method);
    if (status == YK_SINGULAR && d->report.status != YK_SINGULAR)
        yk_dynamics_fail(d, YK_SINGULAR, "a dead point: forces are not determined", "", "");
    return status;
}
