// How far apart two poses of a machine are: angles up to whole turns, in rad; lengths over the machine's size.
#ifndef SOLVE_GAP_H
#define SOLVE_GAP_H
#include "compile/mechanism.h"

// Returns what a difference of one angle or distance counts.
double yk_gap(const YkMechanism *mech, bool is_distance, double difference);
// Returns the largest gap between the unknowns a[] and b[] of a group.
double yk_group_gap(const YkMechanism *mech, const YkBlock *group, const double *a, const double *b);

#endif
