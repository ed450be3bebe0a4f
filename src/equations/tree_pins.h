// Open trees of pins alone: the fast path.
#ifndef EQUATIONS_TREE_PINS_H
#define EQUATIONS_TREE_PINS_H
#include "equations/tree_angles.h"

typedef struct YkTreePins YkTreePins;
// Returns NULL when out of memory. Everything is in the arena.
YkTreePins *yk_tree_pins_new(const YkTreeLinks *links, YkVec gravity, YkArena *arena);
// See yk_tree_accelerate. About 180 bytes of memory for each link, read or written in order.
int yk_tree_pins_accelerate(YkTreePins *pins, const double *q, const double *v, const double *effort, double *a);

#endif
