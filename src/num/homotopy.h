// Follows a solution of complex equations while their coefficients change: Runge and Kutta's method of order 4 on
// Davidenko's equation predicts, Newton's method corrects, and the step adapts to what the first correction finds.
// Source: Allgower & Georg 1990, Numerical Continuation Methods, ch. 6.
#ifndef NUM_HOMOTOPY_H
#define NUM_HOMOTOPY_H
#include <stdbool.h>
#include <stddef.h>
#include "base/vec.h"

enum { YK_HOMOTOPY_UNKNOWNS = 16 };

// The equations of n unknowns, each a complex number as a vector, along a way from t = 0 to 1.
typedef struct YkHomotopy {
    size_t n; // at most YK_HOMOTOPY_UNKNOWNS
    void *context;
    void (*go_to)(void *context, double t);                      // the others work with the coefficients there
    bool (*tangent)(void *context, const YkVec *x, YkVec *rate); // dx/dt; false if it is not determined
    double (*correct)(void *context,
                      YkVec *x); // takes a step of Newton's method; returns its relative size, or infinity
    bool (*goes_on)(void *context, const YkVec *x); // asked before each step
    double first_step, least_step;
    int steps;              // at most
    double enough, at_most; // sizes of corrections: none is needed after `enough`, and the last may be `at_most`
} YkHomotopy;

// Follows x from t = 0 to 1. Returns false if the step falls below `least_step`, after too many steps, or when told not
// to go on; x is then somewhere on the way. Allocates nothing.
bool yk_homotopy_follow(const YkHomotopy *homotopy, YkVec *x);

// Takes up to `most` steps of Newton's method, until one is below 1e-15 or not below the one before: rounding is
// reached then, and x is as it was before that step. Returns the size of the last step that counts.
double yk_homotopy_polish(const YkHomotopy *homotopy, int most, YkVec *x);

#endif
