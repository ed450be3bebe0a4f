// The plan: the order in which the machine is solved when certain coordinates are inputs.
//
// Bodies whose relative pose is an input form a *cluster*. From the ground's cluster outwards the plan peels dyads,
// which two unknowns and one loop determine. Matching and strong components divide the rest into groups.
#ifndef COMPILE_PLAN_H
#define COMPILE_PLAN_H
#include "compile/terms.h"
#include "compile/topology.h"

enum { YK_ANCHORS_MAX = 8 }; // more joints to known clusters add nothing

typedef struct YkInputSum { // what is a sum of inputs
    bool is_known;
    double constant;
    YkRelationSource *sources; // inputs
    size_t count;
} YkInputSum;

typedef struct YkPlan {
    YkMechanism *mech;
    const YkIncidence *incidence;
    YkArena *arena; // scratch memory
    YkProblems *problems;
    int32_t *angle_input, *distance_input; // per joint: input, or YK_NONE
    // clusters
    int32_t *cluster; // per body
    size_t cluster_count;
    uint32_t *cluster_first; // members of cluster c: cluster_member[first[c] .. first[c + 1])
    int32_t *cluster_member;
    YkTree cluster_tree;
    // groups of orientations
    int32_t *group_next;       // circular list of the orientations of a group
    int32_t *orientation_next; // list of the bodies of an orientation
    int32_t *orientation_first;
    // Known so far:
    bool *cluster_known, *root_known, *distance_known, *joint_used, *body_placed;
    int32_t (*anchors)[YK_ANCHORS_MAX]; // per cluster: joints to known clusters
    int32_t *anchor_count;
    int32_t *queue; // clusters to visit
    bool *is_queued;
    size_t head, tail, unknown_clusters;
    // Judges which equations determine which unknowns if equations repeat each other; or NULL.
    const struct YkClosedPose *pose;
    // Per orientation: its angle, per distance: itself, as a sum of inputs, if it is one (machines with relations).
    YkInputSum *forms, *distance_forms;
    YkTermList list;
    size_t missing; // unknowns that nothing determines
    bool failed;    // out of memory
} YkPlan;

// Makes steps and blocks for the inputs of mech->inputs. Returns false when out of memory. plan->missing > 0: more
// inputs are needed. pose: a closed pose, or NULL if counting unknowns and equations is enough.
bool yk_plan_make(YkPlan *plan, YkMechanism *mech, const YkIncidence *incidence, const struct YkClosedPose *pose,
                  YkArena *scratch);
void yk_plan_end(YkPlan *plan);

// Between the plan's files, from below.
//
// input_sums.c: returns the sums of all orientations, made at the first call. NULL when out of memory: plan->failed.
YkInputSum *yk_plan_sums(YkPlan *plan);
YkInputSum *yk_plan_sum_of(const YkPlan *plan, YkRelationTerm term);
// Returns x + y, or 0 if that is but rounding: over hundreds of turns of an input, rounding would be a miss.
double yk_plan_add(double x, double y);
// Adds target += factor * form.
void yk_plan_add_sum(YkPlan *plan, YkInputSum *target, const YkInputSum *form, double factor);
void yk_plan_note_step(YkPlan *plan, const YkStep *step); // notes that a TURN, COMPOSE or DISTANCE step was made

// place.c
void yk_plan_step(YkPlan *plan, YkStep step);
void yk_plan_learn(YkPlan *plan, YkColumn column);
void yk_plan_place(YkPlan *plan, int32_t joint, int32_t known_body); // makes the cluster beyond the joint known
// Places the entry's cluster, with the entry's origin in plan->list: up to the root of the cluster's tree, then all
// others from their parents.
void yk_plan_place_cluster(YkPlan *plan, int32_t entry);

// block.c, relations_plan.c, peel.c, groups.c
bool yk_plan_block(YkPlan *plan, const int32_t *joints, size_t count,
                   size_t expected); // from plan->list, a closed loop
YkBlock *yk_plan_new_block(YkPlan *plan, YkBlockKind kind, const int32_t *joints, size_t count);
void yk_plan_block_bodies(YkPlan *plan, YkBlock *block, const int32_t *clusters, size_t count);
void yk_plan_peel(YkPlan *plan);
void yk_plan_groups(YkPlan *plan);
// Solves every relation with one unknown; returns whether there was one.
bool yk_plan_relations(YkPlan *plan);
// Notes, at the end, the coordinates that are sums of inputs.
void yk_plan_coordinate_sums(YkPlan *plan);
// Lists the unknowns of a remaining relation, at most one for each of its terms.
size_t yk_plan_relation_columns(const YkPlan *plan, size_t relation, YkColumn *columns);
// Puts a relation into the group of these columns.
void yk_plan_group_relation(YkPlan *plan, size_t relation, const YkColumn *columns, size_t count);
static inline bool yk_plan_body_known(const YkPlan *plan, int32_t body)
{
    return plan->cluster_known[plan->cluster[body]];
}

#endif
