// Random points of the machine's motion over the prime field: what their files share: loop_point.c, loop_close.c
// (angles and lengths that close the loops), loop_assembly.c (is it the machine's own assembly?).
#ifndef PROVE_LOOP_POINT_H
#define PROVE_LOOP_POINT_H
#include "derive/blocks.h"
#include "prove/check.h"

// On one assembly of a machine angles may be bound that are free on another: in a parallelogram with the same symbol
// for both cranks these stay parallel, and the other assembly, the contra-parallelogram, is another machine. A bond is
// a sum of whole multiples of the tree's angles that keeps its value, turns * 15 deg; its pivot's factor is 1, and 0 in
// all others.
typedef struct YkLoopBond {
    int32_t pivot; // a coordinate
    int32_t turns;
    int32_t *factor; // [tree_count]
} YkLoopBond;
typedef struct YkLoopBonds {
    YkLoopBond *bond;
    size_t count;
} YkLoopBonds;

// Makes a random point of the machine's motion on such an assembly (NULL: no bonds), dimensions included, over the
// prime field. Returns NULL if none could be made (*is_possible false) or when out of memory. *rank: of the equations
// for what enters the loops linearly; -1 if these do not close. Free it with yk_field_point_free.
YkFieldPoint *yk_derive_assembly_point(YkDerivation *d, const YkLoopBonds *bonds, uint64_t seed, int *rank,
                                       bool *is_possible);

// Linear equations for symbols: in row r, rest + sum of slope * symbol = 0.
typedef struct YkLoopEntry {
    int32_t unknown; // in the list of these
    const YkPoisson *slope;
} YkLoopEntry;
typedef struct YkLoopRow {
    const YkPoisson *rest; // without the unknowns, unless the row is not split
    size_t first;          // its entries; they end where those of the next row begin
    bool is_split;
} YkLoopRow;
typedef struct YkLoopSystem {
    const int32_t *unknowns; // symbols
    size_t unknown_count, row_count;
    YkLoopRow *rows; // [row_count + 1]
    YkLoopEntry *entries;
    size_t held; // rows of what locks hold
} YkLoopSystem;

// The plan: what closes the loops, what moves them, what accelerates them and acts on them. It lies in the derivation's
// arena, made at first use and again when sections have added relations; NULL when out of memory (loop_plan.c).
typedef struct YkLoopPlan {
    YkLoopSystem closing, rates, accelerations;
    size_t relations, unknowns;
} YkLoopPlan;
const YkLoopPlan *yk_loop_plan(YkDerivation *d);
// Returns whether points would take more than a second, because of the number of unknowns.
bool yk_loop_is_large(const YkDerivation *d);

typedef struct YkLoopMaking {
    YkDerivation *d;
    YkFieldPoint *point;
    const YkDeriveBlocks *blocks;
    const YkLoopPlan *plan;
    const YkLoopBonds *bonds;
    int rank;
    bool is_possible, failed;
} YkLoopMaking;

static inline uint64_t yk_loop_field(const YkLoopMaking *making, const YkPoisson *a)
{
    return yk_ring_field(making->d->ring, a, making->point, false);
}

// --- loop_close.c
void yk_loop_close_angles(YkLoopMaking *making); // by bonds, or by slides and welds that close loops
// Finds the symbols for which they are solved: all that enter them linearly. Returns the count; unknowns has room for
// all coordinates and parameters.
size_t yk_loop_linear(YkDerivation *d, const YkDeriveBlocks *blocks, int32_t *unknowns);

// --- loop_assembly.c
// Returns whether the points of that rank with these bonds lie on the machine's assembly at the pose of these values.
// pose of these values?
bool yk_loop_is_assembly(YkDerivation *d, const YkLoopBonds *bonds, int rank, const double *values);

#endif
