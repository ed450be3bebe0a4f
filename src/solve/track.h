// Following a pose along a straight path of the inputs, for machines with groups that Newton's method solves.
#ifndef SOLVE_TRACK_H
#define SOLVE_TRACK_H
#include "solve/assemble.h"

// From the valid pose's inputs to state->input in small steps: predicted by velocity and acceleration, corrected by
// Newton's method, each step checked: the same sign of every determinant, a correction small against the step. YK_LIMIT
// where no step, however small, succeeds.
YkStatus yk_state_track(YkState *state);
// The same way for machines of closed forms whose gears or cams start from angles that loops place: only those angles
// are followed, turn by turn. Leaves state->input; does nothing where the way is short.
void yk_state_walk(YkState *state);
// Takes the angles back to where they were before, as after a way to a pose that does not close.
void yk_state_walk_back(YkState *state);

// Solves at the inputs as they stand, the groups from their last solution; YK_LIMIT where they would move farther than
// `most` (rad, or lengths over the size). For a machine whose dimensions have changed a little.
YkStatus yk_state_settle(YkState *state, double most);

#endif
