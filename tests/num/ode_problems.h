// Equations with known solutions, and a run to the end.
#ifndef TESTS_NUM_ODE_PROBLEMS_H
#define TESTS_NUM_ODE_PROBLEMS_H
#include "check.h"
#include "num/ode/ode.h"

#define PI 3.14159265358979323846

// y'' = -y: y = (cos t, -sin t) from (1, 0).
static inline int oscillator(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    dydt[0] = y[1];
    dydt[1] = -y[0];
    return 0;
}
// The oscillator, and the integral of its first component: sin t.
static inline int oscillator_with_integral(void *context, double t, const double *y, double *dydt)
{
    dydt[2] = y[0];
    return oscillator(context, t, y, dydt);
}
// y' = rate y, all components
typedef struct Growth {
    size_t n;
    double rate;
} Growth;
static inline int growth(void *context, double t, const double *y, double *dydt)
{
    (void)t;
    const Growth *g = context;
    for (size_t j = 0; j < g->n; j++) dydt[j] = g->rate * y[j];
    return 0;
}
// y' = y (1 - y): y = 1 / (1 + (1 / y0 - 1) e^-t)
static inline int logistic(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    dydt[0] = y[0] * (1 - y[0]);
    return 0;
}
static inline double logistic_answer(double y0, double t)
{
    return 1 / (1 + (1 / y0 - 1) * exp(-t));
}
// Depends on time and is not linear: y' = y cos t, y = e^sin t
static inline int swinging(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    dydt[0] = y[0] * cos(t);
    return 0;
}
// y' = sqrt(1 - y): there is no f past y = 1. From 0: y = t - t^2 / 4, at 1 when t = 2.
static inline int wall(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    if (!(y[0] <= 1)) return -1;
    dydt[0] = sqrt(1 - y[0]);
    return 0;
}
// Runs into the wall with speed: y' = 1 while y <= 1, and nothing beyond.
static inline int hard_wall(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    dydt[0] = 1;
    return y[0] <= 1 ? 0 : 7;
}
// The same wall, but f says nothing: it is just not a number behind.
static inline int silent_wall(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    dydt[0] = y[0] <= 1 ? 1 : (double)NAN;
    return 0;
}
// Two bodies in a plane, x, y, their rates; eccentricity e starts at (1 - e, 0) with period 2 pi.
static inline int kepler(void *context, double t, const double *y, double *dydt)
{
    (void)context;
    (void)t;
    double r = hypot(y[0], y[1]), f = -1 / (r * r * r);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = f * y[0];
    dydt[3] = f * y[1];
    return 0;
}
static inline void kepler_start(double e, double *y)
{
    y[0] = 1 - e;
    y[1] = y[2] = 0;
    y[3] = sqrt((1 + e) / (1 - e));
}
static inline double kepler_energy(const double *y)
{
    return (y[2] * y[2] + y[3] * y[3]) / 2 - 1 / hypot(y[0], y[1]);
}

static inline YkOdeOptions with_tolerance(YkOdeMethod method, double tolerance)
{
    return (YkOdeOptions){.method = method, .relative = tolerance, .absolute = tolerance};
}
static inline YkOdeOptions with_step(double step)
{
    return (YkOdeOptions){.method = YK_ODE_RK4, .fixed_step = step};
}
static inline YkOde *new_ode(size_t n, YkOdeOptions options, YkOdeFunction f, void *context)
{
    YkOde *ode = yk_ode_new(n, &options, f, context);
    assert_non_null(ode);
    return ode;
}
// Steps until the end or until a step fails.
static inline YkOdeStatus run_on(YkOde *ode, double t_end)
{
    YkOdeStatus status = YK_ODE_OK;
    for (size_t i = 0; status == YK_ODE_OK && yk_ode_time(ode) != t_end; i++) {
        if (i == 10000000) fail_msg("%s", "does not get to the end");
        status = yk_ode_step(ode);
    }
    return status;
}
static inline YkOdeStatus run(YkOde *ode, double t, const double *y, double t_end)
{
    YkOdeStatus status = yk_ode_start(ode, t, y, t_end, false);
    return status == YK_ODE_OK ? run_on(ode, t_end) : status;
}
#endif
