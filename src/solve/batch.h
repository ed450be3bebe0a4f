// What a batch lets the rooms after it do.
#ifndef SOLVE_BATCH_H
#define SOLVE_BATCH_H
#include <yoke/batch.h>

// Goes on with the branches, reference angles, inputs and pose of this state (of the batch's mechanism).
void yk_batch_restart(YkBatch *batch, const YkState *state);

#endif
