// Answers: angles between bodies, differences of rates, and the mask over what does not close.
#include "solve/elementary.h"

// angle + offset, less as many turns as bring it nearest to the reference.
YK_INLINE double near_reference(double angle, double offset, double reference)
{
    double sum = angle + offset, turns = (sum - reference) * (1 / (2 * YK_PI));
    double k = (turns + YK_TO_INTEGER) - YK_TO_INTEGER;
    return sum - k * (2 * YK_PI);
}

YK_INLINE void angle_loop(double *out, YkTurn a, bool has_a, YkTurn b, bool has_b, double offset, double reference,
                          size_t n)
{
    const YkVec ground = {1, 0};
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec e_b = has_b ? lane_unit(b, i) : ground, e = has_a ? yk_mul(e_b, yk_conj(lane_unit(a, i))) : e_b;
        out[i] = near_reference(unit_angle(e.y, e.x), offset, reference);
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
