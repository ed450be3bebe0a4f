// A walk along a path that never leaves the branch unseen: what sweeps and moves share.
#ifndef SWEEP_WALK_H
#define SWEEP_WALK_H
#include <yoke/sweep.h>
#include "sweep/path.h"

enum { WALK_DEPTH_MAX = 44 }; // levels of halving

typedef struct YkWalk {
    YkPath path;
    double turn_max, from; // the path is looked at every turn_max; where the walk began
    size_t margin_count;
    double *margins;    // [depth][3][block]
    double *flipped_at; // per block: its last change point (NaN: none yet)
    YkEvent *events;
    size_t event_count, event_capacity, more_events; // the first 10,000 are kept, the others counted
    YkStatus status;
    int limit_block;
    YkProblems *problems;
    bool failed; // out of memory
    // Called at every verified place (NULL: never); false stops the walk there, with YK_STOPPED.
    bool (*arrived)(void *context, double at);
    void *context;
} YkWalk;

// Room for a walk along `path`, which the walk owns from here on. False when out of memory; yk_walk_end frees.
bool yk_walk_start(YkWalk *walk, YkPath path, double turn_max);
void yk_walk_end(YkWalk *walk);
// In verified sub-steps from a, where the state stands, to b. False where the motion ends on the way: the status says
// why, and a limit is noted as an event.
bool yk_walk_go(YkWalk *walk, double a, double b);
// Would it take more steps than anybody waits for? Then the status is YK_STOPPED, and the state's report says why. Asked
// before a walk; counts what the machine costs at each step.
bool yk_walk_refuses(YkWalk *walk, double a, double b);
// Keeps an event.
void yk_walk_note(YkWalk *walk, YkEvent event);
// The walk ends at `at`, since the machine does not close at `bad` - or no drive says where it is to be then.
void yk_walk_end_at(YkWalk *walk, double at, double bad);

// The blocks' margins at the three samples of an interval (0 start, 1 middle, 2 end), one set a level of halving.
double *yk_walk_margins(const YkWalk *walk, size_t depth, size_t which);
void yk_walk_read_margins(const YkWalk *walk, double *margins);
// False for the larger groups, which Newton's method solves: they have none of their own.
bool yk_walk_has_margin(const YkWalk *walk, size_t block);
// Blocks that are singular at `a`, where the motion has come to and goes on: double zeros, passed with the other sign.
void yk_walk_flip_at(YkWalk *walk, double a, const double *margins);
double yk_walk_touch(double a, double ma, double b, double mb); // a double zero of a margin between a and b, roughly
// A double zero at `at`, precisely: as far as `reach` from there, in radians or sizes. Where there is none, `at`.
double yk_walk_refine_touch(YkWalk *walk, size_t block, double at, double reach);
// Does b, where the margin is all but zero, lie a little beyond a double zero? Then that is `at`.
bool yk_walk_has_just_passed(YkWalk *walk, size_t block, double b, double way, double *at);
bool yk_walk_was_flipped_near(const YkWalk *walk, size_t block, double at);

#endif
