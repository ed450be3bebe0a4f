// Assembling: a depth-first search over the branches of all blocks.
#ifndef SOLVE_ASSEMBLE_H
#define SOLVE_ASSEMBLE_H
#include "solve/state.h"

typedef struct YkLevel { // a block with branches, in the order of solution
    int32_t block;
    size_t from, to;                             // steps from its own to the next level's
    uint32_t first_coordinate, coordinate_count; // coordinates that become known in these steps
    uint32_t options, tried;
    double before;        // cost of all previous levels
    double *cost;         // of each option
    unsigned char *order; // options that close, nearest first
    double *solutions;    // groups: [option][column]
} YkLevel;

typedef struct YkSearch {
    YkLevel *levels;
    size_t level_count;
    int gave_up_at;    // the block at which the last search gave up: a cap was reached, or a group found nothing; or -1
    size_t first_step; // of level 0: the steps before it involve no choice
    int32_t *coordinates; // sorted by the level after which they are known
    signed char *best_branch;
    double *best_x, *kept_x, *kept_reference, *path, *wanted;
    double *variables;         // scratch: the unknowns of the closure from the guesses
    double *solutions, *costs; // those of the levels, in one block each
    unsigned char *orders;
    YkSpace kept;
} YkSearch;

YkSearch *yk_search_new(const YkMechanism *mech);
void yk_search_free(YkSearch *search);

#endif
