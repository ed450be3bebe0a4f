// The coefficients of a step at a pose: the unknowns that it defines, as a linear function of earlier unknowns.
#ifndef EQUATIONS_COEFFICIENTS_H
#define EQUATIONS_COEFFICIENTS_H
#include "equations/elimination.h"
#include "solve/space.h"

// Scratch memory.
typedef struct YkCoefficients {
    const YkElimination *e;
    YkVec *column;           // gradient of the present sum
    double *D, *K, *tau, *x; // groups
    int *pivot;
    size_t *order;
    void *memory;
} YkCoefficients;

// Returns false when out of memory.
bool yk_coefficients_start(YkCoefficients *work, const YkElimination *elimination);
void yk_coefficients_end(YkCoefficients *work);
// Finds C[own][given] of the operation, which must not be FREE or KNOWN: U = C W. Returns false if it is singular.
// Cost: that of its gradient; for groups cubic in their unknowns. Allocates nothing.
bool yk_coefficients_find(const YkCoefficients *work, const YkSpace *space, const YkOperation *op, double *C);

#endif
