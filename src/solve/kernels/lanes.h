// Lanes of a machine's vectors, orientations and distances: what the kernels read and write (elementary/kernel.h says
// how a kernel is written).
#ifndef SOLVE_KERNELS_LANES_H
#define SOLVE_KERNELS_LANES_H
#include <stdbool.h>
#include "compile/arms.h"
#include "elementary/kernel.h"
#include "solve/kernels/kernels.h"

// One lane of a vector, its rate and its acceleration; of an orientation; of a distance.
YK_INLINE YkVec lane_place(YkPlane p, size_t i)
{
    return yk_vec(p.x[i], p.y[i]);
}
YK_INLINE YkVec lane_rate(YkPlane p, size_t i)
{
    return yk_vec(p.vx[i], p.vy[i]);
}
YK_INLINE YkVec lane_accel(YkPlane p, size_t i)
{
    return yk_vec(p.ax[i], p.ay[i]);
}
YK_INLINE YkVec lane_unit(YkTurn t, size_t i)
{
    return yk_vec(t.c[i], t.s[i]);
}

YK_INLINE void lane_set_unit(YkTurn t, size_t i, YkVec e)
{
    t.c[i] = e.x;
    t.s[i] = e.y;
}

// One lane of a vector that is known with its rate and acceleration.
typedef struct Known {
    YkVec place, rate, accel;
} Known;

// rates: whether they are needed.
YK_INLINE Known lane_known(YkPlane p, bool rates, size_t i)
{
    const YkVec none = {0, 0};
    return (Known){lane_place(p, i), rates ? lane_rate(p, i) : none, rates ? lane_accel(p, i) : none};
}

// One lane of the rates and accelerations of an orientation and a distance.
typedef struct Rates {
    double w, v, turn_accel, slide_accel;
} Rates;

// The result for a dyad of an orientation and a distance.
typedef struct Found {
    YkVec e;
    double d, margin;
    Rates rates;
} Found;

YK_INLINE void lane_set_rates(YkTurn t, YkSlide d, size_t i, Rates rates)
{
    t.w[i] = rates.w;
    t.a[i] = rates.turn_accel;
    d.v[i] = rates.v;
    d.a[i] = rates.slide_accel;
}

YK_INLINE bool arm_varies(YkArm arm)
{
    return arm.lanes.x != NULL;
}
YK_INLINE YkVec arm_place(YkArm arm, bool varies, size_t i)
{
    return varies ? lane_place(arm.lanes, i) : arm.constant;
}

// Returns whether a constant arm is too short for the fast path.
YK_INLINE bool arm_is_short(YkArm arm)
{
    return yk_arm_share(yk_dot(arm.constant, arm.constant), arm.per_enough2) < 1;
}

// The cases for which a loop over lanes is compiled: what it computes, and what varies from lane to lane.
typedef struct Form {
    bool places, rates; // finds positions; velocities and accelerations
    bool varies;        // an arm has lanes
    bool turns;         // a line turns
    bool careful;       // an arm is short, or may be: yk_arm_share
    bool axial;         // constant vectors point along x, as yk_is_axial says: half the products go
} Form;

// Multiplies by a constant v that is real if `axial`.
YK_INLINE YkVec times(YkVec a, YkVec v, bool axial)
{
    return axial ? yk_scale(v.x, a) : yk_mul(a, v);
}
YK_INLINE double dot_with(YkVec v, YkVec a, bool axial)
{
    return axial ? v.x * a.x : yk_dot(v, a);
}
YK_INLINE double cross_with(YkVec v, YkVec a, bool axial)
{
    return axial ? v.x * a.y : yk_cross(v, a);
}

YK_INLINE Known arm_known(YkArm arm, bool varies, bool rates, size_t i)
{
    return varies ? lane_known(arm.lanes, rates, i) : (Known){.place = arm.constant};
}

// Returns the unit vector e = u e^(i line).
YK_INLINE YkVec line_unit(YkTurn line, YkVec u, bool turns, size_t i)
{
    return turns ? yk_mul(lane_unit(line, i), u) : u;
}

// A direction, and how it turns.
typedef struct Line {
    YkVec e;
    double w, a;
} Line;

YK_INLINE Line lane_turning(YkTurn turn, size_t i)
{
    return (Line){lane_unit(turn, i), turn.w[i], turn.a[i]};
}
YK_INLINE Line lane_line(YkTurn line, YkVec u, bool turns, bool rates, size_t i)
{
    return (Line){line_unit(line, u, turns, i), turns && rates ? line.w[i] : 0, turns && rates ? line.a[i] : 0};
}

// Returns sqrt of a, or of 0 if a is negative or NaN. The root need not wait for the choice.
YK_INLINE double root_of(double a)
{
    double root = sqrt(a);
    return a > 0 ? root : 0;
}

// Does the same with a sign: that of a branch, +1 or -1; or of a number. +0 if a is negative or NaN, for both.
YK_INLINE double root_on_branch(double a, double branch)
{
    double root = branch * sqrt(a);
    return a > 0 ? root : 0;
}
YK_INLINE double root_like(double a, double sign)
{
    double root = copysign(sqrt(a), sign);
    return a > 0 ? root : 0;
}

// Returns |a|, or something tiny and harmless for 0. (A choice between a and 1 would tempt compilers into dividing
// twice.)
YK_INLINE double not_zero(double a)
{
    return fabs(a) + 1e-200;
}

// Keeps the least margin of a lane. `own` gets the block's; it is the same array if it is not requested. The margin
// counts as -1 if the witness, a part of the solution, is NaN.
YK_INLINE void lane_margin(double *margin, double *own, size_t i, double m, double witness)
{
    double before = margin[i], known = witness == witness ? m : -1;
    own[i] = known;
    margin[i] = known < before ? known : before;
}

YK_INLINE void lane_set_found(Form form, YkTurn out, YkSlide d, size_t i, Found found, double *margin, double *own)
{
    if (form.places) {
        d.d[i] = found.d;
        lane_set_unit(out, i, found.e);
        lane_margin(margin, own, i, found.margin, found.e.x);
    }
    if (form.rates) lane_set_rates(out, d, i, found.rates);
}

// Keeps the largest gap of a lane. NaN counts as infinite.
YK_INLINE void lane_gap(double *gap, size_t i, double g)
{
    double known = g == g ? g : (double)INFINITY;
    gap[i] = known > gap[i] ? known : gap[i];
}

#endif
