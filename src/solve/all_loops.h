// Poses at which only the kept equations of a machine with redundant constraints are singular.
#ifndef SOLVE_ALL_LOOPS_H
#define SOLVE_ALL_LOOPS_H
#include "solve/state.h"

// Makes the room for them; none is needed where no machine's equations repeat each other. Returns false if memory ran
// out.
bool yk_all_loops_start(YkState *state);
// Settles a pose of `space` that is singular by its blocks, or nearly, where all loops together determine it: closes
// them by least squares, and takes velocities and accelerations from all of them. Then `is_regular` is set and the
// status is REDUNDANT; otherwise it stays. Cost O(n^3) of all orientations and distances, at such a pose alone.
YkStatus yk_state_by_all_loops(YkState *state, YkSpace *space, YkStatus status);

// Writes all orientations and distances, as yk_closure has them, where the inputs have moved on from those of `space`
// by `h` times their rates, in a straight line. `h` is short: the way differs from a straight one by less than 1e-4 rad
// or sizes. Returns NULL if that is not so, or the loops do not determine the motion. Changes the rates of `space`.
const double *yk_all_loops_ahead(YkState *state, YkSpace *space, double h);

#endif
