// Computes many poses at once: runs blocks of lanes through the same steps, then writes the requested channels.
#include "batch/batch.h"
#include <stdlib.h>
#include <string.h>
#include "solve/coincidence.h"
#include "solve/watch.h"

// Lanes in a block: enough to hide the dispatch of a step, few enough that a small machine stays in the first-level
// cache. Tunable. Rows are a little further apart: rows a multiple of 4096 bytes apart compete for the same cache
// lines.
enum { LANES = 96, LANES_MIN = 8, LANES_APART = 8 };
#define CACHE_BYTES ((size_t)1 << 18)

struct YkBatch {
    const YkMechanism *mech;
    YkState *state; // its branches, reference angles, and inputs for NULL arrays; poses of machines with groups are
                    // tracked in it
    YkState *home;  // groups: every pose starts here
    YkSpace space;
    YkChannel *channels;
    int32_t (*turns)[2]; // per channel: the orientations of its angle (a, b)
    double ***row;       // per channel: the lanes in which it is made, redirected to its output; or NULL
    size_t channel_count, lanes;
    double *constant;        // [3 * input + k][lane]: for NULL arrays
    const double **lanes_of; // the runner's view of the inputs of this block
    YkPlane point;           // scratch: the lanes of one point
    double *point_lanes;
    bool is_along;       // the poses follow one path:
    YkBranchWatch watch; // where its branches could have met
    double *next;        // [coordinate]: angles at the end of this block of lanes, references of the next
    size_t clear;        // lanes of this block that are certainly on the path
};

static size_t lanes_for(const YkMechanism *mech)
{
    size_t per_lane = sizeof(double) * (4 * mech->slot_count + 3 * mech->distance_count + 6 * (mech->node_count + 4));
    size_t lanes = CACHE_BYTES / (per_lane + 1);
    return lanes > LANES ? LANES : lanes < LANES_MIN ? LANES_MIN : lanes & ~(size_t)7;
}

// Prepares a channel that is an angle: between which orientations.
static void prepare_angle(YkBatch *b, size_t k)
{
    const YkMechanism *mech = b->mech;
    YkChannel c = b->channels[k];
    const YkTreeCoordinate *q = c.kind == YK_CHANNEL_COORDINATE ? &mech->coordinates[c.index] : NULL;
    b->turns[k][0] = b->turns[k][1] = 0;
    if (c.kind == YK_CHANNEL_BODY) b->turns[k][1] = mech->bodies[c.index].orientation;
    if (c.kind != YK_CHANNEL_JOINT_ANGLE && !(q && !q->is_distance)) return;
    YkJointAngle angle = q ? q->angle : yk_joint_angle(mech, c.index);
    b->turns[k][0] = angle.a;
    b->turns[k][1] = angle.b;
}

// Returns the pointer to the lanes that already hold a channel as requested: a distance, a rate relative to the ground.
// NULL if it has to be computed.
static double **row_of(YkBatch *b, size_t k)
{
    const YkMechanism *mech = b->mech;
    YkChannel c = b->channels[k];
    const YkTreeCoordinate *q = c.kind == YK_CHANNEL_COORDINATE ? &mech->coordinates[c.index] : NULL;
    if (q && q->input != YK_NONE) return NULL;
    if (c.kind == YK_CHANNEL_JOINT_DISTANCE || (q && q->is_distance)) {
        YkSlide *d = &b->space.slide[q ? q->distance : mech->joint_distance[c.index]];
        return c.order == 0 ? &d->d : c.order == 1 ? &d->v : &d->a;
    }
    if (c.order > 0 && b->turns[k][0] == 0 && b->turns[k][1] != 0) {
        YkTurn *t = &b->space.turn[b->turns[k][1]];
        return c.order == 1 ? &t->w : &t->a;
    }
    return NULL;
}

// Returns a row that is still free: it can be redirected to one channel only; further channels get a copy.
static double **free_row_of(YkBatch *b, size_t k)
{
    double **row = row_of(b, k);
    for (size_t j = 0; row && j < k; j++)
        if (b->row[j] == row) return NULL;
    return row;
}

static void fill_constants(YkBatch *b)
{
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        for (size_t k = 0; k < b->lanes; k++) b->constant[i * b->lanes + k] = b->state->input[i];
}

