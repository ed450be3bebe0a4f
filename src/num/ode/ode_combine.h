// The inner loop of every explicit stage, for few components and for very many.
#ifndef NUM_ODE_COMBINE_H
#define NUM_ODE_COMBINE_H
#include <stddef.h>

enum { YK_ODE_MOST_TERMS = 9 };

// Computes z[n] = y + h (a[0] k[of[0]] + a[1] k[of[1]] + ...), all slopes of a component at once, so that every array
// passes the processor once. `terms` is 1 .. YK_ODE_MOST_TERMS; z must not overlap y or the slopes k[...][n].
void yk_ode_combine(size_t n, size_t terms, const double *a, const size_t *of, const double *const *k, double h,
                    const double *y, double *z);

#endif
