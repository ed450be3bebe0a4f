// The N-four-bar by hand: the recursion over its windows, and the augmented Lagrangian.
#define _GNU_SOURCE // sincos
#include "d2.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double G = 9.81, ALPHA = 1e7;

// --- recursion
// ----------------------------------------------------------------------------------------------------------

void d2_recursion(size_t n, const double *crank, const double *coupler, const double *crank_rate,
                  const double *coupler_rate, double *a, double *ratio)
{
    double st, ct, v = 1, r = 0; // of the window's first crank: its acceleration is v a0 + r
    sincos(crank[0], &st, &ct);
    double M = 1. / 3, Q = 0.5 * G * st;
    ratio[0] = 1, a[0] = 0;
    for (size_t i = 0; i < n; i++) {
        double sp, cp, su, cu, w0 = crank_rate[i], w1 = coupler_rate[i], w2 = crank_rate[i + 1];
        sincos(coupler[i], &sp, &cp);
        sincos(crank[i + 1], &su, &cu);
        // sin th + cos ph - sin th' - 1 = 0, cos th + sin ph - cos th' = 0, derived twice
        double over = 1 / (cu * cp - sp * su), bx = -ct * v, by = st * v;
        double vp = (su * bx + cu * by) * over, vt = (-cp * bx - sp * by) * over;
        double gx = -ct * r + st * w0 * w0 + cp * w1 * w1 - su * w2 * w2;
        double gy = st * r + ct * w0 * w0 + sp * w1 * w1 - cu * w2 * w2;
        double rp = (su * gx + cu * gy) * over, rt = (-cp * gx - sp * gy) * over;
        double jx = ct * v - 0.5 * sp * vp, jy = -st * v + 0.5 * cp * vp; // the coupler's centre
        double cx = ct * r - st * w0 * w0 - 0.5 * (sp * rp + cp * w1 * w1);
        double cy = -st * r - ct * w0 * w0 + 0.5 * (cp * rp - sp * w1 * w1);
        M += jx * jx + jy * jy + vp * vp / 12 + vt * vt / 3;
        Q += -jx * cx - jy * (cy + G) - vp * rp / 12 + vt * (0.5 * G * su - rt / 3);
        ratio[i + 1] = vt, ratio[n + 1 + i] = vp, a[i + 1] = rt, a[n + 1 + i] = rp;
        v = vt, r = rt, st = su, ct = cu;
    }
    double a0 = Q / M;
    for (size_t i = 0; i < 2 * n + 1; i++) a[i] += ratio[i] * a0;
}

double d2_exact(size_t n, double angle)
{
    double N = (double)n;
    return G * ((N + 1) / 2 + N) / ((N + 1) / 3 + N) * sin(angle);
}

// --- augmented Lagrangian
// -----------------------------------------------------------------------------------------------

bool d2_start(D2Augmented *s, size_t n)
{
    size_t m = 2 * n + 1;
    double *p = calloc(17 * m, sizeof *p);
    *s = (D2Augmented){.n = n, .unknowns = m, .memory = p};
    if (!p) return false;
    double **rows[] = {&s->q, &s->w, &s->mass, &s->beside,  &s->D,       &s->L1,    &s->L2,    &s->force,
                       &s->x, &s->b, &s->a,    &s->q_stage, &s->w_stage, &s->q_sum, &s->w_sum, &s->turn};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++, p += m) *rows[k] = p; // `turn` is last: two numbers each
    for (size_t i = 0; i <= n; i++) s->w[2 * i] = 1;
    return true;
}

void d2_end(D2Augmented *s)
{
    free(s->memory);
}

