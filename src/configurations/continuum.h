// Finds whether a pose belongs to a continuum of poses with the same inputs, and its dimension.
//
// The equations of a machine are its loops, its gears and its inputs. If the rank of their Jacobian is below the number
// of unknowns, a pose is a dead point, or the machine can move: short steps along the kernel, closed again by Gauss and
// Newton's method, show which. The rank bounds the dimension from above, and is proved with an approximate left
// inverse. It is bounded from below, with proof, where bodies that keep their angle to each other make loops repeat
// each other, as those of parallelograms do: what is left of the equations has full rank, and the implicit function
// theorem holds.
#ifndef CONFIGURATIONS_CONTINUUM_H
#define CONFIGURATIONS_CONTINUUM_H
#include <yoke/configurations.h>
#include "solve/state.h"

// The room for the equations of one machine, and continua that were found.
typedef struct YkContinua {
    const YkMechanism *mech;
    size_t rows, columns, rank, kept, kept_capacity;
    double *x0, *F, *A, *tau, *b, *step, *kernel, *samples; // of the pose in question
    size_t *order, *body, sample_count;
    bool failed;   // memory ran out
    double *poses; // [kept][columns]: one pose of each continuum
    size_t *dimension;
} YkContinua;

// Makes the room. Returns false when out of memory. No machine with laws among its relations, or of more than 100
// unknowns, has any: its continua are not looked for.
bool yk_continua_start(YkContinua *continua, const YkMechanism *mech);
void yk_continua_end(YkContinua *continua);
// Finds the continuum of a state's pose; of dimension 0 if none is found. *is_new: no pose of the same continuum was
// asked for since it was cleared (kept = 0). Returns false when out of memory.
// Cost: some hundred factorisations of all equations at a singular pose, one at any other.
bool yk_continuum_at(YkContinua *continua, const YkState *state, YkContinuum *continuum, bool *is_new);

#endif
