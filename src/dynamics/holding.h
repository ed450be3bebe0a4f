// Dry friction of joints that stand: what it may exert is an interval, and so is the effort of a drive that holds the
// machine. Inverse dynamics has no single answer there.
#ifndef DYNAMICS_HOLDING_H
#define DYNAMICS_HOLDING_H
#include "dynamics/dynamics.h"

typedef struct YkHolding YkHolding;

// For a mechanism whose loads have dry friction. NULL when out of memory.
YkHolding *yk_holding_new(const YkDynamics *dynamics);
void yk_holding_free(YkHolding *holding);
void yk_holding_clear(YkHolding *holding);
// Does a joint with dry friction stand at the state's pose, whose rates are known? Forgets what was found before.
bool yk_holding_is_needed(YkHolding *holding, const YkDynamics *dynamics, const YkState *state);
// There: which of the joints that stand stick and which begin to slip where their accelerations are free, and the
// efforts that hold the prescribed inputs. Leaves a solution with frictions that stand: those of joints that stand on
// drives alone are 0. Cost: a solution for every joint with dry friction, and some linear programs an input.
YkStatus yk_holding_find(YkHolding *holding, YkDynamics *dynamics, YkState *state, YkDynamicsMethod method);
YkEffortRange yk_holding_range(const YkHolding *holding, size_t input); // is_single where nothing was found
bool yk_holding_is_open(const YkHolding *holding); // frictions at rest, and what depends on them, have no single answer

#endif
