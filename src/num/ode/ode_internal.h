// Shared by the steppers: the memory of a run, and the operations of each method that ode_step.c needs.
#ifndef NUM_ODE_INTERNAL_H
#define NUM_ODE_INTERNAL_H
#include <float.h>
#include <math.h>
#include "num/ode/ode.h"

enum { YK_ODE_MOST_STAGES = 16, YK_ODE_MOST_DENSE = 7 };

typedef enum YkOdeTrial {
    YK_TRIAL_DONE,     // the candidate z and its error are valid
    YK_TRIAL_F_FAILED, // f failed, or was not finite
    YK_TRIAL_DIVERGED  // Newton did not converge
} YkOdeTrial;

// Newton's iteration of the implicit method. m = controlled.
typedef struct YkOdeNewton {
    double *J;        // [m][n]: row j begins with df/dy_j (f has all n components)
    double *E;        // [m][m]: LU of I - h gamma J
    double *residual; // [m], then the correction
    double *guess;    // [n]
    double *scratch;  // [m]
    int *pivot;       // [m]
    double factored;  // the h in E; 0: none
    double speed;     // eta of the last stage: the ratio of the remaining error to the last correction
    double slowest;   // the worst rate of convergence in this step
    bool known;       // J has been computed
    bool fresh;       // ... at the present t and y
} YkOdeNewton;

struct YkOde {
    YkOdeOptions options;
    size_t n, controlled;
    size_t room; // n, up to the next whole pair: columns have that many components, of which the last may not count
    YkOdeFunction f;
    void *context;
    double t, previous, start, end;
    double direction; // of time: +1, -1; 0 until an end is set
    double h;         // length of the next step, > 0; 0: to be chosen
    double length;    // signed length of the last step; 0: there is none
    double grid;      // fixed step: where the equal steps began ...
    double even;      // ... and how many there have been since
    bool started, dense_ready;
    YkOdeCounts counts;
    double *floor;                      // [controlled] the error allowed where y = 0
    double *y, *rate;                   // [n] at t
    double *y_previous, *rate_previous; // [n] at previous
    double *z, *z_rate;                 // [n] the candidate, and f there
    double *stage[YK_ODE_MOST_STAGES];  // [n] slopes
    double *dense[YK_ODE_MOST_DENSE];   // [n] coefficients
    YkOdeNewton newton;
    void *memory;
};

static const size_t yk_ode_in_order[] = {0, 1, 2, 3, 4};

// Returns whether v[n] has no NaN and no infinity.
static inline bool yk_ode_finite(size_t n, const double *v)
{
    int bad = 0;
    for (size_t j = 0; j < n; j++) bad |= !(fabs(v[j]) <= DBL_MAX);
    return !bad;
}
static inline bool yk_ode_evaluate(YkOde *ode, double t, const double *y, double *dydt)
{
    ode->counts.evaluations++;
    return ode->f(ode->context, t, y, dydt) == 0;
}
// Returns the error allowed in component j (< controlled) of a step from a to b; never 0.
static inline double yk_ode_allowed(const YkOde *ode, size_t j, double a, double b)
{
    double size = fabs(a) > fabs(b) ? fabs(a) : fabs(b), allowed = ode->floor[j] + ode->options.relative * size;
    return allowed > DBL_MIN ? allowed : DBL_MIN;
}

// Tries a step of signed length h from (t, y) to t_new into z. The step control compares *error with 1. z is valid only
// if the trial is done.
YkOdeTrial yk_ode_dop853_try(YkOde *ode, double h, double *error);
YkOdeTrial yk_ode_sdirk4_try(YkOde *ode, double h, double *error);
YkOdeTrial yk_ode_rk4_try(YkOde *ode, double h);
// Computes y[n] at previous + s * length, 0 < s < 1.
YkOdeStatus yk_ode_dop853_dense(YkOde *ode, double s, double *y);
void yk_ode_sdirk4_dense(const YkOde *ode, double s, double *y);
void yk_ode_rk4_dense(const YkOde *ode, double s, double *y);

// Computes df/dy at (t, y) by differences. Returns false if f fails on both sides.
bool yk_ode_jacobian(YkOde *ode);
// Solves g = known + gamma_h f(t, g) from the guess in g; writes the slope f(t, g) to k. h is the step for which E is
// needed.
YkOdeTrial yk_ode_newton(YkOde *ode, double t, double gamma_h, const double *known, double *g, double *k);
// Factors E = I - gamma_h J. Returns false if it is singular.
bool yk_ode_factor(YkOde *ode, double gamma_h);
// Computes v[controlled] = E^-1 v.
void yk_ode_filter(const YkOde *ode, double *v);

#endif
