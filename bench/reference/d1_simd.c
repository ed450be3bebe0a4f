// The double pendulum's accelerations for many independent states by hand, each with its own parameters: the loop
// vectorises.
#include "d1.h"
#include "lanes.h"

void d1_simd(const D1States *state, double *restrict a1, double *restrict a2, size_t n)
{
    const double *restrict t1 = state->theta1, *restrict t2 = state->theta2, *restrict v1 = state->rate1,
                           *restrict v2 = state->rate2;
    const double *restrict L1 = state->l1, *restrict LC1 = state->lc1, *restrict LC2 = state->lc2,
                           *restrict M1 = state->m1, *restrict M2 = state->m2, *restrict I1 = state->I1,
                           *restrict I2 = state->I2;
    const double g = 9.81, tau1 = 0.5, tau2 = -0.2;
#pragma GCC ivdep
    for (size_t i = 0; i < n; i++) {
        double s1, c1, s2, c2, w1 = v1[i], w2 = v2[i];
        lane_sincos(t1[i], &s1, &c1);
        lane_sincos(t2[i], &s2, &c2);
        double A = I1[i] + I2[i] + M1[i] * LC1[i] * LC1[i] + M2[i] * (L1[i] * L1[i] + LC2[i] * LC2[i]);
        double B = M2[i] * L1[i] * LC2[i], D = I2[i] + M2[i] * LC2[i] * LC2[i];
        double G1 = g * (M1[i] * LC1[i] + M2[i] * L1[i]), G2 = g * M2[i] * LC2[i];
        double s12 = s1 * c2 + c1 * s2, b = B * c2, h = B * s2, m11 = A + 2 * b, m12 = D + b;
        double r1 = tau1 + h * (w2 * (2 * w1 + w2)) - G1 * s1 - G2 * s12, r2 = tau2 - h * w1 * w1 - G2 * s12;
        double over = 1 / (m11 * D - m12 * m12);
        a1[i] = (D * r1 - m12 * r2) * over;
        a2[i] = (m11 * r2 - m12 * r1) * over;
    }
}
