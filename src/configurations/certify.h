// Proves solutions of a group's system: that one exists near a point, that it is alone there, and whether it is real.
#ifndef CONFIGURATIONS_CERTIFY_H
#define CONFIGURATIONS_CERTIFY_H
#include "configurations/system.h"

// The coefficients of a pose come from earlier blocks and carry their rounding: the proof holds for all coefficients
// within this distance, over the machine's size.
#define YK_COEFFICIENT_ERROR 1e-14

typedef enum YkReality { YK_REAL, YK_NOT_REAL, YK_REALITY_UNKNOWN } YkReality;

typedef struct YkCertificate {
    double radius; // the polydisc about x in which the solution is alone: x_k may change by radius * size of x_k
    double within; // the solution is no farther from x than this, by the same measure
    YkReality reality;
} YkCertificate;

// Proves that the system with these coefficients (of a pose: the second half the conjugates of the first) has exactly
// one solution in a polydisc about x, by Krawczyk's operator in complex discs (Krawczyk 1969; Moore 1977): for all
// coefficients in their balls. Where the solution seems real, x is first moved to the nearest real point (|z| = 1,
// distances real); since conjugation maps solutions to solutions and the polydisc's centre to itself, the solution is
// then its own conjugate. Returns false if no radius succeeds. Cost 2 factorisations.
bool yk_certify(const YkShape *shape, const YkVec *coefficients, YkVec *x, YkCertificate *certificate);
// Returns whether two certified solutions of the same system are certainly different.
bool yk_are_distinct(const YkShape *shape, const YkVec *x, const YkCertificate *of_x, const YkVec *y,
                     const YkCertificate *of_y);

#endif
