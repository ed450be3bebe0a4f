// Finds the strongly connected components of a directed graph, in reverse topological order. Source: Tarjan 1972,
// without recursion.
#ifndef NUM_COMPONENTS_H
#define NUM_COMPONENTS_H
#include <stddef.h>
#include <stdint.h>

// Numbers the components of a graph of n nodes: node v has edges to target[first[v]] .. target[first[v + 1] - 1].
// component[v] gets its number; an edge from v to w means component[w] <= component[v], so that what v needs comes
// first. work: 5 n int32. Returns the number of components. Cost O(nodes + edges).
size_t yk_components(size_t n, const uint32_t *first, const int32_t *target, int32_t *component, int32_t *work);

#endif
