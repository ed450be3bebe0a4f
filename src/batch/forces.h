// Forces over lanes: inverse dynamics of many poses at once, made from the steps in symbols (program/), run as a tape.
#ifndef BATCH_FORCES_H
#define BATCH_FORCES_H
#include "compile/variant.h"
#include "solve/space.h"

typedef struct YkLaneForces YkLaneForces;

// Makes what computes these channels, all of forces or energies, with every acceleration given. The values of a
// variant's mechanism may change later. Returns NULL when out of memory, or if they cannot be computed in lanes: *fits
// is then false. Such machines have dry friction, constraints that repeat others, very many bodies.
YkLaneForces *yk_lane_forces_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, size_t lanes,
                                 bool *fits);
void yk_lane_forces_free(YkLaneForces *forces);
size_t yk_lane_forces_length(const YkLaneForces *forces); // operations a pose
// Returns whether a channel is one of those that decide whether all are finite: all are if these are.
bool yk_lane_forces_tell(const YkLaneForces *forces, size_t channel); // with the present parameters
// Takes new values of the variant's parameters.
void yk_lane_forces_redesign(YkLaneForces *forces);

typedef struct YkLanePose {
    const YkSpace *space;
    const double *const *inputs; // [3 * input + k]: lanes
    double time;
    const double *times;            // lanes; NULL: `time` in all
    const double *const *positions; // [coordinate]: lanes of those that yk_lane_forces_needs names
    const size_t *which;            // the lanes that are asked for; NULL: the first n
} YkLanePose;
// Returns whether the loads depend on the position of a coordinate that is neither an input nor a distance.
bool yk_lane_forces_needs(const YkLaneForces *forces, size_t coordinate);
// Returns whether they read the direction of an orientation.
bool yk_lane_forces_need_direction(const YkLaneForces *forces, int32_t slot);
// Returns whether they read its rate or its acceleration.
bool yk_lane_forces_need_rates(const YkLaneForces *forces, int32_t slot);
// Computes out[channel][0 .. n) for n lanes of a pose. Forces of poses at dead points are not finite, or meaningless.
void yk_lane_forces_run(YkLaneForces *forces, const YkLanePose *pose, double *const *out, size_t n);
// Does the same for one pose in a space of one lane, with the same bits. Returns where the channels' numbers stand
// until the next run.
const double *const *yk_lane_forces_run_one(YkLaneForces *forces, const YkLanePose *pose);

// Makes the derivatives of a weighted sum of such channels by all that they are made of, backwards: at a few times the
// cost of the forces, whatever the number of parameters. Not for machines with laws either: *fits is then false.
typedef struct YkGradient YkGradient;
YkLaneForces *yk_force_slopes_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, bool *fits);
typedef struct YkSlopesAt {
    const double *inputs; // [3 * input + k]
    double time;
    const double *weights; // [channel]
} YkSlopesAt;
// Takes the shares of the sum into a gradient that has its pose and was started. by[yk_force_slopes_count]: scratch.
// Returns false if one of them is not finite. Allocates nothing. force_slopes.c
size_t yk_force_slopes_count(const YkLaneForces *slopes);
bool yk_force_slopes_take(YkLaneForces *slopes, YkGradient *gradient, const YkSlopesAt *at, double *by);

#endif
