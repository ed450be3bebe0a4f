// Adds bodies with mass or load to the order of elimination.
#include <stdlib.h>
#include <string.h>
#include "equations/elimination_order.h"

// Adds the reference point relative to the origin: joins the piece of the body's own orientation if the origin has one.
static bool add_reference(YkEliminationOrder *o, YkTerm term, uint32_t first)
{
    YkElimination *e = o->e;
    if (term.slot == 0 || (term.v.x == 0 && term.v.y == 0)) return true;
    for (size_t k = first; k < e->piece_count; k++) {
        YkGradientPiece *piece = &e->pieces[k];
        if (piece->slot != term.slot || piece->distance != YK_NONE) continue;
        piece->v = yk_add(piece->v, term.v);
        return true;
    }
    return yk_gradient_add_term(e, &o->columns, term, 0, YK_NONE, 0);
}

static void add_element(YkEliminationOrder *o, int32_t body)
{
    YkElimination *e = o->e;
    const YkBody *b = &o->mech->model->bodies[body];
    const YkPlacing *placing = &o->mech->bodies[body];
    YkElement element = {.body = body, .mass = b->mass, .inertia = b->inertia, .gradient = yk_gradient_begin(e)};
    yk_order_start_columns(o);
    YkTerm reference = yk_body_term(o->mech, body, b->mass > 0 ? b->center : yk_vec(0, 0));
    if (!yk_gradient_add_sum(e, &o->columns, &placing->origin, 0, YK_NONE, 0)) o->failed = true;
    element.rotation = yk_column(&o->columns, yk_unknown_of_slot(placing->orientation));
    if (!add_reference(o, reference, element.gradient.first_piece)) o->failed = true;
    yk_gradient_end(e, &o->columns, &element.gradient);
    if (o->columns.count == 0) return; // it never moves
    o->element_first[e->element_count] = (uint32_t)o->element_column_count;
    for (size_t k = 0; k < o->columns.count; k++)
        if (!yk_order_keep(&o->element_columns, &o->element_column_count, &o->element_column_capacity,
                           o->columns.unknown[k]))
            o->failed = true;
    e->elements[e->element_count++] = element;
}

void yk_order_add_elements(YkEliminationOrder *o)
{
    const YkModel *model = o->mech->model;
    for (size_t b = 1; b < model->body_count && !o->failed; b++)
        if (model->bodies[b].has_mass || o->is_loaded[b]) add_element(o, (int32_t)b);
    o->element_first[o->e->element_count] = (uint32_t)o->element_column_count;
}

// Sorts elements by the operation that defines their latest unknown (counting sort).
bool yk_order_sort_elements(YkEliminationOrder *o)
{
    YkElimination *e = o->e;
    uint32_t *start = calloc(e->operation_count + 2, sizeof *start);
    YkElement *sorted = calloc(e->element_count + 1, sizeof *sorted);
    uint32_t *first = calloc(e->element_count + 1, sizeof *first);
    bool ok = start && sorted && first;
    for (size_t k = 0; ok && k < e->element_count; k++) {
        int32_t latest = 0;
        for (uint32_t c = o->element_first[k]; c < o->element_first[k + 1]; c++) {
            int32_t p = yk_order_place(o, o->element_columns[c]);
            if (p > latest) latest = p;
        }
        o->element_place[k] = latest;
        start[latest + 1]++;
    }
    for (size_t p = 0; ok && p < e->operation_count; p++) {
        e->operations[p].first_element = start[p];
        e->operations[p].element_count = start[p + 1];
        start[p + 1] += start[p];
    }
    for (size_t k = 0; ok && k < e->element_count; k++) {
        uint32_t at = start[o->element_place[k]]++;
        sorted[at] = e->elements[k];
        first[at] = o->element_first[k];
    }
    if (ok) {
        memcpy(e->elements, sorted, e->element_count * sizeof *sorted);
        memcpy(o->element_first, first, e->element_count * sizeof *first);
    }
    free(start);
    free(sorted);
    free(first);
    return ok;
}
