// Shared by the equations of one derivation: poses of the machine and of others, points of the field. It is valid as
// long as equations start at the same state; the derivation owns it.
#include <stdlib.h>
#include <string.h>
#include "prove/check_inside.h"
#include "solve/state.h"

// Frees what checks have found out about the machine and keep for others; yk_derivation_free calls it.
static void forget(YkDerivation *d)
{
    YkCheckShared *shared = d->checked;
    if (!shared) return;
    yk_check_free_poses(&shared->poses);
    yk_check_free_points(&shared->points);
    yk_check_free_points(&shared->bound);
    yk_field_points_free(shared->anywhere);
    yk_check_free_variants(shared->variants);
    yk_state_free(shared->start);
    free(shared->is_prescribed);
    free(shared);
    d->checked = NULL;
}

static bool is_same(const double *a, const double *b, size_t count)
{
    return count == 0 || memcmp(a, b, count * sizeof *a) == 0;
}

// Compares bit for bit: inputs, time and everything from which solving starts.
static bool is_same_state(const YkState *a, const YkState *b)
{
    const YkMechanism *mech = a->mech;
    return mech == b->mech && a->time == b->time && is_same(a->guess, b->guess, mech->coordinate_count) &&
           is_same(a->input, b->input, 3 * mech->input_count) &&
           is_same(a->reference, b->reference, mech->coordinate_count) &&
           is_same(a->slot_reference, b->slot_reference, mech->reference_count) &&
           memcmp(a->branch, b->branch, mech->block_count) == 0 &&
           is_same(a->groups.x, b->groups.x, mech->column_count);
}

static bool is_same_dynamics(const YkCheckShared *shared, const YkDynamics *dynamics, size_t inputs)
{
    if (shared->dynamics != dynamics) return false;
    for (size_t i = 0; dynamics && i < inputs; i++)
        if (shared->is_prescribed[i] != yk_dynamics_is_prescribed(dynamics, i)) return false;
    return true;
}

static YkCheckShared *begin(YkDerivation *d, const YkState *state, const YkDynamics *dynamics)
{
    enum { SEED = 2024, SEED_ANYWHERE = 17 };
    size_t inputs = d->mech->input_count;
    YkCheckShared *shared = yk_derive_scratch(d, 1, sizeof *shared);
    if (!shared) return NULL;
    shared->start = yk_state_new(d->mech);
    shared->is_prescribed = yk_derive_scratch(d, inputs + 1, sizeof *shared->is_prescribed);
    shared->anywhere = yk_field_points_new(d->ring, SEED_ANYWHERE);
    shared->dynamics = dynamics;
    shared->poses.seed = SEED;
    for (size_t i = 0; dynamics && shared->is_prescribed && i < inputs; i++)
        shared->is_prescribed[i] = yk_dynamics_is_prescribed(dynamics, i);
    if (shared->start) yk_state_copy(shared->start, state);
    return shared;
}

YkCheckShared *yk_check_share(YkDerivation *d, const YkState *state, const YkDynamics *dynamics)
{
    YkCheckShared *shared = d->checked;
    if (shared && is_same_state(shared->start, state) && is_same_dynamics(shared, dynamics, d->mech->input_count))
        return shared;
    forget(d);
    d->checked = begin(d, state, dynamics);
    d->forget_checks = forget;
    shared = d->checked;
    if (!shared || (shared->start && shared->is_prescribed && shared->anywhere)) return shared;
    forget(d);
    return NULL;
}
