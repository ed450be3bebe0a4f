// Assembling: a depth-first search over the branches of all blocks.
#ifndef SOLVE_ASSEMBLE_H
#define SOLVE_ASSEMBLE_H
#include "solve/state.h"

// Room for the options of a level: their unknowns if it is a group ([option][column]), their costs, and those that
// close, nearest first.
typedef struct YkOptionRoom {
    double *solutions, *cost;
    uint16_t *order;
} YkOptionRoom;

typedef struct YkLevel { // a block with branches, in the order of solution
    int32_t block;
    size_t from, to;                             // steps from its own to the next level's
    uint32_t first_coordinate, coordinate_count; // coordinates that become known in these steps
    uint32_t options, tried;
    double before;    // cost of all previous levels
    YkOptionRoom own; // for what a search finds
    YkOptionRoom room;
} YkLevel;

// Lists all solutions of a group in place of the search: block `index` at the pose of `run`, in which earlier blocks
// are solved. Returns their number, with room for them that lasts until the next call for this block. list NULL:
// searches.
typedef struct YkLister {
    size_t (*list)(void *context, const YkRun *run, size_t index, YkOptionRoom *room);
    void *context;
    size_t lost;    // solutions listed that do not close in the steps that solve a group
    size_t settled; // how often a dyad was met that any angle closes, and stands as it was guessed
} YkLister;

typedef struct YkSearch {
    YkLevel *levels;
    size_t level_count;
    int gave_up_at;    // the block at which the last search gave up: a cap was reached, or a group found nothing; or -1
    size_t first_step; // of level 0: the steps before it involve no choice
    int32_t *coordinates; // sorted by the level after which they are known
    signed char *best_branch, *kept_branch;
    double *best_x, *kept_x, *kept_reference, *path, *wanted;
    double *variables; // scratch: the unknowns of the closure from the guesses
    YkLister *lister;  // or NULL
    YkSpace kept;
} YkSearch;

// Makes the room for a search in an arena, except its space, which yk_search_end frees. Returns NULL if memory ran out.
YkSearch *yk_search_new(const YkMechanism *mech, YkArena *arena);
void yk_search_end(YkSearch *search);
// As yk_state_each, with the groups' solutions from a lister (or NULL). *whole: all combinations were visited.
YkStatus yk_search_each(YkState *state, YkLister *lister, bool (*visit)(void *, YkState *), void *context, bool *whole);

#endif
