// Where constraints repeat each other: past a pose at which only the kept equations are singular.
#ifndef SOLVE_PASSING_H
#define SOLVE_PASSING_H
#include "solve/state.h"

// Puts `spare` a little beyond the pose, whose inputs are those at `at` of a path: `ends` has the start and the way of
// each. The loops together lead there, and blocks take the branches that they have beyond. Returns by how much of the
// path it has moved, `left` at most; 0 if all loops together do not lead past it either. Cost O(n^3) of all
// orientations and distances, at such a pose alone.
double yk_state_pass(YkState *state, const double *ends, double at, double left);

// Solves at the present inputs, from the guess in groups.x, into `spare`: also where only the kept equations are
// singular.
YkStatus yk_state_stand_here(YkState *state);

#endif
