// RRR: K + U e^(i Phi1) + W e^(i Phi2) = 0, two circles meet.
//
// With L = -K = p + q: dot(p, L) = A = (L^2 + U^2 - W^2) / 2 and cross(p, q) = D, where
// 4 D^2 = ((U+W)^2 - L^2) (L^2 - (U-W)^2); hence p = L (A - i D) / L^2 and q = L (L^2 - A + i D) / L^2.
// Rates: i p Phi1' + i q Phi2' = -G, hence Phi1' = -dot(G, q) / D, Phi2' = dot(G, p) / D; accelerations with H
// likewise.
#include "solve/lanes.h"

// What the lengths of two arms give: (U+W)^2, (U-W)^2, (U+W) (U-W), 1 / (4 U^2 W^2), U W, 1 / U, 1 / W.
typedef struct Pair {
    double outer, inner, product, scale, rectangle;
    YkVec inverse_U, inverse_W;
} Pair;

YK_INLINE Pair pair_of(YkVec U, YkVec W)
{
    double U2 = yk_dot(U, U), W2 = yk_dot(W, W), sum = sqrt(U2) + sqrt(W2), difference = sqrt(U2) - sqrt(W2);
    return (Pair){sum * sum,     difference * difference, sum * difference, 1 / (4 * U2 * W2),
                  sqrt(U2 * W2), vec_inverse(U),          vec_inverse(W)};
}

// One lane before any root: 4 D^2, and 1 / L^2 and 1 / (4 D^2) by one division that need not wait for it. Where D^2 <=
// 0, the last means nothing; where L = 0 (any angle would do), neither.
typedef struct Triangle {
    double L2, square, per_L2, per_square;
} Triangle;

YK_INLINE Triangle triangle_of(YkVec K, Pair arms)
{
    double L2 = yk_dot(K, K), square = (arms.outer - L2) * (L2 - arms.inner);
    double factor = not_zero(square), inverse = 1 / (L2 * factor);
    return (Triangle){L2, square, factor * inverse, L2 * inverse};
}

// sin^2 of the angle between the arms. What does not close is measured by the base where that is short: a gap of 1e-9
// is nothing to arms of 1, but to a base of 1e-8 it is.
YK_INLINE double rrr_margin(Triangle known, Pair arms)
{
    double m = known.square * arms.scale, shortness = arms.rectangle * known.per_L2;
    return m < 0 ? m * (shortness > 1 ? shortness : 1) : m;
}

// The solution: the arms as they stand, and D.
typedef struct Rrr {
    YkVec p, q;
    double D;
} Rrr;

YK_INLINE Rrr rrr_place(YkVec K, Pair arms, Triangle known, double branch)
{
    double half = 0.5 * known.per_L2, root = branch * root_of(known.square), slope = root * half;
    YkVec p = yk_mul(K, yk_vec(-(known.L2 + arms.product) * half, slope));
    YkVec q = yk_mul(K, yk_vec(-(known.L2 - arms.product) * half, -slope));
    return (Rrr){p, q, 0.5 * root};
}

// The branch of a solution that stands in the lanes: the sign of its determinant.
YK_INLINE double branch_of(YkArm U, bool U_varies, YkArm W, bool W_varies, YkTurn out1, YkTurn out2, size_t i)
{
    YkVec p = yk_mul(arm_place(U, U_varies, i), lane_unit(out1, i));
    YkVec q = yk_mul(arm_place(W, W_varies, i), lane_unit(out2, i));
    return yk_cross(p, q) < 0 ? -1 : 1;
}

// U'' e^(i Phi) + 2 i Phi' U' e^(i Phi): what a varying arm adds to the acceleration.
YK_INLINE YkVec swing(Known U, YkVec e, double w)
{
    return yk_mul(yk_add(U.accel, yk_scale(2 * w, yk_quarter(U.rate))), e);
}

typedef struct RatePair {
    double w1, w2, a1, a2;
} RatePair;

