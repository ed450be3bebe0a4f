// What the files share that make random points of the machine's motion over the prime field: loop_point.c, loop_close.c
// (angles and lengths that close the loops), loop_assembly.c (is it the machine's own assembly?).
#ifndef DERIVE_LOOP_POINT_H
#define DERIVE_LOOP_POINT_H
#include "derive/blocks.h"
#include "derive/check.h"

// On one assembly of a machine angles may be bound that are free on another: in a parallelogram with the same symbol
// for both cranks these stay parallel, and what is left, the contra-parallelogram, is another machine. A bond is a sum
// of whole multiples of the tree's angles that stays turns * 15 deg; its pivot's factor is 1, and 0 in all others.
typedef struct YkLoopBond {
    int32_t pivot; // a coordinate
    int32_t turns;
    int32_t *factor; // [tree_count]
} YkLoopBond;
typedef struct YkLoopBonds {
    YkLoopBond *bond;
    size_t count;
} YkLoopBonds;

// yk_derive_loop_point on such an assembly (NULL: no bonds). *rank: of the equations for what enters the loops
// linearly.
YkFieldPoint *yk_derive_assembly_point(YkDerivation *d, const YkLoopBonds *bonds, uint64_t seed, int *rank,
                                       bool *is_possible);

typedef struct YkLoopMaking {
    YkDerivation *d;
    YkFieldPoint *point;
    const YkDeriveBlocks *blocks;
    const YkLoopBonds *bonds;
    int rank;
    bool is_possible, failed;
} YkLoopMaking;

static inline uint64_t yk_loop_field(const YkLoopMaking *making, const YkPoisson *a)
{
    return yk_ring_field(making->d->ring, a, making->point, false);
}

// Solves rows `zero` of the ring, affine in the unknown symbols, over the field; false where they contradict each
// other.
bool yk_loop_solve(YkLoopMaking *making, const YkPoisson *const *zeros, size_t rows, const int32_t *unknowns,
                   size_t count, int *rank);

// --- loop_close.c
bool yk_loop_is_defined(YkDerivation *d, size_t parameter); // by others, or in a definition
void yk_loop_close_angles(YkLoopMaking *making);            // by bonds, or by slides and welds that close loops
void yk_loop_close(YkLoopMaking *making);                   // all rows, for what enters them linearly
// The symbols for which they are solved: all that enter them linearly. Returns the count; unknowns has room for all
// coordinates and parameters.
size_t yk_loop_linear(YkDerivation *d, const YkDeriveBlocks *blocks, int32_t *unknowns);

// --- loop_assembly.c: do the points of that rank with these bonds lie on the assembly on which the machine is at the
// pose of these values?
bool yk_loop_is_assembly(YkDerivation *d, const YkLoopBonds *bonds, int rank, const double *values);

#endif
