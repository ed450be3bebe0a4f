// The matroid of a group's loops: which of its unknowns the loops alone let vary independently.
#ifndef CONFIGURATIONS_MATROID_H
#define CONFIGURATIONS_MATROID_H
#include "configurations/system.h"

// Its elements are the unknowns z_j and y_m = d_m z_j and, last, the constant 1; its bases are those of the linear
// space of all vectors that satisfy the loops. rank[S] is the rank of a set of elements S, one bit for each.
typedef struct YkMatroid {
    size_t elements;     // unknowns + 1
    unsigned char *rank; // [2^elements]
} YkMatroid;

typedef enum YkMatroidStatus { YK_MATROID_MADE, YK_MATROID_UNCLEAR, YK_MATROID_NO_MEMORY } YkMatroidStatus;

// Makes it for the coefficients of the loops at a pose. UNCLEAR: a minor is neither clearly zero nor clearly not, or
// the loops depend on each other. Cost 2^elements small eliminations.
YkMatroidStatus yk_matroid_make(YkMatroid *matroid, const YkShape *shape, const YkVec *coefficients);
void yk_matroid_free(YkMatroid *matroid);

#endif
