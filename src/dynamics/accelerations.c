// Accelerations of the free inputs by the reduced equations, or why there are none.
#include <string.h>
#include "dynamics/dynamics.h"

// --- the equations

void yk_dynamics_forget_equations(YkDynamics *d)
{
    yk_influence_free(d->influence);
    yk_reduced_free(d->reduced);
    yk_elimination_free(d->elimination);
    yk_tree_dynamics_free(d->tree);
    d->influence = NULL;
    d->reduced = NULL;
    d->elimination = NULL;
    d->tree = NULL;
}

static size_t count_free(const YkDynamics *d)
{
    size_t count = 0;
    for (size_t i = 0; i < d->mech->input_count; i++) count += d->is_free[i];
    return count;
}

static bool make_elimination(YkDynamics *d, size_t free_count)
{
    d->elimination = yk_elimination_new(d->mech, d->is_free, d->loads->is_loaded);
    if (d->elimination) d->reduced = yk_reduced_new(d->elimination);
    if (!d->reduced || free_count == 0 || free_count > YK_INFLUENCE_MAX) return d->reduced != NULL;
    d->influence = yk_influence_new(d->elimination, free_count);
    return d->influence != NULL;
}

// Prepares for efforts that may act along free inputs, and between cams and followers that meet.
static void expect_loads(YkDynamics *d)
{
    const YkModel *model = d->mech->model;
    bool *is_loaded = d->loads->is_loaded;
    for (size_t i = 0; i < d->mech->input_count; i++) {
        const YkJoint *j = &model->joints[d->mech->coordinates[d->mech->inputs[i]].joint];
        if (d->is_free[i]) is_loaded[j->body[0]] = is_loaded[j->body[1]] = true;
    }
    for (size_t k = 0; d->mech->open_cams && k < model->cam_count; k++) {
        const YkCam *cam = &model->cams[k];
        if (d->mech->open_cams[k]) is_loaded[cam->cam] = is_loaded[cam->follower] = is_loaded[cam->carrier] = true;
    }
}

bool yk_dynamics_prepare(YkDynamics *d)
{
    if (!d->is_stale) return true;
    size_t free_count = count_free(d);
    // Impacts need the elimination.
    bool fits = free_count == d->mech->input_count && d->loads->handle_count == 0 && !d->mech->open_cams;
    yk_dynamics_forget_equations(d);
    d->tree = fits ? yk_tree_dynamics_new(d->mech, &fits) : NULL;
    expect_loads(d);
    bool ran_out = fits && !d->tree; // the elimination would give other bits
    d->is_stale = ran_out || (!d->tree && !make_elimination(d, free_count));
    return !d->is_stale;
}

// --- failures

static void append(char *message, size_t capacity, const char *part)
{
    size_t at = strlen(message);
    for (; *part && at + 1 < capacity; part++) message[at++] = *part;
    message[at] = 0;
}

YkStatus yk_dynamics_fail(YkDynamics *d, YkStatus status, const char *head, const char *name, const char *tail)
{
    d->report = (YkReport){.status = status, .block = -1, .joint = -1};
    d->ran_out |= status == YK_NO_MEMORY;
    const char *parts[] = {head, name, tail};
    for (int k = 0; k < 3; k++) append(d->report.message, sizeof d->report.message, parts[k]);
    return status;
}

YkStatus yk_dynamics_fail_at_input(YkDynamics *d, int input)
{
    if (input < 0) return yk_dynamics_fail(d, YK_SINGULAR, "a dead point: a group of links is singular here", "", "");
    const YkTreeCoordinate *c = &d->mech->coordinates[d->mech->inputs[input]];
    const YkJoint *j = &d->mech->model->joints[c->joint];
    yk_dynamics_fail(d, YK_SINGULAR, "no inertia resists `", c->name, "`: give mass or inertia to body `");
    append(d->report.message, sizeof d->report.message, d->mech->model->bodies[j->body[j->body[1] == 0 ? 0 : 1]].name);
    append(d->report.message, sizeof d->report.message, "` or to what moves with it");
    return YK_SINGULAR;
}

YkStatus yk_dynamics_fail_at_load(YkDynamics *d, size_t item)
{
    return yk_dynamics_fail(d, YK_NOT_CONVERGED, "the load `", d->loads->items[item].name,
                            "` has no finite value at this pose and time");
}

// --- accelerations

YkStatus yk_dynamics_reduce_tree(YkDynamics *d, const YkState *state, double *accelerations)
{
    size_t culprit, n = d->mech->input_count;
    for (size_t i = 0; i < n; i++) {
        d->q[i] = state->input[3 * i];
        d->v[i] = state->input[3 * i + 1];
    }
    bool has_efforts = d->loads->item_count > 0;
    if (has_efforts && !yk_loads_efforts(d->loads, state, d->v, d->effort, d->power, &culprit))
        return yk_dynamics_fail_at_load(d, culprit);
    int bad = yk_tree_accelerate(d->tree, d->q, d->v, has_efforts ? d->effort : NULL, accelerations);
    return bad < 0 ? YK_OK : yk_dynamics_fail_at_input(d, bad);
}

// Solves the pose with the free inputs' accelerations 0; *loads on every body is NULL, or in d->load.
static YkStatus stand(YkDynamics *d, YkState *state, const YkLoad **loads)
{
    for (size_t i = 0; i < d->mech->input_count; i++) {
        if (d->is_free[i]) state->input[3 * i + 2] = 0;
        d->acceleration[i] = state->input[3 * i + 2];
    }
    YkStatus status = yk_state_solve(state);
    if (status < 0 || !state->has_rates) {
        d->report = state->report;
        return status;
    }
    *loads = NULL;
    if (d->loads->item_count + d->loads->handle_count == 0) return status;
    size_t culprit;
    memset(d->load, 0, d->mech->model->body_count * sizeof *d->load);
    if (!yk_loads_add(d->loads, state, &state->space, d->load, d->power, &culprit))
        return yk_dynamics_fail_at_load(d, culprit);
    *loads = d->load;
    return status;
}

YkStatus yk_dynamics_reduce(YkDynamics *d, YkState *state)
{
    const YkLoad *loads;
    if (!yk_dynamics_prepare(d)) return yk_dynamics_fail(d, YK_NO_MEMORY, "out of memory", "", "");
    if (d->tree) return yk_dynamics_reduce_tree(d, state, d->acceleration);
    YkStatus status = stand(d, state, &loads);
    if (status < 0 || !state->has_rates) return status;
    int bad = yk_reduced_factor(d->reduced, &state->space, loads);
    if (bad != -1) return yk_dynamics_fail_at_input(d, bad);
    yk_reduced_solve(d->reduced, d->acceleration, false);
    return status;
}

YkStatus yk_dynamics_find_accelerations(YkDynamics *d, YkState *state)
{
    const YkLoad *loads;
    if (!yk_dynamics_prepare(d)) return yk_dynamics_fail(d, YK_NO_MEMORY, "out of memory", "", "");
    if (!d->influence) return yk_dynamics_reduce(d, state);
    YkStatus status = stand(d, state, &loads);
    if (status < 0 || !state->has_rates) return status;
    int bad = yk_influence_accelerate(d->influence, state, loads, d->loads->is_loaded, d->acceleration);
    return bad == -1 ? status : yk_dynamics_fail_at_input(d, bad);
}
