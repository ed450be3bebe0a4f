// Finds all solutions of a group by elimination: a second way beside paths, with which it shares no step.
//
// One unknown h is hidden. All combinations of the loops and their conjugates, with monomials for multipliers, in which
// no monomials but C(2L, L) chosen ones are left are linear in h: M_0 + h M_1. At a solution this matrix maps the
// vector of the monomials' values to zero, so that h is an eigenvalue and the other unknowns are ratios in its
// eigenvector. If no columns of the loops depend on each other, these combinations are the rows of Dixon's determinant.
// Source: Wampler 2001, "Solving the kinematics of planar mechanisms by Dixon determinant and a complex-plane
// formulation"; Nielsen & Roth 1999, "Solving the input/output problem for planar mechanisms".
#ifndef CONFIGURATIONS_ELIMINATE_H
#define CONFIGURATIONS_ELIMINATE_H
#include "configurations/system.h"

enum { YK_ELIMINATION_LOOPS_MAX = 4, YK_ELIMINATION_MOST = 70 }; // C(8, 4)

// Writes candidates for the solutions with these coefficients, solutions[YK_ELIMINATION_MOST][unknowns], not yet
// improved: some may be none. `attempt`, below shape->unknowns, says which unknown is hidden: solutions in which it
// has equal values are not separated, and another attempt may find them. Returns false when out of memory; *count is 0
// where this attempt cannot be made. Cost about 20 n^3 with n up to 6, 20, 70 for 2, 3, 4 loops, and as much to
// combine.
bool yk_eliminate(const YkShape *shape, const YkVec *coefficients, size_t attempt, YkVec *solutions, size_t *count);

#endif
