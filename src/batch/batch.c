// Computes many poses at once: runs blocks of lanes through the same steps, then writes the requested channels.
#include "batch/batch.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "batch/inside.h"
#include "elementary/kernel.h"
#include "solve/single.h"

// Lanes in a block: enough to hide the dispatch of a step, few enough that a small machine stays in a first-level
// cache of 32 KB, with most of its forces where these take many operations; some more where vectors are wide, since the
// same lanes then are fewer turns of a loop. Tunable. Rows are a little further apart: rows a multiple of 4096 bytes
// apart compete for the same cache lines.
enum { LANES = 192, LANES_WITH_FORCES = 128, LANES_WIDE = 64, MANY = 40, LANES_MIN = 8, LANES_APART = 8 };
// Lanes that leave no rest in the loops of a step.
enum { LANES_WHOLE = 32 };
#define CACHE_BYTES ((size_t)1 << 18)

static size_t lanes_for(const YkMechanism *mech)
{
    size_t per_lane = sizeof(double) * (4 * mech->slot_count + 3 * mech->distance_count + 6 * (mech->node_count + 4));
    size_t lanes = CACHE_BYTES / (per_lane + 1), most = LANES + (YK_HAS_WIDE_LANES ? LANES_WIDE : 0);
    return lanes > most ? most : lanes < LANES_MIN ? LANES_MIN : lanes & ~(size_t)7;
}

static void fill_constants(YkBatch *b)
{
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        for (size_t k = 0; k < b->lanes; k++) b->constant[i * b->lanes + k] = b->state->input[i];
}

// Returns whether every pose is solved by a state: it is tracked, or some channel is known only to a state.
static bool needs_state(const YkBatch *b)
{
    if (b->mech->has_groups || b->mech->reference_count > 0 || (b->forces && !b->forces->lanes)) return true;
    for (size_t k = 0; k < b->channel_count; k++)
        if (b->channels[k].kind == YK_CHANNEL_TRANSMISSION) return true;
    return false;
}

static YkBatch *new_batch(const YkState *state, const YkChannel *channels, size_t channel_count, bool is_along)
{
    bool needs_no_forces;
    YkBatch *b = calloc(1, sizeof *b);
    if (!b) return NULL;
    b->is_along = is_along;
    size_t inputs = 3 * state->mech->input_count;
    b->mech = state->mech;
    b->lanes = lanes_for(b->mech);
    b->channel_count = channel_count;
    YkArena *a = b->arena = yk_arena_new();
    b->state = yk_state_new(b->mech);
    b->home = yk_state_new(b->mech);
    b->channels = yk_arena_alloc(a, channel_count + 1, sizeof *b->channels);
    b->turns = yk_arena_alloc(a, channel_count + 1, sizeof *b->turns);
    b->row = yk_arena_alloc(a, channel_count + 1, sizeof *b->row);
    b->number = yk_arena_alloc(a, channel_count + 1, sizeof *b->number);
    b->plain = yk_arena_alloc(a, channel_count + 1, sizeof *b->plain);
    b->constant = aligned_alloc(64, ((inputs + 1) * b->lanes * sizeof(double) + 63) & ~(size_t)63);
    b->lanes_of = yk_arena_alloc(a, inputs + 1, sizeof *b->lanes_of);
    b->point_lanes = aligned_alloc(64, (6 * b->lanes * sizeof(double) + 63) & ~(size_t)63);
    if (is_along) b->next = yk_arena_alloc(a, b->mech->coordinate_count + 1, sizeof *b->next);
    if (!b->state || !b->home || !b->constant || !b->point_lanes || yk_arena_failed(a) ||
        !yk_space_start(&b->space, b->mech, b->lanes + LANES_APART, is_along) ||
        !yk_space_start(&b->single, b->mech, 1, false)) {
        yk_batch_free(b);
        return NULL;
    }
    if (is_along && !yk_watch_start(&b->watch, b->mech)) {
        yk_batch_free(b);
        return NULL;
    }
    b->forces = yk_pose_forces_new(b->mech, channels, channel_count, b->lanes, &needs_no_forces);
    if (!b->forces && !needs_no_forces) {
        yk_batch_free(b);
        return NULL;
    }
    bool has_many = b->forces && b->forces->lanes && yk_lane_forces_length(b->forces->lanes) > MANY;
    size_t most = LANES_WITH_FORCES + (YK_HAS_WIDE_LANES ? LANES_WIDE : 0);
    if (has_many && b->lanes > most) b->lanes = most;
    double *p = b->point_lanes;
    size_t n = b->lanes;
    b->point = (YkPlane){p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n};
    for (size_t k = 0; k < channel_count; k++) {
        b->channels[k] = channels[k];
        yk_batch_prepare_angle(b, k);
        b->row[k] = yk_batch_free_row_of(b, k);
        b->number[k] = yk_batch_number_of(b, k);
        if (!yk_channel_needs_forces(channels[k])) b->plain[b->plain_count++] = k;
    }
    b->needs_state = needs_state(b);
    if (!yk_batch_find_rates_alone(b)) {
        yk_batch_free(b);
        return NULL;
    }
    b->run = (YkRun){b->mech,        NULL,    b->lanes_of, b->state->branch, NULL, 0, b->home->slot_reference,
                     b->rates_alone, b->idle, NULL};
    bool may_fail = !YK_KNOWS_BLOCKS || is_along || b->mech->block_count > 0 || yk_measures_gaps(b->mech);
    if (!may_fail) b->run.is_plain = &b->is_plain;
    yk_batch_restart(b, state);
    return b;
}

