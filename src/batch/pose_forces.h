// Forces of a batch or a study: in lanes if the machine allows it, otherwise by the dynamics of one pose. All
// accelerations are given.
#ifndef BATCH_POSE_FORCES_H
#define BATCH_POSE_FORCES_H
#include <yoke/dynamics.h>
#include "batch/forces.h"
#include "solve/state.h"

typedef struct YkPoseForces {
    const YkMechanism *mech;
    YkChannel *channels; // those that need forces,
    size_t *place;       // and their places among the caller's
    size_t count;
    YkLaneForces *lanes;  // NULL: the machine is not for lanes
    YkDynamics *dynamics; // made when a pose needs it
    uint64_t changes;     // of the variant, when its values were taken
    size_t position_count;
    double **position; // [coordinate]: lanes of a position that the loads depend on, or NULL
    double *position_lanes;
    double **out;         // [k]: of the channels that need forces
    double **seen;        // of those that tell whether all are finite,
    size_t *telling;      // whose k these are,
    size_t telling_count; // and how many
    size_t *which;        // the lanes asked for, when they are not all,
    double *packed;       // [k][lanes]: and their forces
    size_t lane_count;
} YkPoseForces;

// Makes the forces for those of the channels that need some; *none is true if no channel does. lanes: how many at a
// time. Returns NULL when out of memory, or for none.
YkPoseForces *yk_pose_forces_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, size_t lanes,
                                 bool *none);
void yk_pose_forces_free(YkPoseForces *forces);
// Takes the present values of the parameters of a variant.
void yk_pose_forces_take(YkPoseForces *forces);
// Takes them if the mechanism is a variant's and they have changed.
static inline void yk_pose_forces_follow(YkPoseForces *forces)
{
    const YkVariant *variant = forces->mech->variant;
    if (variant && forces->changes != variant->changes) yk_pose_forces_take(forces);
}
// Returns whether the forces of a pose are all finite; makes them 0.
bool yk_pose_forces_are_finite(const YkPoseForces *forces, double *const *outputs, size_t pose);
void yk_pose_forces_clear(const YkPoseForces *forces, double *const *outputs, size_t pose);
// Finds the forces of one pose in a space of one lane, without a status: outputs[channel][pose]. Returns whether all of
// them are finite.
bool yk_pose_forces_run_one(YkPoseForces *forces, const YkLanePose *at, double *const *outputs, size_t pose);
// Finds the forces at the pose of a solved state: outputs[channel][pose] of the caller's channels, 0 if the status is
// not YK_OK. Returns YK_OK; YK_SINGULAR at a dead point; or that of yk_dynamics_solve. The bits are those of a lane.
YkStatus yk_pose_forces_at(YkPoseForces *forces, YkState *state, double *const *outputs, size_t pose);

#endif
