// One step of Levenberg and Marquardt within bounds.
#ifndef SYNTHESIS_LEAST_SQUARES_H
#define SYNTHESIS_LEAST_SQUARES_H
#include <stddef.h>

enum { YK_LINEAR_MAX = 32 };

// Misses and their derivatives by n unknowns, at a point within bounds.
typedef struct YkLinear {
    size_t n, rows;                // at most YK_LINEAR_MAX unknowns
    const double *row, *miss;      // [rows][n], [rows]
    const double *at, *low, *high; // [n]
    double *A, *b;                 // scratch: [rows + n][n], [rows + n]
} YkLinear;
// Finds the damped step[n]. Unknowns with an empty range, and those at a bound that the misses push against, are held;
// what would leave its bounds goes there and is held. Cost O(rows n^2), a few times. Source: More 1978.
void yk_linear_step(const YkLinear *linear, double damping, double *step);

#endif