YK_INLINE RatePair rrr_rates(Known K, Known U, bool U_varies, Known W, bool W_varies, Triangle known, Rrr at, YkVec e1,
                             YkVec e2)
{
    YkVec G = K.rate, H = K.accel;
    double inverse = 4 * at.D * known.per_square; // 1 / D
    if (U_varies) G = yk_add(G, yk_mul(U.rate, e1));
    if (W_varies) G = yk_add(G, yk_mul(W.rate, e2));
    double w1 = -yk_dot(G, at.q) * inverse, w2 = yk_dot(G, at.p) * inverse;
    H = yk_sub(H, yk_add(yk_scale(w1 * w1, at.p), yk_scale(w2 * w2, at.q)));
    if (U_varies) H = yk_add(H, swing(U, e1, w1));
    if (W_varies) H = yk_add(H, swing(W, e2, w2));
    return (RatePair){w1, w2, -yk_dot(H, at.q) * inverse, yk_dot(H, at.p) * inverse};
}

// The loop over the lanes, with what is asked and what varies known when it is compiled.
YK_INLINE void rrr_loop(bool places, bool rates, bool U_varies, bool W_varies, YkPlane K, YkArm U, YkArm W,
                        double branch, YkTurn out1, YkTurn out2, double *margin, double *own, size_t n)
{
    Pair constant = pair_of(U.constant, W.constant);
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Pair arms = constant;
        if (U_varies || W_varies) arms = pair_of(arm_place(U, U_varies, i), arm_place(W, W_varies, i));
        Triangle known = triangle_of(lane_place(K, i), arms);
        double sign = places ? branch : branch_of(U, U_varies, W, W_varies, out1, out2, i);
        Rrr at = rrr_place(lane_place(K, i), arms, known, sign);
        YkVec e1 = yk_mul(at.p, arms.inverse_U), e2 = yk_mul(at.q, arms.inverse_W);
        if (places) {
            lane_set_unit(out1, i, e1);
            lane_set_unit(out2, i, e2);
            lane_margin(margin, own, i, rrr_margin(known, arms), e1.x);
        }
        if (rates) {
            Known u = arm_known(U, U_varies, i), w = arm_known(W, W_varies, i);
            RatePair found = rrr_rates(lane_known(K, i), u, U_varies, w, W_varies, known, at, e1, e2);
            out1.w[i] = found.w1;
            out1.a[i] = found.a1;
            out2.w[i] = found.w2;
            out2.a[i] = found.a2;
        }
    }
}

// Arms that vary are rare: one loop serves them all.
YK_APART void rrr_varying(bool places, bool rates, YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                          double *margin, double *own, size_t n)
{
    rrr_loop(places, rates, arm_varies(U), arm_varies(W), K, U, W, branch, out1, out2, margin, own, n);
}

YK_INLINE void rrr_choose(bool places, bool rates, YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                          double *margin, double *own, size_t n)
{
    if (arm_varies(U) || arm_varies(W))
        rrr_varying(places, rates, K, U, W, branch, out1, out2, margin, own, n);
    else
        rrr_loop(places, rates, false, false, K, U, W, branch, out1, out2, margin, own, n);
}

YK_INLINE void yk_lanes_rrr_body(YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin,
                                 double *block_margin, size_t n)
{
    rrr_choose(true, false, K, U, W, branch, out1, out2, margin, block_margin ? block_margin : margin, n);
}
YK_KERNEL(yk_lanes_rrr,
          (YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin, double *block_margin,
           size_t n),
          (K, U, W, branch, out1, out2, margin, block_margin))

YK_INLINE void yk_lanes_rrr_rates_body(YkPlane K, YkArm U, YkArm W, YkTurn out1, YkTurn out2, size_t n)
{
    rrr_choose(false, true, K, U, W, 0, out1, out2, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrr_rates, (YkPlane K, YkArm U, YkArm W, YkTurn out1, YkTurn out2, size_t n), (K, U, W, out1, out2))

YK_INLINE void yk_lanes_rrr_all_body(YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                                     double *margin, double *block_margin, size_t n)
{
    rrr_choose(true, YK_ONE_PASS, K, U, W, branch, out1, out2, margin, block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) yk_lanes_rrr_rates_body(K, U, W, out1, out2, n);
}
YK_KERNEL(yk_lanes_rrr_all,
          (YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin, double *block_margin,
           size_t n),
          (K, U, W, branch, out1, out2, margin, block_margin))