// M + ALPHA J' J, assembled.
static void assemble(D2Augmented *s)
{
    const double *turn = s->turn;
    for (size_t j = 0; j < s->unknowns; j++) {
        s->mass[j] = 1. / 3;
        s->beside[j] = s->L1[j] = s->L2[j] = 0;
    }
    for (size_t i = 0; i < s->n; i++) {
        s->mass[2 * i] = 4. / 3;
        s->beside[2 * i] = -0.5 * (turn[4 * i + 1] * turn[4 * i + 2] + turn[4 * i] * turn[4 * i + 3]);
    }
    memcpy(s->D, s->mass, s->unknowns * sizeof *s->D);
    memcpy(s->L1, s->beside, s->unknowns * sizeof *s->L1);
    for (size_t i = 0; i < s->n; i++) {
        const double *c = turn + 4 * i;
        double *D = s->D + 2 * i, *L1 = s->L1 + 2 * i, *L2 = s->L2 + 2 * i;
        double x0 = c[1], x1 = -c[2], x2 = -c[5], y0 = -c[0], y1 = c[3], y2 = c[4];
        D[0] += ALPHA * (x0 * x0 + y0 * y0);
        D[1] += ALPHA * (x1 * x1 + y1 * y1);
        D[2] += ALPHA * (x2 * x2 + y2 * y2);
        L1[0] += ALPHA * (x0 * x1 + y0 * y1);
        L1[1] += ALPHA * (x1 * x2 + y1 * y2);
        L2[0] += ALPHA * (x0 * x2 + y0 * y2);
    }
}

static void factor(D2Augmented *s, const double *q)
{
    size_t m = s->unknowns;
    double *D = s->D, *L1 = s->L1, *L2 = s->L2;
    for (size_t j = 0; j < m; j++) sincos(q[j], &s->turn[2 * j], &s->turn[2 * j + 1]);
    assemble(s);
    for (size_t j = 0; j < m; j++) {
        double over = 1 / D[j], a = L1[j] * over, b = L2[j] * over;
        if (j + 1 < m) {
            D[j + 1] -= a * L1[j];
            L1[j + 1] -= a * L2[j];
        }
        if (j + 2 < m) D[j + 2] -= b * L2[j];
        L1[j] = a;
        L2[j] = b;
        D[j] = over;
    }
}

static void solve(const D2Augmented *s, double *b)
{
    size_t m = s->unknowns;
    const double *L1 = s->L1, *L2 = s->L2, *D = s->D;
    for (size_t j = 0; j < m; j++) {
        if (j + 1 < m) b[j + 1] -= L1[j] * b[j];
        if (j + 2 < m) b[j + 2] -= L2[j] * b[j];
        b[j] *= D[j];
    }
    for (size_t j = m; j-- > 0;) {
        if (j + 1 < m) b[j] -= L1[j] * b[j + 1];
        if (j + 2 < m) b[j] -= L2[j] * b[j + 2];
    }
}

static void times_mass(const D2Augmented *s, const double *x, double *y)
{
    size_t m = s->unknowns;
    for (size_t j = 0; j < m; j++) y[j] = s->mass[j] * x[j];
    for (size_t j = 0; j + 1 < m; j += 2) {
        y[j] += s->beside[j] * x[j + 1];
        y[j + 1] += s->beside[j] * x[j];
    }
}

// b -= ALPHA J' (x, y) of one window.
static inline void subtract_window(const double *c, double *b, double x, double y)
{
    b[0] -= ALPHA * (c[1] * x - c[0] * y);
    b[1] -= ALPHA * (-c[2] * x + c[3] * y);
    b[2] -= ALPHA * (-c[5] * x + c[4] * y);
}

static void find_forces(D2Augmented *s, const double *w)
{
    for (size_t j = 0; j < s->unknowns; j++) s->force[j] = j % 2 ? 0 : 0.5 * G * s->turn[2 * j];
    for (size_t i = 0; i < s->n; i++) {
        const double *c = s->turn + 4 * i;
        double w0 = w[2 * i], w1 = w[2 * i + 1];
        double bx = -c[0] * w0 * w0 - 0.5 * c[3] * w1 * w1, by = -c[1] * w0 * w0 - 0.5 * c[2] * w1 * w1 + G;
        s->force[2 * i] -= c[1] * bx - c[0] * by;
        s->force[2 * i + 1] -= 0.5 * (c[3] * by - c[2] * bx);
    }
}

