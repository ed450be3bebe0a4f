// Relations over lanes: gears, racks, belts, cams.
#ifndef SOLVE_RELATIONS_H
#define SOLVE_RELATIONS_H
#include "solve/state.h"

// Sets the relation's target - an orientation or a distance - with its rates.
void yk_run_relation(const YkRun *run, size_t relation);
// Adds to the gap what a relation misses by that repeats others.
void yk_run_relation_check(const YkRun *run, size_t relation);

// A relation of a group in lane 0: what it misses by (m), with the rates that its knowns and rate[] (NULL: 0) give it;
// the law's slope times its gain; the size of what adds up to the value, m.
typedef struct YkRelationPose {
    YkMotion value;
    double slope, scale;
} YkRelationPose;
YkRelationPose yk_relation_pose(const YkRun *run, size_t relation, const double *x, const double *rate);
// Adds its derivatives by the group's unknowns to row[].
void yk_relation_gradient(const YkMechanism *mech, size_t relation, double slope, double *row);

// References of the angles that relations start from: from the guesses of `start:`; from a pose.
void yk_relations_guess(YkState *state);
void yk_relations_refer(YkState *state, const YkSpace *space);

#endif
