// RRP: K + W e^(i Phi) + d e = 0: a circle meets a line.
//
// With q = W e^(i Phi): across the line q has the component cross(e, q) = cross(K, e) = h, so along it g = dot(e, q) =
// +-sqrt(W^2 - h^2); q = e (g + i h), d = -dot(e, K) - g. The determinant is g, the margin g^2 / W^2.
// Rates: i q Phi' + e d' = -G, hence Phi' = -cross(e, G) / g, d' = -dot(q, G) / g; accelerations with H likewise.
#ifndef SOLVE_KERNELS_RRP_H
#define SOLVE_KERNELS_RRP_H
#include "solve/kernels/lanes.h"

// One lane before any root; along: dot(e, K).
typedef struct RrpChord {
    double h, along, g2;
} RrpChord;

YK_INLINE RrpChord rrp_chord(YkVec K, YkArmCircle W, YkVec e, bool axial)
{
    double h = -cross_with(e, K, axial);
    return (RrpChord){h, dot_with(e, K, axial), (W.radius - h) * (W.radius + h)};
}

// Returns -g. If places are not computed, its sign is that of the stored distance plus `along`: the same bits, without
// the digits lost to a distance far away.
YK_INLINE double minus_g(Form form, RrpChord known, double branch, double d)
{
    return form.places ? root_on_branch(known.g2, -branch) : root_like(known.g2, d + known.along);
}

YK_INLINE Rates rrp_rates(Form form, Known K, Known W, Line line, double minus_per_g, YkVec q, YkVec E, double d)
{
    YkVec e = line.e, ie = yk_quarter(e), G = K.rate, H = K.accel;
    double inverse = minus_per_g;
    if (form.varies) G = yk_add(G, yk_mul(W.rate, E));
    if (form.turns) G = yk_add(G, yk_scale(d * line.w, ie));
    double w = cross_with(e, G, form.axial) * inverse, v = yk_dot(q, G) * inverse;
    H = yk_sub(H, yk_scale(w * w, q));
    if (form.varies) H = yk_add(H, yk_mul(yk_add(W.accel, yk_scale(2 * w, yk_quarter(W.rate))), E));
    if (form.turns) H = yk_add(H, yk_sub(yk_scale(d * line.a + 2 * v * line.w, ie), yk_scale(d * line.w * line.w, e)));
    return (Rates){w, v, cross_with(e, H, form.axial) * inverse, yk_dot(q, H) * inverse};
}

// Returns sin^2 of the angle between the line and the arm's path; less if the arm is short, unless the loop does not
// close.
YK_INLINE double rrp_margin(Form form, RrpChord known, YkArmCircle circle)
{
    double m = known.g2 * circle.inverse_square;
    return form.careful && m > 0 ? m * circle.share : m;
}

// Solves one lane. `at`: the distance, if places are not computed.
YK_INLINE Found rrp_solve(Form form, Known K, Known W, YkArmCircle circle, Line line, double branch, double at)
{
    RrpChord known = rrp_chord(K.place, circle, line.e, form.axial);
    double minus = minus_g(form, known, branch, at), d = form.places ? minus - known.along : at;
    YkVec q = times(yk_vec(-minus, known.h), line.e, form.axial);
    YkVec E = times(q, circle.inverse, form.axial);
    Found found = {.e = E, .d = d, .margin = rrp_margin(form, known, circle)};
    double minus_per_g = minus * (1 / known.g2); // this division need not wait for the root
    if (form.rates) found.rates = rrp_rates(form, K, W, line, minus_per_g, q, E, d);
    return found;
}

#endif
