// Follows a pose along a straight path of the inputs, for machines with groups that Newton's method solves.
#ifndef SOLVE_TRACK_H
#define SOLVE_TRACK_H
#include "solve/assemble.h"

// Goes from the valid pose's inputs to state->input in small steps, predicted by velocity and acceleration and
// corrected by Newton's method. Checks each step: the same sign of every determinant, a correction small against the
// step. Returns YK_LIMIT if no step, however small, succeeds.
YkStatus yk_state_track(YkState *state);
// Goes the same path for machines of closed forms whose gears or cams start from angles that loops place: follows only
// those angles, turn by turn. Leaves state->input unchanged; does nothing on a short path.
void yk_state_walk(YkState *state);
// Restores the angles, after a path to a pose that does not close.
void yk_state_walk_back(YkState *state);

// Sets the inputs at `at` of a path, with the path itself as their rates: `ends` has the start and the way of each
// input.
void yk_set_path(YkState *state, const double *ends, double at);
// Runs everything at the present inputs, from the guess in groups.x, into `spare`.
YkStatus yk_state_run_here(YkState *state);

// Solves at the present inputs, the groups from their last solution; returns YK_LIMIT if they would move farther than
// `most` (rad, or lengths over the size). For a machine whose dimensions have changed slightly.
YkStatus yk_state_settle(YkState *state, double most);

#endif