YkBatch *yk_batch_new(const YkState *state, const YkChannel *channels, size_t channel_count)
{
    return new_batch(state, channels, channel_count, false);
}

YkBatch *yk_batch_new_along(const YkState *state, const YkChannel *channels, size_t channel_count)
{
    return new_batch(state, channels, channel_count, true);
}

void yk_batch_restart(YkBatch *b, const YkState *state)
{
    yk_state_copy(b->state, state);
    yk_state_copy(b->home, state);
    fill_constants(b);
}

void yk_batch_free(YkBatch *b)
{
    if (!b) return;
    yk_state_free(b->state);
    yk_state_free(b->home);
    yk_space_end(&b->space);
    yk_space_end(&b->single);
    yk_arena_free(b->arena);
    free(b->constant);
    free(b->point_lanes);
    yk_pose_forces_free(b->forces);
    yk_watch_end(&b->watch);
    free(b);
}

// --- running

// Runs one pose of a machine with groups, with angles that are followed turn by turn, or with a channel that only a
// state knows: each pose is tracked from the batch's own state.
static YkStatus run_one(YkBatch *b, const double *const *inputs, double *const *outputs, size_t pose)
{
    yk_state_copy(b->state, b->home);
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        b->state->input[i] = inputs[i] ? inputs[i][pose] : b->constant[i * b->lanes];
    YkStatus status = yk_state_solve(b->state);
    if (status == YK_REDUNDANT) status = YK_OK;
    if (status < 0 && status != YK_NO_MEMORY) status = YK_LIMIT;
    for (size_t k = 0; k < b->channel_count; k++)
        outputs[k][pose] =
            status < 0 || yk_channel_needs_forces(b->channels[k]) ? 0 : yk_state_channel(b->state, b->channels[k]);
    return status == YK_OK && b->forces ? yk_pose_forces_at(b->forces, b->state, outputs, pose) : status;
}

bool yk_batch_can_follow(const YkMechanism *mech, const YkChannel *channels, size_t channel_count)
{
    if (mech->has_groups || mech->relation_count + mech->derived_count > 0) return false;
    for (size_t c = 0; c < mech->coordinate_count; c++)
        if (mech->coordinates[c].is_sum) return false;
    for (size_t k = 0; k < channel_count; k++)
        if (channels[k].kind == YK_CHANNEL_TRANSMISSION) return false;
    return true;
}

static YkStatus run_poses(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                          size_t count)
{
    YkStatus worst = YK_OK;
    for (size_t pose = 0; pose < count; pose++) {
        YkStatus one = run_one(b, inputs, outputs, pose);
        if (status) status[pose] = (signed char)one;
        worst = yk_worse(worst, one);
    }
    return worst;
}

static size_t clear_lanes(YkBatch *b, YkStatus worst, size_t n)
{
    size_t clear = yk_watch_lanes(&b->watch, &b->space, n);
    for (size_t k = 0; worst != YK_OK && k < clear; k++)
        if (!(b->space.margin[k] > YK_SINGULAR_MARGIN)) clear = k; // also false for gaping lanes: see judge
    return clear;
}

// On a path, lanes end before the first force that is not finite: there a state must judge. Angles are counted anew up
// to there.
static void end_at_forces(YkBatch *b, double *const *outputs, size_t at)
{
    size_t finite = yk_batch_finite_lanes(b, outputs, at, b->clear);
    if (finite == b->clear) return;
    b->clear = finite;
    memcpy(b->next, b->state->reference, b->mech->coordinate_count * sizeof *b->next);
    yk_batch_write_positions(b);
}

// masks: some lanes may have no answer; then forces are masked as well.
static void write_channels(YkBatch *b, bool masks, double *const *outputs, size_t at)
{
    for (size_t k = 0; masks && k < b->channel_count; k++) yk_batch_write_channel(b, k, true, outputs[k] + at);
    for (size_t k = 0; !masks && k < b->plain_count; k++)
        yk_batch_write_channel(b, b->plain[k], false, outputs[b->plain[k]] + at);
}

