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
// coefficients in their balls. If the solution seems real, x is first moved to the nearest real point (|z| = 1,
// distances real); since conjugation maps solutions to solutions and the polydisc's centre to itself, the solution is
// then its own conjugate. Returns false if no radius succeeds. Cost 2 factorisations.
bool yk_certify(const YkShape *shape, const YkVec *coefficients, YkVec *x, YkCertificate *certificate);
// Proves the same for all coefficients within discs, given by their centres and radii, [2][loops][unknowns + 1]. Absent
// coefficients have centre and radius 0. The solution is then a continuous function of the coefficients. Tries radii
// that are small multiples of what the discs let x miss by, and neither moves x nor judges whether it is real.
bool yk_enclose(const YkShape *shape, const YkVec *coefficients, const double *radii, const YkVec *x,
                YkCertificate *certificate);
// A path of coefficients over an interval of a parameter t about its middle: discs of them in the middle, over the
// whole interval, and of their derivatives over it.
typedef struct YkPathDiscs {
    const YkVec *middle, *whole, *rate;
    const double *middle_radius, *whole_radius, *rate_radius;
    double half; // of the interval's length
} YkPathDiscs;
typedef struct YkPathCertificate {
    YkCertificate at;                    // about the line x + rate t, for every t of the interval
    YkVec rate[2 * YK_SYSTEM_LOOPS_MAX]; // of x
    double rate_within; // bound of the distance from `rate` to the solution's derivative, over the size of x
} YkPathCertificate;
// Proves that for every t of the interval exactly one solution lies in a polydisc that moves along a line through x:
// the solution is a smooth function of t. Krawczyk's operator on the moving polydisc; how far the line misses is
// bounded by the mean value theorem, so that intervals may be as long as the Jacobian allows.
bool yk_enclose_path(const YkShape *shape, const YkPathDiscs *path, const YkVec *x, YkPathCertificate *certificate);
// Returns whether two certified solutions of the same system are certainly different.
bool yk_are_distinct(const YkShape *shape, const YkVec *x, const YkCertificate *of_x, const YkVec *y,
                     const YkCertificate *of_y);

#endif
