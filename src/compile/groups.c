// What peeling leaves: larger Assur groups. Their loops are matched with unknowns, and the strong components of the matching
// are solved one after another. Source: Duff & Reid 1978; Pothen & Fan 1990.
#include <stdlib.h>
#include "compile/plan.h"
#include "num/components.h"
#include "num/matching.h"

typedef struct Rest {
    YkPlan *plan;
    YkTree tree;            // over the bodies left, rooted at known bodies
    bool *is_reached;
    int32_t *queue;
    size_t tail;
    int32_t *loop_joint;    // joints that close loops
    YkSum *loop_sum;
    uint32_t *column_first; // columns of loop l: columns[column_first[l] ..)
    int32_t *columns;
    size_t loop_count, column_total, column_capacity;
    YkMatching matching;
    int32_t *component;
} Rest;

static size_t column_id(const YkMechanism *mech, YkColumn c)
{
    return c.is_distance ? mech->orientation_count + (size_t)c.index : (size_t)c.index;
}

static void reach_body(Rest *r, int32_t body, int32_t parent, int32_t joint)
{
    r->tree.parent[body] = parent;
    r->tree.joint[body] = joint;
    r->tree.depth[body] = r->tree.depth[parent] + 1;
    r->is_reached[body] = true;
    r->queue[r->tail++] = body;
}

// The rest of the cluster hangs on its first body reached: up to the root of the cluster's own tree, then outwards from there.
static void reach_cluster(Rest *r, int32_t body, int32_t parent, int32_t joint)
{
    const YkPlan *plan = r->plan;
    const YkTree *tree = &plan->cluster_tree;
    int32_t c = plan->cluster[body];
    reach_body(r, body, parent, joint);
    plan->joint_used[joint] = true;
    for (int32_t b = body; tree->parent[b] != YK_NONE; b = tree->parent[b]) reach_body(r, tree->parent[b], b, tree->joint[b]);
    for (uint32_t k = plan->cluster_first[c]; k < plan->cluster_first[c + 1]; k++) { // parents stand before children
        int32_t b = plan->cluster_member[k];
        if (!r->is_reached[b]) reach_body(r, b, tree->parent[b], tree->joint[b]);
    }
}

static void grow(Rest *r)
{
    YkPlan *plan = r->plan;
    const YkModel *model = plan->mech->model;
    for (size_t b = 0; b < model->body_count; b++) {
        r->is_reached[b] = yk_plan_body_known(plan, (int32_t)b);
        r->tree.parent[b] = r->tree.joint[b] = YK_NONE;
    }
    for (size_t j = 0; j < model->joint_count; j++)
        for (int end = 0; end < 2; end++) {
            int32_t a = model->joints[j].body[end], b = model->joints[j].body[1 - end];
            if (yk_plan_body_known(plan, a) && !r->is_reached[b]) reach_cluster(r, b, a, (int32_t)j);
        }
    for (size_t head = 0; head < r->tail; head++) {
        int32_t b = r->queue[head];
        for (uint32_t e = plan->incidence->first[b]; e < plan->incidence->first[b + 1]; e++) {
            int32_t j = plan->incidence->joint[e], other = yk_other_body(model, j, b);
            if (!r->is_reached[other]) reach_cluster(r, other, b, j);
        }
    }
}

// Round the loop: over the joint, then both ends back until they meet or stand on known bodies.
static void loop_terms(Rest *r, int32_t joint)
{
    YkPlan *plan = r->plan;
    YkMechanism *mech = plan->mech;
    int32_t a = mech->model->joints[joint].body[0], b = mech->model->joints[joint].body[1];
    yk_terms_clear(&plan->list);
    yk_terms_cross(&plan->list, mech, joint, a, 1);
    while (a != b) {
        bool a_known = yk_plan_body_known(plan, a), b_known = yk_plan_body_known(plan, b);
        if (a_known && b_known) break;
        if (b_known || (!a_known && r->tree.depth[a] >= r->tree.depth[b])) {
            yk_terms_cross(&plan->list, mech, r->tree.joint[a], a, -1);
            a = r->tree.parent[a];
        } else {
            yk_terms_cross(&plan->list, mech, r->tree.joint[b], b, 1);
            b = r->tree.parent[b];
        }
    }
    if (a == b) return;
    yk_terms_add_origin(&plan->list, mech, a, 1);
    yk_terms_add_origin(&plan->list, mech, b, -1);
}

