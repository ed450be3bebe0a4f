// Relations over lanes: gears, racks, belts, cams.
#ifndef SOLVE_RELATIONS_H
#define SOLVE_RELATIONS_H
#include "solve/state.h"

// Sets the relation's target - an orientation or a distance - with its rates.
void yk_run_relation(const YkRun *run, size_t relation);
// Adds the residual of a relation that repeats others to the gap.
void yk_run_relation_check(const YkRun *run, size_t relation);

// A relation of a group in lane 0: its residual (m), with the rates that its known parts and rate[] (NULL: 0) give it;
// the law's slope times its gain, and its argument; the scale of the parts of its value, m.
typedef struct YkRelationPose {
    YkMotion value;
    double slope, argument, scale;
} YkRelationPose;
YkRelationPose yk_relation_pose(const YkRun *run, size_t relation, const double *x, const double *rate);
// Adds its derivatives by the group's unknowns to row[].
void yk_relation_gradient(const YkMechanism *mech, size_t relation, double slope, double *row);

// References of the angles from which relations start: from the guesses of `start:`; from a pose.
void yk_relations_guess(YkState *state);
void yk_relations_refer(YkState *state, const YkSpace *space);

#endif
