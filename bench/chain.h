// The quick-return as a chain of kernels: what the engine's step runner does, without the runner.
#ifndef BENCH_CHAIN_H
#define BENCH_CHAIN_H
#include <stddef.h>

#define CHAIN_BLOCK 96 // poses solved together: all lanes stay in the first-level cache

// out[k][pose]: theta2 d3 theta4 d5, their rates, their accelerations; theta1 in rad, its rate w and acceleration al.
void chain_run(const double *theta1, double w, double al, double *const *out, size_t count);
// The same, one pose a call.
void chain_run_singly(const double *theta1, double w, double al, double *const *out, size_t count);

#endif