static YkBatch *new_batch(const YkState *state, const YkChannel *channels, size_t channel_count, bool is_along)
{
    for (size_t k = 0; k < channel_count; k++)
        if (yk_channel_needs_forces(channels[k])) return NULL;
    YkBatch *b = calloc(1, sizeof *b);
    if (!b) return NULL;
    b->is_along = is_along;
    size_t inputs = 3 * state->mech->input_count;
    b->mech = state->mech;
    b->lanes = lanes_for(b->mech);
    b->channel_count = channel_count;
    b->state = yk_state_new(b->mech);
    b->home = yk_state_new(b->mech);
    b->channels = calloc(channel_count + 1, sizeof *b->channels);
    b->turns = calloc(channel_count + 1, sizeof *b->turns);
    b->row = calloc(channel_count + 1, sizeof *b->row);
    b->constant = aligned_alloc(64, ((inputs + 1) * b->lanes * sizeof(double) + 63) & ~(size_t)63);
    b->lanes_of = calloc(inputs + 1, sizeof *b->lanes_of);
    b->point_lanes = aligned_alloc(64, (6 * b->lanes * sizeof(double) + 63) & ~(size_t)63);
    if (!b->state || !b->home || !b->channels || !b->turns || !b->row || !b->constant || !b->lanes_of ||
        !b->point_lanes || !yk_space_start(&b->space, b->mech, b->lanes + LANES_APART, is_along)) {
        yk_batch_free(b);
        return NULL;
    }
    if (is_along) b->next = calloc(b->mech->coordinate_count + 1, sizeof *b->next);
    if (is_along && (!b->next || !yk_watch_start(&b->watch, b->mech))) {
        yk_batch_free(b);
        return NULL;
    }
    double *p = b->point_lanes;
    size_t n = b->lanes;
    b->point = (YkPlane){p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n};
    for (size_t k = 0; k < channel_count; k++) {
        b->channels[k] = channels[k];
        prepare_angle(b, k);
        b->row[k] = free_row_of(b, k);
    }
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
    free(b->channels);
    free(b->turns);
    free(b->row);
    free(b->constant);
    free(b->lanes_of);
    free(b->point_lanes);
    yk_watch_end(&b->watch);
    free(b->next);
    free(b);
}

// --- channels

// Counts turns along a path, whose angles change by less than half a turn from lane to lane.
static void count_turns(const YkBatch *b, size_t coordinate, double *out, size_t n)
{
    const YkTreeCoordinate *q = &b->mech->coordinates[coordinate];
    YkTurn from = yk_space_turn(&b->space, q->angle.a), to = yk_space_turn(&b->space, q->angle.b);
    double last = b->state->reference[coordinate];
    bool turns = false;
    for (size_t k = 0; k < n; k++) {
        turns |= fabs(out[k] - last) > YK_PI;
        last = out[k];
    }
    last = b->state->reference[coordinate];
    for (size_t k = 0; turns && k < n; k++) {
        YkTurn one = {from.c ? from.c + k : NULL, from.s ? from.s + k : NULL, NULL, NULL},
               other = {to.c ? to.c + k : NULL, to.s ? to.s + k : NULL, NULL, NULL};
        yk_lanes_angle(out + k, one, other, q->angle.offset, last, 1);
        last = out[k];
    }
    if (b->clear > 0) b->next[coordinate] = out[b->clear - 1];
}

static void write_coordinate_angle(const YkBatch *b, const YkRun *run, size_t coordinate, double *out, size_t n)
{
    const YkTreeCoordinate *q = &b->mech->coordinates[coordinate];
    YkTurn from = yk_space_turn(&b->space, q->angle.a), to = yk_space_turn(&b->space, q->angle.b);
    if (q->input != YK_NONE)
        memcpy(out, run->inputs[3 * q->input], n * sizeof *out);
    else
        yk_lanes_angle(out, from, to, q->angle.offset, b->state->reference[coordinate], n);
    if (b->is_along && q->input == YK_NONE) count_turns(b, coordinate, out, n);
}

