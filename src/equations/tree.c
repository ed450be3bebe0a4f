// Forward dynamics of open trees: chooses the fast path for pins or the general one.
#include "equations/tree.h"
#include <stdlib.h>
#include "equations/tree_joints.h"
#include "equations/tree_pins.h"

struct YkTreeDynamics {
    YkArena *arena;
    YkTreePins *pins; // one of the two is set
    YkTreeJoints *joints;
};

static bool is_open_tree(const YkMechanism *mech)
{
    const YkModel *model = mech->model;
    bool is_free = mech->loop_count == 0 && mech->input_count == mech->coordinate_count && model->drive_count == 0;
    bool is_bare = model->force_count == 0 && model->spring_count == 0 && model->stop_count == 0;
    for (size_t j = 0; j < model->joint_count; j++) is_bare = is_bare && !model->joints[j].has_friction;
    return is_free && is_bare;
}

// Builds the tree: the fast path copies what it needs of the links; the general one keeps them.
static bool build(YkTreeDynamics *tree, const YkMechanism *mech, YkArena *scratch)
{
    YkVec gravity = mech->model->gravity;
    YkTreeLinks found, *kept;
    if (!yk_tree_links_build(&found, mech, scratch)) return false;
    if (!found.has_slides) {
        tree->pins = yk_tree_pins_new(&found, gravity, tree->arena);
        return tree->pins != NULL;
    }
    kept = YK_NEW(tree->arena, YkTreeLinks, 1);
    if (!kept) return false;
    *kept = found;
    kept->link = YK_NEW(tree->arena, YkTreeLink, found.count);
    for (size_t k = 0; kept->link && k < found.count; k++) kept->link[k] = found.link[k];
    tree->joints = kept->link ? yk_tree_joints_new(kept, gravity, tree->arena) : NULL;
    return tree->joints != NULL;
}

YkTreeDynamics *yk_tree_dynamics_new(const YkMechanism *mech, bool *fits)
{
    *fits = is_open_tree(mech);
    if (!*fits) return NULL;
    YkTreeDynamics *tree = malloc(sizeof *tree);
    if (!tree) return NULL;
    *tree = (YkTreeDynamics){.arena = yk_arena_new()};
    YkArena *scratch = yk_arena_new();
    bool ok = tree->arena && scratch && build(tree, mech, scratch);
    yk_arena_free(scratch);
    if (ok) return tree;
    yk_tree_dynamics_free(tree);
    return NULL;
}

void yk_tree_dynamics_free(YkTreeDynamics *tree)
{
    if (!tree) return;
    yk_arena_free(tree->arena);
    free(tree);
}

int yk_tree_accelerate(YkTreeDynamics *tree, const double *q, const double *v, const double *effort, double *a)
{
    return tree->pins ? yk_tree_pins_accelerate(tree->pins, q, v, effort, a)
                      : yk_tree_joints_accelerate(tree->joints, q, v, effort, a);
}
