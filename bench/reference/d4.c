// Andrews' squeezing mechanism by hand, in the crank's angle.
#define _GNU_SOURCE // sincos
#include "d4.h"
#include <math.h>
#include "dop853.h"

// Data and equations as the test set of initial value problems has them: Mazzia et al., "andrews"; Hairer & Wanner
// 1996, VII.7.
static const double m1 = .04325, m2 = .00365, m3 = .02373, m4 = .00706, m5 = .07050, m6 = .00706, m7 = .05498;
static const double i1 = 2.194e-6, i2 = 4.410e-7, i3 = 5.255e-6, i4 = 5.667e-7, i5 = 1.169e-5, i6 = 5.667e-7,
                    i7 = 1.912e-5;
static const double xa = -.06934, ya = -.00227, xb = -.03635, yb = .03273, xc = .014, yc = .072, c0 = 4530, l0 = .07785,
                    mom = .033;
static const double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, ss = 35e-3, sa = 1874e-5,
                    sb = 1043e-5, sc = 18e-3, sd = 2e-2;
static const double ta = 2308e-5, tb = 916e-5, u = 4e-2, ua = 1228e-5, ub = 449e-5, zf = 2e-2, zt = 4e-2, fa = 1421e-5;

const double d4_start[D4_ANGLES] = {
    -0.06171389001427650, 0, 0.4552798191630704, 0.2226683901658859, 0.4873649795438426, -0.2226683901658859,
    1.230547444549821};
const double d4_end[D4_ANGLES] = {15.81077119515370710,   -15.75637105841183947, 0.04082224011964580486,
                                  -0.5347301163420795938, 0.5244099658799540694, 0.5347301163420795937,
                                  1.048080741041937874};

typedef struct Turns { // cosines and sines: of the angles, and of sums of two of them
    double sbe, cbe, sth, cth, sga, cga, sph, cph, sde, cde, som, com, sep, cep;
    double sbt, cbt, spd, cpd, soe, coe;
} Turns;

// Two links a and b from the origin to (x, y).
static inline void dyad(double x, double y, double a, double b, double branch, double *cp, double *sp, double *cr,
                        double *sr)
{
    double square = x * x + y * y, along = (square + a * a - b * b) / (2 * a);
    double across = branch * sqrt(square - along * along), over = 1 / square;
    *cp = (x * along + y * across) * over;
    *sp = (y * along - x * across) * over;
    *cr = (x - a * *cp) / b;
    *sr = (y - a * *sp) / b;
}

static inline void find_turns(double beta, Turns *t)
{
    double c, s;
    sincos(beta, &t->sbe, &t->cbe);
    double fx = rr * t->cbe, fy = rr * t->sbe;
    dyad(fx - xb, fy - yb, d, ss, -1, &t->cbt, &t->sbt, &t->sga, &c);
    t->cga = -c;
    double ex = fx - d * t->cbt - xa, ey = fy - d * t->sbt - ya;
    dyad(ex, ey, zt, e, -1, &t->cde, &t->sde, &t->spd, &s);
    t->cpd = -s;
    dyad(ex, ey, u, zf, 1, &t->sep, &c, &t->coe, &t->soe);
    t->cep = -c;
    t->sth = t->sbt * t->cbe - t->cbt * t->sbe;
    t->cth = t->cbt * t->cbe + t->sbt * t->sbe;
    t->sph = t->spd * t->cde - t->cpd * t->sde;
    t->cph = t->cpd * t->cde + t->spd * t->sde;
    t->som = t->soe * t->cep - t->coe * t->sep;
    t->com = t->coe * t->cep + t->soe * t->sep;
}

// All rates from the crank's and the right side of the loops' equations.
static inline void rates(const Turns *t, double crank, const double *r, double *x)
{
    double a00 = -rr * t->sbe + d * t->sbt, a01 = d * t->sbt, b00 = rr * t->cbe - d * t->cbt, b01 = -d * t->cbt;
    double px = -ss * t->cga, py = -ss * t->sga, rx = r[0] - a00 * crank, ry = r[1] - b00 * crank;
    double over = 1 / (a01 * py - px * b01);
    x[0] = crank;
    x[1] = (rx * py - px * ry) * over;
    x[2] = (a01 * ry - b01 * rx) * over;
    double wx = a00 * crank + a01 * x[1], wy = b00 * crank + b01 * x[1];
    double p3 = -e * t->cpd, p4 = p3 + zt * t->sde, q3 = -e * t->spd, q4 = q3 - zt * t->cde;
    rx = r[2] - wx;
    ry = r[3] - wy;
    over = 1 / (p3 * q4 - p4 * q3);
    x[3] = (rx * q4 - p4 * ry) * over;
    x[4] = (p3 * ry - q3 * rx) * over;
    p3 = zf * t->soe, p4 = p3 - u * t->cep, q3 = -zf * t->coe, q4 = q3 - u * t->sep;
    rx = r[4] - wx;
    ry = r[5] - wy;
    over = 1 / (p3 * q4 - p4 * q3);
    x[5] = (rx * q4 - p4 * ry) * over;
    x[6] = (p3 * ry - q3 * rx) * over;
}

