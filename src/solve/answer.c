// Reads the answers from a pose.
#include <string.h>
#include "elementary/elementary.h"
#include "solve/angle.h"
#include "solve/pose.h"
#include "solve/state.h"

// The answers for a coordinate, a body or a point that does not exist.
static const YkMotion unknown = {(double)NAN, (double)NAN, (double)NAN};
static const YkPointMotion unknown_point = {
    {(double)NAN, (double)NAN}, {(double)NAN, (double)NAN}, {(double)NAN, (double)NAN}};

YK_INLINE YkMotion without_rates(YkMotion m, bool has_rates)
{
    return (YkMotion){m.position, has_rates ? m.velocity : 0, has_rates ? m.acceleration : 0};
}

YK_INLINE YkMotion distance_in(const YkSpace *space, int32_t distance)
{
    Slide d = pose_slides(space)[distance];
    return (YkMotion){d.d, d.v, d.a};
}

// Returns the reference of an angle: its last value, or the sum of inputs that it is.
YK_INLINE double reference_of(const YkState *s, const YkSpace *space, const YkTreeCoordinate *c)
{
    if (!c->is_sum) return s->reference[c - s->mech->coordinates];
    const double *inputs = space == &s->space ? s->valid_input : s->input;
    double sum = c->sum_offset;
    for (uint32_t k = c->first_source; k < c->first_source + c->source_count; k++)
        sum += s->mech->sources[k].factor * inputs[3 * s->mech->sources[k].index];
    return sum;
}

// Uses the lanes' arithmetic, as the batch does: the same bits.
YK_INLINE YkMotion coordinate_in(const YkState *s, const YkSpace *space, const YkTreeCoordinate *c)
{
    if (c->is_distance) return distance_in(space, c->distance);
    Line a = pose_turns(space)[c->angle.a], b = pose_turns(space)[c->angle.b];
    double reference = reference_of(s, space, c);
    return (YkMotion){angle_between(a.e, c->angle.a != 0, b.e, c->angle.offset, reference), b.w - a.w, b.a - a.a};
}

YkMotion yk_coordinate_in(const YkState *s, const YkSpace *space, size_t coordinate)
{
    return coordinate_in(s, space, &s->mech->coordinates[coordinate]);
}

YkMotion yk_state_coordinate(const YkState *s, size_t coordinate)
{
    if (coordinate >= s->mech->coordinate_count) return unknown;
    const YkTreeCoordinate *c = &s->mech->coordinates[coordinate];
    if (c->input == YK_NONE) return without_rates(coordinate_in(s, &s->space, c), s->has_rates);
    const double *in = s->valid_input + 3 * c->input; // as it was set, to the last bit and turn
    return (YkMotion){in[0], in[1], in[2]};
}

// Adds angles along the tree, so that a body's angle is as continuous as its coordinates.
static double turn_at(const YkState *s, int32_t body)
{
    const YkMechanism *mech = s->mech;
    const YkJoint *joint = &mech->model->joints[mech->tree.joint[body]];
    int32_t c = yk_tree_coordinate(mech, mech->tree.joint[body], false);
    double turn = c == YK_NONE ? joint->turned : yk_state_coordinate(s, (size_t)c).position;
    return joint->body[1] == body ? turn : -turn;
}

static YkMotion motion_of(const YkState *s, size_t body, double angle)
{
    Line t = pose_turns(&s->space)[s->mech->bodies[body].orientation];
    return without_rates((YkMotion){angle, t.w, t.a}, s->has_rates);
}

// Angles add up along the tree, so that a body's angle is as continuous as its coordinates; from the root, as
// yk_state_bodies and batches add them: the same bits.
YkMotion yk_state_body(const YkState *s, size_t body)
{
    if (body >= s->mech->model->body_count) return unknown;
    int32_t path[YK_TREE_PATH];
    double angle = 0;
    for (size_t from = 1, n; (n = yk_tree_path(s->mech, (int32_t)body, from, path)) > 0; from += n)
        for (size_t k = 0; k < n; k++) angle += turn_at(s, path[k]);
    return motion_of(s, body, angle);
}

// Returns the angle of a body whose parents are known; of a carriage's own they are those before it.
static double angle_after(const YkState *s, int32_t body, const YkMotion *motions)
{
    int32_t parent = s->mech->tree.parent[body];
    if (parent == YK_NONE) return 0;
    bool is_carried = s->mech->model->bodies[parent].is_carriage;
    return (is_carried ? angle_after(s, parent, motions) : motions[parent].position) + turn_at(s, body);
}

void yk_state_bodies(const YkState *s, YkMotion *motions)
{
    const YkMechanism *mech = s->mech;
    for (size_t k = 0; k < mech->model->body_count; k++) {
        int32_t b = mech->tree_order[k];
        if (!mech->model->bodies[b].is_carriage) motions[b] = motion_of(s, (size_t)b, angle_after(s, b, motions));
    }
}

