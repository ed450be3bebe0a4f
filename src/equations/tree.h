// Open trees of pins, slides and welds: forward dynamics by one pass inwards and one outwards, at linear cost, for
// chains of any length. This is the planar articulated-body method (Featherstone 1983): with absolute angles as
// unknowns a pin transmits only a force, so a subtree presents a 2 x 2 inertia to its parent through a pin.
#ifndef EQUATIONS_TREE_H
#define EQUATIONS_TREE_H
#include "loads/loads.h"

typedef struct YkTreeDynamics YkTreeDynamics;
// Returns NULL if the machine has loops, or is not of this kind (its only loads are gravity and efforts; no drives), or
// when out of memory: *fits says which.
YkTreeDynamics *yk_tree_dynamics_new(const YkMechanism *mech, bool *fits);
void yk_tree_dynamics_free(YkTreeDynamics *tree);
// Accelerates. q[input], v[input]: positions and rates; effort[input]: along each coordinate (NULL: none). Writes
// a[input]. Returns -1, or the input of a freedom without inertia. Allocates nothing.
int yk_tree_accelerate(YkTreeDynamics *tree, const double *q, const double *v, const double *effort, double *a);

#endif
