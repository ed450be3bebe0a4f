// Coincidences: poses in which a dyad's base, or an arm that varies, has no length. Any angle closes the dyad there.
#ifndef SOLVE_COINCIDENCE_H
#define SOLVE_COINCIDENCE_H
#include "solve/state.h"

// Returns whether a block's margin may be that of a coincidence; only settling can confirm it.
static inline bool yk_may_coincide(double margin)
{
    return margin <= -0.1 || fabs(margin) < 1e-23;
}

// Runs steps [from, to) of the space again, with the state's branches and inputs. Angles that no loop determines at a
// coincidence are taken from `kept`, the angle of each slot. Their rates are 0 and the block's margin is 0, so that the
// pose is singular. Returns whether there was such a block.
bool yk_run_settled(const YkRun *run, size_t from, size_t to, const YkTurn *kept);

#endif
