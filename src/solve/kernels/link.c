// Loops with one unknown, or none: they repeat constraints. The unknown takes its best value, and the gap is how far
// it misses. Rare; plain loops.
#include "solve/kernels/lanes.h"

// Solves K + U e^(i Phi) = 0: e^(i Phi) = -K conj(U) / |K U|; any angle will do if that is 0.
void yk_lanes_link(YkPlane K, YkArm U, YkTurn out, double *gap, size_t n)
{
    bool varies = arm_varies(U);
    for (size_t i = 0; i < n; i++) {
        YkVec place = lane_place(K, i), arm = arm_place(U, varies, i), z = yk_mul(place, yk_conj(arm));
        double length = sqrt(yk_dot(z, z));
        lane_set_unit(out, i, length > 0 ? yk_scale(-1 / length, z) : yk_vec(1, 0));
        lane_gap(gap, i, fabs(sqrt(yk_dot(place, place)) - sqrt(yk_dot(arm, arm))));
    }
}

// Solves i p Phi' = -G in the direction of i p, p = U e^(i Phi): Phi' = -cross(p, G) / U^2; accelerations with H
// likewise.
void yk_lanes_link_rates(YkPlane K, YkArm U, YkTurn out, size_t n)
{
    bool varies = arm_varies(U);
    for (size_t i = 0; i < n; i++) {
        YkVec e = lane_unit(out, i), arm = arm_place(U, varies, i), p = yk_mul(arm, e);
        YkVec G = lane_rate(K, i), H = lane_accel(K, i);
        double inverse = 1 / yk_dot(arm, arm);
        if (varies) G = yk_add(G, yk_mul(lane_rate(U.lanes, i), e));
        out.w[i] = -yk_cross(p, G) * inverse;
        if (varies) {
            YkVec swing = yk_scale(2 * out.w[i], yk_quarter(lane_rate(U.lanes, i)));
            H = yk_add(H, yk_mul(yk_add(lane_accel(U.lanes, i), swing), e));
        }
        out.a[i] = -yk_cross(p, H) * inverse;
    }
}

void yk_lanes_guide(YkPlane K, YkTurn line, YkVec u, YkSlide d, double *gap, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec e = line_unit(line, u, line.c != NULL, i), place = lane_place(K, i);
        d.d[i] = -yk_dot(place, e);
        lane_gap(gap, i, fabs(yk_cross(place, e)));
    }
}

// Uses that e is a unit vector, so dot(e, e') = 0 and dot(e, e'') = -w^2.
void yk_lanes_guide_rates(YkPlane K, YkTurn line, YkVec u, YkSlide d, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec e = line_unit(line, u, line.c != NULL, i);
        double w = line.c ? line.w[i] : 0;
        d.v[i] = -yk_dot(lane_rate(K, i), e);
        d.a[i] = d.d[i] * w * w - yk_dot(lane_accel(K, i), e);
    }
}

void yk_lanes_gap(YkPlane K, double *gap, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec place = lane_place(K, i);
        lane_gap(gap, i, sqrt(yk_dot(place, place)));
    }
}
