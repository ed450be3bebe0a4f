// Watching the margins of poses that follow each other on one way: could a block's branches have met between them?
#ifndef SOLVE_WATCH_H
#define SOLVE_WATCH_H
#include "solve/state.h"

typedef struct YkWatch {
    const YkMechanism *mech;
    double *before; // [block][2]: of the last two poses
    size_t seen;    // poses on the way so far
} YkWatch;

bool yk_watch_start(YkWatch *watch, const YkMechanism *mech);
void yk_watch_end(YkWatch *watch);
// Looks at the next n lanes of a space that keeps margins. Returns how many of them, from the first, stand on the
// branches of the way for sure: n where nothing came near a limit or a change point.
size_t yk_watch_lanes(YkWatch *watch, const YkSpace *space, size_t n);

#endif
