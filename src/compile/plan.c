// Makes the plan: groups of orientations, clusters, and the rounds of peeling and groups.
#include "compile/closure.h"
#include "compile/plan.h"

static bool allocate(YkPlan *plan)
{
    const YkMechanism *mech = plan->mech;
    size_t bodies = mech->model->body_count, joints = mech->model->joint_count + 1,
           orientations = mech->orientation_count;
    YkArena *a = plan->arena;
    plan->angle_input = YK_NEW(a, int32_t, joints);
    plan->distance_input = YK_NEW(a, int32_t, joints);
    plan->cluster = YK_NEW(a, int32_t, bodies);
    plan->cluster_first = YK_NEW(a, uint32_t, bodies + 2);
    plan->cluster_member = YK_NEW(a, int32_t, bodies);
    plan->cluster_tree.parent = YK_NEW(a, int32_t, bodies);
    plan->cluster_tree.joint = YK_NEW(a, int32_t, bodies);
    plan->cluster_tree.depth = YK_NEW(a, int32_t, bodies);
    plan->group_next = YK_NEW(a, int32_t, orientations);
    plan->orientation_next = YK_NEW(a, int32_t, bodies);
    plan->orientation_first = YK_NEW(a, int32_t, orientations);
    plan->cluster_known = YK_NEW(a, bool, bodies);
    plan->root_known = YK_NEW(a, bool, orientations);
    plan->distance_known = YK_NEW(a, bool, mech->distance_count + 1);
    plan->joint_used = YK_NEW(a, bool, joints);
    plan->body_placed = YK_NEW(a, bool, bodies);
    plan->anchors = yk_arena_alloc(a, bodies, sizeof *plan->anchors);
    plan->anchor_count = YK_NEW(a, int32_t, bodies);
    plan->queue = YK_NEW(a, int32_t, bodies + 1);
    plan->is_queued = YK_NEW(a, bool, bodies);
    return !yk_arena_failed(a);
}

static void reset(YkPlan *plan)
{
    YkMechanism *mech = plan->mech;
    mech->step_count = mech->block_count = mech->member_count = mech->column_count = mech->group_loop_count = 0;
    mech->redundant_count = mech->redundant_relation_count = mech->group_relation_count = 0;
    if (mech->recipe) mech->recipe->line_count = 0;
    mech->node_count = 0;
    mech->largest_group = 0;
    mech->has_groups = false;
    mech->source_count = mech->reference_count = mech->derived_count = 0;
    mech->relation_term_count = mech->own_term_count;
    for (size_t k = 0; k < mech->relation_count; k++) {
        mech->relations[k].is_solved = mech->relations[k].is_redundant = false;
        mech->relations[k].weight = 0;
    }
    for (size_t j = 0; j < mech->model->joint_count; j++) plan->angle_input[j] = plan->distance_input[j] = YK_NONE;
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[i]];
        (c->is_distance ? plan->distance_input : plan->angle_input)[c->joint] = (int32_t)i;
    }
    for (size_t o = mech->orientation_count; o-- > 0;) plan->orientation_first[o] = YK_NONE;
    for (size_t b = mech->model->body_count; b-- > 0;) {
        int32_t o = mech->bodies[b].orientation;
        plan->orientation_next[b] = plan->orientation_first[o];
        plan->orientation_first[o] = (int32_t)b;
    }
}

// --- groups of orientations

static void tie(YkPlan *plan, int32_t joint, int32_t from, int32_t root)
{
    YkMechanism *mech = plan->mech;
    YkJointAngle angle = yk_joint_angle(mech, joint);
    bool forward = angle.a == from;
    int32_t o = forward ? angle.b : angle.a;
    mech->group_root[o] = root;
    plan->group_next[o] = plan->group_next[root];
    plan->group_next[root] = o;
    int32_t parent = from;
    if (root != 0) {
        mech->relative_slot[o] = (int32_t)mech->slot_count++;
        parent = from == root ? 0 : mech->relative_slot[from];
    }
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_TURN,
                                .target = root == 0 ? o : mech->relative_slot[o],
                                .parent = parent,
                                .input = plan->angle_input[joint],
                                .offset = -angle.offset,
                                .sign = forward ? 1 : -1});
}

// Makes groups breadth first over orientations, along the joints whose angle is an input. The group's own list is the
// queue.
static void make_groups(YkPlan *plan)
{
    YkMechanism *mech = plan->mech;
    int32_t *queue = YK_NEW(plan->arena, int32_t, mech->orientation_count);
    if (!queue) {
        plan->failed = true;
        return;
    }
    mech->slot_count = mech->orientation_count;
    for (size_t o = 0; o < mech->orientation_count; o++) {
        mech->group_root[o] = YK_NONE;
        mech->relative_slot[o] = 0;
        plan->group_next[o] = (int32_t)o;
    }
    for (size_t root = 0; root < mech->orientation_count; root++) {
        if (mech->group_root[root] != YK_NONE) continue;
        size_t head = 0, tail = 0;
        mech->group_root[root] = (int32_t)root;
        queue[tail++] = (int32_t)root;
        while (head < tail) {
            int32_t o = queue[head++];
            for (int32_t b = plan->orientation_first[o]; b != YK_NONE; b = plan->orientation_next[b])
                for (uint32_t k = plan->incidence->first[b]; k < plan->incidence->first[b + 1]; k++) {
                    int32_t joint = plan->incidence->joint[k], other = yk_other_body(mech->model, joint, b);
                    int32_t p = mech->bodies[other].orientation;
                    if (plan->angle_input[joint] == YK_NONE || mech->group_root[p] != YK_NONE) continue;
                    tie(plan, joint, o, (int32_t)root);
                    queue[tail++] = p;
                }
        }
    }
}

