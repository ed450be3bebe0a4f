// Answers: angles between bodies, differences of rates, and masks for lanes that do not close.
#include <string.h>
#include "solve/angle.h"
#include "solve/kernels/lanes.h"

YK_INLINE void angle_loop(double *out, YkTurn a, bool has_a, YkTurn b, bool has_b, double offset, double reference,
                          size_t n)
{
    const YkVec ground = {1, 0};
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec e_b = has_b ? lane_unit(b, i) : ground, e_a = has_a ? lane_unit(a, i) : ground;
        out[i] = angle_between(e_a, has_a, e_b, offset, reference);
    }
}

YK_INLINE void yk_lanes_angle_body(double *out, YkTurn a, YkTurn b, double offset, double reference, size_t n)
{
    if (a.c && b.c)
        angle_loop(out, a, true, b, true, offset, reference, n);
    else if (b.c)
        angle_loop(out, a, false, b, true, offset, reference, n);
    else
        angle_loop(out, a, a.c != NULL, b, false, offset, reference, n);
}
YK_KERNEL(yk_lanes_angle, (double *out, YkTurn a, YkTurn b, double offset, double reference, size_t n),
          (out, a, b, offset, reference))

YK_INLINE void yk_lanes_difference_body(double *out, const double *b, const double *a, size_t n)
{
    if (a && b) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = b[i] - a[i];
    } else if (b) {
        memcpy(out, b, n * sizeof *out);
    } else if (a) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = 0 - a[i];
    } else {
        memset(out, 0, n * sizeof *out);
    }
}
YK_KERNEL(yk_lanes_difference, (double *out, const double *b, const double *a, size_t n), (out, b, a))

YK_INLINE void yk_lanes_mask_body(double *value, const double *margin, double least, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) value[i] = margin[i] >= least ? value[i] : 0;
}
YK_KERNEL(yk_lanes_mask, (double *value, const double *margin, double least, size_t n), (value, margin, least))

YK_INLINE void yk_lanes_well_body(bool *well, const double *margin, const double *gap, double least, double most,
                                  size_t n)
{
    uint64_t bad = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) bad |= margin[i] > least && gap[i] <= most ? 0u : 1u;
    *well = bad == 0;
}
YK_KERNEL(yk_lanes_well, (bool *well, const double *margin, const double *gap, double least, double most, size_t n),
          (well, margin, gap, least, most))

YK_INLINE void yk_lanes_dip_body(bool *dips, const double *margin, double zero, double most, size_t n)
{
    uint64_t bad = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double a = margin[i], m = margin[i + 1], b = margin[i + 2];
        double low = a < m ? a : m, high = a > m ? a : m;
        low = low < b ? low : b;
        high = high > b ? high : b;
        double range = high - low;
        bad |= low > zero && range <= most && low >= 0.2 * range ? 0u : 1u;
    }
    *dips = bad != 0;
}
YK_KERNEL(yk_lanes_dip, (bool *dips, const double *margin, double zero, double most, size_t n),
          (dips, margin, zero, most))

YK_INLINE void yk_lanes_swing_body(bool *swings, const double *c, const double *s, double least, size_t n)
{
    uint64_t bad = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) bad |= c[i] * c[i + 1] + s[i] * s[i + 1] >= least ? 0u : 1u;
    *swings = bad != 0;
}
YK_KERNEL(yk_lanes_swing, (bool *swings, const double *c, const double *s, double least, size_t n),
          (swings, c, s, least))

// Adds rows: no sum is finite unless all of its parts are. Returns bits of which the highest is set if one is not.
YK_INLINE uint64_t find_not_finite(const double *a, const double *b, const double *c, const double *d, size_t n)
{
    const uint64_t exponent = (uint64_t)0x7ff << 52, one = (uint64_t)1 << 52;
    uint64_t found = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double sum = (a[i] + b[i]) + (c[i] + d[i]);
        uint64_t bits;
        memcpy(&bits, &sum, sizeof bits);
        found |= (bits & exponent) + one;
    }
    return found;
}

YK_INLINE void yk_lanes_finite_body(bool *finite, double *const *rows, size_t count, size_t n)
{
    uint64_t found = 0;
    size_t k = 0;
    for (; k + 4 <= count; k += 4) found |= find_not_finite(rows[k], rows[k + 1], rows[k + 2], rows[k + 3], n);
    if (YK_KNOWS_BLOCKS && k < count && count >= 4) // some rows once more
        found |= find_not_finite(rows[count - 4], rows[count - 3], rows[count - 2], rows[count - 1], n);
    for (; k < count && !(YK_KNOWS_BLOCKS && count >= 4); k++)
        found |= find_not_finite(rows[k], rows[k], rows[k], rows[k], n);
    *finite = found >> 63 == 0;
}
YK_KERNEL(yk_lanes_finite, (bool *finite, double *const *rows, size_t count, size_t n), (finite, rows, count))
