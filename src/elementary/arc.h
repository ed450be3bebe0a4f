// The angle of a tangent and of a sine, one lane: the bodies that kernels inline.
#ifndef ELEMENTARY_ARC_H
#define ELEMENTARY_ARC_H
#include "elementary/bits.h"
#include "elementary/coefficients.h"

// 1 - atan(u) / u for |u| <= tan(pi/8), z = u^2: the published minimax coefficients of fdlibm (Sun Microsystems 1993,
// s_atan), evaluated in our own order.
YK_INLINE double atan_rest(double z)
{
    double w = z * z, w2 = w * w;
    double even = (3.33333333333329318027e-01 + w * 1.42857142725034663711e-01) +
                  w2 * ((9.09088713343650656196e-02 + w * 6.66107313738753120669e-02) +
                        w2 * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02));
    double odd =
        (-1.99999999998764832476e-01 + w * -1.11111104054623557880e-01) +
        w2 * ((-7.69187620504482999495e-02 + w * -5.83357013379057348645e-02) + w2 * -3.65315727442169155270e-02);
    return z * even + w * odd;
}

// asin(s) for |s| <= sin(pi/8): our own fit, tools/fit_arc_sine.py, 2^-55.
YK_INLINE double asin_poly(double s)
{
    double t = s * s, t2 = t * t, t4 = t2 * t2;
    double low =
        (0x1.5555555555551p-3 + t * 0x1.3333333336355p-4) + t2 * (0x1.6db6db686fa77p-5 + t * 0x1.f1c720069f276p-6);
    double high = (0x1.6e8b0584c52f7p-6 + t * 0x1.1c5e3631be7bap-6) +
                  t2 * (0x1.c7c4cfc8b4203p-7 + t * 0x1.8b8504ee7d538p-7) +
                  t4 * (0x1.c5cefdf0254adp-8 + t * 0x1.0dd281af8550ep-6);
    return s + s * t * (low + t4 * high);
}

// The angle of the unit vector (x, y), in [-pi, pi], within 2 ulp as far as its length is 1: no division. The smaller
// component is the sine of the angle to the nearest axis, or after a turn by pi/4 to the diagonal; then unfolded by
// octants.
YK_INLINE double unit_angle(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    double large = ay > ax ? ay : ax, small = ax < ay ? ax : ay;
    bool is_diagonal = small > 0.38268343236508977; // sin(pi/8)
    double a = asin_poly(is_diagonal ? (small - large) * 0.70710678118654752 : small);
    double base = is_diagonal ? 0x1.921fb54442d18p-1 : 0;
    base = ay > ax ? HALF_PI_HIGH - base : base;
    a = ay > ax ? -a : a;
    uint64_t left = bits_of(x) & YK_SIGN_BIT;
    base = x < 0 ? PI_HIGH - base : base;
    a = of_bits(bits_of(a) ^ left);
    return of_bits(bits_of(base + a) | (bits_of(y) & YK_SIGN_BIT));
}

#endif
