// Paths of the inputs: one coordinate, time, or a straight line in all of them at once; and trial poses on a path.
#ifndef SWEEP_PATH_H
#define SWEEP_PATH_H
#include <yoke/sweep.h>
#include "solve/state.h"

// sin^2 below which, less than 1e-5 from a change point, a pose may still be the other branch's: it is not a reference,
// and its rates do not show which way a channel goes.
#define YK_BRANCH_MARGIN 1e-10

enum { YK_MEETING_SEEN = 4, YK_MEETING_LEVELS = 4 };

// A change point of a block, known by the place of the input that leads to it: the block has one sign on each side of
// it.
typedef struct YkMeeting {
    bool is_known, is_off; // off: the signs are set otherwise for the time being
    bool is_shared;        // several inputs lead there together: where this one would be there depends on the others
    int32_t input;         // over time: the only one that leads there; YK_NONE: the place on the path does
    double unit, at, near; // one of its units; its value there; how far from it, in units, nothing else can be
    double slope;          // shared: of the sine of the transmission angle, per unit
    size_t step_count;     // shared: up to the block's own step
    double seen_at[YK_MEETING_SEEN], seen_off[YK_MEETING_SEEN]; // shared: where the path was looked at last
    unsigned seen;
    double off[YK_MEETING_LEVELS]; // scratch of side.c: how far from it the inputs are
    signed char above, side;       // the sign above it; the side on which the motion was last
} YkMeeting;

typedef struct YkPath {
    YkState *state;
    int input;           // -1: time, or a line
    bool is_line;        // from `others` (at 0) to `goal` (at 1)
    double last, way;    // place of the last pose that closed; +1 or -1: the direction of motion to it; 0: unknown
    double passed, side; // the last change point, and the side of it on which the signs hold (0: none yet)
    double *others;      // the inputs at the start: [3 * input + k]; behind them near.c has its scratch
    const double *goal;  // [3 * input + k], owned by the caller
    YkMeeting *meetings; // [block], owned by a walk; none without one
    signed char *signs;  // [block], the same: scratch
    size_t meeting_count;
} YkPath;

static inline bool yk_path_is_time(const YkPath *path)
{
    return path->input < 0 && !path->is_line;
}

// Starts a path of one coordinate, or of time (-1), from the state's position. Returns false when out of memory.
bool yk_path_start(YkPath *path, YkState *state, int coordinate);
// Starts a straight line from the inputs of the state's pose to `goal`, which must outlive the path.
bool yk_path_start_line(YkPath *path, YkState *state, const double *goal);
void yk_path_end(YkPath *path);
// Sets the inputs, and the signs that blocks are known to have there, at `at`: with the motion's own rates, or (along)
// with rates per unit of the path. Returns YK_BAD_MODEL if a drive has no value at that time.
YkStatus yk_path_set(YkPath *path, double at, bool along);
// Does the same and solves: to look, or (probe) to continue from there, with the pose's angles as the next reference.
YkStatus yk_path_try(YkPath *path, double at, bool along);
// Takes the pose as reference unless it is nearly singular.
void yk_path_refer(YkPath *path);
void yk_path_refer_state(YkState *state);
YkStatus yk_path_probe(YkPath *path, double at, bool along);
// Solves the last pose again with the motion's own rates. Where it does not close again, only the inputs have rates.
void yk_path_settle(YkPath *path);
// Returns how far the inputs go between two places: rad, or machine sizes; over time an estimate from samples.
double yk_path_length(YkPath *path, double from, double to);
// Finds the last value that closes, to rounding, between a pose that closes and one that does not. The state ends
// there.
double yk_path_limit(YkPath *path, double good, double bad);

// --- path_inputs.c

// Sets the inputs alone, as yk_path_set does.
YkStatus yk_path_set_inputs(const YkPath *path, double at, bool along);
// Returns the rate of the state's fastest input: rad/s, or machine sizes per second.
double yk_path_fastest(const YkState *state);
// Returns one unit of path for tolerances: a radian, or the machine's size; for time and for a line, the amount in
// which the fastest input now covers it (for time at most 1 s).
double yk_path_scale(const YkPath *path);

// --- near.c: distances by how far the inputs go, rad or machine sizes

// Returns the farthest that an input gets from where it is at `a`, on the way to `b`; infinite if a drive has no
// value.
double yk_path_way(const YkPath *path, double a, double b);
// Returns the place about `distance` from `at`, before it (way -1) or behind it (+1); NaN if the inputs never get that
// far.
double yk_path_off(const YkPath *path, double at, double way, double distance);
// Returns the place between a and b at which this part of the inputs' way is done.
double yk_path_between(const YkPath *path, double a, double b, double part);
// Returns how far an input goes from `at` over the next 1e-5 of the path in that direction; 0 if nothing moves there.
double yk_path_heads(const YkPath *path, size_t input, double at, double way);
// Returns the value of an input at a time; NaN if its drive has none.
double yk_path_input_at(const YkPath *path, size_t input, double time);
// Returns how an input moves along the path, on that side of its last place; only its share in the sum of all counts.
double yk_path_rate(const YkPath *path, size_t input, double side);
// Returns the direction on the path, +1 or -1, in which an earlier motion has come to where the path starts;
// 0: across it, or none has.
double yk_path_heading(const YkPath *path);
// Returns whether the inputs, which have come to `at`, turn back there or rest for good.
bool yk_path_turns_back(const YkPath *path, double at);

// --- side.c

// Gives blocks near known change points the signs that they have for the inputs as they are set, at `at`.
void yk_path_place_signs(const YkPath *path, double at);
// Returns how far the inputs on the path at `at` go over a block's shared change point, in its units, while one of them
// goes by one of its own.
double yk_meeting_rise(const YkPath *path, size_t block, double at, size_t input);

#endif
