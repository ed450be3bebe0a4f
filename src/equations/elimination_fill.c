// Finds the fill-in: which entries the form has, and their addresses.
#include "equations/elimination_order.h"

static bool is_before(const YkEliminationOrder *o, int32_t a,
                      int32_t b) // whether a is eliminated before b; within one operation: by number
{
    int32_t pa = yk_order_place(o, a), pb = yk_order_place(o, b);
    return pa > pb || (pa == pb && a < b);
}

// Returns the entry of a pair, in the row of the unknown eliminated first.
static int32_t entry_of(YkEliminationOrder *o, int32_t a, int32_t b)
{
    int32_t row = is_before(o, a, b) ? a : b, other = row == a ? b : a;
    for (int32_t k = o->head[row]; k != YK_NONE; k = o->links[k].next)
        if (o->links[k].unknown == other) return o->links[k].entry;
    if (!YK_ROOM(o->links, o->link_count, o->link_capacity)) {
        o->failed = true;
        return 0;
    }
    o->links[o->link_count].next = o->head[row];
    o->links[o->link_count].unknown = other;
    o->links[o->link_count].entry = (int32_t)o->e->entry_count++;
    o->head[row] = (int32_t)o->link_count++;
    return o->links[o->head[row]].entry;
}

static void put_index(YkEliminationOrder *o, int32_t value)
{
    if (!yk_order_keep(&o->e->index, &o->e->index_count, &o->e->index_capacity, value)) o->failed = true;
}

static void fill_element(YkEliminationOrder *o, size_t index)
{
    YkElement *element = &o->e->elements[index];
    const int32_t *columns = o->element_columns + o->element_first[index];
    uint32_t n = element->gradient.columns;
    element->first_index = (uint32_t)o->e->index_count;
    for (uint32_t k = 0; k < n; k++) put_index(o, columns[k]);
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i; j < n; j++) put_index(o, entry_of(o, columns[i], columns[j]));
}

// Gathers the neighbours of the operation's unknowns that are eliminated later, W first.
static void gather_neighbours(YkEliminationOrder *o, const YkOperation *op, const int32_t *columns)
{
    yk_order_start_columns(o);
    for (uint32_t k = op->own; k < op->own + op->given; k++) yk_column(&o->columns, columns[k]);
    for (uint32_t u = 0; u < op->own; u++)
        for (int32_t k = o->head[columns[u]]; k != YK_NONE; k = o->links[k].next) {
            bool is_own = false;
            for (uint32_t j = 0; j < op->own; j++) is_own = is_own || columns[j] == o->links[k].unknown;
            if (!is_own) yk_column(&o->columns, o->links[k].unknown);
        }
    if (o->columns.failed) o->failed = true;
}

static int32_t existing_entry(const YkEliminationOrder *o, int32_t row, int32_t other)
{
    for (int32_t k = o->head[row]; k != YK_NONE; k = o->links[k].next)
        if (o->links[k].unknown == other) return o->links[k].entry;
    return YK_NONE;
}

static void fill_operation(YkEliminationOrder *o, YkOperation *op)
{
    YkElimination *e = o->e;
    const int32_t *columns = o->raw_columns + o->raw_first[op->first_index];
    gather_neighbours(o, op, columns);
    uint32_t n = (uint32_t)o->columns.count;
    op->neighbours = n;
    op->first_index = (uint32_t)e->index_count;
    op->first_coefficient = (uint32_t)e->coefficient_count;
    e->coefficient_count += (size_t)op->own * op->given;
    for (uint32_t k = 0; k < op->own; k++) put_index(o, columns[k]);
    for (uint32_t k = 0; k < n; k++) put_index(o, o->columns.unknown[k]);
    for (uint32_t i = 0; i < op->own; i++)
        for (uint32_t j = i; j < op->own; j++) put_index(o, entry_of(o, columns[i], columns[j]));
    for (uint32_t i = 0; i < op->own; i++)
        for (uint32_t j = 0; j < n; j++) put_index(o, existing_entry(o, columns[i], o->columns.unknown[j]));
    uint32_t rows = op->kind == YK_OP_FREE ? n : op->given;
    for (uint32_t i = 0; i < rows && op->kind != YK_OP_KNOWN; i++)
        for (uint32_t j = i; j < n; j++) put_index(o, entry_of(o, o->columns.unknown[i], o->columns.unknown[j]));
    if (n + op->own > e->widest) e->widest = n + op->own;
}

void yk_order_find_fill(YkEliminationOrder *o)
{
    YkElimination *e = o->e;
    for (size_t p = e->operation_count; p-- > 0 && !o->failed;) {
        YkOperation *op = &e->operations[p];
        for (uint32_t k = 0; k < op->element_count; k++) fill_element(o, op->first_element + k);
        fill_operation(o, op);
    }
    for (size_t k = 0; k < e->element_count; k++)
        if (e->elements[k].gradient.columns > e->widest) e->widest = e->elements[k].gradient.columns;
}
