// Solves linear systems whose unknowns have bounds, as contact forces have: a stop only pushes, friction holds up to
// its limit.
#ifndef NUM_BOUNDED_H
#define NUM_BOUNDED_H
#include <stdbool.h>
#include <stddef.h>

typedef struct YkBounds {
    double low, high;
} YkBounds;

// Numbers and indices that yk_bounded_solve needs as scratch space.
#define YK_BOUNDED_WORK(n) ((n) * (n) + 4 * (n))
#define YK_BOUNDED_ORDER(n) (2 * (n))

// Finds x[n] within bounds[n] so that r = A x + b is 0, except for unknowns at a bound: there r may be positive at the
// low bound, negative at the high one. A[n][n] is symmetric and positive semidefinite; an unknown without a positive
// diagonal entry stays as it is. x holds a first guess on entry, the solution on return. Returns false when `steps`
// steps were not enough or there is no solution; x is then meaningless. A few sweeps of projected Gauss-Seidel (Moreau;
// Jourdan, Alart & Jean 1998) usually suffice; otherwise an active set follows.
bool yk_bounded_solve(size_t n, const double *A, const double *b, const YkBounds *bounds, int steps, double *x,
                      double *work, size_t *order);

#endif
