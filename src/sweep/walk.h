// A walk along a path that never leaves the branch unnoticed; sweeps and moves share it.
#ifndef SWEEP_WALK_H
#define SWEEP_WALK_H
#include <yoke/sweep.h>
#include "sweep/path.h"

enum { WALK_DEPTH_MAX = 44 }; // levels of halving

typedef struct YkWalk {
    YkPath path;
    double turn_max, from; // the path is checked every turn_max; where the walk began
    size_t margin_count;
    double *margins;    // [depth][3][block]
    double *flipped_at; // per block: its last change point (NaN: none yet)
    YkEvent *events;
    size_t event_count, event_capacity, more_events; // the first events_max are kept, the others counted
    size_t events_max;
    bool is_witnessed;     // the state's witness knows where it began
    bool has_begun;        // has looked for change points where it began
    double skipped_passes; // change points in whole turns that were left out (turns.c)
    YkStatus status;
    int limit_block;
    YkProblems *problems;
    bool failed; // out of memory
    // Called at every verified place (NULL: never). If it returns false, the walk stops there with YK_STOPPED.
    bool (*arrived)(void *context, double at);
    void *context;
} YkWalk;

// --- walk_begin.c

// Starts a walk along `path`, which the walk owns from here on. Returns false when out of memory; yk_walk_end frees it.
bool yk_walk_start(YkWalk *walk, YkPath path, double turn_max);
void yk_walk_end(YkWalk *walk);
// Returns whether the caller of the long call that the walk works for has stopped it. The status is then YK_STOPPED.
bool yk_walk_is_stopped(YkWalk *walk);
// Records an event.
void yk_walk_note(YkWalk *walk, YkEvent event);
// Ends the walk at `at`, since the machine does not close at `bad`, or no drive gives a position there.
void yk_walk_end_at(YkWalk *walk, double at, double bad);
// Returns the blocks' margins at the three samples of an interval (0 start, 1 middle, 2 end), one set for each level of
// halving.
double *yk_walk_margins(const YkWalk *walk, size_t depth, size_t which);
void yk_walk_read_margins(const YkWalk *walk, double *margins);
// Returns false for the larger groups, which Newton's method solves: they have no margin of their own.
bool yk_walk_has_margin(const YkWalk *walk, size_t block);
// Returns whether the last change point of a block lies within 1e-4 rad, or machine sizes, of the inputs' way from
// `at`.
bool yk_walk_was_flipped_near(const YkWalk *walk, size_t block, double at);

// --- walk.c

// Walks in verified sub-steps from a, where the state is, to b. Returns false if the motion ends on the way: the status
// says why, and a limit is noted as an event.
bool yk_walk_go(YkWalk *walk, double a, double b);
// Returns whether the walk would take unreasonably many steps. The status is then YK_STOPPED, and the state's report
// says why. Call it before a walk; it takes account of the cost of the machine at each step.
bool yk_walk_refuses(YkWalk *walk, double a, double b);
// Flips blocks that are singular at `a`, which the motion has reached and passes: double zeros, passed with the other
// sign.
void yk_walk_flip_at(YkWalk *walk, double a, const double *margins);
// Takes back the flips at a place that proved to be a limit, not a change point. Returns how many there were.
size_t yk_walk_unflip(YkWalk *walk, double a);

// --- touch.c

double yk_walk_touch(double a, double ma, double b, double mb); // a double zero of a margin between a and b, roughly
// Returns a double zero at `at` precisely, searched up to `reach` from there, in radians or sizes. If there is none,
// `at`.
double yk_walk_refine_touch(YkWalk *walk, size_t block, double at, double reach);
// Returns whether a block closes a little beyond a place where its margin is almost zero: at a limit it does not. The
// blocks before it, on which it depends, have the signs that they have there.
bool yk_walk_closes_beyond(YkWalk *walk, size_t block, double at, double way);
// Returns whether b, where the margin is almost zero, lies a little beyond a double zero, and puts that in `at`.
bool yk_walk_has_just_passed(YkWalk *walk, size_t block, double b, double way, double *at);
// Returns whether the drives turn back near `at`, exactly where a block comes to its limit, and puts the time in `at`.
// The square root of the margin is a straight line through zero there, too: the motion goes on with the other sign, as
// a crank passes the dead point of a piston that is driven through its whole stroke.
bool yk_walk_turns_at_limit(YkWalk *walk, size_t block, double *at);
// Returns whether they do so for one of the blocks that touch.
bool yk_walk_turns_at_a_limit(YkWalk *walk, const double *margins, double at);

// --- meeting.c

// Returns the side of a block's known change point, if it lies at `at`, for which the signs hold; 0: it does
// not.
double yk_walk_side_held(const YkWalk *walk, size_t block, double at);

// --- limits.c: poses beside a change point where the walk stands

typedef struct YkBeside {
    YkWalk *walk;
    double at, side;       // the signs hold on that side of the path (+1: ahead)
    const double *margins; // at the change point: which blocks touch
    double step;           // the nearest pose, in units of the path
    int32_t moving;        // over time: the only input that moves, and its way on that side; YK_NONE: along the path
    double way;
    bool is_back;      // over time: both sides of the path lie on the same side of the change point
    bool wants_nearer; // a last visit at a pose nearer than the others, with weight 0
} YkBeside;
typedef void (*YkVisitBeside)(void *context, double weight);
// Finds a step at which the limits of the rates do not depend on it any more, and the limits themselves, as the data of
// the state's space (NULL: not needed). Returns false if there is none, or out of memory (walk->failed).
bool yk_beside_begin(YkBeside *beside, double *limits);
// Solves the poses and visits each with its weight in the limit at the change point, where the state then stands again.
// Returns false if one of them does not close.
bool yk_beside_visit(const YkBeside *beside, YkVisitBeside visit, void *context);
// Gives the state at the singular end of a walk the limits of its rates. Returns CHANGE_POINT; SINGULAR if they have
// none, or depend on more than the way there.
YkStatus yk_walk_take_limits(YkWalk *walk, double at, double way);
// Takes the rates from numbers like the data of the state's space; the positions stay.
void yk_state_take_rates(YkState *state, const double *numbers);
// Returns whether the rates at the end of the path are along it: elsewhere the limits depend on the way there.
bool yk_path_moves_along(const YkPath *path);
int yk_walk_touching_block(const YkWalk *walk, const double *margins); // the first one, or -1

// --- blur.c

// Gives the state, which has come to `at` with that status, rates without rounding where a change point is
// close. Returns the status that it has then; NO_MEMORY if memory ran out.
YkStatus yk_walk_clear_rates(YkWalk *walk, double at, double way, YkStatus status);

// --- heading.c

// Returns whether the signs of a block are already those beyond the change point at which the walk has
// stopped.
bool yk_walk_has_passed(const YkWalk *walk);
// Notes that the walk has ended at the state's pose, going in this direction of its path.
void yk_walk_arrive(const YkWalk *walk, double way);

#endif
