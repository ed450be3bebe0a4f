// How far the loops of the tree are from closing, and their Jacobian: all variables at once, for small machines.
#ifndef COMPILE_CLOSURE_H
#define COMPILE_CLOSURE_H
#include "compile/mechanism.h"

// Variables x: angles of orientations 1.. then distances. residual[2 loops]; jacobian[2 loops][variables] row-major, or NULL.
void yk_closure(const YkMechanism *mech, const double *x, double *residual, double *jacobian);
static inline size_t yk_variable_count(const YkMechanism *mech) { return mech->orientation_count - 1 + mech->distance_count; }
// Guesses from `start:` (unknown ones 0), mapped to variables along the tree.
void yk_closure_guess(const YkMechanism *mech, const double *coordinates, double *x);
// Freedom by rank: assembles from the guesses and from perturbed ones, and takes the largest rank of the loops' Jacobian.
// Accepts further inputs of `candidates` that are independent; sets accepted[k]. -1 when it never closes or memory ran out.
// Dense: for machines up to YK_CLOSURE_MAX variables.
enum { YK_CLOSURE_MAX = 300 };
int yk_closure_freedom(const YkMechanism *mech, const double *guess, const int32_t *candidates, size_t count, bool *accepted);

#endif
