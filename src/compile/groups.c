// Solves what peeling leaves: larger Assur groups. Their loops, and the gears and cams that need them, are matched with
// unknowns; the strong components of the matching are solved one after another. Source: Duff & Reid 1978; Pothen & Fan
// 1990.
#include <stdlib.h>
#include "base/memory.h"
#include "compile/judge.h"
#include "compile/plan.h"
#include "num/components.h"
#include "num/matching.h"

typedef struct Rest {
    YkPlan *plan;
    YkTree tree; // over the remaining bodies, rooted at known bodies
    bool *is_reached;
    int32_t *queue;
    size_t tail;
    int32_t *loop_joint; // joints that close loops
    YkSum *loop_sum;
    int32_t *relation; // remaining relations: equation loop_count + k is relation[k]
    size_t relation_count;
    YkColumn *relation_columns;
    uint32_t *column_first; // columns of equation l: columns[column_first[l] ..)
    int32_t *columns;
    size_t loop_count, column_total, column_capacity;
    uint32_t *row_first;   // rows of equation l: row_first[l] .. row_first[l + 1]
    int32_t *row_equation; // the equation of each row
    uint32_t *path_first;  // joints round loop l, its closing joint last: path[path_first[l] ..)
    int32_t *path;
    size_t path_count, path_capacity;
    YkMatching matching;
    int32_t *component;
    uint32_t *joint_stamp, *cluster_stamp; // the last component that took them, plus one
    int32_t *joints, *clusters;            // of the component being emitted
} Rest;

// Counts the equations: loops have two rows; relations, which follow all loops, have one. If equations repeat each
// other, only independent rows count.
static size_t equation_count(const Rest *r)
{
    return r->loop_count + r->relation_count;
}
static size_t equation_of(const Rest *r, int32_t row)
{
    return (size_t)r->row_equation[row];
}

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

// Reaches the rest of the cluster from its first body reached: up to the root of the cluster's own tree, then outwards
// from there.
static void reach_cluster(Rest *r, int32_t body, int32_t parent, int32_t joint)
{
    const YkPlan *plan = r->plan;
    const YkTree *tree = &plan->cluster_tree;
    int32_t c = plan->cluster[body];
    reach_body(r, body, parent, joint);
    for (int32_t b = body; tree->parent[b] != YK_NONE; b = tree->parent[b])
        reach_body(r, tree->parent[b], b, tree->joint[b]);
    for (uint32_t k = plan->cluster_first[c]; k < plan->cluster_first[c + 1]; k++) { // parents come before children
        int32_t b = plan->cluster_member[k];
        if (!r->is_reached[b]) reach_body(r, b, tree->parent[b], tree->joint[b]);
    }
}

// Follows the joints of groups that have placed bodies relative to each other. The equations of these joints are used
// up, so they come first.
static void follow_used(Rest *r, size_t *next)
{
    const YkPlan *plan = r->plan;
    while (*next < r->tail) {
        int32_t b = r->queue[(*next)++];
        for (uint32_t e = plan->incidence->first[b]; e < plan->incidence->first[b + 1]; e++) {
            int32_t j = plan->incidence->joint[e], other = yk_other_body(plan->mech->model, j, b);
            if (plan->joint_used[j] && !r->is_reached[other]) reach_cluster(r, other, b, j);
        }
    }
}

static void grow(Rest *r)
{
    size_t next = 0; // in the queue: the first body whose used joints have not been followed
    YkPlan *plan = r->plan;
    const YkModel *model = plan->mech->model;
    for (size_t b = 0; b < model->body_count; b++) {
        r->is_reached[b] = yk_plan_body_known(plan, (int32_t)b);
        r->tree.parent[b] = r->tree.joint[b] = YK_NONE;
    }
    for (size_t j = 0; j < model->joint_count; j++)
        for (int end = 0; end < 2; end++) {
            int32_t a = model->joints[j].body[end], b = model->joints[j].body[1 - end];
            if (!yk_plan_body_known(plan, a) || r->is_reached[b]) continue;
            reach_cluster(r, b, a, (int32_t)j);
            follow_used(r, &next);
        }
    for (size_t head = 0; head < r->tail; head++) {
        int32_t b = r->queue[head];
        for (uint32_t e = plan->incidence->first[b]; e < plan->incidence->first[b + 1]; e++) {
            int32_t j = plan->incidence->joint[e], other = yk_other_body(model, j, b);
            if (r->is_reached[other]) continue;
            reach_cluster(r, other, b, j);
            follow_used(r, &next);
        }
    }
}

