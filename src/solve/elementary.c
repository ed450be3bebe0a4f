// sin, cos and atan2: one at a time and, for sin and cos, over lanes.
#include "solve/elementary.h"

void yk_sincos(double x, double *s, double *c)
{
    if (sincos_is_far(sincos_far_bits(x))) {
        *s = sin(x);
        *c = cos(x);
    } else {
        sincos_near(x, s, c);
    }
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

double yk_atan2(double y, double x)
{
    bool is_moderate = fabs(x) <= 0x1p1000 && fabs(y) <= 0x1p1000;
    return is_moderate ? atan2_near(y, x) : atan2(y, x);
}
