#include "compile/terms.h"
#include <stdlib.h>

void yk_terms_free(YkTermList *list)
{
    free(list->items);
    *list = (YkTermList){0};
}

void yk_terms_clear(YkTermList *list)
{
    list->constant = yk_vec(0, 0);
    list->plus = list->minus = YK_NONE;
    list->count = 0;
}

static void drop_if_zero(YkTermList *list, size_t k)
{
    if (list->items[k].v.x == 0 && list->items[k].v.y == 0) list->items[k] = list->items[--list->count];
}

void yk_terms_add(YkTermList *list, YkTerm term, double sign)
{
    term.v = yk_scale(sign, term.v);
    if (term.slot == 0 && term.distance == YK_NONE) {
        list->constant = yk_add(list->constant, term.v);
        return;
    }
    if (term.v.x == 0 && term.v.y == 0) return;
    for (size_t k = 0; k < list->count; k++) {
        if (list->items[k].slot != term.slot || list->items[k].distance != term.distance) continue;
        list->items[k].v = yk_add(list->items[k].v, term.v);
        drop_if_zero(list, k);
        return;
    }
    if (!YK_ROOM(list->items, list->count, list->capacity)) {
        list->failed = true;
        return;
    }
    list->items[list->count++] = term;
}

YkTerm yk_body_term(const YkMechanism *mech, int32_t body, YkVec at)
{
    const YkPlacing *placing = &mech->bodies[body];
    return (YkTerm){placing->orientation, YK_NONE, yk_mul(placing->turn_unit, at)};
}

void yk_terms_add_point(YkTermList *list, const YkMechanism *mech, int32_t body, YkVec at, double sign)
{
    yk_terms_add(list, yk_body_term(mech, body, at), sign);
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
    list->constant = yk_add(list->constant, yk_scale(sign, origin->constant));
    add_node(list, origin->plus, sign);
    for (uint32_t k = 0; k < origin->count; k++) yk_terms_add(list, mech->terms[origin->first + k], sign);
}

void yk_terms_cross(YkTermList *list, const YkMechanism *mech, int32_t joint, int32_t from, double sign)
{
    const YkJoint *j = &mech->model->joints[joint];
    double way = from == j->body[0] ? sign : -sign;
    yk_terms_add_point(list, mech, j->body[0], j->at[0], way);
    if (mech->joint_distance[joint] != YK_NONE) {
        YkTerm slide = yk_body_term(mech, j->body[0], j->along);
        slide.distance = mech->joint_distance[joint];
        yk_terms_add(list, slide, way);
    }
    yk_terms_add_point(list, mech, j->body[1], j->at[1], -way);
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
                   0}; // counts what is stored, also on failure
    for (size_t k = 0; k < list->count; k++) {
        if (!YK_ROOM(mech->terms, mech->term_count, mech->term_capacity)) return false;
        mech->terms[mech->term_count++] = list->items[k];
        sum->count++;
    }
    return !list->failed;
}
