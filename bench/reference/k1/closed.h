// The hand-written closed forms, by name: scalar with libm, SIMD with own elementary functions, and long double.
#ifndef BENCH_CLOSED_H
#define BENCH_CLOSED_H
#include "whitworth.h"

void closed_scalar(double t1, double w, double al, double *o);
void closed_long(long double t1, long double w, long double al, long double *o);
void simd_own(const double *t1, double w, double al, double *const *out, int n);

#endif
