// Peels dyads: a cluster joined to known bodies by two joints, or two clusters joined to them and to each other, with
// two unknowns between them, form a dyad, which one loop solves. A cluster is visited when a neighbour becomes known,
// so the total cost is linear in the number of joints. Source: Assur groups of class II; Galletti 1986.
#include "compile/plan.h"

typedef struct Columns {
    YkColumn items[8];
    size_t count;
} Columns;

static void add_column(Columns *columns, bool is_distance, int32_t index)
{
    for (size_t k = 0; k < columns->count; k++)
        if (columns->items[k].is_distance == is_distance && columns->items[k].index == index) return;
    if (columns->count < 8) columns->items[columns->count++] = (YkColumn){is_distance, index};
}

static int32_t root_of_body(const YkPlan *plan, int32_t body)
{
    return plan->mech->group_root[plan->mech->bodies[body].orientation];
}

static void add_body(const YkPlan *plan, Columns *columns, int32_t body)
{
    int32_t root = root_of_body(plan, body);
    if (!plan->root_known[root]) add_column(columns, false, root);
}

static bool is_distance_open(const YkPlan *plan, int32_t joint)
{
    int32_t d = plan->mech->joint_distance[joint];
    return d != YK_NONE && !plan->distance_known[d];
}

static void add_joint(const YkPlan *plan, Columns *columns, int32_t joint)
{
    if (is_distance_open(plan, joint)) add_column(columns, true, plan->mech->joint_distance[joint]);
}

// Returns the end of a joint that is in (or not in) this cluster.
static int32_t end_in(const YkPlan *plan, int32_t joint, int32_t cluster)
{
    const YkJoint *j = &plan->mech->model->joints[joint];
    return plan->cluster[j->body[0]] == cluster ? j->body[0] : j->body[1];
}
static int32_t end_beyond(const YkPlan *plan, int32_t joint, int32_t cluster)
{
    return yk_other_body(plan->mech->model, joint, end_in(plan, joint, cluster));
}

// Places a whole cluster by one joint whose freedom is already known.
static bool try_follow(YkPlan *plan, int32_t cluster)
{
    for (int32_t k = 0; k < plan->anchor_count[cluster]; k++) {
        int32_t joint = plan->anchors[cluster][k], body = end_in(plan, joint, cluster);
        if (is_distance_open(plan, joint) || !plan->root_known[root_of_body(plan, body)]) continue;
        yk_plan_place(plan, joint, end_beyond(plan, joint, cluster));
        return true;
    }
    return false;
}

// Tries the loop: known - j1 - cluster - j2 - known.
static bool try_two_joints(YkPlan *plan, int32_t cluster, int32_t j1, int32_t j2, size_t wanted)
{
    Columns columns = {0};
    int32_t x1 = end_in(plan, j1, cluster), x2 = end_in(plan, j2, cluster);
    add_body(plan, &columns, x1);
    add_joint(plan, &columns, j1);
    add_joint(plan, &columns, j2);
    if (columns.count != wanted) return false;
    int32_t k1 = end_beyond(plan, j1, cluster), k2 = end_beyond(plan, j2, cluster);
    yk_terms_clear(&plan->list);
    yk_terms_add_origin(&plan->list, plan->mech, k1, 1);
    yk_terms_cross(&plan->list, plan->mech, j1, k1, 1);
    yk_terms_walk(&plan->list, plan->mech, &plan->cluster_tree, x1, x2);
    yk_terms_cross(&plan->list, plan->mech, j2, x2, 1);
    yk_terms_add_origin(&plan->list, plan->mech, k2, -1);
    if (!yk_plan_block(plan, (int32_t[]){j1, j2}, 2, wanted)) return false;
    yk_plan_block_bodies(plan, &plan->mech->blocks[plan->mech->block_count - 1], &cluster, 1);
    plan->joint_used[j2] = true;
    yk_plan_place(plan, j1, k1);
    return true;
}

