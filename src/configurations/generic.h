// All solutions of a generic member of a group's family of systems: where the paths to its poses begin.
#ifndef CONFIGURATIONS_GENERIC_H
#define CONFIGURATIONS_GENERIC_H
#include "configurations/follow.h"

typedef struct YkGeneric {
    YkVec *coefficients; // generic
    YkVec *solutions;    // [count][unknowns]
    size_t count, capacity;
} YkGeneric;

typedef enum YkGenericStatus {
    YK_GENERIC_FULL,
    YK_GENERIC_SHORT,
    YK_GENERIC_STOPPED,
    YK_GENERIC_NO_MEMORY
} YkGenericStatus;

// Makes a start for the coefficients at a pose: invents a solution, chooses the right-hand sides for which it is one,
// and sends it round triangles of right-hand sides until `wanted` solutions are found (monodromy: the solutions of an
// irreducible family permute transitively). wanted 0: unknown; it then ends after several triangles without a new one.
// SHORT: fewer than wanted. The same seed gives the same bits. Source: Duff, Hill, Jensen, Lee, Leykin & Sommars 2019.
YkGenericStatus yk_generic_make(YkGeneric *start, const YkShape *shape, const YkVec *coefficients, size_t wanted,
                                YkPace *pace);
void yk_generic_free(YkGeneric *start);
// Copies a start; `to` is freed first. Returns false when out of memory, with `to` empty.
bool yk_generic_copy(YkGeneric *to, const YkGeneric *from, const YkShape *shape);
// Returns whether two starts are the same.
bool yk_generics_are_same(const YkGeneric *a, const YkGeneric *b, const YkShape *shape);

#endif
