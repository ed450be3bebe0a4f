// RRP: K + W e^(i Phi) + d e = 0, a circle meets a line.
//
// With q = W e^(i Phi): across the line q has the component cross(e, q) = cross(K, e) = h, so along it g = dot(e, q) =
// +-sqrt(W^2 - h^2); q = e (g + i h), d = -dot(e, K) - g. The determinant is g, the margin g^2 / W^2.
// Rates: i q Phi' + e d' = -G, hence Phi' = -cross(e, G) / g, d' = -dot(q, G) / g; accelerations with H likewise.
#ifndef SOLVE_RRP_H
#define SOLVE_RRP_H
#include "solve/lanes.h"

// One lane before any root; along: dot(e, K).
typedef struct RrpChord {
    double h, along, g2;
} RrpChord;

YK_INLINE RrpChord rrp_chord(YkVec K, YkArmCircle W, YkVec e, bool axial)
{
    double h = -cross_with(e, K, axial);
    return (RrpChord){h, dot_with(e, K, axial), (W.radius - h) * (W.radius + h)};
}

// -g, from the distance as it is stored: whoever has the distance finds the same bits.
YK_INLINE double minus_g(RrpChord known, double d)
{
    return d + known.along;
}

YK_INLINE Rates rrp_rates(Form form, Known K, Known W, Line line, RrpChord chord, YkVec q, YkVec E, double d)
{
    YkVec e = line.e, ie = yk_quarter(e), G = K.rate, H = K.accel;
    double inverse = minus_g(chord, d) * (1 / chord.g2); // -1 / g; this division need not wait for the root
    if (form.varies) G = yk_add(G, yk_mul(W.rate, E));
    if (form.turns) G = yk_add(G, yk_scale(d * line.w, ie));
    double w = cross_with(e, G, form.axial) * inverse, v = yk_dot(q, G) * inverse;
    H = yk_sub(H, yk_scale(w * w, q));
    if (form.varies) H = yk_add(H, yk_mul(yk_add(W.accel, yk_scale(2 * w, yk_quarter(W.rate))), E));
    if (form.turns) H = yk_add(H, yk_sub(yk_scale(d * line.a + 2 * v * line.w, ie), yk_scale(d * line.w * line.w, e)));
    return (Rates){w, v, cross_with(e, H, form.axial) * inverse, yk_dot(q, H) * inverse};
}

// `at`: the distance, where places are not asked.
YK_INLINE Found rrp_solve(Form form, Known K, Known W, YkArmCircle circle, Line line, double branch, double at)
{
    RrpChord known = rrp_chord(K.place, circle, line.e, form.axial);
    double d = form.places ? -branch * root_of(known.g2) - known.along : at;
    YkVec q = times(yk_vec(-minus_g(known, d), known.h), line.e, form.axial);
    YkVec E = times(q, circle.inverse, form.axial);
    Found found = {.e = E, .d = d, .margin = known.g2 * circle.inverse_square};
    if (form.rates) found.rates = rrp_rates(form, K, W, line, known, q, E, d);
    return found;
}

#endif