static void note_path(Rest *r, int32_t joint)
{
    if (YK_ROOM(r->path, r->path_count, r->path_capacity))
        r->path[r->path_count++] = joint;
    else
        r->plan->failed = true;
}

// Collects the terms round the loop: over the joint, then back from both ends until they meet or reach known bodies.
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
            note_path(r, r->tree.joint[a]);
            yk_terms_cross(&plan->list, mech, r->tree.joint[a], a, -1);
            a = r->tree.parent[a];
        } else {
            note_path(r, r->tree.joint[b]);
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
        if (!yk_terms_is_there(&plan->list, k)) continue;
        int32_t root = mech->group_root[term.slot], d = term.distance;
        if (!plan->root_known[root] && !add_column(r, from, column_id(mech, (YkColumn){false, root}))) return false;
        if (d != YK_NONE && !plan->distance_known[d] && !add_column(r, from, column_id(mech, (YkColumn){true, d})))
            return false;
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
        r->path_first[r->loop_count] = (uint32_t)r->path_count;
        loop_terms(r, (int32_t)j);
        note_path(r, (int32_t)j);
        if (!yk_terms_store(&plan->list, plan->mech, &r->loop_sum[r->loop_count])) return false;
        r->column_first[r->loop_count] = (uint32_t)r->column_total;
        r->loop_joint[r->loop_count++] = (int32_t)j;
        if (!loop_columns(r)) return false;
    }
    r->column_first[r->loop_count] = (uint32_t)r->column_total;
    r->path_first[r->loop_count] = (uint32_t)r->path_count;
    return true;
}

// Lists the gears, racks, belts, cams and laws that wait for the results of the loops.
static bool make_relations(Rest *r)
{
    YkPlan *plan = r->plan;
    const YkMechanism *mech = plan->mech;
    for (size_t k = 0; k < mech->relation_count; k++) {
        const YkRelation *relation = &mech->relations[k];
        if (relation->is_solved || relation->is_redundant) continue;
        size_t from = r->column_total, count = yk_plan_relation_columns(plan, k, r->relation_columns);
        if (count == 0) continue;
        for (size_t c = 0; c < count; c++)
            if (!add_column(r, from, column_id(mech, r->relation_columns[c]))) return false;
        r->relation[r->relation_count++] = (int32_t)k;
        r->column_first[equation_count(r)] = (uint32_t)r->column_total;
    }
    return true;
}

static YkColumn column_of_id(const YkMechanism *mech, int32_t id)
{
    bool is_distance = (size_t)id >= mech->orientation_count;
    return (YkColumn){is_distance, is_distance ? id - (int32_t)mech->orientation_count : id};
}

static size_t columns_of(const Rest *r, size_t equation)
{
    return r->column_first[equation + 1] - r->column_first[equation];
}

static bool is_judged(const Rest *r, size_t equation)
{
    const YkPlan *plan = r->plan;
    return columns_of(r, equation) > 0 &&
           yk_is_judged(plan, column_of_id(plan->mech, r->columns[r->column_first[equation]]));
}

// Returns the unknowns of the equations that are judged, each once; NULL when out of memory.
static int32_t *judged_columns(const Rest *r, size_t *count)
{
    const YkMechanism *mech = r->plan->mech;
    size_t all = mech->orientation_count + mech->distance_count;
    int32_t *ids = YK_NEW(r->plan->arena, int32_t, all + 1);
    bool *is_listed = YK_NEW(r->plan->arena, bool, all + 1);
    *count = 0;
    if (!ids || !is_listed) return NULL;
    for (size_t l = 0; l < equation_count(r); l++)
        for (uint32_t k = r->column_first[l]; k < r->column_first[l + 1] && is_judged(r, l); k++) {
            if (!is_listed[r->columns[k]]) ids[(*count)++] = r->columns[k];
            is_listed[r->columns[k]] = true;
        }
    return ids;
}

