// The terms of sums as values: turned vectors with their rates and accelerations.
#ifndef SOLVE_KERNELS_TERM_H
#define SOLVE_KERNELS_TERM_H
#include "solve/kernels/lanes.h"

// For z = v e^(i phi): z' = i w z, z'' = (i a - w^2) z.
YK_INLINE YkVec spin_rate(YkVec z, double w)
{
    return yk_scale(w, yk_quarter(z));
}
YK_INLINE YkVec spin_accel(YkVec z, double w, double a)
{
    return yk_sub(yk_scale(a, yk_quarter(z)), yk_scale(w * w, z));
}

// Returns v e^(i phi).
YK_INLINE Known term_turned(Line turn, YkVec v, bool axial)
{
    YkVec z = times(turn.e, v, axial);
    return (Known){z, spin_rate(z, turn.w), spin_accel(z, turn.w, turn.a)};
}

// The known part of a dyad's loop: in lanes, or a constant and one turned vector along x, as in most loops of machines.
// The latter is computed where it is used and never stored.
typedef struct Base {
    bool is_turned;
    YkPlane lanes;
    YkTurned sum;
} Base;

YK_INLINE Known base_at(Base base, bool rates, size_t i)
{
    if (!base.is_turned) return lane_known(base.lanes, rates, i);
    Known known = term_turned(lane_turning(base.sum.turn, i), yk_vec(base.sum.along, 0), true);
    known.place = yk_add(base.sum.constant, known.place);
    return known;
}

// Returns d z with z = v e^(i phi): d' z + d z', d'' z + 2 d' z' + d z''.
YK_INLINE Known term_sliding(Line turn, bool turns, YkVec v, double d, double rate, double accel)
{
    YkVec z = turns ? yk_mul(turn.e, v) : v;
    YkVec velocity = yk_scale(rate, z), acceleration = yk_scale(accel, z);
    if (turns) {
        YkVec dz = spin_rate(z, turn.w), ddz = spin_accel(z, turn.w, turn.a);
        velocity = yk_add(velocity, yk_scale(d, dz));
        acceleration = yk_add(acceleration, yk_add(yk_scale(2 * rate, dz), yk_scale(d, ddz)));
    }
    return (Known){yk_scale(d, z), velocity, acceleration};
}

#endif
