// Forces by hand: Watt's six-bar of examples/watt-with-masses.yaml, Andrews' mechanism of examples/andrews.yaml.
#ifndef BENCH_LINKAGE_FORCES_H
#define BENCH_LINKAGE_FORCES_H
#include <stddef.h>

// A x, y; B; C; D; E; F; G; torque: what the first body of each pin exerts on the second.
enum { WATT_FORCES = 15 };
void watt_forces(const double *alpha, const double *rate, const double *accel, double *const *out, size_t n);
// O x, y; F; B; A5; G; A7; H; E2; E4; E6; torque, besides the constant effort of the file.
enum { ANDREWS_FORCES = 21 };
void andrews_forces(const double *beta, const double *rate, const double *accel, double *const *out, size_t n);

#endif
