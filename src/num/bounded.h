// A linear system whose unknowns have bounds, as the forces of contacts have: a stop pushes only, friction holds up to
// its limit.
#ifndef NUM_BOUNDED_H
#define NUM_BOUNDED_H
#include <stdbool.h>
#include <stddef.h>

typedef struct YkBounds {
    double low, high;
} YkBounds;

// Numbers and indices that yk_bounded_solve needs as scratch.
#define YK_BOUNDED_WORK(n) ((n) * (n) + 4 * (n))
#define YK_BOUNDED_ORDER(n) (2 * (n))

// Finds x[n] within bounds[n] so that r = A x + b is 0, but for unknowns at a bound: there r may be positive at the low
// one, negative at the high one. A[n][n] is symmetric and positive semidefinite; an unknown without a positive diagonal
// is left alone. x: in a first guess, out the answer. False where `steps` steps were not enough, or where there is no
// answer: x is none then. A few sweeps of projected Gauss-Seidel (Moreau; Jourdan, Alart & Jean 1998), which most often
// end it, then an active set.
bool yk_bounded_solve(size_t n, const double *A, const double *b, const YkBounds *bounds, int steps, double *x,
                      double *work, size_t *order);

#endif
