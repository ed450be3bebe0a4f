// Shared by the files of a continuum.
#ifndef CONFIGURATIONS_CONTINUUM_INSIDE_H
#define CONFIGURATIONS_CONTINUUM_INSIDE_H
#include "configurations/continuum.h"

enum { YK_CONTINUUM_SAMPLES = 16 }; // poses that show which bodies keep their angle

// --- continuum_equations.c
double yk_continuum_unit(const YkContinua *continua, size_t column); // of an unknown: 1 rad, or the size
// Evaluates all equations at x, over the size: c->F, and c->A with distances over the size. Returns their miss.
double yk_continuum_evaluate(YkContinua *continua, const double *x);
// Moves x to a pose, by Gauss and Newton's method. Returns whether it closes.
bool yk_continuum_close(YkContinua *continua, double *x, double *miss);
// Computes the kernel at x: c->kernel[dimension][columns], each of size 1. Returns the dimension.
size_t yk_continuum_kernel(YkContinua *continua, const double *x);
// Returns how far apart two poses are: the largest difference, rad up to turns, or sizes.
double yk_continuum_apart(const YkContinua *continua, const double *x, const double *y);

// --- continuum_bound.c
// Bounds the dimension at x, a pose at which the kernel is that of the samples, from both sides.
void yk_continuum_bound(YkContinua *continua, const double *x, YkContinuum *found);
// Returns whether a way along the continuum from x to y was found.
bool yk_continuum_joins(YkContinua *continua, const double *x, const double *y, size_t dimension);

#endif
