// The batch: many independent poses of one mechanism in one call, in structure of arrays.
#ifndef YOKE_BATCH_H
#define YOKE_BATCH_H

#include <yoke/state.h>

typedef struct YkBatch YkBatch;
// NULL also where a channel needs forces. A batch with the branches and reference angles of an assembled state.
// Channels are what it computes; nothing else is.
YK_API YkBatch *yk_batch_new(const YkState *state, const YkChannel *channels, size_t channel_count);
YK_API void yk_batch_free(YkBatch *batch);
// Solves `count` poses. inputs[3*i + k][pose]: input i's position (k = 0), velocity (1), acceleration (2); a NULL array
// stands for the state's own value for all poses (position, velocity or acceleration). outputs[channel][pose].
// status[pose] (may be NULL): YK_OK, YK_SINGULAR (rates 0), YK_LIMIT (outputs NaN-free: 0).
// Every pose stands on the batch's branches, whether or not the machine could come there from the state: limits and
// change points between are not asked for (yk_state_move_to, studies). With groups each pose is tracked straight from
// the pose of the batch's state; YK_LIMIT where that way ends.
// The arrays must not overlap. Returns the worst status. Identical bits to yk_state_solve. Allocates nothing; one batch
// per thread.
YK_API YkStatus yk_batch_run(YkBatch *batch, const double *const *inputs, double *const *outputs, signed char *status,
                             size_t count);

#endif
