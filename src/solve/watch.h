// Watches poses that follow each other on one path: could a block's branches have met between them? Its margins decide,
// three at a time, as long as no body turns far from one pose to the next.
#ifndef SOLVE_WATCH_H
#define SOLVE_WATCH_H
#include "solve/state.h"

typedef struct YkBranchWatch {
    const YkMechanism *mech;
    double *before; // [block][2]: at the last two poses
    YkVec *unit;    // [block][2]: directions of the bodies that it turns, at the last pose
    size_t seen;    // poses on the path so far
} YkBranchWatch;

bool yk_watch_start(YkBranchWatch *watch, const YkMechanism *mech);
void yk_watch_end(YkBranchWatch *watch);
// Checks the next n lanes of a space that keeps margins. Returns how many of them, from the first, are certainly on the
// branches of the path: n if none came near a limit or a change point.
size_t yk_watch_lanes(YkBranchWatch *watch, const YkSpace *space, size_t n);

#endif
