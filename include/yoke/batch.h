// The batch: solves many independent poses of one mechanism in one call, as a structure of arrays.
#ifndef YOKE_BATCH_H
#define YOKE_BATCH_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkBatch YkBatch;
// Makes a batch with the branches and reference angles of an assembled state. It computes these channels and nothing
// else. Channels of forces and energies are those of inverse dynamics: the accelerations of all inputs are given, and
// the effort of each is sought; loads that depend on time take the state's. Forces are 0 for a machine without masses
// and loads. Returns NULL when out of memory. Cost of making, with channels of forces: about 1 ms for ten bodies, 25 ms
// for 60.
YK_API YkBatch *yk_batch_new(const YkState *state, const YkChannel *channels, size_t channel_count);
YK_API void yk_batch_free(YkBatch *batch);
// Solves `count` poses. inputs[3*i + k][pose]: position (k = 0), velocity (1), acceleration (2) of input i (in the
// order of yk_input_coordinate), SI; a NULL array stands for the state's own value at all poses.
// outputs[channel][pose], SI. status[pose] (may be NULL): YK_OK, YK_SINGULAR (rates and forces are 0), YK_LIMIT
// (outputs are 0, never NaN); where forces have no finite value, that of yk_dynamics_solve.
// Every pose lies on the batch's branches, whether or not the machine could get there from the state: limits and change
// points on the way are not sought (see yk_state_move_to and studies). In machines with groups each pose is tracked
// straight from the pose of the batch's state; YK_LIMIT if that path ends before it. The arrays must not overlap.
// Returns the worst status. The results have the bits of yk_state_solve; a force has the same bits in any batch, but
// for the sign of 0, and is that of yk_dynamics_solve up to rounding. Allocates nothing, except for forces of machines
// with dry friction, redundant constraints or more than 64 bodies, which are solved pose by pose; use one batch per
// thread. It has no progress callback: a pose takes about 10 ns for each link, and the poses may be split over several
// calls without changing a bit. A call for one pose is also the fastest way to the forces of one pose: about 0.2 us for
// a machine of five bodies, since it computes nothing but the channels.
YK_API YkStatus yk_batch_run(YkBatch *batch, const double *const *inputs, double *const *outputs, signed char *status,
                             size_t count);

#ifdef __cplusplus
}
#endif

#endif
