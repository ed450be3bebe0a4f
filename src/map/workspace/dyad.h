// Dyads over boxes of coefficients: how many real solutions all of them have.
#ifndef MAP_DYAD_H
#define MAP_DYAD_H
#include "map/piece.h"

// Returns how many real solutions a system of one loop has for all coefficients within the discs: 0, 1 or 2; -1 if they
// do not all have the same number, or if the discs are too wide to decide.
int yk_dyad_count(const YkShape *shape, const YkDiscCoefficients *c);
// Returns a smooth function of the coefficients that is positive where a dyad has two real solutions and negative where
// it has none, with its derivative: the square of four times a triangle's area, or of a chord; infinite for two slides.
YkDual yk_dyad_gap(const YkShape *shape, const YkDiscCoefficients *c);
// Encloses the solution on one branch, +1 or -1 (a dyad with one solution has it on +1), for all coefficients within
// the discs, where yk_dyad_count is positive. Returns false if the discs are too wide.
bool yk_dyad_branch(const YkShape *shape, const YkDiscCoefficients *c, int branch, YkBall x[2]);
// Encloses all real solutions, for all coefficients within the discs, in `parts` pieces: writes piece `part`. It needs
// no proof that there are any, and so holds where two of them meet. Returns false if the discs are too wide.
bool yk_dyad_hull(const YkShape *shape, const YkDiscCoefficients *c, size_t part, size_t parts, YkBall x[2]);

#endif
