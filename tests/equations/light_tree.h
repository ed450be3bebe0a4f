// Random trees that mostly weigh nothing: a few point masses and bodies at the ends of many weightless links.
#ifndef TESTS_EQUATIONS_LIGHT_TREE_H
#define TESTS_EQUATIONS_LIGHT_TREE_H
#include "open_tree.h"

enum { MOST_LINKS = 9 };

typedef struct LightTree {
    size_t links, parent[MOST_LINKS + 1];
    int freedoms[MOST_LINKS + 1], seen[MOST_LINKS + 1]; // of the joint; how many motions of its own mass count
} LightTree;

static inline void add_light_body(Text *text, uint64_t *seed, LightTree *tree, size_t k)
{
    double x = check_uniform(seed, -1, 1), y = check_uniform(seed, -1, 1);
    add(text, k > 0 ? "  b%zu: {points: {" : "  ground: {points: {", k);
    for (size_t j = 1; j <= tree->links; j++) add_point(text, seed, j);
    add(text, "A: [0, 0], B: [3, 0], C: [0, 0], D: [3, 0], own: [0, 0]}");
    if (tree->seen[k]) add(text, ", mass: %.17g, center: [%.17g, %.17g]", check_uniform(seed, 0.2, 3), x, y);
    if (tree->seen[k] == 3) add(text, ", inertia: %.17g", check_uniform(seed, 0.1, 1));
    add(text, "}\n");
}

// Makes a tree on the ground, whose first link is a body, or one on the coupler of a weightless four-bar, b1.
static inline LightTree light_tree(uint64_t *seed, Text *text, bool on_linkage)
{
    LightTree tree = {.links = 3 + check_random(seed) % (MOST_LINKS - 2)};
    static const YkPartKind kinds[] = {YK_PIN, YK_PIN, YK_PIN, YK_SLIDE, YK_PIN_SLOT};
    bool pins_only = check_random(seed) % 2, is_chain = check_random(seed) % 2;
    add(text, "gravity: [0, -9.81]\nbodies:\n");
    for (size_t k = 0; k <= tree.links; k++) {
        size_t weight = k == 0 ? 0 : k == 1 ? 9 : check_random(seed) % 10;
        tree.seen[k] = weight < 5 || (k == 1 && on_linkage) ? 0 : weight < 9 ? 2 : 3;
        add_light_body(text, seed, &tree, k);
    }
    if (on_linkage)
        add(text, "  crank: {points: {A: [0, 0], C: [1, 0]}}\n  rocker: {points: {B: [0, 0], D: [2, 0]}}\njoints:\n"
                  "  A: {pin: [ground, crank], angle: q}\n  B: {pin: [ground, rocker]}\n"
                  "  C: {pin: [crank, b1]}\n  D: {pin: [rocker, b1]}\n");
    else
        add(text, "joints:\n");
    tree.freedoms[1] = 1;
    for (size_t k = on_linkage ? 2 : 1; k <= tree.links; k++) {
        RandomJoint joint = {pins_only ? YK_PIN : kinds[check_random(seed) % 5], .is_reversed = check_random(seed) % 2};
        joint.parent = is_chain ? k - 1 : check_random(seed) % k;
        if (on_linkage && joint.parent == 0) joint.parent = 1;
        tree.parent[k] = joint.parent;
        tree.freedoms[k] = joint.kind == YK_PIN_SLOT ? 2 : 1;
        add_joint(text, seed, &joint, k);
    }
    return tree;
}

// Returns whether a subtree has more freedoms than its masses have motions: the mass matrix is singular in every pose.
// A machine without any mass is none of them: its motion is given.
static inline bool lacks_mass(LightTree tree)
{
    bool lacks = false;
    for (size_t k = tree.links; k > 0; k--) {
        lacks |= tree.freedoms[k] > tree.seen[k];
        tree.freedoms[tree.parent[k]] += tree.freedoms[k];
        tree.seen[tree.parent[k]] += tree.seen[k];
    }
    return lacks && tree.seen[0] > 0;
}

#endif
