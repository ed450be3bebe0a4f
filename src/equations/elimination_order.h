// The inside of yk_elimination_new: what is known while the order of elimination is being determined.
#ifndef EQUATIONS_ELIMINATION_ORDER_H
#define EQUATIONS_ELIMINATION_ORDER_H
#include "base/memory.h"
#include "equations/elimination.h"
#include "equations/gradient.h"

typedef struct YkEliminationOrder {
    YkArena *arena; // of the lists that do not grow
    YkElimination *e;
    const YkMechanism *mech;
    const bool *is_free, *is_loaded;
    YkGradientColumns columns;
    // Operations as the steps give them, before they are ordered:
    YkOperation *raw;
    int32_t *raw_columns; // unknowns of each, U then W
    size_t raw_count, raw_column_count, raw_column_capacity;
    uint32_t *raw_first;
    int32_t *defined_by; // per unknown: raw operation, YK_NONE
    bool *is_needed;     // per raw operation
    int32_t *place;      // per raw operation: its index in forward order, YK_NONE
    int32_t *element_columns;
    size_t element_column_count, element_column_capacity;
    uint32_t *element_first;
    int32_t *element_place;
    // The fill-in: per unknown its entries with others that are eliminated after it.
    int32_t *head;
    struct YkOrderLink {
        int32_t next, unknown, entry;
    } * links;
    size_t link_count, link_capacity;
    bool failed;
} YkEliminationOrder;

// Appends a number to a list that grows.
static inline bool yk_order_keep(int32_t **items, size_t *count, size_t *capacity, int32_t value)
{
    if (!yk_grow((void **)items, *count, capacity, sizeof **items)) return false;
    (*items)[(*count)++] = value;
    return true;
}

static inline void yk_order_start_columns(YkEliminationOrder *o)
{
    o->columns.count = 0;
}

// Returns the index, in forward order, of the operation that defines an unknown.
static inline int32_t yk_order_place(const YkEliminationOrder *o, int32_t unknown)
{
    return o->place[o->defined_by[unknown]];
}

// Each of these marks the order as failed when out of memory.
void yk_order_add_steps(YkEliminationOrder *order);     // operations, as the steps give them
void yk_order_add_elements(YkEliminationOrder *order);  // bodies with mass or load
void yk_order_mark_needed(YkEliminationOrder *order);   // the operations on which bodies and inputs depend
void yk_order_put(YkEliminationOrder *order);           // operations in forward order, free inputs as late as possible
bool yk_order_sort_elements(YkEliminationOrder *order); // by the operation that defines their latest unknown
void yk_order_find_fill(YkEliminationOrder *order);     // the addresses of the form's entries
void yk_order_mark_back(YkEliminationOrder *order);     // the operations on which a free input's acceleration depends

#endif
