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

// Words as long as a number, so that vectors of both are alike.
YK_INLINE uint64_t is_bad(double margin, double least, double gap, double most)
{
    return margin > least && gap <= most ? 0 : UINT64_MAX;
}

YK_INLINE void yk_lanes_well_body(bool *well, const double *margin, const double *gap, double least, double most,
                                  size_t n)
{
    uint64_t bad = 0;
    if (YK_KNOWS_BLOCKS && !gap) {
        YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++) bad |= is_bad(margin[i], least, 0, most);
    } else {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) bad |= is_bad(margin[i], least, gap[i], most);
    }
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

// Returns bits of which the highest is set if a number is not finite.
YK_INLINE uint64_t not_finite(double x)
{
    const uint64_t exponent = (uint64_t)0x7ff << 52, one = (uint64_t)1 << 52;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & exponent) + one;
}

#define FIND(sum)                                                                                                      \
    {                                                                                                                  \
        YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++) found |= not_finite(sum);                                \
        break;                                                                                                         \
    }

// Adds rows, seven at most: no sum is finite unless all of its parts are.
YK_INLINE uint64_t find_not_finite(double *const *rows, size_t count, size_t n)
{
    const double *row[7];
    uint64_t found = 0;
    for (size_t k = 0; k < 7; k++) row[k] = rows[k < count ? k : 0];
    const double *a = row[0], *b = row[1], *c = row[2], *d = row[3], *e = row[4], *f = row[5], *g = row[6];
    switch (count) {
    case 1:
        FIND(a[i])
    case 2:
        FIND(a[i] + b[i])
    case 3:
        FIND((a[i] + b[i]) + c[i])
    case 4:
        FIND((a[i] + b[i]) + (c[i] + d[i]))
    case 5:
        FIND((a[i] + b[i]) + (c[i] + d[i]) + e[i])
    case 6:
        FIND((a[i] + b[i]) + (c[i] + d[i]) + (e[i] + f[i]))
    default:
        FIND((a[i] + b[i]) + (c[i] + d[i]) + ((e[i] + f[i]) + g[i]))
    }
    return found;
}

YK_INLINE void yk_lanes_finite_body(bool *finite, double *const *rows, size_t count, size_t n)
{
    enum { AT_ONCE = YK_KNOWS_BLOCKS ? 4 : 1, MOST = YK_KNOWS_BLOCKS ? 7 : 0 };
    uint64_t found = 0;
    for (; count > MOST; count -= AT_ONCE, rows += AT_ONCE) found |= find_not_finite(rows, AT_ONCE, n);
    if (YK_KNOWS_BLOCKS && count > 0) found |= find_not_finite(rows, count, n);
    *finite = found >> 63 == 0;
}
YK_KERNEL(yk_lanes_finite, (bool *finite, double *const *rows, size_t count, size_t n), (finite, rows, count))
