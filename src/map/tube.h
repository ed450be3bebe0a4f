// A tube: where a block's real solution is over an interval, with proof that there is exactly one.
//
// Cells of strands do this in discs for complex solutions (configurations/certify.h); tubes do it for real ones in
// angles and distances, at a tenth of the cost: motions take one for every few degrees.
#ifndef MAP_TUBE_H
#define MAP_TUBE_H
#include "map/piece.h"

typedef struct YkTube {
    YkVec x[YK_PIECE_UNKNOWNS];     // in the middle: e^(i angle); distances over the size
    double rate[YK_PIECE_UNKNOWNS]; // of angles and distances
    double middle, half;            // of the interval
    double radius;                  // the solution is alone: angles within this of the line, distances times their size
    double within;                  // it is no farther from the line than this
    double rate_within;             // nor its derivative from `rate`
} YkTube;

// Finds the real solution near tube->x at the coefficients of the middle, and proves it over the interval. `over` has
// their derivatives over it; NULL: the interval is a point. Krawczyk's operator for angles and distances: the Jacobian
// at the line is its value in the middle and its slope along the line, whose effects may cancel, and bounds for the
// rest, which cannot. Returns false if that is not proved. Cost 2 n^3 multiplications.
bool yk_tube_make(const YkPiece *piece, const YkDiscCoefficients *middle, const YkDiscCoefficients *over, double half,
                  YkTube *tube);
// Returns whether a pose within `within` lies in the tube at a place of the interval: only one solution does.
bool yk_tube_contains(const YkPiece *piece, const YkTube *tube, double at, const YkVec *x, double within);
// Returns whether the tube's solution at a place is certainly not within `within` of a pose.
bool yk_tube_excludes(const YkPiece *piece, const YkTube *tube, double at, const YkVec *x, double within);
// Returns the pose of the line at a place.
void yk_tube_at(const YkPiece *piece, const YkTube *tube, double at, YkVec *x);
// Makes the unknowns known with their derivatives: all that the solution may be over the interval.
void yk_tube_place(const YkPiece *piece, const YkTube *tube, YkDiscs *discs);

#endif
