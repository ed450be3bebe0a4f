// PP: K + d1 e1 + d2 e2 = 0 with known directions: two lines meet.
//
// D = cross(e1, e2): d1 = -cross(K, e2) / D, d2 = cross(K, e1) / D; rates and accelerations the same with G and H for
// K.
#include "solve/kernels/lanes.h"

YK_INLINE void pp_place_loop(bool turns1, bool turns2, YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2,
                             YkSlide d1, YkSlide d2, double *margin, double *own, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec e1 = line_unit(line1, u1, turns1, i), e2 = line_unit(line2, u2, turns2, i), place = lane_place(K, i);
        double D = yk_cross(e1, e2), inverse = 1 / D, m = D * D;
        d1.d[i] = -yk_cross(place, e2) * inverse;
        d2.d[i] = yk_cross(place, e1) * inverse;
        lane_margin(margin, own, i, m, m * inverse); // parallel lines do not meet
    }
}

// Handles turning lines, which are rare: one loop serves them all.
YK_APART void pp_place_turning(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2,
                               double *margin, double *own, size_t n)
{
    pp_place_loop(line1.c != NULL, line2.c != NULL, K, line1, u1, line2, u2, d1, d2, margin, own, n);
}

YK_INLINE void yk_lanes_pp_body(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2,
                                double *margin, double *block_margin, size_t n)
{
    double *own = block_margin ? block_margin : margin;
    if (line1.c || line2.c)
        pp_place_turning(K, line1, u1, line2, u2, d1, d2, margin, own, n);
    else
        pp_place_loop(false, false, K, line1, u1, line2, u2, d1, d2, margin, own, n);
}
YK_KERNEL(yk_lanes_pp,
          (YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2, double *margin,
           double *block_margin, size_t n),
          (K, line1, u1, line2, u2, d1, d2, margin, block_margin))

// Returns d e': the part of the velocity due to the line's rotation.
YK_INLINE YkVec drift(YkTurn line, YkVec e, double d, size_t i)
{
    return yk_scale(d * line.w[i], yk_quarter(e));
}
// Returns d e'' + 2 d' e'.
YK_INLINE YkVec drift_rate(YkTurn line, YkVec e, double d, double rate, size_t i)
{
    double w = line.w[i];
    return yk_sub(yk_scale(d * line.a[i] + 2 * rate * w, yk_quarter(e)), yk_scale(d * w * w, e));
}

YK_INLINE void pp_rate_loop(bool turns1, bool turns2, YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2,
                            YkSlide d1, YkSlide d2, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec e1 = line_unit(line1, u1, turns1, i), e2 = line_unit(line2, u2, turns2, i);
        YkVec G = lane_rate(K, i), H = lane_accel(K, i);
        double inverse = 1 / yk_cross(e1, e2);
        if (turns1) G = yk_add(G, drift(line1, e1, d1.d[i], i));
        if (turns2) G = yk_add(G, drift(line2, e2, d2.d[i], i));
        double v1 = -yk_cross(G, e2) * inverse, v2 = yk_cross(G, e1) * inverse;
        if (turns1) H = yk_add(H, drift_rate(line1, e1, d1.d[i], v1, i));
        if (turns2) H = yk_add(H, drift_rate(line2, e2, d2.d[i], v2, i));
        d1.v[i] = v1;
        d2.v[i] = v2;
        d1.a[i] = -yk_cross(H, e2) * inverse;
        d2.a[i] = yk_cross(H, e1) * inverse;
    }
}

YK_APART void pp_rate_turning(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2,
                              size_t n)
{
    pp_rate_loop(line1.c != NULL, line2.c != NULL, K, line1, u1, line2, u2, d1, d2, n);
}

YK_INLINE void yk_lanes_pp_rates_body(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2,
                                      size_t n)
{
    if (line1.c || line2.c)
        pp_rate_turning(K, line1, u1, line2, u2, d1, d2, n);
    else
        pp_rate_loop(false, false, K, line1, u1, line2, u2, d1, d2, n);
}
YK_KERNEL(yk_lanes_pp_rates,
          (YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2, size_t n),
          (K, line1, u1, line2, u2, d1, d2))
