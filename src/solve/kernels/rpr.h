// RPR: K + (C + d u e^(i inner)) e^(i Phi) = 0: a line that turns about a pin passes through a point.
//
// In the turning axes, with f = u e^(i inner): C + d f = f (r + i h), where h = cross(f, C) is known and r^2 + h^2 =
// K^2, so r = +-sqrt(K^2 - h^2), d = r - dot(f, C). Then the line's direction in the plane is e = f e^(i Phi) = -K (r -
// i h) / K^2. Rates: with p = -K, e d' + i p Phi' = -G, hence Phi' = cross(G, e) / r, d' = dot(G, K) / r; accelerations
// with H likewise.
//
// The determinant is r. K is known up to the rounding of the machine's lengths, and so is the direction, up to that
// rounding over K. If the point comes to the pin (h = 0, K -> 0), r / K therefore says nothing, but r over the
// machine's size does. The margin is the lesser of the two, squared: r^2 / max(K^2, size^2).
#ifndef SOLVE_KERNELS_RPR_H
#define SOLVE_KERNELS_RPR_H
#include "solve/kernels/lanes.h"

// One lane before any root: 1 / K^2 and 1 / r^2 come from one division that need not wait for it. If r^2 <= 0, the last
// is meaningless; if K = 0 (any angle would do), both are.
typedef struct RprTriangle {
    YkVec K;
    double h, along, r2, per_K2, per_r2;
} RprTriangle; // along: dot(f, C)

YK_INLINE RprTriangle rpr_triangle(YkVec K, YkVec C, YkVec f, bool axial)
{
    if (axial) { // and C = 0: the line passes through the pin
        double K2 = yk_dot(K, K), inverse = 1 / K2;
        return (RprTriangle){K, 0, 0, K2, inverse, inverse};
    }
    double h = yk_cross(f, C), K2 = yk_dot(K, K), r2 = K2 - h * h, factor = not_zero(r2), inverse = 1 / (K2 * factor);
    return (RprTriangle){K, h, yk_dot(f, C), r2, factor * inverse, K2 * inverse};
}

// Returns r. If places are not computed, its sign is that of the stored distance plus `along`: the same bits, without
// the digits lost to a pin far from the line's origin.
YK_INLINE double rpr_root(Form form, RprTriangle known, double branch, double d)
{
    if (form.places) return root_on_branch(known.r2, branch);
    return form.axial ? d : root_like(known.r2, d + known.along);
}

// Returns the line's direction: of length 1 for any K, since r^2 + h^2 = K^2.
YK_INLINE YkVec rpr_direction(RprTriangle known, double r, bool axial)
{
    if (axial) return yk_scale(-r * known.per_K2, known.K);
    return yk_mul(known.K, yk_vec(-r * known.per_K2, known.h * known.per_K2));
}

// Returns the margin; a loop that does not close (K < h) is measured relative to the base.
YK_INLINE double rpr_margin(RprTriangle known, double per_enough2, bool axial)
{
    bool is_short = per_enough2 < known.per_K2 && (axial || known.r2 >= 0);
    return known.r2 * (is_short ? per_enough2 : known.per_K2);
}

// Returns the rates. inverse: 1 / r.
YK_INLINE Rates rpr_rates(Form form, Known K, Known C, Line inner, double inverse, YkVec e, YkVec E, double d)
{
    YkVec G = K.rate, H = K.accel, ie = yk_quarter(e),
          known = yk_vec(0, 0); // of the turning axes' (C + d f)', except d' e
    if (form.varies) known = yk_mul(C.rate, E);
    if (form.turns) known = yk_add(known, yk_scale(d * inner.w, ie));
    if (form.varies || form.turns) G = yk_add(G, known);
    double w = yk_cross(G, e) * inverse, v = yk_dot(G, K.place) * inverse;
    H = yk_add(H, yk_add(yk_scale(2 * w * v, ie), yk_scale(w * w, K.place)));
    if (form.varies || form.turns) H = yk_add(H, yk_scale(2 * w, yk_quarter(known)));
    if (form.varies) H = yk_add(H, yk_mul(C.accel, E));
    if (form.turns)
        H = yk_add(H, yk_sub(yk_scale(d * inner.a + 2 * v * inner.w, ie), yk_scale(d * inner.w * inner.w, e)));
    return (Rates){w, v, yk_cross(H, e) * inverse, yk_dot(H, K.place) * inverse};
}

// Solves one lane. `at`: the distance, if places are not computed. per_enough2: 1 / size^2.
YK_INLINE Found rpr_solve(Form form, Known K, Known C, double per_enough2, Line inner, double branch, double at)
{
    RprTriangle known = rpr_triangle(K.place, C.place, inner.e, form.axial);
    double r = rpr_root(form, known, branch, at), d = !form.places ? at : form.axial ? r : r - known.along;
    YkVec e = rpr_direction(known, r, form.axial), E = times(e, yk_conj(inner.e), form.axial);
    Found found = {.e = E, .d = d, .margin = rpr_margin(known, per_enough2, form.axial)};
    if (form.rates) found.rates = rpr_rates(form, K, C, inner, r * known.per_r2, e, E, d);
    return found;
}

#endif
