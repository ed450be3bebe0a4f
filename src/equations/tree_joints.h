// Open trees with slides and pin-slots: the general path.
#ifndef EQUATIONS_TREE_JOINTS_H
#define EQUATIONS_TREE_JOINTS_H
#include "equations/tree_angles.h"

typedef struct YkTreeJoints YkTreeJoints;
// Returns NULL when out of memory. Everything is in the arena; the links must live as long.
YkTreeJoints *yk_tree_joints_new(const YkTreeLinks *links, YkVec gravity, YkArena *arena);
// See yk_tree_accelerate.
int yk_tree_joints_accelerate(YkTreeJoints *joints, const double *q, const double *v, const double *effort, double *a);

#endif
