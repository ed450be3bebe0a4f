// The RRR dyad over lanes.
#include "solve/kernels/rrr.h"
#include "solve/kernels/term.h"

// Returns the branch of the solution in the lanes: the sign of its determinant.
YK_INLINE double branch_of(YkArm U, bool U_varies, YkArm W, bool W_varies, YkTurn out1, YkTurn out2, size_t i)
{
    YkVec p = yk_mul(arm_place(U, U_varies, i), lane_unit(out1, i));
    YkVec q = yk_mul(arm_place(W, W_varies, i), lane_unit(out2, i));
    return yk_cross(p, q) < 0 ? -1 : 1;
}

// The loop over the lanes; what it computes and what varies are known at compile time.
YK_INLINE void rrr_loop(bool places, bool rates, bool U_varies, bool W_varies, bool axial, bool careful, Base K,
                        YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin, double *own,
                        size_t n)
{
    YkArmPair constant = yk_arm_pair(U.constant, W.constant, U.per_enough2, W.per_enough2);
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Known u = arm_known(U, U_varies, rates, i), w = arm_known(W, W_varies, rates, i);
        YkArmPair arms = U_varies || W_varies ? yk_arm_pair(u.place, w.place, U.per_enough2, W.per_enough2) : constant;
        double sign = places ? branch : branch_of(U, U_varies, W, W_varies, out1, out2, i);
        RrrFound found = rrr_solve(rates, base_at(K, rates, i), u, U_varies, w, W_varies, arms, axial, careful, sign);
        if (places) {
            lane_set_unit(out1, i, found.e1);
            lane_set_unit(out2, i, found.e2);
            lane_margin(margin, own, i, found.margin, found.e1.x);
        }
        if (rates) {
            out1.w[i] = found.rates.w1;
            out1.a[i] = found.rates.a1;
            out2.w[i] = found.rates.w2;
            out2.a[i] = found.rates.a2;
        }
    }
}

// Handles arms that vary or are short, which are rare: one loop serves them all.
YK_APART void rrr_varying(bool places, bool rates, Base K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                          double *margin, double *own, size_t n)
{
    rrr_loop(places, rates, arm_varies(U), arm_varies(W), false, true, K, U, W, branch, out1, out2, margin, own, n);
}

YK_INLINE void rrr_choose(bool places, bool rates, Base K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                          double *margin, double *own, size_t n)
{
    if (arm_varies(U) || arm_varies(W) || arm_is_short(U) || arm_is_short(W))
        rrr_varying(places, rates, K, U, W, branch, out1, out2, margin, own, n);
    else if (yk_is_axial(U.constant) && yk_is_axial(W.constant))
        rrr_loop(places, rates, false, false, true, false, K, U, W, branch, out1, out2, margin, own, n);
    else
        rrr_loop(places, rates, false, false, false, false, K, U, W, branch, out1, out2, margin, own, n);
}

YK_INLINE void yk_lanes_rrr_body(YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin,
                                 double *block_margin, size_t n)
{
    rrr_choose(true, YK_ONE_PASS, (Base){.lanes = K}, U, W, branch, out1, out2, margin,
               block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) rrr_choose(false, true, (Base){.lanes = K}, U, W, 0, out1, out2, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrr,
          (YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin, double *block_margin,
           size_t n),
          (K, U, W, branch, out1, out2, margin, block_margin))

YK_INLINE void yk_lanes_rrr_turned_body(const YkTurned *K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2,
                                        double *margin, double *block_margin, size_t n)
{
    const Base base = {.is_turned = true, .sum = *K};
    const YkArm arm1 = {.constant = U.constant, .per_enough2 = U.per_enough2},
                arm2 = {.constant = W.constant, .per_enough2 = W.per_enough2};
    double *own = block_margin ? block_margin : margin;
    rrr_choose(true, YK_ONE_PASS, base, arm1, arm2, branch, out1, out2, margin, own, n);
    if (!YK_ONE_PASS) rrr_choose(false, true, base, arm1, arm2, 0, out1, out2, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrr_turned,
          (const YkTurned *K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin,
           double *block_margin, size_t n),
          (K, U, W, branch, out1, out2, margin, block_margin))
