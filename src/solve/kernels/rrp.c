// The RRP dyad over lanes.
#include "solve/kernels/rrp.h"
#include "solve/kernels/term.h"

YK_INLINE void rrp_loop(Form form, Base K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                        double *margin, double *own, size_t n)
{
    YkArmCircle constant = yk_arm_circle(W.constant, W.per_enough2);
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Known arm = arm_known(W, form.varies, form.rates, i);
        YkArmCircle circle = form.varies ? yk_arm_circle(arm.place, W.per_enough2) : constant;
        Found found = rrp_solve(form, base_at(K, form.rates, i), arm, circle,
                                lane_line(line, u, form.turns, form.rates, i), branch, form.places ? 0 : d.d[i]);
        lane_set_found(form, out, d, i, found, margin, own);
    }
}

// Handles arms that vary or are short, which are rare: one loop serves them all.
YK_APART void rrp_varying(bool places, bool rates, Base K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    Form form = {places, rates, arm_varies(W), line.c != NULL, true, false};
    rrp_loop(form, K, W, line, u, branch, out, d, margin, own, n);
}

YK_INLINE void rrp_choose(bool places, bool rates, Base K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    if (arm_varies(W) || arm_is_short(W))
        rrp_varying(places, rates, K, W, line, u, branch, out, d, margin, own, n);
    else if (line.c)
        rrp_loop((Form){places, rates, false, true, false, false}, K, W, line, u, branch, out, d, margin, own, n);
    else if (yk_is_axial(u) && yk_is_axial(W.constant))
        rrp_loop((Form){places, rates, false, false, false, true}, K, W, line, u, branch, out, d, margin, own, n);
    else
        rrp_loop((Form){places, rates, false, false, false, false}, K, W, line, u, branch, out, d, margin, own, n);
}

YK_INLINE void yk_lanes_rrp_body(YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                                 double *margin, double *block_margin, size_t n)
{
    rrp_choose(true, YK_ONE_PASS, (Base){.lanes = K}, W, line, u, branch, out, d, margin,
               block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) rrp_choose(false, true, (Base){.lanes = K}, W, line, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrp,
          (YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, W, line, u, branch, out, d, margin, block_margin))

YK_INLINE void yk_lanes_rrp_turned_body(const YkTurned *K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out,
                                        YkSlide d, double *margin, double *block_margin, size_t n)
{
    const Base base = {.is_turned = true, .sum = *K};
    const YkArm arm = {.constant = W.constant, .per_enough2 = W.per_enough2};
    rrp_choose(true, YK_ONE_PASS, base, arm, line, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) rrp_choose(false, true, base, arm, line, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rrp_turned,
          (const YkTurned *K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, W, line, u, branch, out, d, margin, block_margin))
