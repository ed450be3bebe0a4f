// Answers channels of forces at a pose.
#include "batch/pose_forces.h"
#include <stdlib.h>
#include "dynamics/dynamics.h"
#include "elementary/kernel.h"

static bool list_channels(YkPoseForces *f, const YkChannel *channels, size_t count)
{
    f->channels = calloc(count + 1, sizeof *f->channels);
    f->place = calloc(count + 1, sizeof *f->place);
    f->out = calloc(count + 1, sizeof *f->out);
    f->seen = calloc(count + 1, sizeof *f->seen);
    f->telling = calloc(count + 1, sizeof *f->telling);
    if (!f->channels || !f->place || !f->out || !f->seen || !f->telling) return false;
    for (size_t k = 0; k < count; k++) {
        if (!yk_channel_needs_forces(channels[k])) continue;
        f->channels[f->count] = channels[k];
        f->place[f->count++] = k;
    }
    return true;
}

static void list_telling(YkPoseForces *f)
{
    f->telling_count = 0;
    for (size_t k = 0; k < f->count; k++)
        if (yk_lane_forces_tell(f->lanes, k)) f->telling[f->telling_count++] = k;
}

static bool make_lanes(YkPoseForces *f, size_t lanes)
{
    size_t coordinates = f->mech->coordinate_count, count = 0;
    f->position = calloc(coordinates + 1, sizeof *f->position);
    for (size_t k = 0; k < coordinates; k++) count += yk_lane_forces_needs(f->lanes, k);
    f->position_count = count;
    f->position_lanes = calloc(count * lanes + 1, sizeof *f->position_lanes);
    f->which = calloc(lanes, sizeof *f->which);
    f->packed = calloc(f->count * lanes, sizeof *f->packed);
    f->lane_count = lanes;
    if (!f->position || !f->position_lanes || !f->which || !f->packed) return false;
    list_telling(f);
    double *next = f->position_lanes;
    for (size_t k = 0; k < coordinates; k++) {
        if (!yk_lane_forces_needs(f->lanes, k)) continue;
        f->position[k] = next;
        next += lanes;
    }
    return true;
}

static bool make(YkPoseForces *f, const YkChannel *channels, size_t count, size_t lanes)
{
    bool fits;
    if (!list_channels(f, channels, count)) return false;
    if (f->count == 0) return true;
    f->lanes = yk_lane_forces_new(f->mech, f->channels, f->count, lanes, &fits);
    return f->lanes ? make_lanes(f, lanes) : !fits;
}

YkPoseForces *yk_pose_forces_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, size_t lanes,
                                 bool *none)
{
    YkPoseForces *f = calloc(1, sizeof *f);
    *none = false;
    if (!f) return NULL;
    f->mech = mech;
    f->changes = mech->variant ? mech->variant->changes : 0;
    bool good = make(f, channels, channel_count, lanes);
    *none = good && f->count == 0;
    if (good && !*none) return f;
    yk_pose_forces_free(f);
    return NULL;
}

void yk_pose_forces_free(YkPoseForces *f)
{
    if (!f) return;
    yk_lane_forces_free(f->lanes);
    yk_dynamics_free(f->dynamics);
    free(f->channels);
    free(f->place);
    free(f->out);
    free(f->seen);
    free(f->telling);
    free(f->position);
    free(f->position_lanes);
    free(f->which);
    free(f->packed);
    free(f);
}

void yk_pose_forces_take(YkPoseForces *f)
{
    f->changes = f->mech->variant->changes;
    if (!f->lanes) return;
    yk_lane_forces_redesign(f->lanes);
    list_telling(f);
}

// --- one pose

bool yk_pose_forces_run_one(YkPoseForces *f, const YkLanePose *at, double *const *outputs, size_t pose)
{
    const double *const *result = yk_lane_forces_run_one(f->lanes, at);
    double sum = 0; // not finite if one of them is not
    YK_UNROLL
    for (size_t k = 0; k < f->count; k++) {
        double value = *result[k];
        sum += value;
        outputs[f->place[k]][pose] = value;
    }
    return sum - sum == 0 || yk_pose_forces_are_finite(f, outputs, pose);
}

// Runs one lane: the state's own space.
static bool run_lane(YkPoseForces *f, const YkState *state, double *const *outputs, size_t pose)
{
    for (size_t k = 0; f->position_count > 0 && k < f->mech->coordinate_count; k++)
        if (f->position[k]) f->position[k][0] = yk_state_coordinate(state, k).position;
    YkLanePose at = {&state->space, state->input_lanes, state->time, NULL, (const double *const *)f->position, NULL};
    return yk_pose_forces_run_one(f, &at, outputs, pose);
}

bool yk_pose_forces_are_finite(const YkPoseForces *f, double *const *outputs, size_t pose)
{
    double numbers = 0; // or NaN
    for (size_t k = 0; k < f->count; k++) numbers += 0 * outputs[f->place[k]][pose];
    return numbers == 0;
}

void yk_pose_forces_clear(const YkPoseForces *f, double *const *outputs, size_t pose)
{
    for (size_t k = 0; k < f->count; k++) outputs[f->place[k]][pose] = 0;
}

static bool make_dynamics(YkPoseForces *f)
{
    if (f->dynamics) return true;
    f->dynamics = yk_dynamics_new(f->mech, NULL);
    for (size_t i = 0; f->dynamics && i < f->mech->input_count; i++) yk_dynamics_prescribe(f->dynamics, i, true);
    return f->dynamics != NULL;
}

static YkStatus by_dynamics(YkPoseForces *f, YkState *state, double *const *outputs, size_t pose)
{
    YkStatus status = YK_NO_MEMORY;
    if (make_dynamics(f)) {
        yk_dynamics_forget_dry(f->dynamics); // a pose has the same bits whatever was solved before it
        status = yk_dynamics_solve(f->dynamics, state, YK_METHOD_REDUCED);
    }
    if (status == YK_REDUNDANT) status = YK_OK;
    for (size_t k = 0; status == YK_OK && k < f->count; k++)
        outputs[f->place[k]][pose] = yk_dynamics_channel(f->dynamics, state, f->channels[k]);
    if (status == YK_OK && !yk_pose_forces_are_finite(f, outputs, pose)) status = YK_SINGULAR; // an effort not single
    if (status != YK_OK) yk_pose_forces_clear(f, outputs, pose);
    return status;
}

YkStatus yk_pose_forces_at(YkPoseForces *f, YkState *state, double *const *outputs, size_t pose)
{
    yk_pose_forces_follow(f);
    if (f->lanes && state->has_rates && !yk_state_blurs_forces(state) && run_lane(f, state, outputs, pose))
        return YK_OK;
    return by_dynamics(f, state, outputs, pose);
}
