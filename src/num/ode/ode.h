// Ordinary differential equations y' = f(t, y): steppers with error control and dense output. Memory is allocated at
// the start only.
#ifndef NUM_ODE_H
#define NUM_ODE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/archive.h"

typedef enum YkOdeMethod {
    YK_ODE_DOP853, // Dormand & Prince 8(5,3) with dense output of order 7. Hairer, Norsett & Wanner 1993, II.10
    YK_ODE_SDIRK4, // L-stable, singly diagonally implicit, order 4(3). Hairer & Wanner 1996, IV.6
    YK_ODE_RK4     // the classical method at a fixed step; dense output by cubic Hermite
} YkOdeMethod;

typedef enum YkOdeStatus {
    YK_ODE_OK = 0,
    YK_ODE_STEP_TOO_SMALL = -1, // below 1e-14 of the span (or of |t|)
    YK_ODE_FAILED = -2,         // f failed even at the smallest steps, or could not be evaluated at the start
    YK_ODE_NO_MEMORY = -3
} YkOdeStatus;

// Writes dydt[n] at (t, y). Returns 0 if it can; otherwise the step is rejected and tried again with a quarter of its
// length (with a fixed step the run fails).
typedef int (*YkOdeFunction)(void *context, double t, const double *y, double *dydt);

typedef struct YkOdeOptions {
    YkOdeMethod method;
    double relative, absolute; // error allowed per component: absolute + relative |y|, as root mean square over the
                               // first `controlled` components
    const double *scale;       // [n]: sizes that `absolute` multiplies (NULL: 1)
    size_t controlled; // components from this index on are quadratures, carried along without error control (0: all n)
    double first_step; // 0: chosen automatically (Hairer's starting step)
    double largest_step; // 0: no limit
    double fixed_step;   // for RK4
} YkOdeOptions;

typedef struct YkOde YkOde;
// Returns NULL when out of memory, or if the options make no sense (n = 0, negative numbers, no tolerance, RK4 without
// its step). Copies options and scale. SDIRK4 holds two matrices of n^2; the others about 25 n numbers.
YkOde *yk_ode_new(size_t n, const YkOdeOptions *options, YkOdeFunction f, void *context);
void yk_ode_free(YkOde *ode);
// Writes a stepper, or reads it into one made with the same options: it goes on with the same bits.
void yk_ode_archive(YkOde *ode, YkArchive *archive);
// Gives f another context: whoever owns the stepper has moved.
void yk_ode_set_context(YkOde *ode, void *context);
// Starts or restarts at (t, y), towards t_end (which may lie before t). Evaluates f once. With `keep_step` it continues
// with the current step size (after a small change of y) instead of choosing anew. Returns YK_ODE_FAILED when f fails
// here.
YkOdeStatus yk_ode_start(YkOde *ode, double t, const double *y, double t_end, bool keep_step);
// Moves the end without restarting.
void yk_ode_set_end(YkOde *ode, double t_end);
// Makes one accepted step, not beyond the end; does nothing at the end. Repeats rejected steps with smaller ones
// inside. When it fails, time and state stay those of the last accepted step, but values within that step are no longer
// available.
YkOdeStatus yk_ode_step(YkOde *ode);
// Returns the length of the step that will be tried next, at most; 0 if it is not known.
double yk_ode_length(const YkOde *ode);
double yk_ode_time(const YkOde *ode);         // the end of the last accepted step
double yk_ode_previous(const YkOde *ode);     // the start of that step
const double *yk_ode_state(const YkOde *ode); // y at yk_ode_time
const double *yk_ode_rate(const YkOde *ode);  // f there (up to date)
// Computes y anywhere in the last step by dense output; the same bits as the states at its two ends. The first call
// after a step makes the coefficients (DOP853: three more evaluations). Returns YK_ODE_FAILED when those fail, and
// outside the step.
YkOdeStatus yk_ode_dense(YkOde *ode, double t, double *y);
typedef struct YkOdeCounts {
    size_t steps, rejected, evaluations, jacobians;
} YkOdeCounts;
YkOdeCounts yk_ode_counts(const YkOde *ode);

#endif