static bool add_column(Rest *r, size_t from, size_t id)
{
    for (size_t k = from; k < r->column_total; k++)
        if (r->columns[k] == (int32_t)id) return true;
    if (!YK_ROOM(r->columns, r->column_total, r->column_capacity)) return false;
    r->columns[r->column_total++] = (int32_t)id;
    return true;
}

static bool loop_columns(Rest *r)
{
    const YkPlan *plan = r->plan;
    const YkMechanism *mech = plan->mech;
    size_t from = r->column_total;
    for (size_t k = 0; k < plan->list.count; k++) {
        YkTerm term = plan->list.items[k];
        int32_t root = mech->group_root[term.slot], d = term.distance;
        if (!plan->root_known[root] && !add_column(r, from, column_id(mech, (YkColumn){false, root}))) return false;
        if (d != YK_NONE && !plan->distance_known[d] && !add_column(r, from, column_id(mech, (YkColumn){true, d}))) return false;
    }
    return true;
}

static bool make_loops(Rest *r)
{
    YkPlan *plan = r->plan;
    const YkModel *model = plan->mech->model;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        if (plan->joint_used[j]) continue;
        if (yk_plan_body_known(plan, joint->body[0]) && yk_plan_body_known(plan, joint->body[1])) continue;
        if (r->tree.joint[joint->body[0]] == (int32_t)j || r->tree.joint[joint->body[1]] == (int32_t)j) continue;
        plan->joint_used[j] = true;
        loop_terms(r, (int32_t)j);
        if (!yk_terms_store(&plan->list, plan->mech, &r->loop_sum[r->loop_count])) return false;
        r->column_first[r->loop_count] = (uint32_t)r->column_total;
        r->loop_joint[r->loop_count++] = (int32_t)j;
        if (!loop_columns(r)) return false;
    }
    r->column_first[r->loop_count] = (uint32_t)r->column_total;
    return true;
}

static bool match(Rest *r)
{
    const YkMechanism *mech = r->plan->mech;
    size_t columns = mech->orientation_count + mech->distance_count;
    if (!yk_matching_start(&r->matching, r->plan->arena, columns, 2 * r->loop_count, 2 * r->column_total)) return false;
    for (size_t l = 0; l < r->loop_count; l++)
        for (int row = 0; row < 2; row++)
            yk_matching_add(&r->matching, r->columns + r->column_first[l], r->column_first[l + 1] - r->column_first[l], true);
    return true;
}

// Loop l needs the loops whose rows are matched with its columns.
static bool order(Rest *r, size_t *count)
{
    YkArena *arena = r->plan->arena;
    uint32_t *first = YK_NEW(arena, uint32_t, r->loop_count + 2);
    int32_t *target = YK_NEW(arena, int32_t, r->column_total + 1);
    int32_t *work = YK_NEW(arena, int32_t, 5 * r->loop_count + 1);
    r->component = YK_NEW(arena, int32_t, r->loop_count + 1);
    if (yk_arena_failed(arena)) return false;
    uint32_t edges = 0;
    for (size_t l = 0; l < r->loop_count; l++) {
        first[l] = edges;
        for (uint32_t k = r->column_first[l]; k < r->column_first[l + 1]; k++) {
            int32_t row = r->matching.row_of[r->columns[k]];
            if (row >= 0) target[edges++] = row / 2;
        }
    }
    first[r->loop_count] = edges;
    *count = yk_components(r->loop_count, first, target, r->component, work);
    return true;
}

static YkColumn column_of_id(const YkMechanism *mech, int32_t id)
{
    bool is_distance = (size_t)id >= mech->orientation_count;
    return (YkColumn){is_distance, is_distance ? id - (int32_t)mech->orientation_count : id};
}

static void add_group_column(YkPlan *plan, int32_t id)
{
    YkMechanism *mech = plan->mech;
    if (!YK_ROOM(mech->group_columns, mech->column_count, mech->column_capacity)) {
        plan->failed = true;
        return;
    }
    mech->group_columns[mech->column_count++] = column_of_id(mech, id);
}

