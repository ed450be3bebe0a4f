// Forces of a batch's lanes.
#include <string.h>
#include "batch/inside.h"

// Lists the lanes that are wanted. Returns how many.
static size_t list_lanes(YkPoseForces *f, const bool *wanted, size_t n)
{
    size_t count = 0;
    for (size_t k = 0; k < n; k++)
        if (wanted[k]) f->which[count++] = k;
    return count;
}

// Computes only the lanes that are wanted; the others are 0.
static void run_some(YkPoseForces *f, YkLanePose *pose, double *const *outputs, size_t at, size_t n, size_t count)
{
    pose->which = f->which;
    for (size_t k = 0; k < f->count; k++) f->out[k] = f->packed + k * f->lane_count;
    if (count > 0) yk_lane_forces_run(f->lanes, pose, f->out, count);
    for (size_t k = 0; k < f->count; k++) {
        double *out = outputs[f->place[k]] + at;
        memset(out, 0, n * sizeof *out);
        for (size_t lane = 0; lane < count; lane++) out[f->which[lane]] = f->out[k][lane];
        f->out[k] = out;
    }
}

void yk_batch_write_positions(const YkBatch *b)
{
    for (size_t k = 0; b->forces->position_count > 0 && k < b->mech->coordinate_count; k++)
        if (b->forces->position[k]) yk_batch_write_angle(b, k, b->forces->position[k], b->run.lanes);
}

static YkLanePose begin_forces(YkBatch *b)
{
    yk_pose_forces_follow(b->forces);
    yk_batch_write_positions(b);
    return (YkLanePose){
        b->run.space, b->run.inputs, b->state->time, b->times, (const double *const *)b->forces->position, NULL};
}

bool yk_batch_run_forces_alone(YkBatch *b, double *const *outputs, size_t at)
{
    YkLanePose pose = begin_forces(b);
    return yk_pose_forces_run_one(b->forces, &pose, outputs, at);
}

void yk_batch_run_forces(YkBatch *b, double *const *outputs, size_t at, const bool *wanted)
{
    YkPoseForces *f = b->forces;
    if (b->run.space == &b->single) {
        yk_batch_run_forces_alone(b, outputs, at);
        return;
    }
    YkLanePose pose = begin_forces(b);
    size_t count = wanted ? list_lanes(f, wanted, b->run.lanes) : b->run.lanes;
    if (count < b->run.lanes) {
        run_some(f, &pose, outputs, at, b->run.lanes, count);
        return;
    }
    for (size_t k = 0; k < f->count; k++) f->out[k] = outputs[f->place[k]] + at;
    yk_lane_forces_run(f->lanes, &pose, f->out, b->run.lanes);
}

size_t yk_batch_finite_lanes(const YkBatch *b, double *const *outputs, size_t at, size_t n)
{
    size_t lane = 0;
    YkPoseForces *f = b->forces;
    bool finite;
    if (n == 1) return yk_pose_forces_are_finite(f, outputs, at) ? 1 : 0;
    for (size_t k = 0; k < f->telling_count; k++) f->seen[k] = f->out[f->telling[k]];
    yk_lanes_finite(&finite, f->seen, f->telling_count, n);
    if (finite) return n;
    while (lane < n && yk_pose_forces_are_finite(b->forces, outputs, at + lane)) lane++;
    return lane;
}

YkStatus yk_batch_settle_forces(YkBatch *b, double *const *outputs, signed char *status, size_t at, size_t n)
{
    YkStatus worst = YK_OK;
    for (size_t lane = yk_batch_finite_lanes(b, outputs, at, n); lane < n; lane++) {
        if (yk_pose_forces_are_finite(b->forces, outputs, at + lane)) continue;
        YkStatus one = yk_batch_solve_lane(b, lane);
        if (one >= 0) one = yk_pose_forces_at(b->forces, b->state, outputs, at + lane);
        if (one == YK_REDUNDANT) one = YK_OK;
        if (one != YK_OK) yk_pose_forces_clear(b->forces, outputs, at + lane);
        if (status) status[at + lane] = (signed char)one;
        worst = yk_worse(worst, one);
    }
    return worst;
}
