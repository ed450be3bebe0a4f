// Andrews' squeezing mechanism by hand, in the crank's angle alone: the loops close in closed form by three dyads.
#ifndef BENCH_D4_H
#define BENCH_D4_H

enum { D4_BETA, D4_THETA, D4_GAMMA, D4_PHI, D4_DELTA, D4_OMEGA, D4_EPSILON, D4_ANGLES };

extern const double d4_start[D4_ANGLES]; // at rest
extern const double d4_end[D4_ANGLES];   // at 0.03 s: a solution in quadruple precision, good to 28 digits

// y: the crank's angle and rate. Writes its derivative.
void d4_rhs(const double *y, double *dy);
// From rest to 0.03 s by DOP853 at a tolerance. Writes the angles; returns the number of evaluations.
long d4_run(double tolerance, double *angles);

#endif
