// Discs in the complex plane that enclose what they stand for: a centre and a radius.
//
// Every operation widens the radius by a bound of its own rounding, and then by a few units in the last place more than
// the bound's own evaluation can lose, so that the disc of the exact result lies within. Only + - * / and the
// comparison of doubles occur, in a fixed order: the same bits everywhere.
// Source: Rump 1999, "Fast and parallel interval arithmetic"; van der Hoeven 2009, "Ball arithmetic".
#ifndef CONFIGURATIONS_BALL_H
#define CONFIGURATIONS_BALL_H
#include <math.h>
#include "num/complex.h"

typedef struct YkBall {
    YkVec at;
    double radius;
} YkBall;

#define YK_BALL_UNIT 0x1p-52                                      // twice the rounding of one operation
#define YK_BALL_OUT(radius) ((radius) * (1 + 0x1p-48) + 0x1p-900) // also covers underflow

static inline YkBall yk_ball(YkVec at, double radius)
{
    return (YkBall){at, radius};
}
// Returns an upper bound of the largest modulus in it.
static inline double yk_ball_most(YkBall a)
{
    return YK_BALL_OUT(yk_sum_norm(a.at) + a.radius);
}
static inline YkBall yk_ball_add(YkBall a, YkBall b)
{
    YkVec at = yk_add(a.at, b.at);
    return yk_ball(at, YK_BALL_OUT(a.radius + b.radius + YK_BALL_UNIT * yk_sum_norm(at)));
}
static inline YkBall yk_ball_negate(YkBall a)
{
    return yk_ball(yk_scale(-1, a.at), a.radius);
}
// |ab - a0 b0| <= |a0| rb + |b0| ra + ra rb; the product itself is rounded by less than 4 units of |a0| |b0|.
static inline YkBall yk_ball_mul(YkBall a, YkBall b)
{
    double A = yk_sum_norm(a.at), B = yk_sum_norm(b.at);
    return yk_ball(yk_mul(a.at, b.at),
                   YK_BALL_OUT(A * b.radius + B * a.radius + a.radius * b.radius + 4 * YK_BALL_UNIT * A * B));
}
// |1/a - 1/a0| <= r / (|a0| (|a0| - r)); |a0| is at least the larger of its parts. Infinite radius if 0 may be in it.
static inline YkBall yk_ball_inverse(YkBall a)
{
    double least = fmax(fabs(a.at.x), fabs(a.at.y)) * (1 - 0x1p-48), room = (least - a.radius) * (1 - 0x1p-48);
    if (!(room > 0)) return yk_ball(yk_vec(0, 0), INFINITY);
    double error = a.radius / (least * room) + 8 * YK_BALL_UNIT / least;
    return yk_ball(yk_inverse(a.at), YK_BALL_OUT(YK_BALL_OUT(error)));
}

#endif
