// Sets that grow together: each thing names a parent in its set, and the one that is its own parent, the root, stands
// for all. Source: Tarjan 1975, with halving of the way.
#ifndef BASE_SETS_H
#define BASE_SETS_H
#include <stddef.h>
#include <stdint.h>

// Puts each of n things into a set of its own.
static inline void yk_sets_begin(int32_t *parent, size_t n)
{
    for (size_t k = 0; k < n; k++) parent[k] = (int32_t)k;
}

// Returns the root of the set of k, and shortens the way to it.
static inline int32_t yk_root_of(int32_t *parent, int32_t k)
{
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
}

// Joins the sets of a and b; the lower root stands for both.
static inline void yk_sets_join(int32_t *parent, int32_t a, int32_t b)
{
    a = yk_root_of(parent, a);
    b = yk_root_of(parent, b);
    if (a < b) parent[b] = a;
    if (b < a) parent[a] = b;
}

#endif
