// Solves small dense linear programs.
#ifndef NUM_LINEAR_PROGRAM_H
#define NUM_LINEAR_PROGRAM_H
#include <stdbool.h>
#include <stddef.h>

typedef enum YkLinearStatus { YK_LINEAR_OK, YK_LINEAR_UNBOUNDED, YK_LINEAR_EXHAUSTED } YkLinearStatus;

// Numbers and indices that yk_linear_maximise needs as scratch space, for m rows and n unknowns.
#define YK_LINEAR_WORK(m, n) (((m) + 1) * (2 * (n) + 1))
#define YK_LINEAR_ORDER(m, n) ((m) + 2 * (n))

// Maximises c[n] . x[n] over A[m][n] x <= b[m]; x may have either sign. b >= 0, so the search starts at x = 0. Rows and
// unknowns should be of size 1 or so. YK_LINEAR_UNBOUNDED: there is no largest value. YK_LINEAR_EXHAUSTED: not found in
// a number of steps that has always been enough. Simplex method in dictionary form, Bland's rule (Chvatal 1983,
// chapters 2 and 3).
YkLinearStatus yk_linear_maximise(size_t m, size_t n, const double *A, const double *b, const double *c, double *x,
                                  double *work, size_t *order);

#endif
