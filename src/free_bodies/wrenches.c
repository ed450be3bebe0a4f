// Finds the forces and couples that each joint and input transmits, and where they act at a pose.
#include "free_bodies/inside.h"

static const struct {
    size_t count;
    YkWrenchKind kinds[3];
} reactions[YK_PART_COUNT] = {
    [YK_PIN] = {2, {YK_WRENCH_X, YK_WRENCH_Y}},
    [YK_SLIDE] = {2, {YK_WRENCH_NORMAL, YK_WRENCH_COUPLE}},
    [YK_PIN_SLOT] = {1, {YK_WRENCH_NORMAL}},
    [YK_WELD] = {3, {YK_WRENCH_X, YK_WRENCH_Y, YK_WRENCH_COUPLE}},
};

static void add(YkFreeBodies *f, size_t joint, int32_t input, YkWrenchKind kind)
{
    const YkJoint *j = &f->mech->model->joints[joint];
    f->columns[f->column_count++] =
        (YkWrenchColumn){.joint = (int32_t)joint, .input = input, .body = {j->body[0], j->body[1]}, .kind = kind};
}

bool yk_wrenches_build(YkFreeBodies *f)
{
    const YkMechanism *mech = f->mech;
    const YkModel *model = mech->model;
    size_t n = model->joint_count;
    f->columns = YK_NEW(f->arena, YkWrenchColumn, 3 * n + mech->input_count + mech->relation_count + 1);
    f->joint_first = YK_NEW(f->arena, uint32_t, n + 1);
    f->input_column = YK_NEW(f->arena, int32_t, mech->input_count + 1);
    if (yk_arena_failed(f->arena)) return false;
    for (size_t j = 0; j < n; j++) {
        YkPartKind kind = model->joints[j].kind;
        f->joint_first[j] = (uint32_t)f->column_count;
        for (size_t k = 0; k < reactions[kind].count; k++) add(f, j, YK_NONE, reactions[kind].kinds[k]);
    }
    f->joint_first[n] = (uint32_t)f->column_count;
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[i]];
        f->input_column[i] = (int32_t)f->column_count;
        add(f, (size_t)c->joint, (int32_t)i, c->is_distance ? YK_WRENCH_LINE : YK_WRENCH_COUPLE);
    }
    yk_meshes_build(f);
    return true;
}

// A joint at a pose, lengths in m.
typedef struct JointPose {
    YkVec u;        // its line, world axes
    YkVec arm[2];   // from the reference point of each body to the joint's point
    YkVec by_rates; // relative acceleration of its two material points without the coordinate's own
} JointPose;

static YkVec axis_of(const YkFreeBodies *f, const YkSpace *space, int32_t body, double *w)
{
    const YkPlacing *placing = &f->mech->bodies[body];
    *w = 0;
    if (placing->orientation == 0) return placing->turn_unit;
    YkTurn turn = yk_space_turn(space, placing->orientation);
    *w = turn.w[0];
    return yk_mul(yk_vec(turn.c[0], turn.s[0]), placing->turn_unit);
}

// Places a joint. On the first body the point is the second's: out along the line by the distance.
static JointPose pose_of(const YkFreeBodies *f, const YkSpace *space, int32_t joint)
{
    const YkJoint *j = &f->mech->model->joints[joint];
    JointPose p = {.u = {0, 0}};
    double w[2], sliding = 0;
    YkVec e[2];
    for (int k = 0; k < 2; k++) {
        e[k] = axis_of(f, space, j->body[k], &w[k]);
        p.arm[k] = yk_mul(e[k], yk_sub(j->at[k], f->reference[j->body[k]]));
    }
    int32_t distance = f->mech->joint_distance[joint];
    if (distance != YK_NONE) {
        YkSlide slide = yk_space_slide(space, distance);
        p.u = yk_mul(e[0], j->along);
        p.arm[0] = yk_add(p.arm[0], yk_scale(slide.d[0], p.u));
        sliding = slide.v[0];
    }
    YkVec inward = yk_sub(yk_scale(w[1] * w[1], p.arm[1]), yk_scale(w[0] * w[0], p.arm[0]));
    p.by_rates = yk_add(inward, yk_scale(2 * w[0] * sliding, yk_quarter(p.u)));
    return p;
}

static YkVec direction_of(YkWrenchKind kind, YkVec u)
{
    switch (kind) {
    case YK_WRENCH_X:
        return yk_vec(1, 0);
    case YK_WRENCH_Y:
        return yk_vec(0, 1);
    case YK_WRENCH_NORMAL:
        return yk_quarter(u);
    case YK_WRENCH_LINE:
        return u;
    case YK_WRENCH_COUPLE:
    case YK_WRENCH_MESH:
        break;
    }
    return yk_vec(0, 0);
}

// The columns of a joint stand together; those of the inputs follow.
void yk_wrenches_pose(YkFreeBodies *f, const YkSpace *space)
{
    JointPose p = {.u = {0, 0}};
    int32_t placed = YK_NONE;
    for (size_t k = 0; k < f->column_count; k++) {
        YkWrenchColumn *c = &f->columns[k];
        c->share = c->freeness = 0;
        if (c->kind == YK_WRENCH_MESH) {
            yk_mesh_pose(f, space, c);
            continue;
        }
        if (c->joint != placed) p = pose_of(f, space, placed = c->joint);
        double couple = c->kind == YK_WRENCH_COUPLE;
        c->force = direction_of(c->kind, p.u);
        c->moment[0] = -yk_cross(p.arm[0], c->force) / f->size - couple;
        c->moment[1] = yk_cross(p.arm[1], c->force) / f->size + couple;
        c->bias = yk_dot(c->force, p.by_rates) / f->size;
    }
}

double yk_wrench_dot(const YkFreeBodies *f, const YkWrenchColumn *c, const double *x)
{
    double sum = 0;
    for (int k = 0; k < 2; k++) {
        if (c->body[k] == 0) continue;
        const double *row = x + f->body_row[c->body[k]];
        sum += (k ? 1 : -1) * (c->force.x * row[0] + c->force.y * row[1]) + c->moment[k] * row[2];
    }
    return sum;
}
