// Dry friction of joints at rest: it may be any in an interval, and so may the effort of a drive that holds the
// machine. Inverse dynamics has no single answer there.
#ifndef DYNAMICS_HOLDING_H
#define DYNAMICS_HOLDING_H
#include "dynamics/dynamics.h"

typedef struct YkHolding YkHolding;

// For a mechanism whose loads include dry friction. Returns NULL when out of memory.
YkHolding *yk_holding_new(const YkDynamics *dynamics);
void yk_holding_free(YkHolding *holding);
void yk_holding_clear(YkHolding *holding);
// Returns whether a joint with dry friction is at rest at the state's pose, whose rates are known. Forgets earlier
// results.
bool yk_holding_is_needed(YkHolding *holding, const YkDynamics *dynamics, const YkState *state);
// Finds which of the joints at rest stick and which begin to slip if their accelerations are free, and the efforts that
// hold the prescribed inputs. Leaves a solution with frictions that have settled: those of joints held by drives alone
// are 0. Cost: a solution for every joint with dry friction, and some linear programs for each input.
YkStatus yk_holding_find(YkHolding *holding, YkDynamics *dynamics, YkState *state, YkMethod method);
YkEffortRange yk_holding_range(const YkHolding *holding, size_t input); // is_single if nothing was found
// Returns whether frictions at rest, and what depends on them, have more than one answer.
bool yk_holding_is_open(const YkHolding *holding);

#endif
