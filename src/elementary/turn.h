// sin and cos without branches, one lane: the bodies that kernels inline, and the reduction they share with tan.
//
// Reduction: Cody & Waite 1980, "Software Manual for the Elementary Functions", ch. 8, in three parts of pi/2 with the
// rounding of the second difference carried along. Polynomials: the published minimax coefficients of fdlibm (Sun
// Microsystems 1993: k_sin, k_cos), evaluated in our own order.
#ifndef ELEMENTARY_TURN_H
#define ELEMENTARY_TURN_H
#include "elementary/bits.h"

// x = q pi/2 + (y - lost), |y| <= pi/4: lost is what rounding added to y; of q count the last two bits.
typedef struct Reduced {
    double y, lost;
    uint64_t q;
} Reduced;

// The reduction of any x beyond the near range; NaN where x is infinite or NaN. Source: Payne & Hanek 1983.
Reduced yk_reduce_far(double x);

// (sin(r) - r) / -r^3 for r = y - lost, as far as it counts.
YK_INLINE double sin_cubic(double y2)
{
    double y4 = y2 * y2;
    double r = (8.33333333332248946124e-03 + y2 * -1.98412698298579493134e-04) +
               y4 * ((2.75573137070700676789e-06 + y2 * -2.50507602534068634195e-08) + y4 * 1.58969099521155010221e-10);
    return 1.66666666666666324348e-01 - y2 * r;
}

// (cos(r) - 1 + r^2/2) / r^4.
YK_INLINE double cos_quartic(double y2, double y4)
{
    return (4.16666666666666019037e-02 + y2 * -1.38888888888741095749e-03) +
           y4 * ((2.48015872894767294178e-05 + y2 * -2.75573143513906633035e-07) +
                 y4 * (2.08757232129817482790e-09 + y2 * -1.13596475577881948265e-11));
}

// sin(y - lost) for |y| <= pi/4.
YK_INLINE double sin_poly(double y, double lost, double y2)
{
    double y3 = y2 * y, w = 1 - 0.5 * y2; // the cosine, as far as what is lost asks for
    return y - (lost * w + y3 * sin_cubic(y2));
}

// cos(y - lost), likewise.
YK_INLINE double cos_poly(double y, double lost, double y2)
{
    double y4 = y2 * y2, half = 0.5 * y2, w = 1 - half;
    return w + (((1 - w) - half) + (y4 * cos_quartic(y2, y4) + y * lost));
}

// x in quarter turns, to the nearest, plus YK_TO_INTEGER.
YK_INLINE double quarter_turns(double x)
{
    return x * 0x1.45f306dc9c883p-1 + YK_TO_INTEGER;
}

// Returns whether x (NaN too) is beyond the near range, at most 2^16 quarter turns, so that the products with 37-bit
// parts of pi/2 are exact: a bit of the answer above the lowest 17 is set. Answers of many x may be or-ed.
YK_INLINE uint64_t sincos_far_bits(double x)
{
    return bits_of(quarter_turns(x)) - (bits_of(YK_TO_INTEGER) - 0x10000);
}
YK_INLINE bool sincos_is_far(uint64_t far_bits)
{
    return far_bits >> 17 != 0;
}

YK_INLINE Reduced reduce_near(double x)
{
    double shifted = quarter_turns(x), k = shifted - YK_TO_INTEGER;
    double t = x - k * 0x1.921fb5444p+0, p = k * 0x1.68c234c4cp-39; // both products and the difference are exact
    double y = t - p, lost = k * 0x1.98a2e03707345p-77 - ((t - y) - p);
    return (Reduced){y, lost, bits_of(shifted)};
}

YK_INLINE void sincos_reduced(Reduced r, double *sine, double *cosine)
{
    double y2 = r.y * r.y, s = sin_poly(r.y, r.lost, y2), c = cos_poly(r.y, r.lost, y2);
    bool is_odd = (r.q & 1) != 0;
    *sine = of_bits(bits_of(is_odd ? c : s) ^ (r.q << 62 & YK_SIGN_BIT));
    *cosine = of_bits(bits_of(is_odd ? s : c) ^ ((r.q + 1) << 62 & YK_SIGN_BIT));
}

// sin and cos in the near range; garbage beyond.
YK_INLINE void sincos_near(double x, double *sine, double *cosine)
{
    sincos_reduced(reduce_near(x), sine, cosine);
}

#endif
