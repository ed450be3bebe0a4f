// Pieces in real unknowns: groups with gears, belts or racks among their equations, and gears that turn by a fraction
// of an angle that loops place. Angles count modulo 2 pi: over all turns of the wheels that their meshes allow.
#ifndef MAP_MESHED_H
#define MAP_MESHED_H
#include "configurations/exclude.h"
#include "map/piece.h"
#include "solve/state.h"

typedef struct YkMeshed {
    YkGeared geared; // how the relations depend on the unknowns; at the last pose that was solved
    bool is_listed;  // all solutions are known in closed form
    YkExcluded found;
} YkMeshed;

// Reads the group, or the gear, that a step of the piece's mechanism solves, at a state that stands. Returns false if
// it is not of this kind, or when out of memory.
bool yk_meshed_read(YkPiece *piece, const YkState *start, size_t step, bool *out_of_memory);
void yk_meshed_free(YkMeshed *meshed);
// Computes a relation at what is known: its factors [unknowns], and the rest.
void yk_meshed_row(const YkMeshed *meshed, const YkDiscs *discs, size_t relation, YkDual *row);
// Finds all real solutions at coefficients. *all: whether they are proved to be all. Returns false when out of memory.
bool yk_meshed_solve(YkPiece *piece, const YkDiscCoefficients *coefficients, YkPace *pace, bool *all);
// Takes coefficients, as wide as they are, into `geared`. Returns false if the loops do not bound all distances.
bool yk_meshed_take(YkMeshed *meshed, const YkDiscCoefficients *coefficients);
size_t yk_meshed_count(const YkPiece *piece);
void yk_meshed_solution(const YkPiece *piece, size_t index, YkVec *x);
// Returns whether the relations are the same after whole turns of an input, `turns` of them.
bool yk_meshed_repeats(const YkMeshed *meshed, const YkMechanism *mech, int32_t input, int turns);

#endif
