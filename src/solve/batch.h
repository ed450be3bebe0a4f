// What a batch lets the rooms after it do.
#ifndef SOLVE_BATCH_H
#define SOLVE_BATCH_H
#include <yoke/batch.h>

// A batch of a machine of dyads whose poses follow each other on one way of the inputs, at most some degrees apart. Its
// angles are counted turn by turn along the way, and it tells where the branches may not be those of the way.
YkBatch *yk_batch_new_along(const YkState *state, const YkChannel *channels, size_t channel_count);
// Can poses be followed so: closed forms alone, without gears, belts, cams and channels that only a state knows?
bool yk_batch_can_follow(const YkMechanism *mech, const YkChannel *channels, size_t channel_count);
// Begins a way with the branches and the angles of this state; inputs of NULL arrays stay those of the batch.
void yk_batch_begin(YkBatch *batch, const YkState *state);
// Goes on through `count` poses of the way, as yk_batch_run. Returns how many of them, from the first, are the way's
// for sure: `count` where nothing came near a limit or a change point. The others have no answer yet, and the way ends.
size_t yk_batch_run_along(YkBatch *batch, const double *const *inputs, double *const *outputs, signed char *status,
                          size_t count);
// Gives a state the angles that the way has come to, as its references.
void yk_batch_refer(const YkBatch *batch, YkState *state);

// Goes on with the branches, reference angles, inputs and pose of this state (of the batch's mechanism).
void yk_batch_restart(YkBatch *batch, const YkState *state);

#endif
