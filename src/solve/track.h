// Following a pose along a straight path of the inputs, for machines with groups that Newton's method solves.
#ifndef SOLVE_TRACK_H
#define SOLVE_TRACK_H
#include "solve/assemble.h"

// From the valid pose's inputs to state->input in small steps: predicted by velocity and acceleration, corrected by
// Newton's method, each step checked: the same sign of every determinant, a correction small against the step. YK_LIMIT
// where no step, however small, succeeds.
YkStatus yk_state_track(YkState *state);

#endif
