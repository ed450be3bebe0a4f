// SDIRK4: five stages, L-stable, stiffly accurate, order 4 with an estimate of order 3 and a continuous extension.
// Hairer & Wanner 1996, Solving Ordinary Differential Equations II, IV.6, (6.16) and (6.17).
#include "num/ode/ode_combine.h"
#include "num/ode/ode_internal.h"

static const double GAMMA = 0.25;
static const double NODE[5] = {1.0 / 4, 3.0 / 4, 11.0 / 20, 1.0 / 2, 1};
static const double A[5][4] = {{0},
                               {1.0 / 2},
                               {17.0 / 50, -1.0 / 25},
                               {371.0 / 1360, -137.0 / 2720, 15.0 / 544},
                               {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12}};
static const double ERROR[5] = {-3.0 / 16, -27.0 / 32, 25.0 / 32, 0, 1.0 / 4};

// Weights of the earlier stages' slopes that extrapolate the first guess of a stage's slope to its node. Stage 0 uses
// the end of the last step.
static const double GUESS[5][4] = {{0}, {1}, {2.0 / 5, 3.0 / 5}, {1.0 / 12, -1.0 / 8, 25.0 / 24}, {0, 2, 0, -1}};

static void guess_slope(const YkOde *ode, size_t i, const double *first, double *g)
{
    for (size_t j = 0; j < ode->n; j++) {
        double slope = i == 0 ? first[j] : 0;
        for (size_t m = 0; m < i; m++) slope += GUESS[i][m] * ode->stage[m][j];
        g[j] = slope;
    }
}

static YkOdeTrial solve_stages(YkOde *ode, double h)
{
    double *known = ode->stage[5], *g = ode->z;
    const double *const *k = (const double *const *)ode->stage;
    ode->newton.slowest = 0;
    for (size_t i = 0; i < 5; i++) {
        const double *base = ode->y;
        if (i > 0) {
            yk_ode_combine(ode->room, i, A[i], yk_ode_in_order, k, h, ode->y, known);
            base = known;
        }
        guess_slope(ode, i, ode->rate, g);
        for (size_t j = 0; j < ode->n; j++) g[j] = base[j] + h * GAMMA * g[j];
        YkOdeTrial trial = yk_ode_newton(ode, ode->t + NODE[i] * h, h * GAMMA, base, g, ode->stage[i]);
        if (trial != YK_TRIAL_DONE) return trial;
    }
    return YK_TRIAL_DONE;
}

// Filters the difference of the two methods by (I - h gamma J)^-1: otherwise it would overestimate stiff components.
static double error_norm(YkOde *ode, double h)
{
    double *e = ode->newton.residual, sum = 0;
    for (size_t j = 0; j < ode->controlled; j++) {
        e[j] = 0;
        for (size_t i = 0; i < 5; i++) e[j] += h * ERROR[i] * ode->stage[i][j];
    }
    yk_ode_filter(ode, e);
    for (size_t j = 0; j < ode->controlled; j++) {
        double part = e[j] / yk_ode_allowed(ode, j, ode->y[j], ode->z[j]);
        sum += part * part;
    }
    return sqrt(sum / (double)ode->controlled);
}

// Uses a Jacobian for many steps: computes a new one only when Newton converged slowly with it or failed.
YkOdeTrial yk_ode_sdirk4_try(YkOde *ode, double h, double *error)
{
    YkOdeNewton *newton = &ode->newton;
    if (newton->slowest > 0.1 && !newton->fresh) newton->known = false;
    for (;;) {
        if (!newton->known && !yk_ode_jacobian(ode)) return YK_TRIAL_F_FAILED;
        bool fresh = newton->fresh;
        YkOdeTrial trial = yk_ode_factor(ode, h * GAMMA) ? solve_stages(ode, h) : YK_TRIAL_DIVERGED;
        if (trial == YK_TRIAL_DONE) break;
        newton->speed = 1;
        if (fresh || trial == YK_TRIAL_F_FAILED) return trial;
        newton->known = false;
    }
    *error = error_norm(ode, h);
    return YK_TRIAL_DONE;
}

void yk_ode_sdirk4_dense(const YkOde *ode, double s, double *y)
{
    double h = ode->length * s;
    double b[5] = {11.0 / 3 + s * (-463.0 / 72 + s * (217.0 / 36 - s * 20.0 / 9)),
                   11.0 / 2 + s * (-385.0 / 16 + s * (661.0 / 24 - s * 10)),
                   -125.0 / 18 + s * (20125.0 / 432 + s * (-8875.0 / 216 + s * 250.0 / 27)),
                   s * (-85.0 / 4 + s * 85.0 / 6), -11.0 / 9 + s * (557.0 / 108 + s * (-359.0 / 54 + s * 80.0 / 27))};
    yk_ode_combine(ode->n, 5, b, yk_ode_in_order, (const double *const *)ode->stage, h, ode->y_previous, y);
}
