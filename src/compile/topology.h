// The machine's graph: orientations, distances, the spanning tree of its coordinates, its loops.
#ifndef COMPILE_TOPOLOGY_H
#define COMPILE_TOPOLOGY_H
#include "compile/mechanism.h"

// The joints of each body: incidence.joint[first[b] .. first[b + 1]).
typedef struct YkIncidence {
    uint32_t *first;
    int32_t *joint;
} YkIncidence;

bool yk_incidence_build(YkIncidence *incidence, YkArena *arena, const YkModel *model);
static inline int32_t yk_other_body(const YkModel *model, int32_t joint, int32_t body)
{
    const YkJoint *j = &model->joints[joint];
    return j->body[0] == body ? j->body[1] : j->body[0];
}
// guess.c: returns the values of the tree's coordinates at the start: drives at t = 0, otherwise `start:`, otherwise 0.
// guess[coordinate].
void yk_start_guess(const YkMechanism *mech, double *guess);
// topology.c: finds the bodies' orientations and the joints' distances; reports slides and welds that contradict each
// other.
bool yk_topology_orientations(YkMechanism *mech, const YkIncidence *incidence, YkProblems *problems);
// Finds tree, coordinates, loops, gruebler; reports declared coordinates that close a loop.
bool yk_topology_tree(YkMechanism *mech, const YkIncidence *incidence, YkProblems *problems);

#endif
