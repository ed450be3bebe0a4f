// The N-four-bar by hand: N parallelograms side by side, all rods 1 m and 1 kg.
//
// Angles: cranks from the vertical, clockwise (tip of crank i at (i + sin, cos)); couplers from the horizontal.
#ifndef BENCH_D2_H
#define BENCH_D2_H
#include <stdbool.h>
#include <stddef.h>

// Accelerations by a recursion over the windows: every one is p a0 + r, each window gives the next p and r by a 2 x 2
// solution, and the equation of the one freedom gives a0. Singular where the linkage lies stretched.
// crank[n + 1], coupler[n] and their rates in; a[2 n + 1] out: cranks, then couplers. ratio[2 n + 1]: scratch.
void d2_recursion(size_t n, const double *crank, const double *coupler, const double *crank_rate,
                  const double *coupler_rate, double *a, double *ratio);
// The acceleration of all cranks, from the one equation that the symmetry leaves: the exact value.
double d2_exact(size_t n, double angle);

// What does not know the symmetry and passes the singular positions: an augmented Lagrangian with two corrections,
// pentadiagonal, Runge-Kutta 4 at a fixed step, positions and velocities projected once a step. Bayo & Ledesma 1996.
typedef struct D2Augmented {
    size_t n, unknowns;
    double *q, *w;                                              // crank 0, coupler 0, crank 1, ..., crank n
    double *turn, *mass, *beside, *D, *L1, *L2, *force, *x, *b; // of the system of equations
    double *a, *q_stage, *w_stage, *q_sum, *w_sum;
    void *memory;
} D2Augmented;

bool d2_start(D2Augmented *system, size_t n); // upright, turning at 1 rad/s
void d2_end(D2Augmented *system);
void d2_step(D2Augmented *system, double h);
double d2_energy(const D2Augmented *system);

#endif