// Runs one block of lanes from `at`.
static YkStatus run_lanes(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                          YkAlong along, size_t at)
{
    YkRun *run = &b->run;
    b->times = along.times ? along.times + at : NULL;
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        b->lanes_of[i] = inputs[i] ? inputs[i] + at : b->constant + i * b->lanes;
    run->space = run->lanes == 1 && !b->is_along ? &b->single : &b->space;
    for (size_t k = 0; run->space == &b->space && k < b->plain_count; k++)
        if (b->row[b->plain[k]]) *b->row[b->plain[k]] = outputs[b->plain[k]] + at;
    yk_run_begin(run);
    yk_run_steps(run, 0, b->mech->step_count);
    YkStatus here = yk_batch_judge(b, status ? status + at : NULL, run->lanes);
    if (b->is_along) b->clear = clear_lanes(b, here, run->lanes);
    if (b->forces) yk_batch_run_forces(b, outputs, at, along.wanted ? along.wanted + at : NULL);
    if (b->forces && b->is_along) end_at_forces(b, outputs, at);
    write_channels(b, here != YK_OK, outputs, at);
    if (b->has_settled) here = yk_worse(here, yk_batch_write_settled(b, outputs, at, run->lanes));
    if (!b->forces || b->is_along) return here;
    return yk_worse(here, yk_batch_settle_forces(b, outputs, status, at, run->lanes));
}

// Runs one pose that is well: nothing to mask or settle, no block of lanes. Returns false if it may not be; the outputs
// then hold garbage.
static bool run_alone(YkBatch *b, const double *const *inputs, double *const *outputs)
{
    YkRun *run = &b->run;
    YkSpace *space = &b->single;
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        b->lanes_of[i] = inputs[i] ? inputs[i] : b->constant + i * b->lanes;
    run->lanes = 1;
    run->space = space;
    b->times = NULL;
    yk_run_begin(run);
    yk_run_single(run, 0, b->mech->step_count);
    bool is_well =
        *space->margin > yk_state_close_margin(b->state) && *space->gap <= b->mech->size * YK_CLOSING_TOLERANCE;
    for (size_t i = 0; is_well && i < b->plain_count; i++) {
        size_t k = b->plain[i];
        if (b->number[k])
            *outputs[k] = *b->number[k];
        else
            yk_batch_write_channel(b, k, false, outputs[k]);
    }
    return is_well && (!b->forces || yk_batch_run_forces_alone(b, outputs, 0));
}

// Returns how many numbers stand in a cache line before the first one of an output, if they are as many for all
// outputs.
static size_t lanes_before(const YkBatch *b, double *const *outputs)
{
    size_t beyond = YK_KNOWS_BLOCKS && b->channel_count > 0 ? (uintptr_t)outputs[0] % 64 : 0;
    for (size_t k = 1; beyond > 0 && k < b->channel_count; k++)
        if ((uintptr_t)outputs[k] % 64 != beyond) return 0;
    return beyond / sizeof(double);
}

// Returns how many lanes the block has that begins at a pose; the last one may begin before, and repeat some answers.
static size_t block_lanes(const YkBatch *b, size_t at, size_t count)
{
    size_t turn = YK_KNOWS_BLOCKS && at > 0 ? LANES_WHOLE : 1, lanes = (count - at + turn - 1) / turn * turn;
    return lanes < b->lanes ? lanes : b->lanes;
}

// Blocks have whole loops and, but for the first and the last one, begin where cache lines of the outputs do: a vector
// in two lines is stored in twice the time.
static YkStatus run_blocks(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                           size_t count)
{
    YkStatus worst = YK_OK;
    size_t at = 0, before = count > b->lanes ? lanes_before(b, outputs) : 0;
    while (at < count) {
        size_t lanes = block_lanes(b, at, count), from = at + lanes < count ? at : count - lanes;
        b->run.lanes = lanes;
        worst = yk_worse(worst, run_lanes(b, inputs, outputs, status, (YkAlong){NULL, NULL}, from));
        at = from + lanes - (at == 0 && lanes < count ? before : 0);
    }
    return worst;
}

YkStatus yk_batch_run(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                      size_t count)
{
    if (b->needs_state) return run_poses(b, inputs, outputs, status, count);
    if (count == 1 && run_alone(b, inputs, outputs)) {
        if (status) *status = YK_OK;
        return YK_OK;
    }
    return run_blocks(b, inputs, outputs, status, count);
}

bool yk_batch_has_slow_forces(const YkBatch *b)
{
    return b->forces && !b->forces->lanes;
}

bool yk_batch_has_lanes(const YkBatch *b)
{
    return !b->needs_state;
}

YkPoseForces *yk_batch_forces(YkBatch *b)
{
    return b->forces;
}

// --- along a path

void yk_batch_begin(YkBatch *b, const YkState *state)
{
    const YkMechanism *mech = b->mech;
    memcpy(b->state->branch, state->branch, mech->block_count);
    memcpy(b->state->reference, state->reference, mech->coordinate_count * sizeof *state->reference);
    memcpy(b->next, state->reference, mech->coordinate_count * sizeof *state->reference);
    b->watch.seen = 0;
}

size_t yk_batch_run_along(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                          YkAlong along, size_t count)
{
    for (size_t at = 0; at < count; at += b->lanes) {
        b->run.lanes = count - at < b->lanes ? count - at : b->lanes;
        run_lanes(b, inputs, outputs, status, along, at);
        memcpy(b->state->reference, b->next, b->mech->coordinate_count * sizeof *b->next);
        if (b->clear == b->run.lanes) continue;
        return at + b->clear;
    }
    return count;
}

void yk_batch_refer(const YkBatch *b, YkState *state)
{
    memcpy(state->reference, b->state->reference, b->mech->coordinate_count * sizeof *state->reference);
}
