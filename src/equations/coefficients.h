// The coefficients of a step at a pose: what it defines, as a linear function of earlier unknowns.
#ifndef EQUATIONS_COEFFICIENTS_H
#define EQUATIONS_COEFFICIENTS_H
#include "equations/elimination.h"
#include "solve/space.h"

// Room to work in.
typedef struct YkCoefficients {
    const YkElimination *e;
    YkVec *column;           // gradient of the sum in work
    double *D, *K, *tau, *x; // groups
    int *pivot;
    size_t *order;
    void *memory;
} YkCoefficients;

// False when out of memory.
bool yk_coefficients_start(YkCoefficients *work, const YkElimination *elimination);
void yk_coefficients_end(YkCoefficients *work);
// C[own][given] of the operation, which is not FREE or KNOWN: U = C W. False where it is singular. Cost: that of its
// gradient; groups: cubic in their unknowns. Allocates nothing.
bool yk_coefficients_find(const YkCoefficients *work, const YkSpace *space, const YkOperation *op, double *C);

#endif