// Finds rows[l], how many independent rows an equation has. Equations with few unknowns come first, so that relations
// between a few bodies stay among them. Returns false when out of memory.
static bool judge_rows(const Rest *r, size_t *rows)
{
    YkJudge judge;
    size_t unknowns, longest = 0;
    int32_t *ids = judged_columns(r, &unknowns);
    if (!ids || !yk_judge_start(&judge, r->plan, ids, unknowns)) return false;
    for (size_t l = 0; l < equation_count(r); l++) longest = columns_of(r, l) > longest ? columns_of(r, l) : longest;
    for (size_t length = 1; length <= longest; length++)
        for (size_t l = 0; l < equation_count(r); l++) {
            if (columns_of(r, l) != length || !is_judged(r, l)) continue;
            rows[l] = l < r->loop_count ? yk_judge_loop(&judge, &r->loop_sum[l])
                                        : yk_judge_relation(&judge, (size_t)r->relation[l - r->loop_count]);
        }
    bool all_told = judge.taken == unknowns; // otherwise counting has to suffice
    for (size_t l = 0; l < equation_count(r) && !all_told; l++) rows[l] = l < r->loop_count ? 2 : 1;
    return true;
}

static bool count_rows(Rest *r)
{
    YkArena *arena = r->plan->arena;
    size_t equations = equation_count(r), *rows = YK_NEW(arena, size_t, equations + 1);
    r->row_first = YK_NEW(arena, uint32_t, equations + 2);
    r->row_equation = YK_NEW(arena, int32_t, 2 * equations + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t l = 0; l < equations; l++) rows[l] = l < r->loop_count ? 2 : 1;
    if (r->plan->pose && !judge_rows(r, rows)) return false;
    for (size_t l = 0; l < equations; l++) {
        r->row_first[l + 1] = r->row_first[l] + (uint32_t)rows[l];
        for (uint32_t row = r->row_first[l]; row < r->row_first[l + 1]; row++) r->row_equation[row] = (int32_t)l;
    }
    return true;
}

static bool match(Rest *r)
{
    const YkMechanism *mech = r->plan->mech;
    if (!count_rows(r)) return false;
    size_t columns = mech->orientation_count + mech->distance_count, rows = r->row_first[equation_count(r)];
    if (!yk_matching_start(&r->matching, r->plan->arena, columns, rows, 2 * r->column_total)) return false;
    for (size_t row = 0; row < rows; row++) {
        size_t l = equation_of(r, (int32_t)row);
        yk_matching_add(&r->matching, yk_from(r->columns, r->column_first[l]), columns_of(r, l), true);
    }
    return true;
}

