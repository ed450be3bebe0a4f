// A motion that repeats itself turn by turn: one turn is followed, the others are counted.
#ifndef SWEEP_TURNS_H
#define SWEEP_TURNS_H
#include "sweep/walk.h"

// The part of a line in which its inputs make whole turns together; 0 where there is none, or no more than a few.
double yk_turns_period(const YkPath *path);
// Walks from 0 until the machine comes back to a pose that it had some whole periods before, and skips as many such
// stretches as the line has. Returns where on the line the state stands then, or a negative number where the walk ended
// on the way (walk->status) or memory was short (walk->failed).
double yk_turns_skip(YkWalk *walk, double period);

#endif
