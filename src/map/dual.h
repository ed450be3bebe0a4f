// Values in discs of the complex plane, with their derivatives by the mapped input.
#ifndef MAP_DUAL_H
#define MAP_DUAL_H
#include "configurations/ball.h"

typedef struct YkDual {
    YkBall at, rate;
} YkDual;

static inline YkBall yk_real_disc(double at, double radius)
{
    return yk_ball(yk_vec(at, 0), radius);
}

static inline YkDual yk_dual_constant(YkVec v)
{
    return (YkDual){yk_ball(v, 0), yk_ball(yk_vec(0, 0), 0)};
}

static inline YkDual yk_dual_add(YkDual a, YkDual b)
{
    return (YkDual){yk_ball_add(a.at, b.at), yk_ball_add(a.rate, b.rate)};
}

static inline YkDual yk_dual_negate(YkDual a)
{
    return (YkDual){yk_ball_negate(a.at), yk_ball_negate(a.rate)};
}

static inline YkDual yk_dual_mul(YkDual a, YkDual b)
{
    return (YkDual){yk_ball_mul(a.at, b.at), yk_ball_add(yk_ball_mul(a.rate, b.at), yk_ball_mul(a.at, b.rate))};
}

// Returns the product with a constant, whose zeros stay zeros.
static inline YkDual yk_dual_times(YkVec v, YkDual a)
{
    YkBall factor = yk_ball(v, 0);
    return (YkDual){yk_ball_mul(factor, a.at), yk_ball_mul(factor, a.rate)};
}

static inline YkDual yk_dual_conjugate(YkDual a)
{
    return (YkDual){yk_ball(yk_conj(a.at.at), a.at.radius), yk_ball(yk_conj(a.rate.at), a.rate.radius)};
}

#endif
