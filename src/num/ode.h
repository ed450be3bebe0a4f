// Ordinary differential equations y' = f(t, y): steppers with error control and dense output. Allocates at the start
// only.
#ifndef NUM_ODE_H
#define NUM_ODE_H
#include <stdbool.h>
#include <stddef.h>

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

// dydt[n] at (t, y). Returns 0; otherwise the step is rejected and tried again with a quarter of its length (fixed
// step: the run fails).
typedef int (*YkOdeFunction)(void *context, double t, const double *y, double *dydt);

typedef struct YkOdeOptions {
    YkOdeMethod method;
    double relative, absolute; // error allowed per component: absolute + relative |y|; root of the mean square over the
                               // first `controlled` components
    const double *scale;       // [n]: sizes that `absolute` is taken of (NULL: 1)
    size_t controlled;   // components from this on are quadratures: carried along without error control (0: all n)
    double first_step;   // 0: chosen (Hairer's starting step)
    double largest_step; // 0: none
    double fixed_step;   // RK4
} YkOdeOptions;

typedef struct YkOde YkOde;
// NULL when out of memory, or with options that make no sense (n = 0, negative numbers, no tolerance, RK4 without its
// step). Options and scale are copied. SDIRK4 holds two matrices of n^2; the others about 25 n numbers.
YkOde *yk_ode_new(size_t n, const YkOdeOptions *options, YkOdeFunction f, void *context);
void yk_ode_free(YkOde *ode);
// (Re)starts at (t, y), towards t_end (which may lie before t). Evaluates f once. `keep_step`: go on with the step size
// in use (after a small change of y) instead of choosing anew. YK_ODE_FAILED when f fails here.
YkOdeStatus yk_ode_start(YkOde *ode, double t, const double *y, double t_end, bool keep_step);
// Moves the end without restarting.
void yk_ode_set_end(YkOde *ode, double t_end);
// One accepted step, not beyond the end; at the end nothing is done. Rejected steps are repeated with smaller ones
// inside. When it fails time and state stay those of the last accepted step, but that step can no longer be looked
// into.
YkOdeStatus yk_ode_step(YkOde *ode);
double yk_ode_time(const YkOde *ode);         // of the last accepted step
double yk_ode_previous(const YkOde *ode);     // where that step began
const double *yk_ode_state(const YkOde *ode); // y at yk_ode_time
const double *yk_ode_rate(const YkOde *ode);  // f there (fresh)
// y anywhere in the last step, by dense output; the same bits as the states at its two ends. The coefficients are made
// at the first call after a step (DOP853: three more evaluations). YK_ODE_FAILED where those fail, and outside the
// step.
YkOdeStatus yk_ode_dense(YkOde *ode, double t, double *y);
typedef struct YkOdeCounts {
    size_t steps, rejected, evaluations, jacobians;
} YkOdeCounts;
YkOdeCounts yk_ode_counts(const YkOde *ode);

#endif
