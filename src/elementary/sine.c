// sin and cos: one at a time and over lanes.
#include "elementary/elementary.h"
#include "elementary/turn.h"

void yk_sincos(double x, double *s, double *c)
{
    if (sincos_is_far(sincos_far_bits(x)))
        sincos_reduced(yk_reduce_far(x), s, c);
    else
        sincos_near(x, s, c);
}

double yk_sin(double x)
{
    double s, c;
    yk_sincos(x, &s, &c);
    return s;
}

double yk_cos(double x)
{
    double s, c;
    yk_sincos(x, &s, &c);
    return c;
}

// Repeats the lanes one by one if at least one is beyond the reduction's range.
YK_APART void sincos_one_by_one(const double *x, double *s, double *c, size_t n)
{
    for (size_t i = 0; i < n; i++) yk_sincos(x[i], &s[i], &c[i]);
}

YK_INLINE void yk_sincos_lanes_body(const double *x, double *s, double *c, size_t n)
{
    uint64_t far = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        far |= sincos_far_bits(x[i]);
        sincos_near(x[i], &s[i], &c[i]);
    }
    if (sincos_is_far(far)) sincos_one_by_one(x, s, c, n);
}
YK_KERNEL(yk_sincos_lanes, (const double *x, double *s, double *c, size_t n), (x, s, c))
