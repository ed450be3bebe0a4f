// sin, cos and atan2 without branches, for one lane: the bodies that kernels inline. Basic IEEE operations only.
//
// Reduction: Cody & Waite 1980, "Software Manual for the Elementary Functions", ch. 8, in three parts of pi/2 with the
// rounding of the second difference carried along. Polynomials: the published minimax coefficients of fdlibm (Sun
// Microsystems 1993: k_sin, k_cos, s_atan), evaluated in our own order.
#ifndef SOLVE_ELEMENTARY_H
#define SOLVE_ELEMENTARY_H
#include "solve/kernels/lanes.h"

#define YK_SINCOS_LIMIT 1e5 // rad: at most 2^16 quarter turns, so that the products with 37-bit parts of pi/2 are exact

YK_INLINE uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

YK_INLINE double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

#define YK_SIGN_BIT ((uint64_t)1 << 63)

// Returns sin(y - lost) for |y| <= pi/4, where lost is what rounding added to y.
YK_INLINE double sin_poly(double y, double lost, double y2)
{
    double y4 = y2 * y2, y3 = y2 * y;
    double r = (8.33333333332248946124e-03 + y2 * -1.98412698298579493134e-04) +
               y4 * ((2.75573137070700676789e-06 + y2 * -2.50507602534068634195e-08) + y4 * 1.58969099521155010221e-10);
    return y - (lost + y3 * (1.66666666666666324348e-01 - y2 * r));
}

// Returns cos(y - lost), likewise.
YK_INLINE double cos_poly(double y, double lost, double y2)
{
    double y4 = y2 * y2, half = 0.5 * y2, w = 1 - half;
    double r = (4.16666666666666019037e-02 + y2 * -1.38888888888741095749e-03) +
               y4 * ((2.48015872894767294178e-05 + y2 * -2.75573143513906633035e-07) +
                     y4 * (2.08757232129817482790e-09 + y2 * -1.13596475577881948265e-11));
    return w + (((1 - w) - half) + (y4 * r + y * lost));
}

// A number that rounds a small one to an integer when added to it; the lowest bits of the sum are then the integer.
#define YK_TO_INTEGER 0x1.8p52

// Returns x in quarter turns, to the nearest, plus YK_TO_INTEGER.
YK_INLINE double quarter_turns(double x)
{
    return x * 0x1.45f306dc9c883p-1 + YK_TO_INTEGER;
}

// Returns bits that tell whether x (also NaN) is beyond the range: a bit above the lowest 17 is set. The bits of many x
// may be or-ed.
YK_INLINE uint64_t sincos_far_bits(double x)
{
    return bits_of(quarter_turns(x)) - (bits_of(YK_TO_INTEGER) - 0x10000);
}
YK_INLINE bool sincos_is_far(uint64_t far_bits)
{
    return far_bits >> 17 != 0;
}

// Computes sin and cos of |x| <= YK_SINCOS_LIMIT within 1 ulp; garbage beyond.
YK_INLINE void sincos_near(double x, double *sine, double *cosine)
{
    double shifted = quarter_turns(x), k = shifted - YK_TO_INTEGER;
    double t = x - k * 0x1.921fb5444p+0, p = k * 0x1.68c234c4cp-39; // both products and the difference are exact
    double y = t - p, lost = k * 0x1.98a2e03707345p-77 - ((t - y) - p), y2 = y * y;
    double s = sin_poly(y, lost, y2), c = cos_poly(y, lost, y2);
    uint64_t q = bits_of(shifted);
    bool is_odd = (q & 1) != 0;
    *sine = of_bits(bits_of(is_odd ? c : s) ^ (q << 62 & YK_SIGN_BIT));
    *cosine = of_bits(bits_of(is_odd ? s : c) ^ ((q + 1) << 62 & YK_SIGN_BIT));
}

// Returns atan(u) for |u| <= tan(pi/8).
YK_INLINE double atan_poly(double u)
{
    double z = u * u, w = z * z, w2 = w * w;
    double even = (3.33333333333329318027e-01 + w * 1.42857142725034663711e-01) +
                  w2 * ((9.09088713343650656196e-02 + w * 6.66107313738753120669e-02) +
                        w2 * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02));
    double odd =
        (-1.99999999998764832476e-01 + w * -1.11111104054623557880e-01) +
        w2 * ((-7.69187620504482999495e-02 + w * -5.83357013379057348645e-02) + w2 * -3.65315727442169155270e-02);
    return u - u * (z * even + w * odd);
}

// Returns the angle of (x, y), in [-pi, pi], within 2 ulp, signs of zeros as in C; for magnitudes up to 2^1000. Takes
// the smaller over the larger magnitude, turned by pi/4 if that is closer; then unfolds by octants: j pi/4 +- atan(u).
YK_INLINE double atan2_near(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    double large = ay > ax ? ay : ax, small = ay > ax ? ax : ay;
    bool is_diagonal = small > 0.41421356237309503 * large; // tan(pi/8)
    double numerator = is_diagonal ? small - large : small, denominator = is_diagonal ? small + large : large;
    double a = atan_poly(numerator / (denominator > 0 ? denominator : 1));
    double j = is_diagonal ? 1 : 0;
    j = ay > ax ? 2 - j : j;
    a = ay > ax ? -a : a;
    uint64_t left = bits_of(x) & YK_SIGN_BIT;
    j = left ? 4 - j : j;
    a = of_bits(bits_of(a) ^ left);
    double angle =
        j * 0x1.921fb54442d1p-1 + (a + j * 0x1.08d313198a2ep-50); // pi/4 in two parts: the first product is exact
    return of_bits((bits_of(angle) & ~YK_SIGN_BIT) | (bits_of(y) & YK_SIGN_BIT));
}

// Returns asin(s) for |s| <= sin(pi/8): our own fit, tools/fit_arc_sine.py, 2^-55.
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

// Returns the angle of the unit vector (x, y), in [-pi, pi], within 2 ulp as far as its length is 1, without a
// division. The smaller component is the sine of the angle to the nearest axis, or after a turn by pi/4 to the
// diagonal; then unfolds by octants.
YK_INLINE double unit_angle(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    double large = ay > ax ? ay : ax, small = ax < ay ? ax : ay;
    bool is_diagonal = small > 0.38268343236508977; // sin(pi/8)
    double a = asin_poly(is_diagonal ? (small - large) * 0.70710678118654752 : small);
    double base = is_diagonal ? YK_PI / 4 : 0;
    base = ay > ax ? YK_PI / 2 - base : base;
    a = ay > ax ? -a : a;
    uint64_t left = bits_of(x) & YK_SIGN_BIT;
    base = x < 0 ? YK_PI - base : base;
    a = of_bits(bits_of(a) ^ left);
    return of_bits(bits_of(base + a) | (bits_of(y) & YK_SIGN_BIT));
}

#endif