// Orders the equations: one needs those whose rows are matched with its columns.
static bool order(Rest *r, size_t *count)
{
    YkArena *arena = r->plan->arena;
    size_t equations = equation_count(r);
    uint32_t *first = YK_NEW(arena, uint32_t, equations + 2);
    int32_t *target = YK_NEW(arena, int32_t, r->column_total + 1);
    int32_t *work = YK_NEW(arena, int32_t, 5 * equations + 1);
    r->component = YK_NEW(arena, int32_t, equations + 1);
    if (yk_arena_failed(arena)) return false;
    uint32_t edges = 0;
    for (size_t l = 0; l < equations; l++) {
        first[l] = edges;
        for (uint32_t k = r->column_first[l]; k < r->column_first[l + 1]; k++) {
            int32_t row = r->matching.row_of[r->columns[k]];
            if (row >= 0) target[edges++] = (int32_t)equation_of(r, row);
        }
    }
    first[equations] = edges;
    *count = yk_components(equations, first, target, r->component, work);
    return true;
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

// Gathers the joints round the component's loops, those that close them last, and the clusters it places; stamps keep
// each once.
static size_t gather_joints(Rest *r, const int32_t *members, size_t count, uint32_t stamp)
{
    size_t joints = 0;
    for (int closing = 0; closing < 2; closing++)
        for (size_t k = 0; k < count && (size_t)members[k] < r->loop_count; k++) { // relations come last
            uint32_t last = r->path_first[members[k] + 1] - 1;
            for (uint32_t e = closing ? last : r->path_first[members[k]]; e < last + (uint32_t)closing; e++) {
                if (r->joint_stamp[r->path[e]] == stamp) continue;
                r->joint_stamp[r->path[e]] = stamp;
                r->joints[joints++] = r->path[e];
                r->plan->joint_used[r->path[e]] = true;
            }
        }
    return joints;
}

static size_t gather_clusters(Rest *r, size_t joints, uint32_t stamp)
{
    const YkPlan *plan = r->plan;
    size_t clusters = 0;
    for (size_t k = 0; k < joints; k++)
        for (int end = 0; end < 2; end++) {
            int32_t c = plan->cluster[plan->mech->model->joints[r->joints[k]].body[end]];
            if (plan->cluster_known[c] || r->cluster_stamp[c] == stamp) continue;
            r->cluster_stamp[c] = stamp;
            r->clusters[clusters++] = c;
        }
    return clusters;
}

// Fills in the loops, then the relations of a component, and the unknowns matched with them.
static void fill_group(Rest *r, YkBlock *group, const int32_t *members, size_t count)
{
    YkPlan *plan = r->plan;
    YkMechanism *mech = plan->mech;
    *group = (YkBlock){.first_column = (uint32_t)mech->column_count,
                       .first_loop = (uint32_t)mech->group_loop_count,
                       .first_relation = (uint32_t)mech->group_relation_count};
    for (size_t k = 0; k < count; k++) {
        size_t l = (size_t)members[k];
        if (l < r->loop_count) add_group_loop(plan, r->loop_sum[l]);
        for (uint32_t row = r->row_first[l]; row < r->row_first[l + 1]; row++)
            if (r->matching.column_of[row] >= 0) add_group_column(plan, r->matching.column_of[row]);
    }
    group->column_count = (uint32_t)mech->column_count - group->first_column;
    group->loop_count = (uint32_t)mech->group_loop_count - group->first_loop;
    for (size_t k = group->loop_count; k < count && !plan->failed; k++)
        yk_plan_group_relation(plan, (size_t)r->relation[(size_t)members[k] - r->loop_count],
                               mech->group_columns + group->first_column, group->column_count);
    group->relation_count = (uint32_t)mech->group_relation_count - group->first_relation;
}

// Notes the loops of a group that repeat something, by the joints that close them.
static void note_redundant(Rest *r, const int32_t *members, size_t count)
{
    YkMechanism *mech = r->plan->mech;
    for (size_t k = 0; k < count && (size_t)members[k] < r->loop_count; k++) {
        if (r->row_first[members[k] + 1] - r->row_first[members[k]] == 2) continue;
        if (YK_ROOM(mech->redundant, mech->redundant_count, mech->redundant_capacity))
            mech->redundant[mech->redundant_count++] = r->loop_joint[members[k]];
        else
            r->plan->failed = true;
    }
}

// Emits a component. members: its equations in file order, loops first.
static void emit_group(Rest *r, const int32_t *members, size_t count, uint32_t stamp)
{
    YkPlan *plan = r->plan;
    YkMechanism *mech = plan->mech;
    YkBlock group;
    fill_group(r, &group, members, count);
    if (group.column_count == 0) return; // everything that it ties is known already: left for a check
    size_t joints = gather_joints(r, members, count, stamp), rows = yk_block_rows(&group);
    YkBlock *block = plan->failed ? NULL : yk_plan_new_block(plan, YK_BLOCK_GROUP, r->joints, joints);
    if (!block) return;
    block->first_column = group.first_column;
    block->column_count = group.column_count;
    block->first_loop = group.first_loop;
    block->loop_count = group.loop_count;
    block->first_relation = group.first_relation;
    block->relation_count = group.relation_count;
    if (group.loop_count == 0) block->label = mech->relations[mech->group_relations[group.first_relation]].name;
    block->aside->assur_class = count == 1 ? 2 : count == 2 ? 3 : 4;
    yk_plan_block_bodies(plan, block, r->clusters, gather_clusters(r, joints, stamp));
    note_redundant(r, members, count);
    mech->has_groups = true;
    if (block->column_count > mech->largest_group) mech->largest_group = block->column_count;
    if (rows > mech->largest_group) mech->largest_group = rows;
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_BLOCK, .target = (int32_t)mech->block_count - 1});
    for (size_t k = block->first_column; k < mech->column_count; k++) yk_plan_learn(plan, mech->group_columns[k]);
}

// Returns whether the component needs no other and determines everything in it.
static bool stands_alone(const Rest *r, const int32_t *members, size_t count)
{
    for (size_t k = 0; k < count; k++)
        for (uint32_t e = r->column_first[members[k]]; e < r->column_first[members[k] + 1]; e++) {
            int32_t row = r->matching.row_of[r->columns[e]];
            if (row < 0 || r->component[equation_of(r, row)] != r->component[members[k]]) return false;
        }
    return count > 0;
}

