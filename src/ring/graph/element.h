// Elements as values of a graph: in a form to compute rather than to read.
//
// A graph computes the sine and cosine of an angle once, derives those of sums of angles by products, and separates
// what depends on constants alone. Constants are leaves with their names in C; all other symbols are m->NAME.
#ifndef RING_GRAPH_ELEMENT_H
#define RING_GRAPH_ELEMENT_H
#include "graph/graph.h"
#include "ring/ring.h"

typedef struct YkRingGraph {
    YkGraph graph;
    YkRing *ring;
    YkRef *leaf, *defined; // per symbol: its leaf, the value that defines it; or YK_NONE
    size_t symbol_count;
    struct YkRingDefinition {
        int32_t symbol;
        YkRef before;
    } * definitions;
    size_t definition_count, definition_capacity;
} YkRingGraph;

bool yk_ring_graph_start(YkRingGraph *values, YkRing *ring, YkArena *arena); // false when out of memory; end it as well
void yk_ring_graph_end(YkRingGraph *values);

// Failure shows in values->graph.failed: no memory, or an element that is not real (see the ring's status).
YkRef yk_ring_graph_symbol(YkRingGraph *values, int32_t symbol); // or the value that defines it
// Adds a real element: sums of (constants * sine or cosine), grouped by their products of coordinates and rates. Cost
// O(terms log terms).
YkRef yk_ring_graph_of(YkRingGraph *values, const YkPoisson *a);
// Lets a symbol stand for a value from now on (a body's angle for a sum of joint angles; what an earlier line has
// solved).
void yk_ring_graph_define(YkRingGraph *values, int32_t symbol, YkRef value);
// Takes back all definitions but the first `count`.
void yk_ring_graph_forget(YkRingGraph *values, size_t count);

#endif
