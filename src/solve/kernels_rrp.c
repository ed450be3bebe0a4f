// RRP: K + W e^(i Phi) + d e = 0, a circle meets a line.
//
// With q = W e^(i Phi): across the line q has the component cross(e, q) = cross(K, e) = h, so along it g = dot(e, q) =
// +-sqrt(W^2 - h^2); q = e (g + i h), d = -dot(e, K) - g. The determinant is g, the margin g^2 / W^2.
// Rates: i q Phi' + e d' = -G, hence Phi' = -cross(e, G) / g, d' = -dot(q, G) / g; accelerations with H likewise.
#include "solve/lanes.h"

// The circle: its radius and what turns q back to e^(i Phi).
typedef struct Circle {
    double radius, inverse_square;
    YkVec inverse;
} Circle;

YK_INLINE Circle circle_of(YkVec W)
{
    double square = yk_dot(W, W), inverse = 1 / square;
    return (Circle){sqrt(square), inverse, yk_scale(inverse, yk_conj(W))};
}

// One lane before any root; along: dot(e, K).
typedef struct Chord {
    YkVec e;
    double h, along, g2;
} Chord;

YK_INLINE Chord chord_of(YkVec K, Circle W, YkVec e, bool axial)
{
    double h = -cross_with(e, K, axial);
    return (Chord){e, h, dot_with(e, K, axial), (W.radius - h) * (W.radius + h)};
}

// -g, from the distance as it is stored: whoever has the distance finds the same bits.
YK_INLINE double minus_g(Chord known, double d)
{
    return d + known.along;
}

YK_INLINE Rates rrp_rates(Form form, Known K, Known W, double spin, double spin_rate, Chord chord, YkVec q, YkVec E,
                          double d)
{
    YkVec e = chord.e, ie = yk_quarter(e), G = K.rate, H = K.accel;
    double inverse = minus_g(chord, d) * (1 / chord.g2); // -1 / g; this division need not wait for the root
    if (form.varies) G = yk_add(G, yk_mul(W.rate, E));
    if (form.turns) G = yk_add(G, yk_scale(d * spin, ie));
    double w = cross_with(e, G, form.axial) * inverse, v = yk_dot(q, G) * inverse;
    H = yk_sub(H, yk_scale(w * w, q));
    if (form.varies) H = yk_add(H, yk_mul(yk_add(W.accel, yk_scale(2 * w, yk_quarter(W.rate))), E));
    if (form.turns) H = yk_add(H, yk_sub(yk_scale(d * spin_rate + 2 * v * spin, ie), yk_scale(d * spin * spin, e)));
    return (Rates){w, v, cross_with(e, H, form.axial) * inverse, yk_dot(q, H) * inverse};
}

YK_INLINE void rrp_loop(Form form, YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                        double *margin, double *own, size_t n)
{
    Circle constant = circle_of(W.constant);
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Circle circle = form.varies ? circle_of(lane_place(W.lanes, i)) : constant;
        Chord known = chord_of(lane_place(K, i), circle, line_unit(line, u, form.turns, i), form.axial);
        double at = form.places ? -branch * root_of(known.g2) - known.along : d.d[i];
        YkVec q = times(yk_vec(-minus_g(known, at), known.h), known.e, form.axial);
        YkVec E = times(q, circle.inverse, form.axial);
        if (form.places) {
            double m = known.g2 * circle.inverse_square;
            d.d[i] = at;
            lane_set_unit(out, i, E);
            lane_margin(margin, own, i, m, m);
        }
        if (form.rates) {
            double spin = form.turns ? line.w[i] : 0, spin_rate = form.turns ? line.a[i] : 0;
            Known arm = arm_known(W, form.varies, i);
            lane_set_rates(out, d, i, rrp_rates(form, lane_known(K, i), arm, spin, spin_rate, known, q, E, at));
        }
    }
}

// Arms that vary are rare: one loop serves them all.
YK_APART void rrp_varying(bool places, bool rates, YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    Form form = {places, rates, true, line.c != NULL, false};
    rrp_loop(form, K, W, line, u, branch, out, d, margin, own, n);
}

YK_INLINE void rrp_choose(bool places, bool rates, YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    if (arm_varies(W))
        rrp_varying(places, rates, K, W, line, u, branch, out, d, margin, own, n);
    else if (line.c)
        rrp_loop((Form){places, rates, false, true, false}, K, W, line, u, branch, out, d, margin, own, n);
    else if (is_axial(u) && is_axial(W.constant))
        rrp_loop((Form){places, rates, false, false, true}, K, W, line, u, branch, out, d, margin, own, n);
    else
        rrp_loop((Form){places, rates, false, false, false}, K, W, line, u, branch, out, d, margin, own, n);
}

YK_INLINE void yk_lanes_rrp_body(YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                                 double *margin, double *block_margin, size_t n)
{
    rrp_choose(true, false, K, W, line, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
}
YK_KERNEL(yk_lanes_rrp,
          (YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, W, line, u, branch, out, d, margin, block_margin))

YK_INLINE void yk_lanes_rrp_rates_body(YkPlane K, YkArm W, YkTurn line, YkVec u, YkTurn out, YkSlide d, size_t n)
{
    rrp_choose(false, true, K, W, line, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrp_rates, (YkPlane K, YkArm W, YkTurn line, YkVec u, YkTurn out, YkSlide d, size_t n),
          (K, W, line, u, out, d))

YK_INLINE void yk_lanes_rrp_all_body(YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                                     double *margin, double *block_margin, size_t n)
{
    rrp_choose(true, YK_ONE_PASS, K, W, line, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) yk_lanes_rrp_rates_body(K, W, line, u, out, d, n);
}
YK_KERNEL(yk_lanes_rrp_all,
          (YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, W, line, u, branch, out, d, margin, block_margin))
