// Forces by hand: the planetary gear of examples/planetary-gear.yaml, the cam of examples/valve-cam.yaml.
#ifndef BENCH_TRAIN_FORCES_H
#define BENCH_TRAIN_FORCES_H
#include <stddef.h>

// S x, y; C x, y; P x, y; R x, y, moment; torque of the sun.
enum { PLANETARY_FORCES = 10 };
void planetary_forces(const double *theta, const double *rate, const double *accel, double *const *out, size_t n);
// C x, y; V x, moment; torque of the camshaft; for any angle.
enum { VALVE_FORCES = 5 };
void valve_forces(const double *theta, const double *rate, const double *accel, double *const *out, size_t n);

#endif