// --- clusters

static bool is_rigid(const YkPlan *plan, int32_t joint)
{
    const YkPart *part = yk_part(plan->mech->model->joints[joint].kind);
    return (!part->turns || plan->angle_input[joint] != YK_NONE) &&
           (!part->slides || plan->distance_input[joint] != YK_NONE);
}

static void make_clusters(YkPlan *plan)
{
    const YkModel *model = plan->mech->model;
    size_t tail = 0;
    for (size_t b = 0; b < model->body_count; b++) plan->cluster[b] = YK_NONE;
    for (size_t start = 0; start < model->body_count; start++) {
        if (plan->cluster[start] != YK_NONE) continue;
        int32_t c = (int32_t)plan->cluster_count++;
        size_t head = tail;
        plan->cluster_first[c] = (uint32_t)tail;
        plan->cluster[start] = c;
        plan->cluster_tree.parent[start] = plan->cluster_tree.joint[start] = YK_NONE;
        plan->cluster_member[tail++] = (int32_t)start;
        while (head < tail) {
            int32_t b = plan->cluster_member[head++];
            for (uint32_t k = plan->incidence->first[b]; k < plan->incidence->first[b + 1]; k++) {
                int32_t joint = plan->incidence->joint[k], other = yk_other_body(model, joint, b);
                if (!is_rigid(plan, joint) || plan->cluster[other] != YK_NONE) continue;
                plan->cluster[other] = c;
                plan->cluster_tree.parent[other] = b;
                plan->cluster_tree.joint[other] = joint;
                plan->cluster_tree.depth[other] = plan->cluster_tree.depth[b] + 1;
                plan->joint_used[joint] = true;
                plan->cluster_member[tail++] = other;
            }
        }
    }
    plan->cluster_first[plan->cluster_count] = (uint32_t)tail;
}

// --- loops that close without a solution

static void check_leftover_joints(YkPlan *plan)
{
    const YkModel *model = plan->mech->model;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        if (plan->joint_used[j] || !yk_plan_body_known(plan, joint->body[0]) ||
            !yk_plan_body_known(plan, joint->body[1]))
            continue;
        int32_t index = (int32_t)j, d = plan->mech->joint_distance[j];
        yk_terms_clear(&plan->list);
        yk_terms_add_origin(&plan->list, plan->mech, joint->body[0], 1);
        yk_terms_cross(&plan->list, plan->mech, index, joint->body[0], 1);
        yk_terms_add_origin(&plan->list, plan->mech, joint->body[1], -1);
        plan->joint_used[j] = true;
        yk_plan_block(plan, &index, 1, d != YK_NONE && !plan->distance_known[d] ? 1 : 0);
    }
}

static void count_missing(YkPlan *plan)
{
    const YkMechanism *mech = plan->mech;
    for (size_t o = 0; o < mech->orientation_count; o++)
        if (mech->group_root[o] == (int32_t)o && !plan->root_known[o]) plan->missing++;
    for (size_t d = 0; d < mech->distance_count; d++)
        if (!plan->distance_known[d]) plan->missing++;
}

bool yk_plan_make(YkPlan *plan, YkMechanism *mech, const YkIncidence *incidence, const YkClosedPose *pose,
                  YkArena *scratch)
{
    *plan = (YkPlan){
        .mech = mech, .incidence = incidence, .pose = pose, .arena = scratch, .list = {.recipe = mech->recipe}};
    mech->term_count = 0;
    for (size_t l = 0; l < mech->loop_count; l++) { // the tree's loops keep their terms, at the front
        size_t end = mech->loops[l].sum.first + mech->loops[l].sum.count;
        if (mech->recipe && mech->loops[l].sum.count == 0) end++; // see yk_terms_store
        if (end > mech->term_count) mech->term_count = end;
    }
    if (!allocate(plan)) return false;
    reset(plan);
    make_groups(plan);
    make_clusters(plan);
    plan->unknown_clusters = plan->cluster_count;
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[i]];
        if (!c->is_distance) continue;
        plan->distance_known[c->distance] = true;
        yk_plan_step(plan, (YkStep){.kind = YK_STEP_DISTANCE, .target = c->distance, .input = (int32_t)i, .sign = 1});
    }
    if (plan->failed) return false;
    plan->root_known[0] = true;
    yk_terms_clear(&plan->list);
    yk_plan_place_cluster(plan, 0);
    yk_plan_peel(plan);
    if (plan->unknown_clusters > 0) yk_plan_groups(plan);
    yk_plan_relations(plan); // what is left only repeats others
    yk_plan_coordinate_sums(plan);
    check_leftover_joints(plan);
    count_missing(plan);
    return !plan->failed && !plan->list.failed && !yk_arena_failed(plan->arena);
}

void yk_plan_end(YkPlan *plan)
{
    yk_terms_free(&plan->list);
}
