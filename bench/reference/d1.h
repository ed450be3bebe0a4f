// The double pendulum of examples/double-pendulum.yaml, by hand: equations in closed form.
#ifndef BENCH_D1_H
#define BENCH_D1_H

// y: theta1 from the downward vertical, theta2 relative, their rates; tau: torques along both. Writes the derivative of
// y.
void d1_rhs(const double *y, const double *tau, double *dy);
// y from 0 to `end` by DOP853 at a relative and absolute tolerance, without torques. Returns the number of evaluations.
long d1_run(double *y, double end, double tolerance);
// Kinetic and potential energy, J; potential 0 at the pivot's height.
double d1_energy(const double *y);

#endif