static void add_turn_at(const YkBatch *b, const YkRun *run, int32_t body, double *out, double *one, size_t n)
{
    int32_t at = b->mech->tree.joint[body], coordinate = yk_tree_coordinate(b->mech, at, false);
    const YkJoint *joint = &b->mech->model->joints[at];
    double way = joint->body[1] == body ? 1 : -1;
    if (coordinate != YK_NONE) write_coordinate_angle(b, run, (size_t)coordinate, one, n);
    for (size_t k = 0; k < n; k++) out[k] += way * (coordinate != YK_NONE ? one[k] : joint->turned);
}

// Writes a body's angle: the sum along the tree, as yk_state_body adds it.
static void write_body_angle(const YkBatch *b, const YkRun *run, size_t body, double *out, double *one, size_t n)
{
    int32_t path[YK_TREE_PATH];
    for (size_t k = 0; k < n; k++) out[k] = 0;
    for (size_t from = 1, count; (count = yk_tree_path(b->mech, (int32_t)body, from, path)) > 0; from += count)
        for (size_t k = 0; k < count; k++) add_turn_at(b, run, path[k], out, one, n);
}

// Writes the angle of a joint: the difference of its bodies' angles.
static void write_joint_angle(const YkBatch *b, const YkRun *run, size_t joint, double *out, size_t n)
{
    const YkJoint *j = &b->mech->model->joints[joint];
    write_body_angle(b, run, (size_t)j->body[1], out, b->point.x, n);
    write_body_angle(b, run, (size_t)j->body[0], b->point.y, b->point.x, n);
    for (size_t k = 0; k < n; k++) out[k] -= b->point.y[k];
}

static void write_turning(const YkBatch *b, size_t k, double *out, size_t n)
{
    YkTurn from = yk_space_turn(&b->space, b->turns[k][0]), to = yk_space_turn(&b->space, b->turns[k][1]);
    bool is_rate = b->channels[k].order == 1;
    yk_lanes_difference(out, is_rate ? to.w : to.a, is_rate ? from.w : from.a, n);
}

static void write_angle(const YkBatch *b, const YkRun *run, size_t k, double *out, size_t n)
{
    YkChannel c = b->channels[k];
    if (c.order > 0)
        write_turning(b, k, out, n);
    else if (c.kind == YK_CHANNEL_COORDINATE)
        write_coordinate_angle(b, run, (size_t)c.index, out, n);
    else if (c.kind == YK_CHANNEL_BODY)
        write_body_angle(b, run, (size_t)c.index, out, b->point.x, n);
    else
        write_joint_angle(b, run, (size_t)c.index, out, n);
}

static void write_distance(const YkBatch *b, int32_t distance, int order, double *out, size_t n)
{
    YkSlide d = yk_space_slide(&b->space, distance);
    memcpy(out, order == 0 ? d.d : order == 1 ? d.v : d.a, n * sizeof *out);
}

static void write_point(const YkBatch *b, const YkRun *run, YkChannel c, double *out, size_t n)
{
    yk_run_point(run, (size_t)c.index, b->point);
    if (c.kind == YK_CHANNEL_POINT_SPEED) {
        for (size_t k = 0; k < n; k++) out[k] = sqrt(b->point.vx[k] * b->point.vx[k] + b->point.vy[k] * b->point.vy[k]);
        return;
    }
    const double *x[] = {b->point.x, b->point.vx, b->point.ax}, *y[] = {b->point.y, b->point.vy, b->point.ay};
    memcpy(out, (c.kind == YK_CHANNEL_POINT_X ? x : y)[c.order], n * sizeof *out);
}

static void make_channel(const YkBatch *b, const YkRun *run, size_t k, double *out)
{
    YkChannel c = b->channels[k];
    size_t n = run->lanes;
    switch (c.kind) {
    case YK_CHANNEL_COORDINATE: {
        const YkTreeCoordinate *q = &b->mech->coordinates[c.index];
        if (q->input != YK_NONE)
            memcpy(out, run->inputs[3 * q->input + c.order], n * sizeof *out);
        else if (q->is_distance)
            write_distance(b, q->distance, c.order, out, n);
        else
            write_angle(b, run, k, out, n);
        break;
    }
    case YK_CHANNEL_BODY:
    case YK_CHANNEL_JOINT_ANGLE:
        write_angle(b, run, k, out, n);
        break;
    case YK_CHANNEL_JOINT_DISTANCE:
        write_distance(b, b->mech->joint_distance[c.index], c.order, out, n);
        break;
    case YK_CHANNEL_POINT_X:
    case YK_CHANNEL_POINT_Y:
    case YK_CHANNEL_POINT_SPEED:
        write_point(b, run, c, out, n);
        break;
    case YK_CHANNEL_TIME:
    case YK_CHANNEL_TRANSMISSION:
    default: // yk_batch_new refuses forces
        for (size_t i = 0; i < n; i++) out[i] = b->state->time;
        break;
    }
}

