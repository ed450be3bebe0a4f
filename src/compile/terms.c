// Builds sums of turned vectors and stores them in the mechanism.
#include "compile/terms.h"
#include <stdlib.h>

void yk_terms_free(YkTermList *list)
{
    free(list->items);
    free(list->nodes);
    *list = (YkTermList){0};
}

void yk_terms_clear(YkTermList *list)
{
    list->constant = yk_vec(0, 0);
    list->plus = list->minus = YK_NONE;
    list->count = 0;
    list->constant_node = 0;
}

static bool has_room(YkTermList *list)
{
    return YK_ROOM(list->items, list->count, list->capacity) &&
           (!list->recipe || YK_ROOM(list->nodes, list->count, list->node_capacity));
}

static void add_constant(YkTermList *list, YkVec v, int32_t node)
{
    list->constant = yk_add(list->constant, v);
    list->constant_node = yk_recipe_add(list->recipe, list->constant_node, node, list->constant);
}

void yk_terms_add_node(YkTermList *list, YkTerm term, int32_t node, double sign)
{
    term.v = yk_scale(sign, term.v);
    if (sign < 0) node = yk_recipe_negate(list->recipe, node, term.v);
    if (term.slot == 0 && term.distance == YK_NONE) {
        add_constant(list, term.v, node);
        return;
    }
    for (size_t k = 0; k < list->count; k++) {
        if (list->items[k].slot != term.slot || list->items[k].distance != term.distance) continue;
        list->items[k].v = yk_add(list->items[k].v, term.v);
        if (list->recipe) list->nodes[k] = yk_recipe_add(list->recipe, list->nodes[k], node, list->items[k].v);
        return;
    }
    if (!has_room(list)) {
        list->failed = true;
        return;
    }
    if (list->recipe) list->nodes[list->count] = node;
    list->items[list->count++] = term;
}

YkTerm yk_body_term(const YkMechanism *mech, int32_t body, YkVec at)
{
    const YkPlacing *placing = &mech->bodies[body];
    return (YkTerm){placing->orientation, YK_NONE, yk_mul(placing->turn_unit, at)};
}

static void add_node(YkTermList *list, int32_t node, double sign)
{
    if (node == YK_NONE) return;
    int32_t *here = sign > 0 ? &list->plus : &list->minus, *there = sign > 0 ? &list->minus : &list->plus;
    if (*there == node)
        *there = YK_NONE; // cancels
    else
        *here = node;
}

void yk_terms_add_origin(YkTermList *list, const YkMechanism *mech, int32_t body, double sign)
{
    const YkSum *origin = &mech->bodies[body].origin;
    YkRecipe *recipe = list->recipe;
    YkVec constant = yk_scale(sign, origin->constant);
    int32_t node = yk_recipe_constant(recipe, origin->first, origin->plus != YK_NONE);
    add_constant(list, constant, sign < 0 ? yk_recipe_negate(recipe, node, constant) : node);
    add_node(list, origin->plus, sign);
    for (uint32_t k = origin->first; k < origin->first + origin->count; k++)
        yk_terms_add_node(list, mech->terms[k], recipe && k < recipe->term_count ? recipe->of_term[k] : 0, sign);
}

// Adds a joint's point on one of its sides, relative to that body's origin.
static void add_joint_point(YkTermList *list, const YkMechanism *mech, int32_t joint, int side, double sign)
{
    const YkJoint *j = &mech->model->joints[joint];
    YkTerm term = yk_body_term(mech, j->body[side], j->at[side]);
    yk_terms_add_node(list, term, yk_recipe_leaf(list->recipe, YK_RECIPE_POINT, joint, side, term.v), sign);
}

void yk_terms_cross(YkTermList *list, const YkMechanism *mech, int32_t joint, int32_t from, double sign)
{
    const YkJoint *j = &mech->model->joints[joint];
    double way = from == j->body[0] ? sign : -sign;
    add_joint_point(list, mech, joint, 0, way);
    if (mech->joint_distance[joint] != YK_NONE) {
        YkTerm slide = yk_body_term(mech, j->body[0], j->along);
        slide.distance = mech->joint_distance[joint];
        yk_terms_add_node(list, slide, yk_recipe_leaf(list->recipe, YK_RECIPE_ALONG, joint, 0, slide.v), way);
    }
    add_joint_point(list, mech, joint, 1, -way);
}

void yk_terms_walk(YkTermList *list, const YkMechanism *mech, const YkTree *tree, int32_t from, int32_t to)
{
    while (from != to) {
        if (tree->depth[from] >= tree->depth[to]) {
            yk_terms_cross(list, mech, tree->joint[from], from, 1);
            from = tree->parent[from];
        } else {
            yk_terms_cross(list, mech, tree->joint[to], to, -1);
            to = tree->parent[to];
        }
    }
}

bool yk_terms_store(const YkTermList *list, YkMechanism *mech, YkSum *sum)
{
    *sum = (YkSum){list->constant, list->plus, list->minus, (uint32_t)mech->term_count,
                   0}; // counts the stored terms, also on failure
    yk_recipe_note_constant(list->recipe, mech->term_count, list->constant_node);
    for (size_t k = 0; k < list->count; k++) {
        if (!yk_terms_is_there(list, k)) continue;
        if (!YK_ROOM(mech->terms, mech->term_count, mech->term_capacity)) return false;
        yk_recipe_note_term(list->recipe, mech->term_count, yk_terms_node(list, k));
        mech->terms[mech->term_count++] = list->items[k];
        sum->count++;
    }
    if (list->recipe && sum->count == 0) { // no other sum may begin here: its first term identifies it in the recipe
        if (!YK_ROOM(mech->terms, mech->term_count, mech->term_capacity)) return false;
        yk_recipe_note_term(list->recipe, mech->term_count, 0);
        mech->terms[mech->term_count++] = (YkTerm){.distance = YK_NONE};
    }
    return !list->failed && !(list->recipe && list->recipe->failed);
}
