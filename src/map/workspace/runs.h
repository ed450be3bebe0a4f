// Runs: neighbouring cells of a row that have the same number of configurations. Runs of one number that touch along
// sides of cells are a region.
#ifndef MAP_RUNS_H
#define MAP_RUNS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "map/workspace/field.h"

typedef struct YkCellRun {
    uint32_t from; // the first column; it ends where the next one begins, or at the end of the row
    uint32_t part; // 1 + the region; 0: no configurations
} YkCellRun;

typedef struct YkRuns {
    size_t n;         // rows, and columns
    YkCellRun *items; // row by row
    size_t *first;    // [n + 1]: of each row
    size_t count, capacity, part_count;
} YkRuns;

// Finds the runs of a field, and which of them are one region: numbered by their first cells. Returns false when out
// of memory.
bool yk_runs_find(YkRuns *runs, const YkField *field);
void yk_runs_end(YkRuns *runs);
// Returns 1 + the region of a cell; 0: none.
uint32_t yk_runs_part(const YkRuns *runs, size_t x, size_t y);

#endif
