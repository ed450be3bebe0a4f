// Gradients of sums: the unknowns on which a sum depends, as columns in the order in which they are met.
#ifndef EQUATIONS_GRADIENT_H
#define EQUATIONS_GRADIENT_H
#include "equations/elimination.h"

typedef struct YkGradientColumns { // of the present gradient
    int32_t *unknown;
    size_t count, capacity;
    bool failed;
} YkGradientColumns;

// Returns the column of an unknown, added if it is new; YK_NONE for the ground.
int32_t yk_column(YkGradientColumns *columns, int32_t unknown);
// Begin a gradient in the elimination's lists; end it, counting what was added since.
YkGradient yk_gradient_begin(const YkElimination *e);
void yk_gradient_end(YkElimination *e, const YkGradientColumns *columns, YkGradient *gradient);
// Adds a sum turned by the orientation `root` (0: none); root_column gets the contribution of turning the whole.
bool yk_gradient_add_sum(YkElimination *e, YkGradientColumns *columns, const YkSum *sum, int32_t root,
                         int32_t root_column, int32_t row);
bool yk_gradient_add_term(YkElimination *e, YkGradientColumns *columns, YkTerm term, int32_t root, int32_t root_column,
                          int32_t row);

#endif