// Writes a channel. masks: some lanes may not close, or are at a dead point.
static void write_channel(const YkBatch *b, const YkRun *run, size_t k, bool masks, double *out)
{
    YkChannel c = b->channels[k];
    size_t n = run->lanes;
    if (!b->row[k]) make_channel(b, run, k, out);
    if (!masks) return;
    bool is_input =
        c.kind == YK_CHANNEL_COORDINATE && b->mech->coordinates[c.index].input != YK_NONE; // known at a dead point too
    bool is_rate = (c.order > 0 && !is_input) || c.kind == YK_CHANNEL_POINT_SPEED;
    yk_lanes_mask(out, b->space.margin, is_rate ? nextafter(YK_SINGULAR_MARGIN, 1) : YK_LIMIT_MARGIN, n);
}

// --- running

static YkStatus worse(YkStatus a, YkStatus b)
{
    return a < 0 || b < 0 ? (a < b ? a : b) : (a > b ? a : b);
}

// Returns whether a lane's rates are blurred, as the state judges it.
static bool is_singular(YkBatch *b, size_t lane)
{
    yk_state_copy(b->state, b->home);
    for (size_t i = 0; i < 3 * b->mech->input_count; i++) b->state->input[i] = b->lanes_of[i][lane];
    return yk_state_solve(b->state) == YK_SINGULAR;
}

// The margin of a lane at a coincidence, until its answers are written. They are the state's, which settles the angles
// that no loop determines; a lane cannot.
#define SETTLED_MARGIN (-2.0)

// Judges a lane; leaves a margin that masks what it cannot tell. On a path the state judges close poses, not a lane.
static YkStatus judge_lane(YkBatch *b, size_t k)
{
    double *margin = &b->space.margin[k];
    bool closes = *margin >= YK_LIMIT_MARGIN && b->space.gap[k] <= yk_gap_tolerance(b->mech, *margin);
    bool is_close = closes ? *margin <= YK_BLUR_MARGIN : !b->is_along && yk_may_coincide(*margin);
    if (is_close && b->is_along) {
        *margin = fmin(*margin, YK_SINGULAR_MARGIN);
    } else if (is_close && is_singular(b, k)) {
        *margin = b->state->is_kept ? SETTLED_MARGIN : fmin(*margin, YK_SINGULAR_MARGIN);
        return YK_SINGULAR;
    } else if (!closes) {
        *margin = -1;
    }
    return !closes ? YK_LIMIT : *margin <= YK_SINGULAR_MARGIN ? YK_SINGULAR : YK_OK;
}

static void write_settled(YkBatch *b, double *const *outputs, size_t at, size_t n)
{
    for (size_t lane = 0; lane < n; lane++) {
        if (b->space.margin[lane] != SETTLED_MARGIN || !is_singular(b, lane)) continue;
        for (size_t k = 0; k < b->channel_count; k++)
            outputs[k][at + lane] = yk_state_channel(b->state, b->channels[k]);
    }
}

static YkStatus judge(YkBatch *b, signed char *status, size_t n)
{
    YkStatus worst = YK_OK;
    bool well;
    yk_lanes_well(&well, b->space.margin, b->space.gap, YK_BLUR_MARGIN, b->mech->size * YK_CLOSING_TOLERANCE, n);
    if (well) {
        if (status) memset(status, YK_OK, n);
        return YK_OK;
    }
    for (size_t k = 0; k < n; k++) {
        YkStatus one = judge_lane(b, k);
        if (status) status[k] = (signed char)one;
        worst = worse(worst, one);
    }
    return worst;
}

