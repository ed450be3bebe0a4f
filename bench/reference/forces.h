// Forces by hand: the quick-return of bench/machines/quick-return-forces.yaml.
#ifndef BENCH_FORCES_H
#define BENCH_FORCES_H
#include <stddef.h>

// O1 x, y; O2 x, y; S x, y, moment; A x, y; B x, y; C x, y; R y; torque: of the first body on the second.
enum { QUICK_RETURN_FORCES = 15 };
// Each pose has a rate and an acceleration of its own, as in yk_batch_run.
void quick_return_forces(const double *theta, const double *rate, const double *accel, double *const *out,
                         size_t n);                                                 // SIMD
void quick_return_forces_one(double theta, double rate, double accel, double *out); // scalar, libm

#endif