static void add_group_loop(YkPlan *plan, YkSum sum)
{
    YkMechanism *mech = plan->mech;
    if (!YK_ROOM(mech->group_loops, mech->group_loop_count, mech->group_loop_capacity)) {
        plan->failed = true;
        return;
    }
    mech->group_loops[mech->group_loop_count++] = sum;
}

// members: the loops of the component, in file order.
static void emit_group(Rest *r, const int32_t *members, size_t count, int32_t *joints)
{
    YkPlan *plan = r->plan;
    YkMechanism *mech = plan->mech;
    size_t first_column = mech->column_count, first_loop = mech->group_loop_count;
    for (size_t k = 0; k < count; k++) {
        int32_t l = members[k];
        joints[k] = r->loop_joint[l];
        add_group_loop(plan, r->loop_sum[l]);
        for (int row = 0; row < 2; row++)
            if (r->matching.column_of[2 * l + row] >= 0) add_group_column(plan, r->matching.column_of[2 * l + row]);
    }
    YkBlock *block = plan->failed ? NULL : yk_plan_new_block(plan, YK_BLOCK_GROUP, joints, count);
    if (!block) return;
    block->first_column = (uint32_t)first_column;
    block->column_count = (uint32_t)(mech->column_count - first_column);
    block->first_loop = (uint32_t)first_loop;
    block->loop_count = (uint32_t)count;
    block->assur_class = count == 1 ? 2 : count == 2 ? 3 : 4;
    mech->has_groups = true;
    if (block->column_count > mech->largest_group) mech->largest_group = block->column_count;
    if (2 * count > mech->largest_group) mech->largest_group = 2 * count;
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_BLOCK, .target = (int32_t)mech->block_count - 1});
    for (size_t k = first_column; k < mech->column_count; k++) yk_plan_learn(plan, mech->group_columns[k]);
}

// Loops sorted by component, file order within.
static bool emit_groups(Rest *r, size_t count)
{
    YkArena *arena = r->plan->arena;
    uint32_t *first = YK_NEW(arena, uint32_t, count + 2);
    int32_t *members = YK_NEW(arena, int32_t, r->loop_count + 1), *joints = YK_NEW(arena, int32_t, r->loop_count + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t l = 0; l < r->loop_count; l++) first[r->component[l] + 2]++;
    for (size_t c = 0; c < count; c++) first[c + 2] += first[c + 1];
    for (size_t l = 0; l < r->loop_count; l++) members[first[r->component[l] + 1]++] = (int32_t)l;
    for (size_t c = 0; c < count; c++) emit_group(r, members + first[c], first[c + 1] - first[c], joints);
    return true;
}

// Every body left now hangs on known ones, in the order it was reached.
static void place_rest(Rest *r)
{
    YkPlan *plan = r->plan;
    for (size_t k = 0; k < r->tail; k++) {
        int32_t b = r->queue[k];
        if (!yk_plan_body_known(plan, b)) yk_plan_place(plan, r->tree.joint[b], r->tree.parent[b]);
    }
}

void yk_plan_groups(YkPlan *plan)
{
    Rest r = {.plan = plan};
    YkArena *a = plan->arena;
    size_t bodies = plan->mech->model->body_count, joints = plan->mech->model->joint_count, components = 0;
    r.tree.parent = YK_NEW(a, int32_t, bodies);
    r.tree.joint = YK_NEW(a, int32_t, bodies);
    r.tree.depth = YK_NEW(a, int32_t, bodies);
    r.is_reached = YK_NEW(a, bool, bodies);
    r.queue = YK_NEW(a, int32_t, bodies + 1);
    r.loop_joint = YK_NEW(a, int32_t, joints + 1);
    r.loop_sum = YK_NEW(a, YkSum, joints + 1);
    r.column_first = YK_NEW(a, uint32_t, joints + 2);
    if (yk_arena_failed(a)) {
        plan->failed = true;
        return;
    }
    grow(&r);
    if (!make_loops(&r) || !match(&r) || !order(&r, &components) || !emit_groups(&r, components)) plan->failed = true;
    if (!plan->failed) place_rest(&r);
    free(r.columns);
}
