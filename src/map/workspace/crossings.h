// Crossings: where the number of configurations changes between the centres of two neighbouring cells. There are few:
// they are kept in a table, not with the cells.
#ifndef MAP_CROSSINGS_H
#define MAP_CROSSINGS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct YkCrossing {
    uint32_t key;  // twice the first cell's index, plus 1 if the second is above it and not to its right; plus 1
    float part;    // of the way from the first centre to the second
    int16_t piece; // the one whose configurations meet there
} YkCrossing;

typedef struct YkCrossings {
    YkCrossing *items; // [capacity], a power of two; key 0: free
    size_t count, capacity;
} YkCrossings;

static inline uint32_t yk_crossing_key(size_t cell, int axis)
{
    return (uint32_t)(2 * cell + (size_t)axis + 1);
}
static inline size_t yk_crossing_cell(const YkCrossing *c)
{
    return (c->key - 1) / 2;
}

// Returns the crossing with this key, or NULL.
const YkCrossing *yk_crossings_find(const YkCrossings *crossings, uint32_t key);
// Adds one whose key is not yet there. Returns false when out of memory.
bool yk_crossings_add(YkCrossings *crossings, YkCrossing crossing);
void yk_crossings_end(YkCrossings *crossings);

#endif
