// Counts equations and unknowns, as a textbook does.
//
// Every moving body has two force equations and a moment equation. A pin that joins three bodies or more is a massless
// junction with two force equations of its own and a force from each body. A joint that closes a loop gives as many
// acceleration equations as it takes freedoms; a gear, rack, belt, cam or law gives one, and a force of its own. If the
// forces on a body all meet in its centre of mass, its moment equation is trivial - the moment of its guide is 0 - and
// both are left out.
#include <stdlib.h>
#include "base/sets.h"
#include "dynamics/dynamics.h"

static bool are_one_point(YkVec a, YkVec b, double size)
{
    return yk_norm(yk_sub(a, b)) <= 1e-12 * size;
}

typedef struct Meeting { // of the forces on a body
    int slides, others;
    bool in_center;
} Meeting;

static void look_at_joints(const YkDynamics *d, Meeting *meetings)
{
    const YkModel *model = d->mech->model;
    for (size_t b = 0; b < model->body_count; b++) meetings[b].in_center = true;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        for (int side = 0; side < 2; side++) {
            Meeting *m = &meetings[joint->body[side]];
            if (joint->kind == YK_SLIDE)
                m->slides++;
            else
                m->others++;
            bool is_bearing = joint->kind == YK_SLIDE && side == 1; // its normal force passes through the point `to`
            bool is_pin = joint->kind == YK_PIN;
            YkVec center = yk_reference_point(model, (size_t)joint->body[side]);
            if ((!is_pin && !is_bearing) || !are_one_point(joint->at[side], center, d->mech->size))
                m->in_center = false;
        }
    }
}

// Considers wheels, racks and cams, whose forces turn their bodies; the drive of a law acts along its guide.
static void look_at_meshes(const YkModel *model, Meeting *meetings)
{
    for (size_t k = 0; k < model->gear_count; k++)
        for (int i = 0; i < 2; i++) meetings[model->gears[k].body[i]].in_center = false;
    for (size_t k = 0; k < model->belt_count; k++)
        for (int i = 0; i < 2; i++) meetings[model->belts[k].body[i]].in_center = false;
    for (size_t k = 0; k < model->rack_count; k++)
        meetings[model->racks[k].pinion].in_center = meetings[model->racks[k].rack].in_center = false;
    for (size_t k = 0; k < model->cam_count; k++)
        meetings[model->cams[k].cam].in_center = meetings[model->cams[k].follower].in_center = false;
}

// Returns whether a load turns the body.
static bool is_turned(const YkDynamics *d, size_t body)
{
    for (size_t k = 0; k < d->loads->item_count; k++) {
        const YkLoadItem *item = &d->loads->items[k];
        if (item->joint != YK_NONE && item->is_distance) continue; // along the guide
        if (item->joint == YK_NONE) {
            if (item->body[0] == (int32_t)body || (item->kind == YK_LOAD_SPRING && item->body[1] == (int32_t)body))
                return true;
            continue;
        }
        const YkJoint *j = &d->mech->model->joints[item->joint];
        if (j->body[0] == (int32_t)body || j->body[1] == (int32_t)body) return true;
    }
    return false;
}

static bool is_trivial(const YkDynamics *d, const Meeting *meetings, size_t body)
{
    return meetings[body].slides == 1 && meetings[body].in_center && !is_turned(d, body);
}

typedef struct PinEnd {
    int32_t body, joint;
    YkVec at;
} PinEnd;

static int by_place(const void *a, const void *b)
{
    const PinEnd *p = a, *q = b;
    if (p->body != q->body) return p->body < q->body ? -1 : 1;
    if (p->at.x != q->at.x) return p->at.x < q->at.x ? -1 : 1;
    return p->at.y != q->at.y ? (p->at.y < q->at.y ? -1 : 1) : p->joint - q->joint;
}

