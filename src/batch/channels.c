// Channels of a batch: the requests to the lanes.
#include <math.h>
#include <string.h>
#include "batch/inside.h"
#include "solve/run.h"

// Prepares a channel that is an angle: between which orientations.
void yk_batch_prepare_angle(YkBatch *b, size_t k)
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

// Returns the pointer to the lanes of a space that already hold a channel as requested: a distance, a rate relative to
// the ground. NULL if it has to be computed.
static double **row_of(const YkBatch *b, const YkSpace *space, size_t k)
{
    const YkMechanism *mech = b->mech;
    YkChannel c = b->channels[k];
    const YkTreeCoordinate *q = c.kind == YK_CHANNEL_COORDINATE ? &mech->coordinates[c.index] : NULL;
    if (q && q->input != YK_NONE) return NULL;
    if (c.kind == YK_CHANNEL_JOINT_DISTANCE || (q && q->is_distance)) {
        YkSlide *d = &space->slide[q ? q->distance : mech->joint_distance[c.index]];
        return c.order == 0 ? &d->d : c.order == 1 ? &d->v : &d->a;
    }
    if (c.order > 0 && b->turns[k][0] == 0 && b->turns[k][1] != 0) {
        YkTurn *t = &space->turn[b->turns[k][1]];
        return c.order == 1 ? &t->w : &t->a;
    }
    return NULL;
}

// Returns a row that is still free: it can be redirected to one channel only; further channels get a copy.
double **yk_batch_free_row_of(YkBatch *b, size_t k)
{
    double **row = row_of(b, &b->space, k);
    for (size_t j = 0; row && j < k; j++)
        if (b->row[j] == row) return NULL;
    return row;
}

const double *yk_batch_number_of(const YkBatch *b, size_t k)
{
    double *const *row = row_of(b, &b->single, k);
    return row ? *row : NULL;
}

// --- writing

