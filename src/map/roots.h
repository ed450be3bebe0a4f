// Sets that grow together: each thing names a parent in its set, and the one that is its own parent stands for all.
#ifndef MAP_ROOTS_H
#define MAP_ROOTS_H
#include <stddef.h>

// Returns the one that stands for the set of k, and shortens the way to it.
static inline size_t yk_root_of(size_t *parent, size_t k)
{
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
}

#endif