// Emits the components that stand alone, or all; returns how many. Equations are sorted by component, in file order
// within.
static size_t emit_groups(Rest *r, size_t count, bool all)
{
    YkArena *arena = r->plan->arena;
    size_t emitted = 0;
    uint32_t *first = YK_NEW(arena, uint32_t, count + 2);
    int32_t *members = YK_NEW(arena, int32_t, equation_count(r) + 1);
    if (yk_arena_failed(arena)) {
        r->plan->failed = true;
        return 0;
    }
    for (size_t l = 0; l < equation_count(r); l++) first[r->component[l] + 2]++;
    for (size_t c = 0; c < count; c++) first[c + 2] += first[c + 1];
    for (size_t l = 0; l < equation_count(r); l++) members[first[r->component[l] + 1]++] = (int32_t)l;
    for (size_t c = 0; c < count; c++) {
        if (!all && !stands_alone(r, members + first[c], first[c + 1] - first[c])) continue;
        emit_group(r, members + first[c], first[c + 1] - first[c], (uint32_t)c + 1);
        emitted++;
    }
    return emitted;
}

// Places the remaining bodies, each next to a known one, in the order in which they were reached.
static void place_rest(Rest *r)
{
    YkPlan *plan = r->plan;
    for (size_t k = 0; k < r->tail; k++) {
        int32_t b = r->queue[k];
        if (!yk_plan_body_known(plan, b)) yk_plan_place(plan, r->tree.joint[b], r->tree.parent[b]);
    }
}

static bool allocate(Rest *r)
{
    YkArena *a = r->plan->arena;
    size_t bodies = r->plan->mech->model->body_count, joints = r->plan->mech->model->joint_count,
           relations = r->plan->mech->relation_count;
    r->tree.parent = YK_NEW(a, int32_t, bodies);
    r->tree.joint = YK_NEW(a, int32_t, bodies);
    r->tree.depth = YK_NEW(a, int32_t, bodies);
    r->is_reached = YK_NEW(a, bool, bodies);
    r->queue = YK_NEW(a, int32_t, bodies + 1);
    r->clusters = YK_NEW(a, int32_t, bodies + 1);
    r->cluster_stamp = YK_NEW(a, uint32_t, bodies + 1);
    r->loop_joint = YK_NEW(a, int32_t, joints + 1);
    r->loop_sum = YK_NEW(a, YkSum, joints + 1);
    r->relation = YK_NEW(a, int32_t, relations + 1);
    r->relation_columns = YK_NEW(a, YkColumn, r->plan->mech->relation_term_count + 1);
    r->column_first = YK_NEW(a, uint32_t, joints + relations + 2);
    r->path_first = YK_NEW(a, uint32_t, joints + 2);
    r->joints = YK_NEW(a, int32_t, joints + 1);
    r->joint_stamp = YK_NEW(a, uint32_t, joints + 1);
    return !yk_arena_failed(a);
}

// Runs one round: groups that need nothing unknown become blocks. If there are none, or in the last round, all groups
// do, and every remaining body is placed. Returns whether to go on.
static bool round_of_groups(YkPlan *plan, bool last)
{
    Rest r = {.plan = plan};
    size_t components = 0, emitted = 0;
    bool ok = allocate(&r);
    if (ok) {
        grow(&r);
        ok = make_loops(&r) && make_relations(&r) && !plan->failed && match(&r) && order(&r, &components);
    }
    if (ok) emitted = emit_groups(&r, components, last);
    if (ok && emitted == 0 && !plan->failed) {
        emit_groups(&r, components, true);
        last = true;
    }
    if (!ok) plan->failed = true;
    if (last && !plan->failed) place_rest(&r);
    free(r.columns);
    free(r.path);
    return !last && !plan->failed;
}

// Solves groups in rounds. Bodies attached to a group may form dyads again, so peeling continues after each round. The
// number of rounds is bounded, for linear cost.
void yk_plan_groups(YkPlan *plan)
{
    enum { ROUNDS_MAX = 64 };
    for (int k = 1; plan->unknown_clusters > 0 && round_of_groups(plan, k == ROUNDS_MAX); k++) yk_plan_peel(plan);
}
