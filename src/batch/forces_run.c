// Runs the forces of lanes: brings the numbers of poses to the tape.
#include <stdlib.h>
#include "batch/lane_forces.h"

// --- what the tape reads

static bool is_in_space(YkLeafKind kind)
{
    return kind == YK_LEAF_OF_TURN || kind == YK_LEAF_OF_SLIDE || kind == YK_LEAF_OF_NODE || kind == YK_LEAF_OF_GAIN;
}

// Returns the place of a number in a space for one pose, whose records follow each other.
static size_t number_of(const YkMechanism *mech, const YkLeafSource *s)
{
    size_t index = (size_t)s->index, part = (size_t)s->part, slides = 4 * mech->slot_count;
    size_t planes = slides + 3 * mech->distance_count, gains = planes + 6 * (mech->node_count + YK_SCRATCH_COUNT) + 2;
    if (s->kind == YK_LEAF_OF_TURN) return 4 * index + part;
    if (s->kind == YK_LEAF_OF_SLIDE) return slides + 3 * index + part;
    if (s->kind == YK_LEAF_OF_NODE) return planes + 6 * index + part;
    return gains + index;
}

static void sort_needed(YkLaneForces *f, bool in_space)
{
    for (size_t k = 0; k < f->leaf_count; k++) {
        YkLeafSource s = f->sources[k];
        if (!yk_tape_needs(f->tape, k) || is_in_space(s.kind) != in_space) continue;
        if (s.kind == YK_LEAF_OF_COORDINATE) f->needs[s.index] = true;
        s.leaf = k;
        if (in_space) yk_tape_read_number(f->tape, k, number_of(f->mech, &s));
        s.one = yk_tape_leaf_of_one(f->tape, k);
        f->needed[f->needed_count++] = s;
    }
}

bool yk_lane_forces_keep_needed(YkLaneForces *f)
{
    f->needed = calloc(f->leaf_count + 1, sizeof *f->needed);
    if (!f->needed) return false;
    sort_needed(f, true);
    f->in_space = f->needed_count;
    sort_needed(f, false);
    return true;
}

// --- running

void yk_lane_forces_redesign(YkLaneForces *f)
{
    for (const YkLeafSource *s = f->needed; s < f->needed + f->needed_count; s++)
        if (s->kind == YK_LEAF_OF_PARAMETER)
            yk_tape_set(f->tape, s->leaf, yk_redesign_now(f->variant->redesign, s->index));
    yk_tape_prepare(f->tape);
}

static const double *lanes_of(const YkLeafSource *s, const YkLanePose *pose)
{
    const YkSpace *space = pose->space;
    if (s->kind == YK_LEAF_OF_TURN) {
        YkTurn t = yk_space_turn(space, s->index);
        return (const double *const[]){t.c, t.s, t.w, t.a}[s->part];
    }
    if (s->kind == YK_LEAF_OF_SLIDE) {
        YkSlide d = yk_space_slide(space, s->index);
        return (const double *const[]){d.d, d.v, d.a}[s->part];
    }
    if (s->kind == YK_LEAF_OF_NODE) {
        YkPlane n = yk_space_plane(space, s->index);
        return (const double *const[]){n.x, n.y, n.vx, n.vy, n.ax, n.ay}[s->part];
    }
    if (s->kind == YK_LEAF_OF_COORDINATE) return pose->positions[s->index];
    if (s->kind == YK_LEAF_OF_INPUT) return pose->inputs[3 * s->index + s->part];
    if (s->kind == YK_LEAF_OF_TIME) return pose->times;
    return space->gain + (size_t)s->index * space->stride;
}

void yk_lane_forces_run(YkLaneForces *f, const YkLanePose *pose, double *const *out, size_t n)
{
    for (const YkLeafSource *s = f->needed; s < f->needed + f->needed_count; s++) {
        if (s->kind == YK_LEAF_OF_PARAMETER) continue;
        if (s->kind == YK_LEAF_OF_TIME && !pose->times)
            yk_tape_set(f->tape, s->leaf, pose->time);
        else if (pose->which)
            yk_tape_pack_lanes(f->tape, s->leaf, lanes_of(s, pose), pose->which, n);
        else
            yk_tape_set_lanes(f->tape, s->leaf, lanes_of(s, pose));
    }
    yk_tape_run(f->tape, out, n);
}

// Returns a number of one pose that is not in its space.
static double number_beside(const YkLeafSource *s, const YkLanePose *pose)
{
    if (s->kind == YK_LEAF_OF_COORDINATE) return *pose->positions[s->index];
    if (s->kind == YK_LEAF_OF_INPUT) return *pose->inputs[3 * s->index + s->part];
    return pose->times ? *pose->times : pose->time;
}

const double *const *yk_lane_forces_run_one(YkLaneForces *f, const YkLanePose *pose)
{
    const YkLeafSource *s = f->needed + f->in_space, *end = f->needed + f->needed_count;
    for (; s < end; s++)
        if (s->kind != YK_LEAF_OF_PARAMETER) *s->one = number_beside(s, pose);
    return yk_tape_run_one(f->tape, pose->space->data);
}
