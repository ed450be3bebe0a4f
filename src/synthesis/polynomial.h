// Roots of small polynomials, and the points where two conics meet.
#ifndef SYNTHESIS_POLYNOMIAL_H
#define SYNTHESIS_POLYNOMIAL_H
#include <stdbool.h>
#include <stddef.h>
#include "base/vec.h"

enum { YK_DEGREE_MAX = 8 };

// Finds the roots of c[0] + c[1] x + ... + c[degree] x^degree, complex, each refined by Newton's method. Leading
// coefficients that are 0 beside the largest lower the degree. Returns their number; 0 if all coefficients are 0.
// Source: eigenvalues of the companion matrix.
size_t yk_roots(const double *c, size_t degree, YkVec *root);

// A conic sum of q[i][j] c_i c_j over i <= j, in homogeneous coordinates c_0, c_1, c_2.
typedef struct YkConic {
    double q[3][3];
} YkConic;
// Finds the points where two conics meet, as complex vectors c[3] of length about 1. Returns their number, at most 4;
// 5 if the conics share a part.
size_t yk_conics_meet(const YkConic *first, const YkConic *second, YkVec point[4][3]);

#endif
