// Builds sums of turned vectors.
#ifndef COMPILE_TERMS_H
#define COMPILE_TERMS_H
#include "compile/mechanism.h"
#include "compile/recipe.h"

// A sum under construction, in which like terms merge. A term that is 0 or cancels exactly keeps its place until the
// sum is stored, so that the order of the others does not depend on values.
typedef struct YkTermList {
    YkVec constant;
    int32_t plus, minus;
    YkTerm *items;
    size_t count, capacity;
    bool failed;      // out of memory
    YkRecipe *recipe; // of the mechanism, or NULL; if set, the nodes of constant and items:
    int32_t constant_node;
    int32_t *nodes; // [items]
    size_t node_capacity;
} YkTermList;

void yk_terms_free(YkTermList *list);
void yk_terms_clear(YkTermList *list);
// Adds sign * term, a vector that is `node` in the recipe.
void yk_terms_add_node(YkTermList *list, YkTerm term, int32_t node, double sign);
static inline bool yk_terms_is_there(const YkTermList *list, size_t k)
{
    return list->items[k].v.x != 0 || list->items[k].v.y != 0;
}
static inline int32_t yk_terms_node(const YkTermList *list, size_t k)
{
    return list->recipe ? list->nodes[k] : 0;
}
// Adds the origin of a placed body in the world.
void yk_terms_add_origin(YkTermList *list, const YkMechanism *mech, int32_t body, double sign);
// Crosses a joint: from the origin of body `from` over `joint` to the origin of its other body.
void yk_terms_cross(YkTermList *list, const YkMechanism *mech, int32_t joint, int32_t from, double sign);
// Walks from the origin of `from` to the origin of `to` along the tree. Cost: length of the path.
void yk_terms_walk(YkTermList *list, const YkMechanism *mech, const YkTree *tree, int32_t from, int32_t to);
// Moves the list into the mechanism's terms. Returns false when out of memory.
bool yk_terms_store(const YkTermList *list, YkMechanism *mech, YkSum *sum);

#endif
