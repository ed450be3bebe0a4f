// Forward dynamics over lanes, for machines whose inverse dynamics a batch computes in lanes: closed forms, at most
// some free inputs, no dry friction.
#ifndef STUDY_LANE_MOTION_H
#define STUDY_LANE_MOTION_H
#include <yoke/dynamics.h>
#include <yoke/study.h>

typedef struct YkLaneMotion YkLaneMotion;
// home: solved, of the mechanism whose free inputs are those of the dynamics. capacity: of states at a time. Returns
// NULL if the machine is not of this kind (*fits false), or when out of memory.
YkLaneMotion *yk_lane_motion_new(const YkState *home, const YkDynamics *dynamics, size_t capacity, bool *fits);
void yk_lane_motion_free(YkLaneMotion *motion);
// Solves the states [from, from + count) of a case with the present values of the parameters, with the same bits for
// any count. is_solved[state - from]: false for those left to the dynamics of one pose; they have no accelerations.
// Returns false when out of memory.
bool yk_lane_motion_run(YkLaneMotion *motion, const YkMotionCase *asked, size_t from, size_t count,
                        double *const *accelerations, bool *is_solved);

#endif
