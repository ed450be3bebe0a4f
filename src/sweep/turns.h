// Motions that repeat themselves turn by turn: one turn is followed, the others are counted.
#ifndef SWEEP_TURNS_H
#define SWEEP_TURNS_H
#include "sweep/walk.h"

// Returns the part of a line in which its inputs make whole turns together; 0 if there is none, or only a few such
// parts.
double yk_turns_period(const YkPath *path);
// Walks from 0 until the machine returns to a pose that it had some whole periods before, and skips as many such
// stretches as the line contains. Returns the place on the line that it has reached, or a negative number if the walk
// ended on the way (walk->status) or memory was short (walk->failed).
double yk_turns_skip(YkWalk *walk, double period);

#endif
