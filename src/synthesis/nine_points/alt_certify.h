// Proofs for solutions of Alt's problem: that one exists, that it is real or not, and that two triples are different.
#ifndef SYNTHESIS_ALT_CERTIFY_H
#define SYNTHESIS_ALT_CERTIFY_H
#include "configurations/ball.h"
#include "synthesis/nine_points/alt.h"

typedef enum YkAltReality { YK_ALT_REAL, YK_ALT_NOT_REAL, YK_ALT_UNKNOWN } YkAltReality;

typedef struct YkAltProof {
    YkBall key[2];        // the sums of the triple's three fixed pivots, z and z^: the same for all names
    double radius;        // of the polydisc about x in which the solution is alone: x_k may change by radius * |x_k|
    YkAltReality reality; // UNKNOWN: the places are not real, or the proof does not tell
} YkAltProof;

// Proves by Krawczyk's operator in complex discs that exactly one solution for these places, as they are rounded, is
// near x, and improves x to the last digits. If the places are real and the solution seems so, x is first moved to the
// nearest real point: that the solution is alone there proves that it is its own conjugate. Returns false if no radius
// succeeds.
// Source: Krawczyk 1969; Moore 1977. Cost: some 0.1 ms.
bool yk_alt_certify(const YkVec *places, YkVec *x, YkAltProof *proof);
// Returns whether two proved solutions certainly belong to different triples.
bool yk_alt_are_different(const YkAltProof *one, const YkAltProof *other);

#endif
