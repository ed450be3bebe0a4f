// Forces of a batch's lanes.
#include <math.h>
#include "batch/inside.h"

void yk_batch_run_forces(YkBatch *b, const YkRun *run, double *const *outputs, size_t at)
{
    YkPoseForces *f = b->forces;
    for (size_t k = 0; k < b->mech->coordinate_count; k++)
        if (f->position[k]) yk_batch_write_angle(b, run, k, f->position[k], run->lanes);
    for (size_t k = 0; k < f->count; k++) f->out[k] = outputs[f->which[k]] + at;
    YkLanePose pose = {&b->space, run->inputs, b->state->time, (const double *const *)f->position};
    yk_lane_forces_run(f->lanes, &pose, f->out, run->lanes);
}

static bool is_finite(const YkPoseForces *f, double *const *outputs, size_t at, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < f->count; k++)
        for (size_t lane = at; lane < at + n; lane++) sum += 0 * outputs[f->which[k]][lane];
    return sum == 0;
}

size_t yk_batch_finite_lanes(const YkBatch *b, double *const *outputs, size_t at, size_t n)
{
    size_t lane = 0;
    if (is_finite(b->forces, outputs, at, n)) return n;
    while (is_finite(b->forces, outputs, at + lane, 1)) lane++;
    return lane;
}

YkStatus yk_batch_settle_forces(YkBatch *b, double *const *outputs, signed char *status, size_t at, size_t n)
{
    YkStatus worst = YK_OK;
    for (size_t lane = yk_batch_finite_lanes(b, outputs, at, n); lane < n; lane++) {
        if (is_finite(b->forces, outputs, at + lane, 1)) continue;
        YkStatus one = yk_batch_solve_lane(b, lane);
        if (one >= 0) one = yk_pose_forces_at(b->forces, b->state, outputs, at + lane);
        if (one == YK_REDUNDANT) one = YK_OK;
        for (size_t k = 0; one != YK_OK && k < b->forces->count; k++) outputs[b->forces->which[k]][at + lane] = 0;
        if (status) status[at + lane] = (signed char)one;
        worst = yk_batch_worse(worst, one);
    }
    return worst;
}
