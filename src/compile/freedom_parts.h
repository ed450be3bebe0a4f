// The parts of a machine that move independently: their freedom is found one by one.
#ifndef COMPILE_FREEDOM_PARTS_H
#define COMPILE_FREEDOM_PARTS_H
#include "compile/mechanism.h"

// The parts of a machine, which share only the ground: their variables, loops and candidates, sorted by part.
typedef struct YkFreedomParts {
    int32_t *of_variable, *column; // per variable: its part, and its column there
    size_t count;
    uint32_t *variable_first, *loop_first, *relation_first, *candidate_first; // per part
    int32_t *variables, *loops, *relations, *candidates;
} YkFreedomParts;

// Finds the parts, in the arena. Returns false when out of memory.
bool yk_freedom_parts_sort(YkFreedomParts *parts, const YkMechanism *mech, const int32_t *candidates, size_t count,
                           YkArena *arena);
// Returns a variable that the coordinate measures, or YK_NONE if its angle is constant.
int32_t yk_coordinate_variable(const YkMechanism *mech, int32_t coordinate);

#endif
