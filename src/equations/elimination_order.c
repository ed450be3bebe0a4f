// Puts the operations in order.
#include "equations/elimination_order.h"

static void need(YkEliminationOrder *o, int32_t unknown)
{
    if (o->defined_by[unknown] != YK_NONE) o->is_needed[o->defined_by[unknown]] = true;
}

void yk_order_mark_needed(YkEliminationOrder *o)
{
    for (size_t k = 0; k < o->element_column_count; k++) need(o, o->element_columns[k]);
    for (size_t r = o->raw_count; r-- > 0;) {
        if (o->raw[r].input != YK_NONE) o->is_needed[r] = true;
        if (!o->is_needed[r]) continue;
        for (uint32_t k = 0; k < o->raw[r].own + o->raw[r].given; k++) need(o, o->raw_columns[o->raw_first[r] + k]);
    }
}

static void emit(YkEliminationOrder *o, size_t raw, size_t *place)
{
    if (o->place[raw] != YK_NONE) return;
    o->place[raw] = (int32_t)*place;
    o->e->operations[*place] = o->raw[raw];
    o->e->operations[(*place)++].first_index = (uint32_t)raw; // until the fill-in is found
}

// Puts operations in order, free inputs as late as possible: just before the first operation that needs them.
void yk_order_put(YkEliminationOrder *o)
{
    size_t place = 0;
    for (size_t r = 0; r < o->raw_count; r++) {
        if (!o->is_needed[r] || o->raw[r].kind == YK_OP_FREE) continue;
        for (uint32_t k = o->raw[r].own; k < o->raw[r].own + o->raw[r].given; k++) {
            int32_t by = o->defined_by[o->raw_columns[o->raw_first[r] + k]];
            if (by != YK_NONE) emit(o, (size_t)by, &place);
        }
        emit(o, r, &place);
    }
    for (size_t r = 0; r < o->raw_count; r++)
        if (o->is_needed[r]) emit(o, r, &place);
    o->e->operation_count = place;
    for (size_t i = 0; i < o->mech->input_count; i++)
        if (o->e->operation_of_input[i] != YK_NONE) o->e->operation_of_input[i] = o->place[o->e->operation_of_input[i]];
}

// Marks where back substitution is needed: as far as a free input's acceleration has effect.
void yk_order_mark_back(YkEliminationOrder *o)
{
    YkElimination *e = o->e;
    for (size_t i = 0; i < o->mech->input_count; i++) {
        int32_t parent = e->parent_of_input[i];
        if (o->is_free[i] && parent > 0 && o->defined_by[parent] != YK_NONE)
            e->is_back_needed[yk_order_place(o, parent)] = true;
    }
    for (size_t p = e->operation_count; p-- > 0;) {
        const YkOperation *op = &e->operations[p];
        if (op->kind == YK_OP_FREE) e->is_back_needed[p] = true;
        if (!e->is_back_needed[p]) continue;
        const int32_t *unknown = e->index + op->first_index + op->own;
        uint32_t n = op->kind == YK_OP_FREE ? op->neighbours : op->given;
        for (uint32_t k = 0; k < n; k++) e->is_back_needed[yk_order_place(o, unknown[k])] = true;
    }
}
