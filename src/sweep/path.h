// A path of the inputs: one coordinate, time, or a straight line in all of them at once; and probing poses on it.
#ifndef SWEEP_PATH_H
#define SWEEP_PATH_H
#include <yoke/sweep.h>
#include "solve/state.h"

typedef struct YkPath {
    YkState *state;
    int input;           // -1: time, or a line
    bool is_line;        // from `others` (at 0) to `goal` (at 1)
    double last, way;    // where the last pose that closed stands; +1 or -1: the way to it
    double passed, side; // the last change point, and on which side of it the signs hold (0: none yet)
    double *others;      // the inputs as they were: [3 * input + k]
    const double *goal;  // [3 * input + k], the caller's
} YkPath;

// A path of one coordinate, or of time (-1), from where the state stands. False when out of memory.
bool yk_path_start(YkPath *path, YkState *state, int coordinate);
// A straight line from the inputs of the state's pose to `goal`, which must outlive the path.
bool yk_path_start_line(YkPath *path, YkState *state, const double *goal);
void yk_path_end(YkPath *path);
// Sets the inputs at `at`: with the motion's own rates, or (along) with rates per unit of the path. YK_BAD_MODEL where
// a drive has no value at that time.
YkStatus yk_path_set(YkPath *path, double at, bool along);
// The same, and solves: to look, and (probe) to go on from there, with the pose's angles as the reference of the next.
YkStatus yk_path_try(YkPath *path, double at, bool along);
// The reference stays where the pose is all but singular: it may still be the other branch's, which need not be near.
void yk_path_refer(YkPath *path);
void yk_path_refer_state(YkState *state);
YkStatus yk_path_probe(YkPath *path, double at, bool along);
// How far the inputs go between two places: rad, or sizes of the machine; over time an estimate from samples.
double yk_path_length(YkPath *path, double from, double to);
// Between a pose that closes and one that does not: the last value that closes, to rounding. The state ends there.
double yk_path_limit(YkPath *path, double good, double bad);
// One unit of path for tolerances: a radian, or the machine's size; of time and of a line, what the fastest input takes
// for it now (of time at most 1 s).
double yk_path_scale(const YkPath *path);

#endif
