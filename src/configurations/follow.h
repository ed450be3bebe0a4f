// Follows a solution of a group's system along a path of its coefficients.
#ifndef CONFIGURATIONS_FOLLOW_H
#define CONFIGURATIONS_FOLLOW_H
#include "base/pace.h"
#include "configurations/system.h"

// Returns how large a change of x is, relative to it: of z to its size, of a distance to itself or the machine's size.
double yk_relative_change(const YkShape *shape, const YkVec *x, const YkVec *change);
// Improves x by Newton's method until it stands still. Returns the size of the last step, or infinity.
double yk_system_polish(const YkShape *shape, const YkVec *coefficients, YkVec *x);
// Follows the solution x of the coefficients `from` along (1 - t) from + t to, t from 0 to 1. Returns whether x is then
// a solution of `to`; it is not where the path has no end in finite space or comes too close to another one.
// Steps are chosen such that the predictor (Runge and Kutta's of order 4 on Davidenko's equation) misses by some 1e-5,
// so that the corrector does not leave its path. Source: Sommese & Wampler 2005, ch. 2.
bool yk_path_follow(const YkShape *shape, const YkVec *from, const YkVec *to, YkVec *x, YkPace *pace);

#endif