// Tries the loop: known - j1 - cluster X - j - cluster Y - j2 - known.
static bool try_three_joints(YkPlan *plan, int32_t X, int32_t j1, int32_t j, int32_t j2, size_t wanted)
{
    Columns columns = {0};
    int32_t Y = plan->cluster[end_beyond(plan, j, X)];
    int32_t x1 = end_in(plan, j1, X), x2 = end_in(plan, j, X), y1 = end_in(plan, j, Y), y2 = end_in(plan, j2, Y);
    add_body(plan, &columns, x1);
    add_body(plan, &columns, y1);
    add_joint(plan, &columns, j1);
    add_joint(plan, &columns, j);
    add_joint(plan, &columns, j2);
    if (columns.count != wanted) return false;
    int32_t k1 = end_beyond(plan, j1, X), k2 = end_beyond(plan, j2, Y);
    yk_terms_clear(&plan->list);
    yk_terms_add_origin(&plan->list, plan->mech, k1, 1);
    yk_terms_cross(&plan->list, plan->mech, j1, k1, 1);
    yk_terms_walk(&plan->list, plan->mech, &plan->cluster_tree, x1, x2);
    yk_terms_cross(&plan->list, plan->mech, j, x2, 1);
    yk_terms_walk(&plan->list, plan->mech, &plan->cluster_tree, y1, y2);
    yk_terms_cross(&plan->list, plan->mech, j2, y2, 1);
    yk_terms_add_origin(&plan->list, plan->mech, k2, -1);
    if (!yk_plan_block(plan, (int32_t[]){j1, j, j2}, 3, wanted)) return false;
    yk_plan_block_bodies(plan, &plan->mech->blocks[plan->mech->block_count - 1], (int32_t[]){X, Y}, 2);
    plan->joint_used[j] = plan->joint_used[j2] = true;
    yk_plan_place(plan, j1, k1);
    yk_plan_place(plan, j2, k2);
    return true;
}

static bool try_pairs(YkPlan *plan, int32_t X, size_t wanted)
{
    for (int32_t a = 0; a < plan->anchor_count[X]; a++)
        for (int32_t b = a + 1; b < plan->anchor_count[X]; b++)
            if (try_two_joints(plan, X, plan->anchors[X][a], plan->anchors[X][b], wanted)) return true;
    return false;
}

static bool try_neighbour(YkPlan *plan, int32_t X, int32_t joint, size_t wanted)
{
    int32_t Y = plan->cluster[end_beyond(plan, joint, X)];
    if (Y == X || plan->cluster_known[Y] || plan->anchor_count[Y] == 0) return false;
    for (int32_t a = 0; a < plan->anchor_count[X]; a++)
        for (int32_t b = 0; b < plan->anchor_count[Y]; b++)
            if (try_three_joints(plan, X, plan->anchors[X][a], joint, plan->anchors[Y][b], wanted)) return true;
    return false;
}

static bool try_neighbours(YkPlan *plan, int32_t X, size_t wanted)
{
    for (uint32_t m = plan->cluster_first[X]; m < plan->cluster_first[X + 1]; m++) {
        int32_t body = plan->cluster_member[m];
        for (uint32_t e = plan->incidence->first[body]; e < plan->incidence->first[body + 1]; e++)
            if (try_neighbour(plan, X, plan->incidence->joint[e], wanted)) return true;
    }
    return false;
}

// Visits a cluster. Two unknowns come first: with fewer, a loop repeats constraints, and a dyad found later may leave
// it nothing to solve.
static void look_at(YkPlan *plan, int32_t X)
{
    if (try_follow(plan, X) || try_pairs(plan, X, 2) || try_neighbours(plan, X, 2)) return;
    if (try_pairs(plan, X, 1)) return;
    try_neighbours(plan, X, 1);
}

void yk_plan_peel(YkPlan *plan)
{
    size_t room = plan->mech->model->body_count + 1;
    do {
        while (plan->head < plan->tail && !plan->failed) {
            int32_t X = plan->queue[plan->head++ % room];
            if (!yk_compile_goes_on(plan->mech, 1)) return;
            plan->is_queued[X] = false;
            if (!plan->cluster_known[X]) look_at(plan, X);
        }
    } while (yk_plan_relations(plan) && !plan->failed);
}
