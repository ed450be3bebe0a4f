// The functions of a batch for later rooms.
#ifndef BATCH_BATCH_H
#define BATCH_BATCH_H
#include <yoke/batch.h>

// Makes a batch for a machine of dyads whose poses follow each other along one path of the inputs, at most some degrees
// apart. It counts angles turn by turn along the path, and marks where the branches may no longer be those of the path.
YkBatch *yk_batch_new_along(const YkState *state, const YkChannel *channels, size_t channel_count);
// Returns whether its channels of forces cannot be computed in lanes.
bool yk_batch_has_slow_forces(const YkBatch *batch);
// Returns whether all its channels are computed in lanes, with no pose solved by a state of its own.
bool yk_batch_has_lanes(const YkBatch *batch);
struct YkPoseForces *yk_batch_forces(YkBatch *batch); // NULL: no channel needs any
// Returns whether poses can be followed so: closed forms only, without gears, belts, cams and channels that only a
// state knows.
bool yk_batch_can_follow(const YkMechanism *mech, const YkChannel *channels, size_t channel_count);
// Begins a path with the branches and angles of this state; inputs of NULL arrays stay those of the batch.
void yk_batch_begin(YkBatch *batch, const YkState *state);
// Continues through `count` poses of the path, like yk_batch_run. Returns how many of them, from the first, are
// certainly on the path: `count` if none came near a limit or a change point. The others have no answer yet, and the
// path ends. wanted[pose] (may be NULL): the forces of all other poses are left out, and 0. times[pose] (may be NULL:
// the state's): of loads.
typedef struct YkAlong {
    const bool *wanted;
    const double *times;
} YkAlong;
size_t yk_batch_run_along(YkBatch *batch, const double *const *inputs, double *const *outputs, signed char *status,
                          YkAlong along, size_t count);
// Gives a state the angles that the path has reached, as its references.
void yk_batch_refer(const YkBatch *batch, YkState *state);

// Continues with the branches, reference angles, inputs and pose of this state (of the batch's mechanism).
void yk_batch_restart(YkBatch *batch, const YkState *state);

#endif
