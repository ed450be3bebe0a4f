// A hanging chain of uniform rods (1 m, 1 kg), by hand: the planar articulated-body recursion in absolute angles.
#ifndef BENCH_D3_H
#define BENCH_D3_H
#include <stddef.h>

typedef struct D3Link {
    double ex, ey, over_J, hx, hy, u;
} D3Link;

// theta[n] from the downward vertical and w[n], absolute. Writes alpha[n], absolute. link[n]: scratch.
void d3_chain(size_t n, const double *theta, const double *w, double *alpha, D3Link *link);
// The same; sines are found first, many at a time, for moderate angles (absolute error 7e-16 up to 17 rad). sine[2 n]:
// scratch.
void d3_chain_lanes(size_t n, const double *theta, const double *w, double *alpha, D3Link *link, double *sine);

#endif
