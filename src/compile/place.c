// Places bodies, cluster by cluster, and learns unknowns: what each step of the plan makes known.
#include "compile/plan.h"

void yk_plan_step(YkPlan *plan, YkStep step)
{
    YkMechanism *mech = plan->mech;
    if (!YK_ROOM(mech->steps, mech->step_count, mech->step_capacity)) {
        plan->failed = true;
        return;
    }
    mech->steps[mech->step_count++] = step;
    if (step.kind == YK_STEP_TURN || step.kind == YK_STEP_COMPOSE || step.kind == YK_STEP_DISTANCE)
        yk_plan_note_step(plan, &step);
}

enum { TERMS_MAX = 3 }; // a longer origin becomes a node of its own, so that sums stay short in a deep machine

static void set_origin(YkPlan *plan, int32_t body)
{
    YkMechanism *mech = plan->mech;
    YkSum *origin = &mech->bodies[body].origin;
    if (!yk_terms_store(&plan->list, mech, origin)) plan->failed = true;
    if (origin->count <= TERMS_MAX) return;
    if (!YK_ROOM(mech->node_sums, mech->node_count, mech->node_capacity)) {
        plan->failed = true;
        return;
    }
    int32_t node = (int32_t)mech->node_count++;
    mech->node_sums[node] = *origin;
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_NODE, .target = node});
    *origin = (YkSum){.plus = node, .minus = YK_NONE};
}

static void enqueue(YkPlan *plan, int32_t cluster)
{
    if (plan->cluster_known[cluster] || plan->is_queued[cluster]) return;
    plan->is_queued[cluster] = true;
    plan->queue[plan->tail++ % (plan->mech->model->body_count + 1)] = cluster;
}

// Places a body next to one that is placed, over a joint of the cluster.
static void place_beside(YkPlan *plan, int32_t placed, int32_t joint)
{
    int32_t body = yk_other_body(plan->mech->model, joint, placed);
    if (plan->body_placed[body]) return;
    yk_terms_clear(&plan->list);
    yk_terms_add_origin(&plan->list, plan->mech, placed, 1);
    yk_terms_cross(&plan->list, plan->mech, joint, placed, 1);
    set_origin(plan, body);
    plan->body_placed[body] = true;
}

static void announce(YkPlan *plan, int32_t body)
{
    for (uint32_t e = plan->incidence->first[body]; e < plan->incidence->first[body + 1]; e++) {
        int32_t joint = plan->incidence->joint[e], c = plan->cluster[yk_other_body(plan->mech->model, joint, body)];
        if (plan->cluster_known[c]) continue;
        if (plan->anchor_count[c] < YK_ANCHORS_MAX) plan->anchors[c][plan->anchor_count[c]++] = joint;
        enqueue(plan, c);
    }
}

void yk_plan_place_cluster(YkPlan *plan, int32_t entry)
{
    const YkTree *tree = &plan->cluster_tree;
    int32_t c = plan->cluster[entry];
    plan->cluster_known[c] = true;
    plan->unknown_clusters--;
    set_origin(plan, entry);
    plan->body_placed[entry] = true;
    for (int32_t b = entry; tree->parent[b] != YK_NONE; b = tree->parent[b]) place_beside(plan, b, tree->joint[b]);
    for (uint32_t k = plan->cluster_first[c]; k < plan->cluster_first[c + 1]; k++) { // parents come before children
        int32_t b = plan->cluster_member[k];
        if (!plan->body_placed[b]) place_beside(plan, tree->parent[b], tree->joint[b]);
    }
    for (uint32_t k = plan->cluster_first[c]; k < plan->cluster_first[c + 1]; k++)
        announce(plan, plan->cluster_member[k]);
}

void yk_plan_place(YkPlan *plan, int32_t joint, int32_t known_body)
{
    yk_terms_clear(&plan->list);
    yk_terms_add_origin(&plan->list, plan->mech, known_body, 1);
    yk_terms_cross(&plan->list, plan->mech, joint, known_body, 1);
    plan->joint_used[joint] = true;
    yk_plan_place_cluster(plan, yk_other_body(plan->mech->model, joint, known_body));
}

void yk_plan_learn(YkPlan *plan, YkColumn column)
{
    YkMechanism *mech = plan->mech;
    if (column.is_distance) {
        plan->distance_known[column.index] = true;
        return;
    }
    int32_t root = column.index;
    plan->root_known[root] = true;
    // A group lists its members; each turns with its root. Bodies of these orientations may follow now.
    int32_t o = root;
    do {
        if (o != root)
            yk_plan_step(
                plan, (YkStep){.kind = YK_STEP_COMPOSE, .target = o, .parent = root, .other = mech->relative_slot[o]});
        for (int32_t b = plan->orientation_first[o]; b != YK_NONE; b = plan->orientation_next[b])
            enqueue(plan, plan->cluster[b]);
        o = plan->group_next[o];
    } while (o != root);
}
