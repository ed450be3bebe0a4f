// Newton and Euler for a planetary gear and for a cam, each for its one machine.
#include "train_forces.h"
#include <math.h>
#include "lanes.h"

#define G 9.81

// The teeth of sun and ring push along the pitch circles with forces that the accelerations alone determine; pin P of
// one planet holds these, its weight and its inertia. Around the carrier all else cancels.
void planetary_forces(const double *restrict theta, const double *restrict rate, const double *restrict accel,
                      double *const *out, size_t n)
{
    const double rs = 0.020, rp = 0.016, rr = 0.052, r = 0.036, m = 0.15, planet = 2e-5, sun = 9e-5, arm = 5e-4;
    const double ratio = rs / (rs + rr), slope = 0.36397023426620234;
    const double per_al = (arm + 3 * m * r * r) / (3 * r), load = 25 / (3 * r), spin = planet * (1 - rr / rp) / rp;
    double *restrict sx = out[0], *restrict sy = out[1], *restrict cx = out[2], *restrict cy = out[3],
                     *restrict px = out[4], *restrict py = out[5], *restrict rx = out[6], *restrict ry = out[7],
                     *restrict couple = out[8], *restrict effort = out[9];
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s, c, w = ratio * rate[i], al = ratio * accel[i];
        lane_sincos(ratio * theta[i], &s, &c);
        double sum = per_al * al + load, less = spin * al;
        double from_sun = (sum - less) / 2, from_ring = (sum + less) / 2;
        double outward = -m * r * w * w - slope * (fabs(from_sun) - fabs(from_ring)), along = m * r * al - sum;
        sx[i] = 0, sy[i] = 0.4 * G, cx[i] = 0, cy[i] = (0.6 + 3 * m) * G;
        px[i] = outward * c - along * s, py[i] = outward * s + along * c + m * G;
        rx[i] = 0, ry[i] = 0, couple[i] = 3 * rr * from_ring, effort[i] = sun * accel[i] + 3 * rs * from_sun;
    }
}

// Lift 576 mm u^3 (1 - u)^3, u = theta / 120 degrees: 9 mm in the middle; a dwell over the other 240 degrees. The
// roller's centre stands 25 mm above the shaft at no lift; the guide holds what the cam pushes aside.
void valve_forces(const double *restrict theta, const double *restrict rate, const double *restrict accel,
                  double *const *out, size_t n)
{
    const double per = 3 / (2 * 3.14159265358979323846), most = 0.576, m = 0.11, k = 40e3, base = 0.025, free = -0.008;
    double *restrict cx = out[0], *restrict cy = out[1], *restrict vx = out[2], *restrict couple = out[3],
                     *restrict effort = out[4];
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double w = rate[i], turns = theta[i] * per, wrapped = turns - 3 * floor(turns * (1.0 / 3));
        double u = wrapped < 1 ? wrapped : 1, v = u * (1 - u), d = 1 - 2 * u;
        double s = most * v * v * v, first = 3 * most * per * v * v * d;
        double second = 6 * most * per * per * v * (d * d - v);
        double push = m * (second * w * w + first * accel[i] + G) + k * (s - free);
        double torque = push * first, aside = torque / (base + s);
        cx[i] = -aside, cy[i] = push, vx[i] = aside, couple[i] = -base * aside, effort[i] = torque;
    }
}
