// Groups over boxes of coefficients: loops that cannot close.
#ifndef MAP_POLYGON_H
#define MAP_POLYGON_H
#include "map/piece.h"

// Returns whether no coefficients within the discs let the group close: whether in one of its loops, or in the sum or
// the difference of two, one side is longer than all others together. Loops with an unknown distance are not looked at.
// Cost loops^2 unknowns.
bool yk_polygon_is_open(const YkShape *shape, const YkDiscCoefficients *c);

#endif
