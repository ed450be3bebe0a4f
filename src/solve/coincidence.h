// Coincidences: poses in which a dyad's base, or an arm that varies, has no length left. Any angle closes it there.
#ifndef SOLVE_COINCIDENCE_H
#define SOLVE_COINCIDENCE_H
#include "solve/state.h"

// Whether a block's margin may be that of a coincidence: it is one only if settling finds it.
static inline bool yk_may_coincide(double margin)
{
    return margin <= -0.1 || fabs(margin) < 1e-23;
}

// Runs steps [from, to) of the space anew, as the state's branches and inputs are, but turns what no loop holds at a
// coincidence as `kept` says: the angle of each slot. Its rates are 0 and its block's margin is 0, so that the pose is
// singular. Returns whether there was such a block among them.
bool yk_run_settled(const YkRun *run, size_t from, size_t to, const YkTurn *kept);

#endif
