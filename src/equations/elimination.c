// Makes the order of elimination from the steps of solution.
#include "equations/elimination.h"
#include <stdlib.h>
#include "equations/elimination_order.h"

static bool allocate(YkEliminationOrder *o)
{
    YkElimination *e = o->e;
    const YkMechanism *mech = o->mech;
    size_t steps = mech->step_count + 1, bodies = mech->model->body_count + 1, inputs = mech->input_count + 1;
    e->unknown_count = mech->slot_count + mech->distance_count + 2 * mech->node_count;
    YkArena *a = e->arena = yk_arena_new();
    e->operations = yk_arena_alloc(a, steps, sizeof *e->operations);
    e->elements = yk_arena_alloc(a, bodies, sizeof *e->elements);
    e->operation_of_input = yk_arena_alloc(a, inputs, sizeof *e->operation_of_input);
    e->parent_of_input = yk_arena_alloc(a, inputs, sizeof *e->parent_of_input);
    e->sign_of_input = yk_arena_alloc(a, inputs, sizeof *e->sign_of_input);
    e->is_back_needed = yk_arena_alloc(a, steps, sizeof *e->is_back_needed);
    o->raw = yk_arena_alloc(o->arena, steps, sizeof *o->raw);
    o->raw_first = yk_arena_alloc(o->arena, steps, sizeof *o->raw_first);
    o->is_needed = yk_arena_alloc(o->arena, steps, sizeof *o->is_needed);
    o->place = yk_arena_alloc(o->arena, steps, sizeof *o->place);
    o->defined_by = yk_arena_alloc(o->arena, e->unknown_count + 1, sizeof *o->defined_by);
    o->head = yk_arena_alloc(o->arena, e->unknown_count + 1, sizeof *o->head);
    o->element_first = yk_arena_alloc(o->arena, bodies + 1, sizeof *o->element_first);
    o->element_place = yk_arena_alloc(o->arena, bodies, sizeof *o->element_place);
    if (yk_arena_failed(a) || yk_arena_failed(o->arena)) return false;
    for (size_t k = 0; k < inputs; k++) e->operation_of_input[k] = YK_NONE;
    for (size_t k = 0; k < steps; k++) o->place[k] = YK_NONE;
    for (size_t k = 0; k < e->unknown_count + 1; k++) o->defined_by[k] = o->head[k] = YK_NONE;
    return true;
}

static void free_order(YkEliminationOrder *o)
{
    free(o->columns.unknown);
    free(o->raw_columns);
    free(o->links);
    free(o->element_columns);
    yk_arena_free(o->arena);
}

YkElimination *yk_elimination_new(const YkMechanism *mech, const bool *is_free, const bool *is_loaded)
{
    YkElimination *e = calloc(1, sizeof *e);
    if (!e) return NULL;
    e->mech = mech;
    YkEliminationOrder o = {.arena = yk_arena_new(), .e = e, .mech = mech, .is_free = is_free, .is_loaded = is_loaded};
    bool ok = allocate(&o);
    if (ok) {
        yk_order_add_steps(&o);
        if (!o.failed) yk_order_add_elements(&o);
        if (!o.failed) { // otherwise lists have gaps
            yk_order_mark_needed(&o);
            yk_order_put(&o);
        }
        ok = !o.failed && yk_order_sort_elements(&o);
        if (ok) yk_order_find_fill(&o);
        if (ok) yk_order_mark_back(&o);
    }
    if (!ok || o.failed) {
        yk_elimination_free(e);
        e = NULL;
    }
    free_order(&o);
    return e;
}

void yk_elimination_free(YkElimination *e)
{
    if (!e) return;
    yk_arena_free(e->arena);
    free(e->pieces);
    free(e->nodes);
    free(e->index);
    free(e->factors);
    free(e);
}
