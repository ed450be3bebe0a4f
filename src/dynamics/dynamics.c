// Makes the dynamics of a mechanism, and takes what the caller sets.
#include "dynamics/dynamics.h"
#include <stdlib.h>
#include "base/problems.h"
#include "compile/variant.h"
#include "dynamics/holding.h"

// --- making

static bool allocate(YkDynamics *d)
{
    size_t inputs = d->mech->input_count + 1, bodies = d->mech->model->body_count;
    YkArena *a = d->arena = yk_arena_new();
    d->is_free = yk_arena_alloc(a, 2 * inputs, sizeof *d->is_free);
    d->q = yk_arena_alloc(a, 5 * inputs, sizeof *d->q);
    d->loads = yk_loads_new(d->mech);
    d->bodies = yk_free_bodies_new(d->mech);
    d->load = yk_arena_alloc(a, 2 * bodies, sizeof *d->load);
    d->motion = yk_arena_alloc(a, bodies, sizeof *d->motion);
    d->joint = yk_arena_alloc(a, d->mech->model->joint_count + 1, sizeof *d->joint);
    d->whole = yk_arena_alloc(a, d->mech->model->joint_count + 1, sizeof *d->whole);
    d->contact = yk_arena_alloc(a, d->mech->relation_count + 1, sizeof *d->contact);
    d->power = d->loads ? calloc(d->loads->item_count + d->mech->coordinate_count + 1, sizeof *d->power) : NULL;
    if (yk_arena_failed(a) || !d->loads || !d->bodies || !d->power) return false;
    if (d->loads->has_dry && !(d->holding = yk_holding_new(d))) return false;
    d->prescribed = d->is_free + inputs;
    d->v = d->q + inputs;
    d->effort = d->v + inputs;
    d->acceleration = d->effort + inputs;
    d->drive = d->acceleration + inputs;
    d->reaction = d->load + bodies;
    return true;
}

YkDynamics *yk_dynamics_new(const YkMechanism *mech, YkProblems *problems)
{
    YkDynamics *d = calloc(1, sizeof *d);
    if (d) d->mech = mech;
    if (d && mech->variant) d->changes = mech->variant->changes;
    if (!d || !allocate(d)) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing the dynamics");
        yk_dynamics_free(d);
        return NULL;
    }
    for (size_t b = 1; b < mech->model->body_count; b++) d->has_mass = d->has_mass || mech->model->bodies[b].has_mass;
    for (size_t i = 0; i < mech->input_count; i++)
        d->is_free[i] = d->has_mass && mech->coordinates[mech->inputs[i]].drive == YK_NONE;
    d->is_stale = true;
    return d;
}

// Forgets everything that depends on the choice of free inputs.
void yk_dynamics_free(YkDynamics *d)
{
    if (!d) return;
    yk_loads_free(d->loads);
    yk_dynamics_forget_equations(d);
    yk_holding_free(d->holding);
    yk_free_bodies_free(d->bodies);
    yk_arena_free(d->arena);
    free(d->power);
    free(d);
}

bool yk_dynamics_has_loads(const YkDynamics *d)
{
    return d->has_mass || d->loads->item_count > 0;
}

void yk_dynamics_prescribe(YkDynamics *d, size_t input, bool is_prescribed)
{
    if (input >= d->mech->input_count) return;
    if (d->is_free[input] == !is_prescribed) return;
    d->is_free[input] = !is_prescribed;
    d->is_stale = true;
}

bool yk_dynamics_is_prescribed(const YkDynamics *d, size_t input)
{
    if (input >= d->mech->input_count) return false;
    return !d->is_free[input];
}

void yk_dynamics_set_effort(YkDynamics *d, size_t coordinate, double effort)
{
    if (coordinate >= d->mech->coordinate_count) return;
    if (yk_loads_set_effort(d->loads, coordinate, effort)) d->is_stale = true;
}

const YkReport *yk_dynamics_report(const YkDynamics *d)
{
    return &d->report;
}
