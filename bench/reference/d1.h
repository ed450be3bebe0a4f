// The double pendulum of examples/double-pendulum.yaml, by hand: equations in closed form.
#ifndef BENCH_D1_H
#define BENCH_D1_H
#include <stddef.h>

// y: theta1 from the downward vertical, theta2 relative, their rates; tau: torques along both. Writes the derivative of
// y.
void d1_rhs(const double *y, const double *tau, double *dy);
// y from 0 to `end` by DOP853 at a relative and absolute tolerance, without torques. Returns the number of evaluations.
long d1_run(double *y, double end, double tolerance);
// Kinetic and potential energy, J; potential 0 at the pivot's height.
double d1_energy(const double *y);

// Many states, each with its own parameters, in structure of arrays.
typedef struct D1States {
    const double *theta1, *theta2, *rate1, *rate2, *l1, *lc1, *lc2, *m1, *m2, *I1, *I2;
} D1States;
// Their accelerations under the file's torques and gravity: d1_simd.c.
void d1_simd(const D1States *states, double *a1, double *a2, size_t n);

#endif
