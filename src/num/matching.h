// Maximum bipartite matching of equations (rows) with unknowns (columns), grown one row at a time. Source: augmenting
// paths with cheap assignment, Duff 1981 (MC21).
#ifndef NUM_MATCHING_H
#define NUM_MATCHING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"

typedef struct YkMatching {
    size_t columns, row_capacity, entry_capacity;
    size_t rows;     // rows added so far
    uint32_t *first; // row r has the columns entries[first[r]] .. entries[first[r + 1] - 1]
    int32_t *entries;
    int32_t *row_of;    // column -> row, -1 free
    int32_t *column_of; // row -> column, -1 unmatched
    uint32_t *seen;     // per row: stamp of the last search that visited it
    uint32_t *next;     // per row: next entry to try in this search
    int32_t *stack;
    uint32_t stamp;
} YkMatching;

// Makes room for this number of columns, rows and entries (arena memory). Returns false when out of memory.
bool yk_matching_start(YkMatching *matching, YkArena *arena, size_t columns, size_t rows, size_t entries);
// Adds a row and matches it if an augmenting path exists. Returns whether it was matched; an unmatched row is kept if
// `keep`, otherwise dropped. One search costs O(rows + entries), typically O(1).
bool yk_matching_add(YkMatching *matching, const int32_t *columns, size_t count, bool keep);

#endif
