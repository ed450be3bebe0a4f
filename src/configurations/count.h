// The number of complex solutions of a group: a bound that no pose exceeds, and that nearly all attain.
//
// A solution is a vector x of the space of the loops and a vector y of the conjugates' space with x_j y_j = 1 for every
// angle, and with equal distances. If the right-hand sides are generic, all solutions differ, and their number depends
// on the matroid of the space alone: it is the intersection number of two tropical linear spaces. Isolated solutions
// are never more than at generic right-hand sides; and since all right-hand sides together make one irreducible
// variety, as many distinct regular solutions as this number leave no room for any other, isolated or in a continuum.
#ifndef CONFIGURATIONS_COUNT_H
#define CONFIGURATIONS_COUNT_H
#include "base/pace.h"
#include "configurations/matroid.h"

typedef enum YkCountStatus { YK_COUNTED, YK_COUNT_TOO_LARGE, YK_COUNT_STOPPED, YK_COUNT_NO_MEMORY } YkCountStatus;

// Counts the solutions of a group whose unknowns are angles, by deletion and contraction of the matroid. This is the
// recursion for Laman graphs by Capco, Gallet, Grasegger, Koutschan, Lubbes and Schicho 2018, stated for the bodies
// themselves instead of the bars of their triangles; docs/configurations.md has the proof.
// Cost at most 4^(unknowns), usually far less.
YkCountStatus yk_count_angles(const YkMatroid *matroid, YkPace *pace, size_t *count);
// Counts those of any group by intersecting the cones of the two tropical spaces one by one. TOO_LARGE beyond 10,000
// cones: groups of six loops mostly have fewer.
YkCountStatus yk_count_cones(const YkMatroid *matroid, const YkShape *shape, YkPace *pace, size_t *count);

#endif
