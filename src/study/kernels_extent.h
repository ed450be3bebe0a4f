// The least, the largest and the sum of a row of numbers.
#ifndef STUDY_KERNELS_EXTENT_H
#define STUDY_KERNELS_EXTENT_H
#include <stddef.h>

// Takes the numbers of a row into an extent. The sum is taken in eight parts, always in the same order, so that it has
// the same bits on any machine.
void yk_lanes_extent(double *least, double *largest, double *sum, const double *row, size_t n);

#endif