// Uses the lanes' arithmetic, as the batch does: the same bits.
YkPointMotion yk_state_point(const YkState *s, size_t point)
{
    if (point >= s->mech->model->point_count) return unknown_point;
    double x[6];
    YkRun run = {.mech = s->mech, .space = &s->space, .lanes = 1};
    yk_run_point(&run, point, (YkPlane){x, x + 1, x + 2, x + 3, x + 4, x + 5});
    if (!s->has_rates) return (YkPointMotion){{x[0], x[1]}, {0, 0}, {0, 0}};
    return (YkPointMotion){{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}};
}

static YkVec place_of(YkPlane p)
{
    return yk_vec(p.x[0], p.y[0]);
}

// Returns sin^2 of the angle between a block's columns; the margin is less if a length varies and may vanish.
static double sine2(const YkState *s, const YkBlock *b, double margin)
{
    bool is_plain = b->kind >= YK_BLOCK_PP || (b->form > YK_FORM_RRR_SHORT && b->kind != YK_BLOCK_RPR);
    if (is_plain) return margin;
    YkRun run = {.mech = s->mech, .space = &s->space, .lanes = 1};
    YkPlane p = yk_space_scratch(&s->space, YK_SCRATCH_ARM_1);
    double share = 1;
    if (b->kind == YK_BLOCK_RPR) {
        yk_run_sum(&run, &b->known, p);
        double K2 = yk_dot(place_of(p), place_of(p));
        return K2 > 0 ? margin * fmax(1, 1 / (K2 * b->per_size2)) : 0;
    }
    for (int k = 0; b->kind <= YK_BLOCK_RRP && k < (b->kind == YK_BLOCK_RRR ? 2 : 1); k++) {
        yk_run_sum(&run, &b->aside->arm[k], p);
        double enough = b->arm_is_constant[k] ? YK_PER_ARM_ENOUGH2 : 1;
        share = fmin(share, yk_arm_share(yk_dot(place_of(p), place_of(p)), enough * b->per_size2));
    }
    return share > 0 ? margin / share : 0;
}

double yk_state_transmission(const YkState *s, size_t block)
{
    if (block >= s->mech->block_count) return (double)NAN;
    double m = sine2(s, &s->mech->blocks[block], s->space.block_margin[block]);
    return yk_asin(sqrt(fmin(1, fmax(0, m))));
}

static double order_of(YkMotion m, int order)
{
    return order == 0 ? m.position : order == 1 ? m.velocity : m.acceleration;
}

static double point_order(const YkPointMotion *m, int order, int axis)
{
    return order == 0 ? m->position[axis] : order == 1 ? m->velocity[axis] : m->acceleration[axis];
}

double yk_state_channel(const YkState *s, YkChannel c)
{
    size_t index = (size_t)c.index;
    YkPointMotion p;
    switch (c.kind) {
    case YK_CHANNEL_TIME:
        return s->time;
    case YK_CHANNEL_COORDINATE:
        return order_of(yk_state_coordinate(s, index), c.order);
    case YK_CHANNEL_BODY:
        return order_of(yk_state_body(s, index), c.order);
    case YK_CHANNEL_JOINT_DISTANCE:
        return order_of(without_rates(distance_in(&s->space, s->mech->joint_distance[index]), s->has_rates), c.order);
    // For a joint that closes a loop: the difference of its bodies' continuous angles.
    case YK_CHANNEL_JOINT_ANGLE: {
        const YkJoint *j = &s->mech->model->joints[index];
        YkMotion a = yk_state_body(s, (size_t)j->body[0]), b = yk_state_body(s, (size_t)j->body[1]);
        return order_of((YkMotion){b.position - a.position, b.velocity - a.velocity, b.acceleration - a.acceleration},
                        c.order);
    }
    case YK_CHANNEL_POINT_X:
    case YK_CHANNEL_POINT_Y:
        p = yk_state_point(s, index);
        return point_order(&p, c.order, c.kind == YK_CHANNEL_POINT_Y);
    case YK_CHANNEL_POINT_SPEED:
        p = yk_state_point(s, index);
        return sqrt(p.velocity[0] * p.velocity[0] + p.velocity[1] * p.velocity[1]); // not hypot: the batch's bits
    case YK_CHANNEL_TRANSMISSION:
        return yk_state_transmission(s, index);
    default: // forces: yk_dynamics_channel
        break;
    }
    return 0;
}

size_t yk_state_label(const YkState *s, char *text, size_t capacity)
{
    size_t length = 0;
    for (size_t b = 0; b < s->mech->block_count; b++) {
        const YkBlock *block = &s->mech->blocks[b];
        if (block->kind > YK_BLOCK_RPR && block->kind != YK_BLOCK_GROUP) continue;
        const char *parts[3] = {length > 0 ? " " : "", block->label,
                                s->branch[b] < 0   ? "-"
                                : s->branch[b] > 0 ? "+"
                                                   : "0"};
        for (int k = 0; k < 3; k++)
            for (const char *c = parts[k]; *c; c++, length++)
                if (length + 1 < capacity) text[length] = *c;
    }
    if (capacity > 0) text[length < capacity ? length : capacity - 1] = 0;
    return length;
}

void yk_state_write_label(const YkState *s, YkText *text)
{
    size_t length = yk_state_label(s, NULL, 0);
    yk_text_clear(text);
    if (!yk_text_reserve(text, length)) return;
    yk_state_label(s, text->data, length + 1);
    text->length = length;
}
