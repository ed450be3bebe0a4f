// The inside of YkBatch.
#ifndef BATCH_INSIDE_H
#define BATCH_INSIDE_H
#include "base/worse.h"
#include "batch/batch.h"
#include "batch/pose_forces.h"
#include "solve/run.h"
#include "solve/state.h"
#include "solve/watch.h"

struct YkBatch {
    YkArena *arena; // of its arrays but those of lanes, which need not be zeroed
    const YkMechanism *mech;
    YkState *state; // its branches, reference angles, and inputs for NULL arrays; poses of machines with groups are
                    // tracked in it
    YkState *home;  // groups: every pose starts here
    YkSpace space, single; // for blocks of lanes; for one pose
    YkRun run;             // its steps; of the present block: which space, how many lanes
    YkChannel *channels;
    int32_t (*turns)[2];   // per channel: the orientations of its angle (a, b)
    double ***row;         // per channel: the lanes in which it is made, redirected to its output; or NULL
    const double **number; // per channel: where a pose alone holds it as requested; or NULL
    size_t channel_count, lanes;
    size_t *plain; // the channels that need no forces
    size_t plain_count;
    bool *rates_alone;       // [slot]: no step and no channel needs its direction; NULL: all may be needed
    bool *idle;              // [slot]: none needs anything of it; NULL: all may be needed
    bool needs_state;        // every pose is solved by a state
    double *constant;        // [3 * input + k][lane]: for NULL arrays
    const double **lanes_of; // the runner's view of the inputs of this block
    YkPlane point;           // scratch: the lanes of one point
    double *point_lanes;
    bool is_along;        // the poses follow one path:
    YkBranchWatch watch;  // where its branches could have met
    double *next;         // [coordinate]: angles at the end of this block of lanes, references of the next
    bool is_plain;        // the inputs of this block are numbers, and nothing else can fail: see YkRun
    bool has_settled;     // some lanes of this block have the state's answers
    size_t clear;         // lanes of this block that are certainly on the path
    const double *times;  // of the lanes of this block; NULL: the state's
    YkPoseForces *forces; // of the channels that need them; NULL if none does
};

// needed.c: finds the orientations whose direction is never read, and those that are not read at all. Returns false
// when out of memory.
bool yk_batch_find_rates_alone(YkBatch *batch);
// channels.c: prepares the angles of a channel, and finds the lanes that already hold it.
void yk_batch_prepare_angle(YkBatch *batch, size_t channel);
double **yk_batch_free_row_of(YkBatch *batch, size_t channel);
// Returns where the space of one pose holds a channel as requested; NULL if it has to be computed.
const double *yk_batch_number_of(const YkBatch *batch, size_t channel);
// Writes the positions of a coordinate that is an angle.
void yk_batch_write_angle(const YkBatch *batch, size_t coordinate, double *out, size_t n);
// Writes a channel that is none of forces. masks: some lanes may not close, or are at a dead point.
void yk_batch_write_channel(const YkBatch *batch, size_t channel, bool masks, double *out);
// judge.c: finds the status of n lanes, and leaves margins that mask undecided ones. Returns the worst.
YkStatus yk_batch_judge(YkBatch *batch, signed char *status, size_t n);
// Solves one lane of the block in batch->state.
YkStatus yk_batch_solve_lane(YkBatch *batch, size_t lane);
// Writes the answers of poses that only a state settles. Returns OK, or NO_MEMORY.
YkStatus yk_batch_write_settled(YkBatch *batch, double *const *outputs, size_t at, size_t n);
// batch_forces.c: computes the forces of a block of lanes, before its channels are masked: of those that are wanted;
// NULL: of all.
void yk_batch_run_forces(YkBatch *batch, double *const *outputs, size_t at, const bool *wanted);
// Computes the forces of one pose in the space of one lane. Returns whether all of them are finite.
bool yk_batch_run_forces_alone(YkBatch *batch, double *const *outputs, size_t at);
// Writes the positions on which loads depend.
void yk_batch_write_positions(const YkBatch *batch);
// Returns how many lanes have finite forces, from the first.
size_t yk_batch_finite_lanes(const YkBatch *batch, double *const *outputs, size_t at, size_t n);
// Replaces forces that are not finite by those of one pose, or takes its status. Returns the worst.
YkStatus yk_batch_settle_forces(YkBatch *batch, double *const *outputs, signed char *status, size_t at, size_t n);

#endif
