// Judges the lanes of a batch: which close, which are at a dead point, which only a state can settle.
#include <math.h>
#include <string.h>
#include "batch/inside.h"
#include "elementary/kernel.h"
#include "solve/coincidence.h"

YkStatus yk_batch_solve_lane(YkBatch *b, size_t lane)
{
    yk_state_copy(b->state, b->home);
    for (size_t i = 0; i < 3 * b->mech->input_count; i++) b->state->input[i] = b->lanes_of[i][lane];
    return yk_state_solve(b->state);
}

// The margin of a lane whose answers are the state's, until they are written: the state settles angles that no loop
// determines, and closes all loops where those that are kept are singular; a lane cannot.
#define SETTLED_MARGIN (-2.0)

// Judges a lane that may be singular as the state does.
static YkStatus judge_by_state(YkBatch *b, size_t k, bool closes)
{
    double *margin = &b->run.space->margin[k];
    YkStatus status = yk_batch_solve_lane(b, k);
    if (status == YK_NO_MEMORY) {
        *margin = -1;
        return status;
    }
    if (status == YK_SINGULAR || (status >= 0 && b->state->is_regular)) {
        bool is_settled = b->state->is_kept || b->state->is_regular;
        *margin = is_settled ? SETTLED_MARGIN : fmin(*margin, YK_SINGULAR_MARGIN);
        b->has_settled |= is_settled;
        return status == YK_SINGULAR ? YK_SINGULAR : YK_OK;
    }
    if (!closes) *margin = -1;
    return !closes ? YK_LIMIT : *margin <= YK_SINGULAR_MARGIN ? YK_SINGULAR : YK_OK;
}

// Judges a lane; leaves a margin that masks it if it is undecided. On a path the state judges close poses, not a lane.
static YkStatus judge_lane(YkBatch *b, size_t k)
{
    double *margin = &b->run.space->margin[k];
    bool closes = *margin >= YK_LIMIT_MARGIN && b->run.space->gap[k] <= yk_gap_tolerance(b->mech, *margin);
    bool is_close = closes ? *margin <= yk_state_close_margin(b->state) : !b->is_along && yk_may_coincide(*margin);
    if (is_close && !b->is_along) return judge_by_state(b, k, closes);
    if (is_close)
        *margin = fmin(*margin, YK_SINGULAR_MARGIN);
    else if (!closes)
        *margin = -1;
    return !closes ? YK_LIMIT : *margin <= YK_SINGULAR_MARGIN ? YK_SINGULAR : YK_OK;
}

YkStatus yk_batch_write_settled(YkBatch *b, double *const *outputs, size_t at, size_t n)
{
    for (size_t lane = 0; lane < n; lane++) {
        if (b->run.space->margin[lane] != SETTLED_MARGIN) continue;
        YkStatus status = yk_batch_solve_lane(b, lane);
        if (status < 0) return status; // out of memory
        for (size_t k = 0; k < b->channel_count; k++)
            if (!yk_channel_needs_forces(b->channels[k]))
                outputs[k][at + lane] = yk_state_channel(b->state, b->channels[k]);
    }
    return YK_OK;
}

YkStatus yk_batch_judge(YkBatch *b, signed char *status, size_t n)
{
    YkStatus worst = YK_OK;
    bool well = b->is_plain && n > 1;
    b->has_settled = false;
    if (!well)
        yk_lanes_well(&well, b->run.space->margin,
                      YK_KNOWS_BLOCKS && !yk_measures_gaps(b->mech) ? NULL : b->run.space->gap,
                      yk_state_close_margin(b->state), b->mech->size * YK_CLOSING_TOLERANCE, n);
    if (well) {
        if (status) memset(status, YK_OK, n);
        return YK_OK;
    }
    for (size_t k = 0; k < n; k++) {
        YkStatus one = judge_lane(b, k);
        if (status) status[k] = (signed char)one;
        worst = yk_worse(worst, one);
    }
    return worst;
}
