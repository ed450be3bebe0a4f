// Newton and Euler for this one machine: from the ram's acceleration back to the crank's torque.
#include "forces.h"
#include <math.h>
#include "lanes.h"

#define G 9.81
#define CUT 800.0

typedef struct Forces {
    double o1x, o1y, o2x, o2y, sx, sy, couple, ax, ay, bx, by, cx, cy, ry, torque;
} Forces;

ALWAYS void quick_return(double s1, double c1, double w, double al, Forces *f)
{
    const double a1 = 1, a2 = 1, l1 = 0.75, l2 = 1.75, l4 = 2.0 / 3, g1 = 0.3, g2 = 0.9, g4 = 0.33;
    const double m1 = 12, m2 = 20, m3 = 2, m4 = 6, m5 = 30, i1 = 0.9, i2 = 5.5, i3 = 0.01, i4 = 0.25;
    // positions, velocities, accelerations
    double x = l1 * c1, y = l1 * s1 + a1, id3 = 1 / sqrt(x * x + y * y);
    double c2 = x * id3, s2 = y * id3, s4 = (a1 + a2 - l2 * s2) * (1 / l4), c4 = sqrt((1 - s4) * (1 + s4));
    double xd = -l1 * s1 * w, yd = l1 * c1 * w;
    double ax = -l1 * (c1 * w * w + s1 * al), ay = l1 * (c1 * al - s1 * w * w);
    double d3d = c2 * xd + s2 * yd, w2 = (c2 * yd - s2 * xd) * id3, e2 = (c2 * ay - s2 * ax - 2 * d3d * w2) * id3;
    double ic = 1 / (l4 * c4), w4 = -l2 * c2 * w2 * ic;
    double e4 = (l4 * s4 * w4 * w4 - l2 * (c2 * e2 - s2 * w2 * w2)) * ic;
    double ux = -s2 * e2 - c2 * w2 * w2, uy = c2 * e2 - s2 * w2 * w2; // of lever and coupler, a metre out
    double vx = -s4 * e4 - c4 * w4 * w4, vy = c4 * e4 - s4 * w4 * w4;
    // ram, coupler
    double cx = m5 * (l2 * ux + l4 * vx) + CUT;
    double px = m4 * (l2 * ux + g4 * vx), py = m4 * (l2 * uy + g4 * vy + G);
    double cy = (s4 * cx * l4 - i4 * e4 - g4 * (c4 * py - s4 * px)) * ic;
    double bx = px + cx, by = py + cy;
    // lever, block, crank
    double n = -((i2 + i3 + m2 * g2 * g2) * e2 + m2 * g2 * c2 * G + l2 * (c2 * by - s2 * bx)) * id3;
    double fx = m3 * ax + n * s2, fy = m3 * (ay + G) - n * c2;
    f->o1x = m1 * (g1 / l1) * ax + fx, f->o1y = m1 * ((g1 / l1) * ay + G) + fy;
    f->o2x = m2 * g2 * ux - n * s2 + bx, f->o2y = m2 * (g2 * uy + G) + n * c2 + by;
    f->sx = -n * s2, f->sy = n * c2, f->couple = i3 * e2;
    f->ax = fx, f->ay = fy, f->bx = bx, f->by = by, f->cx = cx, f->cy = cy, f->ry = m5 * G - cy;
    f->torque = (i1 + m1 * g1 * g1) * al + m1 * g1 * c1 * G + l1 * (c1 * fy - s1 * fx);
}

void quick_return_forces(const double *restrict theta, const double *restrict w, const double *restrict al,
                         double *const *out, size_t n)
{
    double *restrict o0 = out[0], *restrict o1 = out[1], *restrict o2 = out[2], *restrict o3 = out[3],
                     *restrict o4 = out[4], *restrict o5 = out[5], *restrict o6 = out[6], *restrict o7 = out[7],
                     *restrict o8 = out[8], *restrict o9 = out[9], *restrict o10 = out[10], *restrict o11 = out[11],
                     *restrict o12 = out[12], *restrict o13 = out[13], *restrict o14 = out[14];
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s, c;
        Forces f;
        lane_sincos(theta[i], &s, &c);
        quick_return(s, c, w[i], al[i], &f);
        o0[i] = f.o1x, o1[i] = f.o1y, o2[i] = f.o2x, o3[i] = f.o2y, o4[i] = f.sx, o5[i] = f.sy, o6[i] = f.couple;
        o7[i] = f.ax, o8[i] = f.ay, o9[i] = f.bx, o10[i] = f.by, o11[i] = f.cx, o12[i] = f.cy, o13[i] = f.ry;
        o14[i] = f.torque;
    }
}

void quick_return_forces_one(double theta, double w, double al, double *out)
{
    Forces f;
    quick_return(sin(theta), cos(theta), w, al, &f);
    const double all[] = {f.o1x, f.o1y, f.o2x, f.o2y, f.sx, f.sy, f.couple, f.ax,
                          f.ay,  f.bx,  f.by,  f.cx,  f.cy, f.ry, f.torque};
    for (int k = 0; k < QUICK_RETURN_FORCES; k++) out[k] = all[k];
}
