// The elementary functions: sin to erfc, with the same bits from every compiler, C library and processor.
//
// They take what the C standard lets <math.h> take and answer as its annex F says: NaN where there is no value,
// infinities, signed zeros, exact cases exact. No errno, no flags. Each is within 1 unit in the last place
// everywhere; README.md has the measurements. Functions that IEEE 754 fixes to the bit - sqrt, fabs, floor, rint,
// ldexp, fma and the like - come from the C library.
#ifndef ELEMENTARY_ELEMENTARY_H
#define ELEMENTARY_ELEMENTARY_H
#include <stddef.h>

double yk_sin(double x);
double yk_cos(double x);
// Both at once, with the bits of yk_sin and yk_cos.
void yk_sincos(double x, double *s, double *c);
// n of them, with the same bits.
void yk_sincos_lanes(const double *x, double *s, double *c, size_t n);
double yk_tan(double x);

double yk_asin(double x);
double yk_acos(double x);
double yk_atan(double x);
double yk_atan2(double y, double x);

double yk_exp(double x);
double yk_exp2(double x);
double yk_log(double x);
double yk_log2(double x);
double yk_log10(double x);
double yk_pow(double x, double y);

double yk_sinh(double x);
double yk_cosh(double x);
double yk_tanh(double x);

double yk_hypot(double x, double y);
double yk_erfc(double x);
// x less a multiple of y, exactly: the one nearest to zero with the sign of x, and the one nearest to zero.
double yk_fmod(double x, double y);
double yk_remainder(double x, double y);

#endif
