// RRR: K + U e^(i Phi1) + W e^(i Phi2) = 0: two circles meet.
//
// With L = -K = p + q: dot(p, L) = A = (L^2 + U^2 - W^2) / 2 and cross(p, q) = D, where
// 4 D^2 = ((U+W)^2 - L^2) (L^2 - (U-W)^2); hence p = L (A - i D) / L^2 and q = L (L^2 - A + i D) / L^2.
// Rates: i p Phi1' + i q Phi2' = -G, hence Phi1' = -dot(G, q) / D, Phi2' = dot(G, p) / D; accelerations with H
// likewise.
#ifndef SOLVE_KERNELS_RRR_H
#define SOLVE_KERNELS_RRR_H
#include "solve/kernels/lanes.h"

// One lane before any root: 4 D^2, 1 / (2 L^2) and 1 / (4 D^2). If D^2 <= 0, the last is meaningless; if L = 0 (any
// angle would do), the one before. Each has a division of its own, so that neither waits for more than it needs: in a
// chain of dyads the waiting is the cost.
typedef struct RrrTriangle {
    double L2, square, half_per_L2, per_square;
} RrrTriangle;

YK_INLINE RrrTriangle rrr_triangle(YkVec K, YkArmPair arms)
{
    double L2 = yk_dot(K, K), square = (arms.outer - L2) * (L2 - arms.inner);
    return (RrrTriangle){L2, square, 0.5 / L2, 1 / not_zero(square)};
}

// Returns sin^2 of the angle between the arms; less if they are short. A loop that does not close is measured relative
// to the base if that is short: a gap of 1e-9 is nothing to arms of 1, but much to a base of 1e-8.
YK_INLINE double rrr_margin(RrrTriangle known, YkArmPair arms, bool careful)
{
    double m = known.square * arms.scale, shortness = 2 * arms.rectangle * known.half_per_L2;
    return m < 0 ? m * (shortness > 1 ? shortness : 1) : careful ? m * arms.share : m;
}

// The solution: the arms as they stand, and D.
typedef struct Rrr {
    YkVec p, q;
    double D;
} Rrr;

YK_INLINE Rrr rrr_place(YkVec K, YkArmPair arms, RrrTriangle known, double branch)
{
    double half = known.half_per_L2, root = root_of(known.square);
    YkVec across =
        yk_scale(root, yk_quarter(yk_scale(branch * half, K))); // the root, which comes last, enters one product
    YkVec p = yk_add(yk_scale(-(known.L2 + arms.product) * half, K), across);
    YkVec q = yk_sub(yk_scale(-(known.L2 - arms.product) * half, K), across);
    return (Rrr){p, q, 0.5 * branch * root};
}

// Returns U'' e^(i Phi) + 2 i Phi' U' e^(i Phi): what a varying arm adds to the acceleration.
YK_INLINE YkVec swing(Known U, YkVec e, double w)
{
    return yk_mul(yk_add(U.accel, yk_scale(2 * w, yk_quarter(U.rate))), e);
}

typedef struct RatePair {
    double w1, w2, a1, a2;
} RatePair;

// Returns the rates. inverse: 1 / D.
YK_INLINE RatePair rrr_rates(Known K, Known U, bool U_varies, Known W, bool W_varies, Rrr at, double inverse, YkVec e1,
                             YkVec e2)
{
    YkVec G = K.rate, H = K.accel;
    if (U_varies) G = yk_add(G, yk_mul(U.rate, e1));
    if (W_varies) G = yk_add(G, yk_mul(W.rate, e2));
    double w1 = -yk_dot(G, at.q) * inverse, w2 = yk_dot(G, at.p) * inverse;
    H = yk_sub(H, yk_add(yk_scale(w1 * w1, at.p), yk_scale(w2 * w2, at.q)));
    if (U_varies) H = yk_add(H, swing(U, e1, w1));
    if (W_varies) H = yk_add(H, swing(W, e2, w2));
    return (RatePair){w1, w2, -yk_dot(H, at.q) * inverse, yk_dot(H, at.p) * inverse};
}

typedef struct RrrFound {
    YkVec e1, e2;
    double margin;
    RatePair rates;
} RrrFound;

// Returns the factor that restores length 1, which rounding changes if the base is long compared with the arm. Not for
// 0.
YK_INLINE double to_length_one(YkVec e)
{
    double square = yk_dot(e, e), near = 1.5 - 0.5 * square, far = 1 / sqrt(square);
    return fabs(square - 1) < 1e-8 ? near : far; // the first differs from the root by 3/8 of the square of that
}

// Solves one lane. axial: both arms point along x. careful: an arm is short, or may be, so that its unit vector needs
// correction for the rounding of the base.
YK_INLINE RrrFound rrr_solve(bool rates, Known K, Known U, bool U_varies, Known W, bool W_varies, YkArmPair arms,
                             bool axial, bool careful, double branch)
{
    RrrTriangle known = rrr_triangle(K.place, arms);
    Rrr at = rrr_place(K.place, arms, known, branch);
    YkVec e1 = times(at.p, arms.inverse_U, axial), e2 = times(at.q, arms.inverse_W, axial);
    double inverse = 4 * at.D * known.per_square;
    if (careful) {
        double factor1 = to_length_one(e1), factor2 = to_length_one(e2);
        e1 = yk_scale(factor1, e1), e2 = yk_scale(factor2, e2);
        at.p = yk_scale(factor1, at.p), at.q = yk_scale(factor2, at.q);
        inverse = 1 / yk_cross(at.p, at.q);
    }
    RrrFound found = {.e1 = e1, .e2 = e2, .margin = rrr_margin(known, arms, careful)};
    if (rates) found.rates = rrr_rates(K, U, U_varies, W, W_varies, at, inverse, e1, e2);
    return found;
}

#endif
