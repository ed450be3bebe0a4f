// Simplified Newton iteration for the stages of an implicit method. Hairer & Wanner 1996, Solving Ordinary Differential
// Equations II, IV.8. Only the controlled components enter the linear systems: the others are quadratures, on which
// nothing depends.
#include "elementary/elementary.h"
#include "num/dense.h"
#include "num/ode/ode_internal.h"

enum { MOST_ITERATIONS = 10 };
// The first correction of a stage is assumed to leave at least this part of the error: J may be outdated.
static const double NOT_MEASURED = 0.1;

// Computes one column from a difference in y_j, in the direction of its motion; the other way, and closer, if f fails
// there.
static bool differentiate(YkOde *ode, size_t j, double *column)
{
    double *y = ode->newton.guess, y_j = y[j];
    double size = ode->options.absolute > 0 ? ode->floor[j] / ode->options.absolute : 1;
    double delta = sqrt(DBL_EPSILON * fmax(1e-5 * size, fabs(y_j)) * fmax(size, fabs(y_j)));
    if (delta == 0) delta = sqrt(DBL_EPSILON);
    if (ode->rate[j] * ode->direction < 0) delta = -delta;
    for (int i = 0; i < 6; i++, delta *= i % 2 ? -1 : -0.0625) {
        y[j] = y_j + delta;
        double step = y[j] - y_j; // the difference after rounding
        bool fine = yk_ode_evaluate(ode, ode->t, y, column) && yk_ode_finite(ode->n, column) && step != 0;
        y[j] = y_j;
        if (!fine) continue;
        for (size_t r = 0; r < ode->controlled; r++) column[r] = (column[r] - ode->rate[r]) / step;
        return true;
    }
    return false;
}

bool yk_ode_jacobian(YkOde *ode)
{
    YkOdeNewton *newton = &ode->newton;
    ode->counts.jacobians++;
    newton->factored = 0;
    newton->speed = 1;
    newton->known = newton->fresh = false;
    for (size_t j = 0; j < ode->n; j++) newton->guess[j] = ode->y[j];
    for (size_t j = 0; j < ode->controlled; j++)
        if (!differentiate(ode, j, newton->J + j * ode->n)) return false;
    newton->known = newton->fresh = true;
    return true;
}

bool yk_ode_factor(YkOde *ode, double gamma_h)
{
    YkOdeNewton *newton = &ode->newton;
    size_t m = ode->controlled;
    if (newton->factored == gamma_h) return true;
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < m; j++) newton->E[i * m + j] = (i == j) - gamma_h * newton->J[j * ode->n + i];
    double determinant = yk_lu_factor(m, newton->E, newton->pivot, newton->scratch);
    newton->factored = determinant != 0 && fabs(determinant) <= DBL_MAX ? gamma_h : 0;
    return newton->factored != 0;
}

void yk_ode_filter(const YkOde *ode, double *v)
{
    yk_lu_solve(ode->controlled, ode->newton.E, ode->newton.pivot, v);
}

// Corrects g once; quadratures follow f before it. Returns the correction's norm; NaN if f was not finite.
static double correct(YkOde *ode, double gamma_h, const double *known, double *g, double *k)
{
    double *d = ode->newton.residual, sum = 0;
    for (size_t j = 0; j < ode->controlled; j++) d[j] = known[j] + gamma_h * k[j] - g[j];
    yk_ode_filter(ode, d);
    for (size_t j = 0; j < ode->controlled; j++) {
        double e = d[j] / yk_ode_allowed(ode, j, ode->y[j], ode->y[j]);
        g[j] += d[j];
        sum += e * e;
    }
    for (size_t i = ode->controlled; i < ode->n; i++) g[i] = known[i] + gamma_h * k[i];
    return sqrt(sum / (double)ode->controlled);
}

// Returns the part of the allowed error to which a stage is solved: a tenth of the part that Hairer & Wanner choose,
// since the weights of SDIRK4 make the error of a stage some thirty times larger.
static double stopping_norm(double relative)
{
    return relative > 0 ? fmax(10 * DBL_EPSILON / relative, fmin(0.003, 0.1 * sqrt(relative))) : 0.001;
}

YkOdeTrial yk_ode_newton(YkOde *ode, double t, double gamma_h, const double *known, double *g, double *k)
{
    YkOdeNewton *newton = &ode->newton;
    double stop = stopping_norm(ode->options.relative), last = 0;
    double speed = fmax(NOT_MEASURED, yk_pow(fmax(newton->speed, DBL_EPSILON), 0.8));
    bool quadratures = ode->controlled < ode->n; // their slopes are as accurate as g was before the last correction
    for (int i = 0; i < MOST_ITERATIONS; i++) {
        if (!yk_ode_evaluate(ode, t, g, k)) return YK_TRIAL_F_FAILED;
        double norm = correct(ode, gamma_h, known, g, k);
        if (!(norm <= DBL_MAX)) return YK_TRIAL_F_FAILED;
        if (i > 0 && last > 0) {
            double rate = norm / last;
            newton->slowest = fmax(newton->slowest, rate);
            double hoped = rate < 0.99 ? norm * yk_pow(rate, MOST_ITERATIONS - 1 - i) / (1 - rate) : DBL_MAX;
            if (norm > stop && hoped > stop) return YK_TRIAL_DIVERGED;
            speed = rate < 0.99 ? rate / (1 - rate) : 1;
        }
        if ((quadratures ? fmax(speed, 1) : speed) * norm <= stop) {
            newton->speed = speed;
            for (size_t j = 0; j < ode->controlled; j++) k[j] = (g[j] - known[j]) / gamma_h;
            return YK_TRIAL_DONE;
        }
        last = norm;
    }
    return YK_TRIAL_DIVERGED;
}