static void accelerate(D2Augmented *s, const double *q, const double *w, double *a)
{
    size_t size = s->unknowns * sizeof *a;
    factor(s, q);
    find_forces(s, w);
    for (int round = 0; round < 3; round++) { // without reactions, then two corrections of them
        if (round == 0)
            memcpy(s->b, s->force, size);
        else
            times_mass(s, s->x, s->b);
        for (size_t i = 0; i < s->n; i++) {
            const double *c = s->turn + 4 * i;
            double w0 = w[2 * i], w1 = w[2 * i + 1], w2 = w[2 * i + 2];
            subtract_window(c, s->b + 2 * i, -c[0] * w0 * w0 - c[3] * w1 * w1 + c[4] * w2 * w2,
                            -c[1] * w0 * w0 - c[2] * w1 * w1 + c[5] * w2 * w2);
        }
        solve(s, s->b);
        memcpy(s->x, s->b, size);
    }
    memcpy(a, s->x, size);
}

static void project(D2Augmented *s)
{
    size_t m = s->unknowns;
    for (int round = 0; round < 2; round++) {
        factor(s, s->q);
        memset(s->b, 0, m * sizeof *s->b);
        for (size_t i = 0; i < s->n; i++) {
            const double *c = s->turn + 4 * i;
            subtract_window(c, s->b + 2 * i, c[0] + c[3] - c[4] - 1, c[1] + c[2] - c[5]);
        }
        solve(s, s->b);
        for (size_t j = 0; j < m; j++) s->q[j] += s->b[j];
    }
    factor(s, s->q);
    for (int round = 0; round < 2; round++) {
        times_mass(s, s->w, s->b);
        solve(s, s->b);
        memcpy(s->w, s->b, m * sizeof *s->b);
    }
}

void d2_step(D2Augmented *s, double h)
{
    static const double part[4] = {0, .5, .5, 1}, weight[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
    size_t m = s->unknowns, size = m * sizeof *s->q;
    memcpy(s->q_stage, s->q, size);
    memcpy(s->w_stage, s->w, size);
    memset(s->q_sum, 0, size);
    memset(s->w_sum, 0, size);
    for (int stage = 0; stage < 4; stage++) {
        if (stage > 0)
            for (size_t j = 0; j < m; j++) {
                s->q_stage[j] = s->q[j] + part[stage] * h * s->w_stage[j];
                s->w_stage[j] = s->w[j] + part[stage] * h * s->a[j];
            }
        accelerate(s, s->q_stage, s->w_stage, s->a);
        for (size_t j = 0; j < m; j++) {
            s->q_sum[j] += weight[stage] * s->w_stage[j];
            s->w_sum[j] += weight[stage] * s->a[j];
        }
    }
    for (size_t j = 0; j < m; j++) {
        s->q[j] += h * s->q_sum[j];
        s->w[j] += h * s->w_sum[j];
    }
    project(s);
}

double d2_energy(const D2Augmented *s)
{
    double E = 0;
    for (size_t i = 0; i <= s->n; i++) E += s->w[2 * i] * s->w[2 * i] / 6 + 0.5 * G * cos(s->q[2 * i]);
    for (size_t i = 0; i < s->n; i++) {
        double st = sin(s->q[2 * i]), ct = cos(s->q[2 * i]), sp = sin(s->q[2 * i + 1]), cp = cos(s->q[2 * i + 1]);
        double w0 = s->w[2 * i], w1 = s->w[2 * i + 1];
        double vx = ct * w0 - 0.5 * sp * w1, vy = -st * w0 + 0.5 * cp * w1;
        E += 0.5 * (vx * vx + vy * vy) + w1 * w1 / 24 + G * (ct + 0.5 * sp);
    }
    return E;
}
