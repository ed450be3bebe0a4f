// The double pendulum by hand: its equations in closed form.
#define _GNU_SOURCE // sincos
#include "d1.h"
#include <math.h>
#include "dop853.h"

static const double L1 = 0.5, LC1 = 0.35, LC2 = 0.3, M1 = 0.5, M2 = 0.4, I1 = 0.025, I2 = 0.02, G = 9.81;
#define A (I1 + I2 + M1 * LC1 * LC1 + M2 * (L1 * L1 + LC2 * LC2))
#define B (M2 * L1 * LC2)
#define D (I2 + M2 * LC2 * LC2)
#define G1 (G * (M1 * LC1 + M2 * L1))
#define G2 (G * M2 * LC2)

static inline __attribute__((always_inline)) void right_hand_side(const double *y, const double *tau, double *dy)
{
    double s1, c1, s2, c2, w1 = y[2], w2 = y[3];
    sincos(y[0], &s1, &c1);
    sincos(y[1], &s2, &c2);
    double s12 = s1 * c2 + c1 * s2, b = B * c2, h = B * s2;
    double m11 = A + 2 * b, m12 = D + b;
    double r1 = tau[0] + h * (w2 * (2 * w1 + w2)) - G1 * s1 - G2 * s12;
    double r2 = tau[1] - h * w1 * w1 - G2 * s12;
    double over = 1 / (m11 * D - m12 * m12);
    dy[0] = w1;
    dy[1] = w2;
    dy[2] = (D * r1 - m12 * r2) * over;
    dy[3] = (m11 * r2 - m12 * r1) * over;
}

void d1_rhs(const double *y, const double *tau, double *dy)
{
    right_hand_side(y, tau, dy);
}

static inline __attribute__((always_inline)) void without_torques(const double *y, double *dy)
{
    static const double none[2] = {0};
    right_hand_side(y, none, dy);
}

long d1_run(double *y, double end, double tolerance)
{
    return dop853(4, without_torques, y, end, tolerance);
}

double d1_energy(const double *y)
{
    double c2 = cos(y[1]), w1 = y[2], w2 = y[3];
    double kinetic = 0.5 * ((A + 2 * B * c2) * w1 * w1 + 2 * (D + B * c2) * w1 * w2 + D * w2 * w2);
    return kinetic - G1 * cos(y[0]) - G2 * cos(y[0] + y[1]);
}