// Counts turns along a path, whose angles change by less than half a turn from lane to lane.
static void count_turns(const YkBatch *b, size_t coordinate, double *out, size_t n)
{
    const YkTreeCoordinate *q = &b->mech->coordinates[coordinate];
    YkTurn from = yk_space_turn(b->run.space, q->angle.a), to = yk_space_turn(b->run.space, q->angle.b);
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

void yk_batch_write_angle(const YkBatch *b, size_t coordinate, double *out, size_t n)
{
    const YkTreeCoordinate *q = &b->mech->coordinates[coordinate];
    YkTurn from = yk_space_turn(b->run.space, q->angle.a), to = yk_space_turn(b->run.space, q->angle.b);
    if (q->input != YK_NONE)
        memcpy(out, b->run.inputs[3 * q->input], n * sizeof *out);
    else
        yk_lanes_angle(out, from, to, q->angle.offset, b->state->reference[coordinate], n);
    if (b->is_along && q->input == YK_NONE) count_turns(b, coordinate, out, n);
}

static void add_turn_at(const YkBatch *b, int32_t body, double *out, double *one, size_t n)
{
    int32_t at = b->mech->tree.joint[body], coordinate = yk_tree_coordinate(b->mech, at, false);
    const YkJoint *joint = &b->mech->model->joints[at];
    double way = joint->body[1] == body ? 1 : -1;
    if (coordinate != YK_NONE) yk_batch_write_angle(b, (size_t)coordinate, one, n);
    for (size_t k = 0; k < n; k++) out[k] += way * (coordinate != YK_NONE ? one[k] : joint->turned);
}

// Writes a body's angle: the sum along the tree, as yk_state_body adds it.
static void write_body_angle(const YkBatch *b, size_t body, double *out, double *one, size_t n)
{
    int32_t path[YK_TREE_PATH];
    for (size_t k = 0; k < n; k++) out[k] = 0;
    for (size_t from = 1, count; (count = yk_tree_path(b->mech, (int32_t)body, from, path)) > 0; from += count)
        for (size_t k = 0; k < count; k++) add_turn_at(b, path[k], out, one, n);
}

// Writes the angle of a joint: the difference of its bodies' angles.
static void write_joint_angle(const YkBatch *b, size_t joint, double *out, size_t n)
{
    const YkJoint *j = &b->mech->model->joints[joint];
    write_body_angle(b, (size_t)j->body[1], out, b->point.x, n);
    write_body_angle(b, (size_t)j->body[0], b->point.y, b->point.x, n);
    for (size_t k = 0; k < n; k++) out[k] -= b->point.y[k];
}

static void write_turning(const YkBatch *b, size_t k, double *out, size_t n)
{
    YkTurn from = yk_space_turn(b->run.space, b->turns[k][0]), to = yk_space_turn(b->run.space, b->turns[k][1]);
    bool is_rate = b->channels[k].order == 1;
    yk_lanes_difference(out, is_rate ? to.w : to.a, is_rate ? from.w : from.a, n);
}

static void write_angle(const YkBatch *b, size_t k, double *out, size_t n)
{
    YkChannel c = b->channels[k];
    if (c.order > 0)
        write_turning(b, k, out, n);
    else if (c.kind == YK_CHANNEL_COORDINATE)
        yk_batch_write_angle(b, (size_t)c.index, out, n);
    else if (c.kind == YK_CHANNEL_BODY)
        write_body_angle(b, (size_t)c.index, out, b->point.x, n);
    else
        write_joint_angle(b, (size_t)c.index, out, n);
}

static void write_distance(const YkBatch *b, int32_t distance, int order, double *out, size_t n)
{
    YkSlide d = yk_space_slide(b->run.space, distance);
    memcpy(out, order == 0 ? d.d : order == 1 ? d.v : d.a, n * sizeof *out);
}

static void write_point(const YkBatch *b, YkChannel c, double *out, size_t n)
{
    yk_run_point(&b->run, (size_t)c.index, b->point);
    if (c.kind == YK_CHANNEL_POINT_SPEED) {
        for (size_t k = 0; k < n; k++) out[k] = sqrt(b->point.vx[k] * b->point.vx[k] + b->point.vy[k] * b->point.vy[k]);
        return;
    }
    const double *x[] = {b->point.x, b->point.vx, b->point.ax}, *y[] = {b->point.y, b->point.vy, b->point.ay};
    memcpy(out, (c.kind == YK_CHANNEL_POINT_X ? x : y)[c.order], n * sizeof *out);
}

static void make_channel(const YkBatch *b, size_t k, double *out)
{
    YkChannel c = b->channels[k];
    size_t n = b->run.lanes;
    switch (c.kind) {
    case YK_CHANNEL_COORDINATE: {
        const YkTreeCoordinate *q = &b->mech->coordinates[c.index];
        if (q->input != YK_NONE)
            memcpy(out, b->run.inputs[3 * q->input + c.order], n * sizeof *out);
        else if (q->is_distance)
            write_distance(b, q->distance, c.order, out, n);
        else
            write_angle(b, k, out, n);
        break;
    }
    case YK_CHANNEL_BODY:
    case YK_CHANNEL_JOINT_ANGLE:
        write_angle(b, k, out, n);
        break;
    case YK_CHANNEL_JOINT_DISTANCE:
        write_distance(b, b->mech->joint_distance[c.index], c.order, out, n);
        break;
    case YK_CHANNEL_POINT_X:
    case YK_CHANNEL_POINT_Y:
    case YK_CHANNEL_POINT_SPEED:
        write_point(b, c, out, n);
        break;
    case YK_CHANNEL_TIME:
    case YK_CHANNEL_TRANSMISSION:
    default:
        for (size_t i = 0; i < n; i++) out[i] = b->times ? b->times[i] : b->state->time;
        break;
    }
}

// Makes a channel 0 in lanes that have no answer.
static void write_mask(const YkBatch *b, size_t k, double *out, size_t n)
{
    YkChannel c = b->channels[k];
    bool is_input =
        c.kind == YK_CHANNEL_COORDINATE && b->mech->coordinates[c.index].input != YK_NONE; // known at a dead point too
    bool is_rate = (c.order > 0 && !is_input) || c.kind == YK_CHANNEL_POINT_SPEED || yk_channel_needs_forces(c);
    yk_lanes_mask(out, b->run.space->margin, is_rate ? nextafter(YK_SINGULAR_MARGIN, 1) : YK_LIMIT_MARGIN, n);
}

void yk_batch_write_channel(const YkBatch *b, size_t k, bool masks, double *out)
{
    bool is_there = b->row[k] && b->run.space == &b->space;
    if (!is_there && !yk_channel_needs_forces(b->channels[k])) make_channel(b, k, out);
    if (masks) write_mask(b, k, out, b->run.lanes);
}
