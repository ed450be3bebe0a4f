// The assembly of the file, in a variant of its machine.
#ifndef STUDY_START_H
#define STUDY_START_H
#include <yoke/move.h>
#include "solve/state.h"

// Puts a state of a variant, at the file's own values, in the pose of the file's state.
YkStatus yk_study_take_home(YkState *home, const YkState *state);
// Prepares a state with the branches of `home` or, for groups, with its assembly carried along from the file's values
// to these; it has no pose of its own before that. goal: room for the inputs.
YkStatus yk_study_carry(YkVariant *variant, const YkState *home, YkState *state, const double *own,
                        const double *values, size_t count, YkMotion *goal);

#endif
