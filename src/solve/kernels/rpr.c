// The RPR dyad over lanes.
#include "solve/kernels/rpr.h"
#include "solve/kernels/term.h"

YK_INLINE void rpr_loop(Form form, Base K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d,
                        double *margin, double *own, size_t n)
{
    const double per_enough2 = C.per_enough2 > 0 ? C.per_enough2 : (double)INFINITY;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Found found = rpr_solve(form, base_at(K, form.rates, i), arm_known(C, form.varies, form.rates, i), per_enough2,
                                lane_line(inner, u, form.turns, form.rates, i), branch, form.places ? 0 : d.d[i]);
        lane_set_found(form, out, d, i, found, margin, own);
    }
}

// Handles arms that vary and inner turns, which are rare: one loop serves them all.
YK_APART void rpr_varying(bool places, bool rates, Base K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    Form form = {places, rates, arm_varies(C), inner.c != NULL, false, false};
    rpr_loop(form, K, C, inner, u, branch, out, d, margin, own, n);
}

YK_INLINE void rpr_choose(bool places, bool rates, Base K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out,
                          YkSlide d, double *margin, double *own, size_t n)
{
    if (arm_varies(C) || inner.c)
        rpr_varying(places, rates, K, C, inner, u, branch, out, d, margin, own, n);
    else if (yk_is_axial(u) && C.constant.x == 0 && C.constant.y == 0)
        rpr_loop((Form){places, rates, false, false, false, true}, K, C, inner, u, branch, out, d, margin, own, n);
    else
        rpr_loop((Form){places, rates, false, false, false, false}, K, C, inner, u, branch, out, d, margin, own, n);
}

YK_INLINE void yk_lanes_rpr_body(YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d,
                                 double *margin, double *block_margin, size_t n)
{
    rpr_choose(true, YK_ONE_PASS, (Base){.lanes = K}, C, inner, u, branch, out, d, margin,
               block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) rpr_choose(false, true, (Base){.lanes = K}, C, inner, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rpr,
          (YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, C, inner, u, branch, out, d, margin, block_margin))

YK_INLINE void yk_lanes_rpr_turned_body(const YkTurned *K, YkArm C, YkVec u, double branch, YkTurn out, YkSlide d,
                                        double *margin, double *block_margin, size_t n)
{
    const Base base = {.is_turned = true, .sum = *K};
    const YkArm arm = {.constant = C.constant, .per_enough2 = C.per_enough2};
    const YkTurn none = {0};
    rpr_choose(true, YK_ONE_PASS, base, arm, none, u, branch, out, d, margin, block_margin ? block_margin : margin, n);
    if (!YK_ONE_PASS) rpr_choose(false, true, base, arm, none, u, 0, out, d, NULL, NULL, n);
}
YK_KERNEL(yk_lanes_rpr_turned,
          (const YkTurned *K, YkArm C, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
           double *block_margin, size_t n),
          (K, C, u, branch, out, d, margin, block_margin))
