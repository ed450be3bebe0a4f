// Change points that a walk knows by the place of the input that leads to them.
#ifndef SWEEP_MEETING_H
#define SWEEP_MEETING_H
#include "sweep/walk.h"

// --- meeting_find.c

// Looks for change points near the start of a walk, where the state stands, which goes on in that direction of its
// path.
void yk_walk_begin_at(YkWalk *walk, double at, double way);
// Looks for a change point of a block near `at`. If it finds it, the block's sign follows from the side of it from here
// on; it has its present sign at the place `known`, to which the motion has come in the direction `way`. Returns
// whether it did; the state must be solved again.
bool yk_walk_meets(YkWalk *walk, size_t block, double at, double known, double way);

// --- meeting.c

// Returns whether all of [a, b] is so close to the block's known change point that its sign follows from the side
// alone.
bool yk_walk_is_at_meeting(const YkWalk *walk, size_t block, double a, double b);
// Returns whether a block's known change point is the one that poses about `at` belong to.
bool yk_walk_knows_meeting(const YkWalk *walk, size_t block, double at);
// Notes the known change points that the path passes between a and b, where the state stands.
void yk_walk_note_crossings(YkWalk *walk, double a, double b);
// Returns whether the path does not turn back at a known change point, exactly at `at`. If it goes over it there, this
// is noted. is_start: the walk begins there.
bool yk_walk_passes_meeting(YkWalk *walk, size_t block, double at, double way, bool is_start);

// --- side.c: where the inputs are

// Returns how far the inputs on the path at `at` are from a block's known change point, in units; NaN if that cannot
// be found: far away, if several inputs decide together.
double yk_meeting_off_at(const YkPath *path, size_t block, double at);
// Returns the distance up to which a place counts as the change point itself.
double yk_meeting_tolerance(const YkMeeting *meeting, const YkState *state);
// Returns the side of the change point, +1 or -1, for a distance from it; 0: just there, or unknown.
int yk_meeting_side(const YkMeeting *meeting, const YkState *state, double off);
// Returns the side on which the path is just before `at` (way -1) or just behind it (+1); 0: it rests there for ever.
int yk_meeting_side_beside(const YkPath *path, size_t block, double at, double way);

#endif