// Counts junctions: sets of at least two pins in one point, chained by the bodies they share.
static size_t count_junctions(const YkModel *model, bool *ran_out)
{
    PinEnd *ends = calloc(2 * model->joint_count + 1, sizeof *ends);
    int32_t *parent = calloc(model->joint_count + 1, sizeof *parent),
            *size = calloc(model->joint_count + 1, sizeof *size);
    size_t count = 0, junctions = 0;
    *ran_out = !ends || !parent || !size;
    if (parent) yk_sets_begin(parent, model->joint_count);
    for (size_t j = 0; ends && parent && size && j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        for (int side = 0; side < 2 && joint->kind == YK_PIN; side++)
            ends[count++] = (PinEnd){joint->body[side], (int32_t)j, joint->at[side]};
    }
    if (count > 0) {
        qsort(ends, count, sizeof *ends, by_place);
        for (size_t k = 1; k < count; k++)
            if (ends[k].body == ends[k - 1].body && ends[k].body != 0 && ends[k].at.x == ends[k - 1].at.x &&
                ends[k].at.y == ends[k - 1].at.y)
                yk_sets_join(parent, ends[k].joint, ends[k - 1].joint);
        for (size_t j = 0; j < model->joint_count; j++)
            if (model->joints[j].kind == YK_PIN && ++size[yk_root_of(parent, (int32_t)j)] == 2) junctions++;
    }
    free(ends);
    free(parent);
    free(size);
    return junctions;
}

// Joins bodies whose angles are tied by slides and welds of the tree.
static void join_orientations(const YkMechanism *mech, int32_t *parent)
{
    const YkModel *model = mech->model;
    yk_sets_begin(parent, model->body_count);
    for (size_t b = 1; b < model->body_count; b++) {
        int32_t j = mech->tree.joint[b];
        if (j == YK_NONE || yk_part(model->joints[j].kind)->turns) continue;
        yk_sets_join(parent, model->joints[j].body[0], model->joints[j].body[1]);
    }
}

static size_t count_closing(const YkMechanism *mech, int32_t *parent)
{
    size_t count = mech->relation_count;
    join_orientations(mech, parent);
    for (size_t l = 0; l < mech->loop_count; l++) {
        const YkJoint *joint = &mech->model->joints[mech->loops[l].joint];
        const YkPart *part = yk_part(joint->kind);
        bool turn_together = yk_root_of(parent, joint->body[0]) == yk_root_of(parent, joint->body[1]);
        count += part->slides ? 1 : 2;
        if (!part->turns && !turn_together) count++;
    }
    return count;
}

YkEquationCount yk_dynamics_count(const YkDynamics *d)
{
    const YkModel *model = d->mech->model;
    YkEquationCount c = {0};
    Meeting *meetings = calloc(model->body_count, sizeof *meetings);
    int32_t *parent = calloc(model->body_count, sizeof *parent);
    if (!meetings || !parent) {
        free(meetings);
        free(parent);
        c.ran_out = true;
        return c;
    }
    look_at_joints(d, meetings);
    look_at_meshes(model, meetings);
    size_t junctions = count_junctions(model, &c.ran_out);
    c.force = 2 * (model->body_count - model->carriage_count - 1 + junctions);
    c.unknown_reactions = 2 * junctions;
    for (size_t j = 0; j < model->joint_count; j++)
        if (!model->joints[j].is_free) c.unknown_reactions += (size_t)yk_part(model->joints[j].kind)->constraints;
    for (size_t b = 1; b < model->body_count - model->carriage_count; b++) {
        if (is_trivial(d, meetings, b))
            c.unknown_reactions--;
        else
            c.moment++;
    }
    c.acceleration = count_closing(d->mech, parent);
    c.unknown_reactions += d->mech->relation_count;
    c.unknown_accelerations = d->mech->coordinate_count;
    for (size_t i = 0; i < d->mech->input_count; i++)
        if (!d->is_free[i]) {
            c.unknown_accelerations--;
            c.unknown_efforts++;
        }
    free(meetings);
    free(parent);
    return c;
}
