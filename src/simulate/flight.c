// Followers that leave their cams, fly free, and land.
//
// A follower in flight is another machine, with one freedom more: the cam's relation is left out, and the independent
// coordinates change as they do near a dead point. In contact the relation closes again, so that nothing drifts.
#include <stdlib.h>
#include "simulate/crossing.h"

bool yk_simulation_is_loose(const YkSimulation *sim, size_t cam)
{
    return yk_dynamics_loose_cam(sim->dynamics, yk_contact_of_cam(sim->mech, cam)) != NULL;
}

double yk_simulation_pull(YkSimulation *sim, size_t cam)
{
    const YkDynamics *dynamics = yk_simulation_dynamics(sim);
    return sim->forces_are_known ? yk_dynamics_contact_pull(dynamics, yk_contact_of_cam(sim->mech, cam)) : 0;
}

// Finds the way in which the follower's coordinate goes as the follower leaves, from the place of contact.
static double way_of(YkSimulation *sim, size_t index)
{
    const YkCam *cam = &sim->model->cams[index];
    if (!cam->oscillates) return 1;
    const YkDynamics *d = yk_simulation_dynamics(sim);
    YkReaction touch = yk_dynamics_contact(d, yk_contact_of_cam(sim->mech, index));
    YkReaction shaft = yk_dynamics_reaction(d, (size_t)cam->cam_joint);
    YkReaction pivot = yk_dynamics_reaction(d, (size_t)cam->follower_joint);
    YkVec outwards = yk_vec(touch.at[0] - shaft.at[0], touch.at[1] - shaft.at[1]);
    YkVec arm = yk_vec(touch.at[0] - pivot.at[0], touch.at[1] - pivot.at[1]);
    bool is_second = sim->model->joints[cam->follower_joint].body[1] == cam->follower;
    return (yk_dot(outwards, yk_quarter(arm)) > 0) == is_second ? 1 : -1;
}

// --- opening and closing

static int32_t coordinate_of(const YkSimulation *sim, int32_t joint, bool is_distance)
{
    return yk_tree_coordinate(sim->mech, joint, is_distance);
}

// Opens a cam: the follower's coordinate becomes an independent one, or the cam's if the follower's is one already.
static bool open_cam(YkSimulation *sim, size_t index)
{
    const YkCam *cam = &sim->model->cams[index];
    size_t count = sim->free_count;
    const char **names = calloc(count + 1, sizeof *names);
    if (!names) {
        yk_arena_fail(sim->arena);
        return false;
    }
    for (size_t k = 0; k < count; k++) names[k] = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].name;
    int32_t choice[] = {coordinate_of(sim, cam->follower_joint, !cam->oscillates),
                        coordinate_of(sim, cam->cam_joint, false)};
    for (size_t k = 0; k < 2 && count == sim->free_count; k++)
        if (choice[k] != YK_NONE && sim->mech->coordinates[choice[k]].input == YK_NONE)
            names[count++] = sim->mech->coordinates[choice[k]].name;
    sim->flights[index].way = way_of(sim, index);
    sim->open[index] = true;
    bool changed = false, ok = yk_simulation_take_named(sim, names, count, sim->free_count + 1, &changed);
    sim->open[index] = changed;
    sim->flights[index].is_held = !changed;
    free(names);
    if (!ok) yk_arena_fail(sim->arena);
    return ok;
}

// Closes a cam: one of the independent coordinates now follows from the others, the follower's own if possible.
static bool close_cam(YkSimulation *sim, size_t index)
{
    const YkCam *cam = &sim->model->cams[index];
    size_t count = sim->free_count;
    int32_t own = coordinate_of(sim, cam->follower_joint, !cam->oscillates);
    const char **names = calloc(count + 1, sizeof *names);
    bool changed = false, ok = names != NULL;
    sim->open[index] = false;
    for (size_t attempt = 0; ok && !changed && attempt <= count; attempt++) {
        size_t kept = 0;
        for (size_t k = 0; k < count; k++) {
            int32_t c = sim->mech->inputs[sim->free_input[k]];
            if (attempt == 0 ? c != own : k + 1 != attempt) names[kept++] = sim->mech->coordinates[c].name;
        }
        if (kept + 1 == count) ok = yk_simulation_take_named(sim, names, kept, kept, &changed);
    }
    sim->open[index] = !changed;
    free(names);
    if (ok && changed) ok = yk_simulation_start_guide(sim);
    if (!ok) yk_arena_fail(sim->arena);
    if (ok && !changed) {
        yk_dynamics_fail(sim->dynamics, YK_NOT_CONVERGED, "the follower of cam `", cam->name,
                         "` lands where the cam does not determine its position");
        sim->report = sim->dynamics->report;
        sim->status = YK_NOT_CONVERGED;
    }
    return ok && changed;
}

// --- events

static double angle_of(const YkSimulation *sim, size_t cam)
{
    YkChannel angle = {.kind = YK_CHANNEL_JOINT_ANGLE, .index = sim->model->cams[cam].cam_joint};
    return yk_state_channel(sim->state, angle);
}

bool yk_simulation_lift_off(YkSimulation *sim, size_t cam)
{
    double angle = angle_of(sim, cam);
    if (!open_cam(sim, cam)) return false;
    yk_simulation_note(sim, sim->open[cam] ? YK_HAPPENING_LIFT_OFF : YK_HAPPENING_PULL, sim->time,
                       sim->model->cams[cam].name, angle);
    return true;
}

bool yk_simulation_open_touching(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->model->cam_count; k++) {
        YkFlight *flight = &sim->flights[k];
        flight->is_about = false;
        if (!yk_simulation_is_loose(sim, k) || flight->is_held) continue;
        if (!open_cam(sim, k)) return false;
        flight->is_about = sim->open[k];
        flight->is_held = false; // that is reported once it would have to pull
    }
    return true;
}

bool yk_simulation_close_touching(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->model->cam_count; k++) {
        const YkCam *cam = &sim->model->cams[k];
        if (!sim->flights[k].is_about) continue;
        sim->flights[k].is_about = false;
        double slowest = yk_simulation_rate_floor(sim) * (cam->oscillates ? 1 : sim->mech->size);
        bool parts = yk_simulation_gap(sim, k).velocity > fmax(slowest, 1e-6 * fabs(sim->fastest));
        if (parts)
            yk_simulation_note(sim, YK_HAPPENING_LIFT_OFF, sim->time, cam->name, angle_of(sim, k));
        else if (!close_cam(sim, k))
            return false;
    }
    return true;
}
