// The reduced equations of motion at a pose: the elimination in numbers. Cost linear in the elimination's size;
// allocates nothing.
#ifndef EQUATIONS_REDUCED_H
#define EQUATIONS_REDUCED_H
#include "equations/coefficients.h"
#include "loads/loads.h"

typedef struct YkReduced {
    const YkElimination *e;
    double *H;     // [entry] the form
    double *N;     // [entry] in doubt: the noise of H, in units of the relative rounding error; see tree_noise.h
    double *lost;  // [unknown] about how much was subtracted from its diagonal
    double *g;     // [unknown] the forces
    double *xi;    // [unknown] accelerations relative to those of the pose
    double *C;     // [coefficient]
    double *B, *G; // rows of the present operation
    YkCoefficients work;
    bool is_in_doubt, measures; // a pivot is small for what was lost: the noise is measured too, in a second pass
    void *memory;
} YkReduced;

YkReduced *yk_reduced_new(const YkElimination *elimination);
void yk_reduced_free(YkReduced *reduced);
// Assembles inertia and loads at the pose of the space (lane 0), whose accelerations are those for all free inputs at
// 0, and eliminates. loads[body] without gravity, or NULL: none. Returns -1; otherwise the input of a freedom without
// inertia, or -2 at a singular group.
int yk_reduced_factor(YkReduced *reduced, const YkSpace *space, const YkLoad *loads);
// Finds the accelerations of the free inputs; the other entries stay. all: also finds xi of every unknown.
void yk_reduced_solve(YkReduced *reduced, double *acceleration, bool all);
// Returns what a prescribed input's drive exerts (after yk_reduced_solve with all).
double yk_reduced_effort(const YkReduced *reduced, size_t input);
// Solves with the same factors and other forces: a unit effort between two unknowns (a torque on b, its reaction on a),
// or on one. Sets xi of every unknown to the response.
void yk_reduced_respond(YkReduced *reduced, int32_t unknown_b, int32_t unknown_a);

#endif
