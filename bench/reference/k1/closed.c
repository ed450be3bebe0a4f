/* The quick-return in closed form. */
#define _GNU_SOURCE
#include <math.h>
#include "closed.h"

/* ---------- (i) scalar closed form ---------- */
void closed_scalar(double t1, double w, double al, double *o)
{
    double s1, c1;
    sincos(t1, &s1, &c1);
    double x = WL1 * c1, y = WL1 * s1 + WA1;
    double d3 = sqrt(x * x + y * y), id3 = 1 / d3;
    double c2 = x * id3, s2 = y * id3;
    double s24 = (WA1 + WA2 - WL2 * s2) / WL4, c24 = sqrt(1 - s24 * s24);
    double t2 = atan2(y, x), t24 = asin(s24);
    double xd = -WL1 * s1 * w, yd = WL1 * c1 * w;
    double xdd = -WL1 * (c1 * w * w + s1 * al), ydd = WL1 * (-s1 * w * w + c1 * al);
    double d3d = c2 * xd + s2 * yd, t2d = (c2 * yd - s2 * xd) * id3;
    double d3dd = c2 * xdd + s2 * ydd + d3 * t2d * t2d;
    double t2dd = (c2 * ydd - s2 * xdd - 2 * d3d * t2d) * id3;
    double ic = 1 / (WL4 * c24);
    double w24 = -WL2 * c2 * t2d * ic;
    double a24 = (WL4 * s24 * w24 * w24 - WL2 * (c2 * t2dd - s2 * t2d * t2d)) * ic;
    o[T2] = t2;
    o[D3] = d3;
    o[T4] = t24 - t2;
    o[D5] = WL2 * c2 + WL4 * c24;
    o[V_T2] = t2d;
    o[V_D3] = d3d;
    o[V_T4] = w24 - t2d;
    o[V_D5] = -WL2 * s2 * t2d - WL4 * s24 * w24;
    o[A_T2] = t2dd;
    o[A_D3] = d3dd;
    o[A_T4] = a24 - t2dd;
    o[A_D5] = -WL2 * (s2 * t2dd + c2 * t2d * t2d) - WL4 * (s24 * a24 + c24 * w24 * w24);
}

void closed_long(long double t1, long double w, long double al, long double *o)
{
    long double L1 = 0.75L, L2 = 1.75L, L4 = 2.0L / 3, s1 = sinl(t1), c1 = cosl(t1);
    long double x = L1 * c1, y = L1 * s1 + 1, d3 = sqrtl(x * x + y * y), c2 = x / d3, s2 = y / d3;
    long double s24 = (2 - L2 * s2) / L4, c24 = sqrtl(1 - s24 * s24), t2 = atan2l(y, x), t24 = asinl(s24);
    long double xd = -L1 * s1 * w, yd = L1 * c1 * w, xdd = -L1 * (c1 * w * w + s1 * al),
                ydd = L1 * (-s1 * w * w + c1 * al);
    long double d3d = c2 * xd + s2 * yd, t2d = (c2 * yd - s2 * xd) / d3, d3dd = c2 * xdd + s2 * ydd + d3 * t2d * t2d;
    long double t2dd = (c2 * ydd - s2 * xdd - 2 * d3d * t2d) / d3, w24 = -L2 * c2 * t2d / (L4 * c24);
    long double a24 = (L4 * s24 * w24 * w24 - L2 * (c2 * t2dd - s2 * t2d * t2d)) / (L4 * c24);
    o[T2] = t2;
    o[D3] = d3;
    o[T4] = t24 - t2;
    o[D5] = L2 * c2 + L4 * c24;
    o[V_T2] = t2d;
    o[V_D3] = d3d;
    o[V_T4] = w24 - t2d;
    o[V_D5] = -L2 * s2 * t2d - L4 * s24 * w24;
    o[A_T2] = t2dd;
    o[A_D3] = d3dd;
    o[A_T4] = a24 - t2dd;
    o[A_D5] = -L2 * (s2 * t2dd + c2 * t2d * t2d) - L4 * (s24 * a24 + c24 * w24 * w24);
}
