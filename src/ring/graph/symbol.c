// Symbols of the ring as values of a graph, and their meanings.
#include <stdlib.h>
#include "ring/graph/element.h"
#include "ring/inside.h"
#include "ring/print/write.h"

bool yk_ring_graph_start(YkRingGraph *values, YkRing *ring, YkArena *arena)
{
    *values = (YkRingGraph){.ring = ring};
    bool has_started = yk_graph_start(&values->graph, arena);
    values->graph.pace = yk_ring_pace(ring);
    values->graph.shares_signs = true;
    return has_started;
}

void yk_ring_graph_end(YkRingGraph *values)
{
    yk_graph_end(&values->graph);
    free(values->leaf);
    free(values->defined);
    free(values->definitions);
}

// Symbols may have been added to the ring since.
static bool has_room(YkRingGraph *values)
{
    size_t count = yk_ring_symbol_count(values->ring), from = values->symbol_count;
    if (count <= from) return true;
    YkRef *leaf = realloc(values->leaf, count * sizeof *leaf);
    if (leaf) values->leaf = leaf;
    YkRef *defined = realloc(values->defined, count * sizeof *defined);
    if (defined) values->defined = defined;
    if (!leaf || !defined) {
        values->graph.failed = true;
        return false;
    }
    for (size_t s = from; s < count; s++) leaf[s] = defined[s] = YK_NONE;
    values->symbol_count = count;
    return true;
}

static YkRef new_leaf(YkRingGraph *values, int32_t symbol)
{
    const char *name = yk_ring_name_in(values->ring, symbol, YK_RING_C);
    if (yk_ring_is_constant(values->ring, symbol)) return yk_graph_leaf(&values->graph, YK_LEAF_PARAMETER, name);
    return yk_graph_leaf(&values->graph, YK_LEAF_POSE, yk_graph_text(&values->graph, "m->%s", name));
}

YkRef yk_ring_graph_symbol(YkRingGraph *values, int32_t symbol)
{
    if (symbol < 0 || !has_room(values)) return 0;
    if (values->defined[symbol] != YK_NONE) return values->defined[symbol];
    const YkRingSymbol *of = &values->ring->symbols[symbol];
    if (of->meaning->pi_over > 0) return yk_graph_number(&values->graph, YK_PI / (double)of->meaning->pi_over);
    if (of->meaning->square)
        return yk_graph_function(&values->graph, YK_SQRT, yk_ring_graph_of(values, of->meaning->square), YK_NONE);
    if (values->leaf[symbol] == YK_NONE) values->leaf[symbol] = new_leaf(values, symbol);
    return values->leaf[symbol];
}

void yk_ring_graph_define(YkRingGraph *values, int32_t symbol, YkRef value)
{
    if (!has_room(values) || !YK_ROOM(values->definitions, values->definition_count, values->definition_capacity)) {
        values->graph.failed = true;
        return;
    }
    values->definitions[values->definition_count++] = (struct YkRingDefinition){symbol, values->defined[symbol]};
    values->defined[symbol] = value;
}

void yk_ring_graph_forget(YkRingGraph *values, size_t count)
{
    while (values->definition_count > count) {
        const struct YkRingDefinition *last = &values->definitions[--values->definition_count];
        values->defined[last->symbol] = last->before;
    }
}
