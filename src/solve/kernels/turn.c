// Orientations: the turn of a joint, and of one body by another.
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "solve/kernels/lanes.h"

// Turns by x, on top of the parent's turn if there is a parent.
YK_INLINE void turn_lane(YkTurn out, YkTurn parent, bool has_parent, YkVec e, size_t i)
{
    lane_set_unit(out, i, has_parent ? yk_mul(lane_unit(parent, i), e) : e);
}

// Returns bits that are set if any angle is beyond the range of the quick reduction.
YK_INLINE uint64_t turn_near(YkTurn out, YkTurn parent, bool has_parent, const double *theta, double offset,
                             double sign, size_t n)
{
    uint64_t far = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double x = sign * (theta[i] + offset);
        YkVec e;
        sincos_near(x, &e.y, &e.x);
        far |= sincos_far_bits(x);
        turn_lane(out, parent, has_parent, e, i);
    }
    return far;
}

YK_APART void turn_one_by_one(YkTurn out, YkTurn parent, const double *theta, double offset, double sign, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec e;
        yk_sincos(sign * (theta[i] + offset), &e.y, &e.x);
        turn_lane(out, parent, parent.c != NULL, e, i);
    }
}

// Computes out = base + sign * change; either may be NULL: zero.
YK_INLINE void turn_rates(double *out, const double *base, const double *change, double sign, size_t n)
{
    if (base && change) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = base[i] + sign * change[i];
    } else if (change && !(change == out && sign == 1)) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = sign * change[i];
    } else if (base) {
        memcpy(out, base, n * sizeof *out);
    } else if (!change) {
        memset(out, 0, n * sizeof *out);
    }
}

YK_INLINE void yk_lanes_turn_body(YkTurn out, YkTurn parent, const double *theta, const double *rate,
                                  const double *accel, double offset, double sign, size_t n)
{
    uint64_t far = 0;
    if (out.c && parent.c)
        far = turn_near(out, parent, true, theta, offset, sign, n);
    else if (out.c)
        far = turn_near(out, parent, false, theta, offset, sign, n);
    if (out.c && sincos_is_far(far)) turn_one_by_one(out, parent, theta, offset, sign, n);
    turn_rates(out.w, parent.c ? parent.w : NULL, rate, sign, n);
    turn_rates(out.a, parent.c ? parent.a : NULL, accel, sign, n);
}
YK_KERNEL(yk_lanes_turn,
          (YkTurn out, YkTurn parent, const double *theta, const double *rate, const double *accel, double offset,
           double sign, size_t n),
          (out, parent, theta, rate, accel, offset, sign))

// Copies an orientation; the ground's is (1, 0) at rest.
YK_APART void turn_copy(YkTurn out, YkTurn a, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        out.c[i] = a.c ? a.c[i] : 1;
        out.s[i] = a.c ? a.s[i] : 0;
        out.w[i] = a.c ? a.w[i] : 0;
        out.a[i] = a.c ? a.a[i] : 0;
    }
}

YK_INLINE void yk_lanes_compose_body(YkTurn out, YkTurn a, YkTurn b, size_t n)
{
    if (!a.c || !b.c) {
        turn_copy(out, a.c ? a : b, n);
        return;
    }
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        lane_set_unit(out, i, yk_mul(lane_unit(a, i), lane_unit(b, i)));
        out.w[i] = a.w[i] + b.w[i];
        out.a[i] = a.a[i] + b.a[i];
    }
}
YK_KERNEL(yk_lanes_compose, (YkTurn out, YkTurn a, YkTurn b, size_t n), (out, a, b))
