// Places the bodies: by a point of each, or by a neighbour if a body has no named point.
#include "picture/drawing/drawing.h"

static bool is_placed(YkFrame frame)
{
    return isfinite(frame.origin.x);
}

// Places body `side` of a joint from the other one.
static void place_beside(const YkJoint *joint, int side, double distance, YkFrame *frames)
{
    YkFrame *own = &frames[joint->body[side]], *a = &frames[joint->body[0]], *other = &frames[joint->body[!side]];
    YkVec along = yk_mul(a->axis, joint->along); // world direction of the joint's line
    YkVec meeting = yk_frame_apply(*other, joint->at[!side]);
    YkVec at = yk_add(meeting, yk_scale(side == 1 ? distance : -distance, along));
    own->origin = yk_sub(at, yk_mul(own->axis, joint->at[side]));
}

static double distance_of(const YkState *state, const YkModel *model, size_t joint)
{
    YkPartKind kind = model->joints[joint].kind;
    if (kind != YK_SLIDE && kind != YK_PIN_SLOT) return 0;
    YkChannel channel = {.kind = YK_CHANNEL_JOINT_DISTANCE, .index = (int)joint, .quantity = YK_QUANTITY_LENGTH};
    return yk_state_channel(state, channel);
}

// Passes once over the joints; returns true if it placed something. Bodies without points are rare and attached to one
// with points, so one or two passes are enough.
static bool pass(const YkModel *model, const YkState *state, YkFrame *frames)
{
    bool found = false;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        bool first = is_placed(frames[joint->body[0]]), second = is_placed(frames[joint->body[1]]);
        if (first == second) continue;
        place_beside(joint, first ? 1 : 0, distance_of(state, model, j), frames);
        found |= is_placed(frames[joint->body[first ? 1 : 0]]);
    }
    return found;
}

bool yk_drawing_place(const YkDrawing *drawing, const YkState *state, YkFrame *frames)
{
    const YkModel *model = drawing->model;
    yk_state_bodies(state, drawing->motions);
    for (size_t b = yk_model_body_count(model); b < model->body_count; b++)
        drawing->motions[b] =
            yk_state_body(state, b); // carriages of free joints are not drawn, but joints connect other bodies to them
    for (size_t b = 0; b < model->body_count; b++) {
        frames[b].axis = yk_unit(drawing->motions[b].position);
        frames[b].origin = b == 0 ? yk_vec(0, 0) : yk_vec(NAN, NAN);
        if (b == 0 || model->bodies[b].point_count == 0) continue;
        size_t p = (size_t)model->bodies[b].first_point;
        YkPointMotion motion = yk_state_point(state, p);
        YkVec world = yk_vec(motion.position[0], motion.position[1]);
        frames[b].origin = yk_sub(world, yk_mul(frames[b].axis, model->points[p].at));
    }
    while (pass(model, state, frames)) {}
    for (size_t b = 0; b < model->body_count; b++)
        if (!is_placed(frames[b]) || !isfinite(frames[b].axis.x)) return false;
    yk_drawing_move_followers(drawing, frames);
    return true;
}
