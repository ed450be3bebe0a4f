// RPR: K + (C + d u e^(i inner)) e^(i Phi) = 0, a line that turns about a pin passes a point.
//
// In the turning axes, with f = u e^(i inner): C + d f = f (r + i h), where h = cross(f, C) is known and r^2 + h^2 =
// K^2, so r = +-sqrt(K^2 - h^2), d = r - dot(f, C). Then the line's direction in the plane is e = f e^(i Phi) = -K (r -
// i h) / K^2. The determinant is r, the margin r^2 / K^2. Rates: with p = -K, e d' + i p Phi' = -G, hence Phi' =
// cross(G, e) / r, d' = dot(G, K) / r; accelerations with H likewise.
#include "solve/lanes.h"

// One lane before any root: 1 / K^2 and 1 / r^2 come of one division that need not wait for it. Where r^2 <= 0, the
// last means nothing; where K = 0 (any angle would do), neither.
typedef struct Triangle {
    YkVec K, f;
    double h, along, r2, per_K2, per_r2;
} Triangle; // along: dot(f, C)

YK_INLINE Triangle triangle_of(YkVec K, YkVec C, YkVec f, bool axial)
{
    if (axial) { // and C = 0: the line passes the pin
        double K2 = yk_dot(K, K), inverse = 1 / K2;
        return (Triangle){K, f, 0, 0, K2, inverse, inverse};
    }
    double h = yk_cross(f, C), K2 = yk_dot(K, K), r2 = K2 - h * h, factor = not_zero(r2), inverse = 1 / (K2 * factor);
    return (Triangle){K, f, h, yk_dot(f, C), r2, factor * inverse, K2 * inverse};
}

// The line's direction, from the distance as it is stored: whoever has the distance finds the same bits.
YK_INLINE YkVec direction(Triangle known, double d, bool axial)
{
    if (axial) return yk_scale(-d * known.per_K2, known.K);
    return yk_mul(known.K, yk_vec(-(d + known.along) * known.per_K2, known.h * known.per_K2));
}

YK_INLINE Rates rpr_rates(Form form, Known K, Known C, double spin, double spin_rate, Triangle triangle, YkVec e,
                          YkVec E, double d)
{
    YkVec G = K.rate, H = K.accel, ie = yk_quarter(e),
          known = yk_vec(0, 0); // of the turning axes' (C + d f)', all but d' e
    double inverse = (form.axial ? d : d + triangle.along) * triangle.per_r2; // 1 / r
    if (form.varies) known = yk_mul(C.rate, E);
    if (form.turns) known = yk_add(known, yk_scale(d * spin, ie));
    if (form.varies || form.turns) G = yk_add(G, known);
    double w = yk_cross(G, e) * inverse, v = yk_dot(G, K.place) * inverse;
    H = yk_add(H, yk_add(yk_scale(2 * w * v, ie), yk_scale(w * w, K.place)));
    if (form.varies || form.turns) H = yk_add(H, yk_scale(2 * w, yk_quarter(known)));
    if (form.varies) H = yk_add(H, yk_mul(C.accel, E));
    if (form.turns) H = yk_add(H, yk_sub(yk_scale(d * spin_rate + 2 * v * spin, ie), yk_scale(d * spin * spin, e)));
    return (Rates){w, v, yk_cross(H, e) * inverse, yk_dot(H, K.place) * inverse};
}

YK_INLINE void rpr_loop(Form form, YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d,
                        double *margin, double *own, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec f = line_unit(inner, u, form.turns, i);
        Triangle known = triangle_of(lane_place(K, i), arm_place(C, form.varies, i), f, form.axial);
        double at = !form.places ? d.d[i] : branch * root_of(known.r2) - (form.axial ? 0 : known.along);
        YkVec e = direction(known, at, form.axial), E = times(e, yk_conj(f), form.axial);
        if (form.places) {
            double m = known.r2 * known.per_K2;
            d.d[i] = at;
            lane_set_unit(out, i, E);
            lane_margin(margin, own, i, m, m);
        }
        if (form.rates) {
            double spin = form.turns ? inner.w[i] : 0, spin_rate = form.turns ? inner.a[i] : 0;
            Known arm = arm_known(C, form.varies, i);
            lane_set_rates(out, d, i, rpr_rates(form, lane_known(K, i), arm, spin, spin_rate, known, e, E, at));
        }
    }
}

// Arms that vary and inner turns are rare: one loop serves them all.
YK_APART void rpr_varying(bool places, bool rates, YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    Form form = {places, rates, arm_varies(C), inner.c != NULL, false};
    rpr_loop(form, K, C, inner, u, branch, out, d, margin, own, n);
}

YK_INLINE void rpr_choose(bool places, bool rates, YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    if (arm_varies(C) || inner.c)
        rpr_varying(places, rates, K, C, inner, u, branch, out, d, margin, own, n);
    else if (is_axial(u) && C.constant.x == 0 && C.constant.y == 0)
        rpr_loop((Form){places, rates, false, false, true}, K, C, inner, u, branch, out, d, margin, own, n);
    else
        rpr_loop((Form){places, rates, false, false, false}, K, C, inner, u, branch, out, d, margin, own, n);
}

YK_INLINE void yk_lanes_rpr_body(YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d,
                                 double *margin, double *block_margin, size_t n)
{
    rpr_choose(true, false, K, C, inner, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
}
YK_KERNEL(yk_lanes_rpr,
          (YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, C, inner, u, branch, out, d, margin, block_margin))

YK_INLINE void yk_lanes_rpr_rates_body(YkPlane K, YkArm C, YkTurn inner, YkVec u, YkTurn out, YkSlide d, size_t n)
{
    rpr_choose(false, true, K, C, inner, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rpr_rates, (YkPlane K, YkArm C, YkTurn inner, YkVec u, YkTurn out, YkSlide d, size_t n),
          (K, C, inner, u, out, d))

YK_INLINE void yk_lanes_rpr_all_body(YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d,
                                     double *margin, double *block_margin, size_t n)
{
    rpr_choose(true, YK_ONE_PASS, K, C, inner, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) yk_lanes_rpr_rates_body(K, C, inner, u, out, d, n);
}
YK_KERNEL(yk_lanes_rpr_all,
          (YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, C, inner, u, branch, out, d, margin, block_margin))