// The rest of the loops' equations when all accelerations are 0.
static inline void bias(const Turns *t, const double *v, double *g)
{
    double b2 = v[0] * v[0], bt = (v[0] + v[1]) * (v[0] + v[1]), pd = (v[3] + v[4]) * (v[3] + v[4]);
    double oe = (v[5] + v[6]) * (v[5] + v[6]);
    double x = -rr * t->cbe * b2 + d * t->cbt * bt, y = -rr * t->sbe * b2 + d * t->sbt * bt;
    g[0] = x + ss * t->sga * v[2] * v[2];
    g[1] = y - ss * t->cga * v[2] * v[2];
    g[2] = x + e * t->spd * pd + zt * t->cde * v[4] * v[4];
    g[3] = y - e * t->cpd * pd + zt * t->sde * v[4] * v[4];
    g[4] = x + zf * t->coe * oe + u * t->sep * v[6] * v[6];
    g[5] = y + zf * t->soe * oe - u * t->cep * v[6] * v[6];
}

// The mass matrix: its diagonal, and the pairs (0, 1), (3, 4), (5, 6).
static inline void mass(const Turns *t, double *M, double *pair)
{
    double k = e - ea, z = zf - fa;
    M[0] = m1 * ra * ra + m2 * (rr * rr - 2 * da * rr * t->cth + da * da) + i1 + i2;
    M[1] = m2 * da * da + i2;
    M[2] = m3 * (sa * sa + sb * sb) + i3;
    M[3] = m4 * k * k + i4;
    M[4] = m4 * (zt * zt + 2 * zt * k * t->sph + k * k) + m5 * (ta * ta + tb * tb) + i4 + i5;
    M[5] = m6 * z * z + i6;
    M[6] = m6 * (z * z - 2 * u * z * t->som + u * u) + m7 * (ua * ua + ub * ub) + i6 + i7;
    pair[0] = m2 * (da * da - da * rr * t->cth) + i2;
    pair[1] = m4 * (k * k + zt * k * t->sph) + i4;
    pair[2] = m6 * (z * z - u * z * t->som) + i6;
}

static inline void force(const Turns *t, const double *v, double *f)
{
    double dx = sd * t->cga + sc * t->sga + xb - xc, dy = sd * t->sga - sc * t->cga + yb - yc;
    double length = sqrt(dx * dx + dy * dy), pull = -c0 * (length - l0) / length, fx = pull * dx, fy = pull * dy;
    f[0] = mom - m2 * da * rr * v[1] * (v[1] + 2 * v[0]) * t->sth;
    f[1] = m2 * da * rr * v[0] * v[0] * t->sth;
    f[2] = fx * (sc * t->cga - sd * t->sga) + fy * (sd * t->cga + sc * t->sga);
    f[3] = m4 * zt * (e - ea) * v[4] * v[4] * t->cph;
    f[4] = -m4 * zt * (e - ea) * v[3] * (v[3] + 2 * v[4]) * t->cph;
    f[5] = -m6 * u * (zf - fa) * v[6] * v[6] * t->com;
    f[6] = m6 * u * (zf - fa) * v[5] * (v[5] + 2 * v[6]) * t->com;
}

static inline __attribute__((always_inline)) void right_hand_side(const double *y, double *dy)
{
    static const double none[6] = {0};
    Turns t;
    double V[7], v[7], R[7], g[6], M[7], pair[3], F[7], MV[7], A = 0, B = 0;
    find_turns(y[0], &t);
    rates(&t, 1, none, V);
    for (int i = 0; i < 7; i++) v[i] = V[i] * y[1];
    bias(&t, v, g);
    for (int i = 0; i < 6; i++) g[i] = -g[i];
    rates(&t, 0, g, R);
    mass(&t, M, pair);
    force(&t, v, F);
    for (int i = 0; i < 7; i++) MV[i] = M[i] * V[i];
    MV[0] += pair[0] * V[1], MV[1] += pair[0] * V[0];
    MV[3] += pair[1] * V[4], MV[4] += pair[1] * V[3];
    MV[5] += pair[2] * V[6], MV[6] += pair[2] * V[5];
    for (int i = 0; i < 7; i++) {
        A += MV[i] * V[i];
        B += V[i] * F[i] - MV[i] * R[i];
    }
    dy[0] = y[1];
    dy[1] = B / A;
}

void d4_rhs(const double *y, double *dy)
{
    right_hand_side(y, dy);
}

long d4_run(double tolerance, double *angles)
{
    Turns t;
    double y[2] = {d4_start[0], 0};
    long evaluations = dop853(2, right_hand_side, y, 0.03, tolerance);
    find_turns(y[0], &t);
    double theta = atan2(t.sth, t.cth), turn = 2 * 3.14159265358979323846;
    double found[] = {y[0],
                      theta + turn * rint((d4_end[D4_THETA] - theta) / turn),
                      atan2(t.sga, t.cga),
                      atan2(t.sph, t.cph),
                      atan2(t.sde, t.cde),
                      atan2(t.som, t.com),
                      atan2(t.sep, t.cep)};
    memcpy(angles, found, sizeof found);
    return evaluations;
}