// Runs one pose of a machine with groups, with angles that are followed turn by turn, or with a channel that only a
// state knows: each pose is tracked from the batch's own state.
static YkStatus run_one(YkBatch *b, const double *const *inputs, double *const *outputs, size_t pose)
{
    yk_state_copy(b->state, b->home);
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        b->state->input[i] = inputs[i] ? inputs[i][pose] : b->constant[i * b->lanes];
    YkStatus status = yk_state_solve(b->state);
    if (status == YK_REDUNDANT) status = YK_OK;
    if (status < 0) status = YK_LIMIT;
    for (size_t k = 0; k < b->channel_count; k++)
        outputs[k][pose] = status < 0 ? 0 : yk_state_channel(b->state, b->channels[k]);
    return status;
}

static bool needs_state(const YkBatch *b)
{
    if (b->mech->has_groups || b->mech->reference_count > 0) return true;
    for (size_t k = 0; k < b->channel_count; k++)
        if (b->channels[k].kind == YK_CHANNEL_TRANSMISSION) return true;
    return false;
}

bool yk_batch_can_follow(const YkMechanism *mech, const YkChannel *channels, size_t channel_count)
{
    if (mech->has_groups || mech->relation_count + mech->derived_count > 0) return false;
    for (size_t c = 0; c < mech->coordinate_count; c++)
        if (mech->coordinates[c].is_sum) return false;
    for (size_t k = 0; k < channel_count; k++)
        if (channels[k].kind == YK_CHANNEL_TRANSMISSION || yk_channel_needs_forces(channels[k])) return false;
    return true;
}

static YkStatus run_poses(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                          size_t count)
{
    YkStatus worst = YK_OK;
    for (size_t pose = 0; pose < count; pose++) {
        YkStatus one = run_one(b, inputs, outputs, pose);
        if (status) status[pose] = (signed char)one;
        worst = worse(worst, one);
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

// Runs one block of lanes from `at`.
static YkStatus run_lanes(YkBatch *b, YkRun *run, const double *const *inputs, double *const *outputs,
                          signed char *status, size_t at)
{
    for (size_t i = 0; i < 3 * b->mech->input_count; i++)
        b->lanes_of[i] = inputs[i] ? inputs[i] + at : b->constant + i * b->lanes;
    for (size_t k = 0; k < b->channel_count; k++)
        if (b->row[k]) *b->row[k] = outputs[k] + at;
    yk_run_begin(run);
    yk_run_steps(run, 0, b->mech->step_count);
    YkStatus here = judge(b, status ? status + at : NULL, run->lanes);
    if (b->is_along) b->clear = clear_lanes(b, here, run->lanes);
    for (size_t k = 0; k < b->channel_count; k++) write_channel(b, run, k, here != YK_OK, outputs[k] + at);
    if (here != YK_OK) write_settled(b, outputs, at, run->lanes);
    return here;
}

static YkRun run_of(const YkBatch *b)
{
    return (YkRun){b->mech, (YkSpace *)(uintptr_t)&b->space, b->lanes_of, b->state->branch, NULL,
                   0,       b->home->slot_reference};
}

YkStatus yk_batch_run(YkBatch *b, const double *const *inputs, double *const *outputs, signed char *status,
                      size_t count)
{
    YkStatus worst = YK_OK;
    if (needs_state(b)) return run_poses(b, inputs, outputs, status, count);
    YkRun run = run_of(b);
    for (size_t at = 0; at < count; at += b->lanes) {
        run.lanes = count - at < b->lanes ? count - at : b->lanes;
        worst = worse(worst, run_lanes(b, &run, inputs, outputs, status, at));
    }
    return worst;
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
                          size_t count)
{
    YkRun run = run_of(b);
    for (size_t at = 0; at < count; at += b->lanes) {
        run.lanes = count - at < b->lanes ? count - at : b->lanes;
        run_lanes(b, &run, inputs, outputs, status, at);
        memcpy(b->state->reference, b->next, b->mech->coordinate_count * sizeof *b->next);
        if (b->clear == run.lanes) continue;
        return at + b->clear;
    }
    return count;
}

void yk_batch_refer(const YkBatch *b, YkState *state)
{
    memcpy(state->reference, b->state->reference, b->mech->coordinate_count * sizeof *state->reference);
}
