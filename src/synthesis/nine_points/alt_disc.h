// Discs in the complex plane that enclose what they stand for, with a centre of twice the precision.
//
// Large linkages are solutions that nearly cancel: their equations are proved only where they are evaluated more
// precisely than to double. Every operation widens the radius by a bound of its own rounding, as in
// configurations/ball.h.
// Source: Dekker 1971; van der Hoeven 2009, "Ball arithmetic".
#ifndef SYNTHESIS_ALT_DISC_H
#define SYNTHESIS_ALT_DISC_H
#include "configurations/ball.h"
#include "elementary/double_double.h"

typedef struct YkDisc {
    YkVec at, rest; // the centre is their sum, |rest| below 2^-52 |at|
    double radius;
} YkDisc;

// Over twice what rounding loses: 8 * 2^-106 of a double-double's product, and 4 * 2^-106 more for the sum of two.
#define YK_DISC_UNIT 0x1p-101

static inline YkDisc yk_disc(YkVec at, double radius)
{
    return (YkDisc){at, {0, 0}, radius};
}
static inline DoubleDouble yk_fine_sum(DoubleDouble a, DoubleDouble b)
{
    DoubleDouble sum = dd_sum(a.high, b.high);
    return dd_ordered_sum(sum.high, sum.low + (a.low + b.low));
}
static inline YkDisc yk_disc_of(DoubleDouble x, DoubleDouble y, double radius)
{
    return (YkDisc){{x.high, y.high}, {x.low, y.low}, YK_BALL_OUT(radius)};
}
static inline YkDisc yk_disc_add(YkDisc a, YkDisc b)
{
    DoubleDouble x = yk_fine_sum((DoubleDouble){a.at.x, a.rest.x}, (DoubleDouble){b.at.x, b.rest.x});
    DoubleDouble y = yk_fine_sum((DoubleDouble){a.at.y, a.rest.y}, (DoubleDouble){b.at.y, b.rest.y});
    return yk_disc_of(x, y, a.radius + b.radius + YK_DISC_UNIT * (yk_sum_norm(a.at) + yk_sum_norm(b.at)));
}
static inline YkDisc yk_disc_negate(YkDisc a)
{
    return (YkDisc){yk_scale(-1, a.at), yk_scale(-1, a.rest), a.radius};
}
static inline YkDisc yk_disc_mul(YkDisc a, YkDisc b)
{
    DoubleDouble ax = {a.at.x, a.rest.x}, ay = {a.at.y, a.rest.y}, bx = {b.at.x, b.rest.x}, by = {b.at.y, b.rest.y};
    DoubleDouble yy = dd_times(ay, by), x = yk_fine_sum(dd_times(ax, bx), (DoubleDouble){-yy.high, -yy.low});
    DoubleDouble y = yk_fine_sum(dd_times(ax, by), dd_times(ay, bx));
    double A = YK_BALL_OUT(yk_sum_norm(a.at)), B = YK_BALL_OUT(yk_sum_norm(b.at));
    return yk_disc_of(x, y, A * b.radius + B * a.radius + a.radius * b.radius + YK_DISC_UNIT * A * B);
}
static inline YkDisc yk_disc_sub(YkDisc a, YkDisc b)
{
    return yk_disc_add(a, yk_disc_negate(b));
}
static inline YkDisc yk_disc_add_product(YkDisc sum, YkDisc a, YkDisc b)
{
    return yk_disc_add(sum, yk_disc_mul(a, b));
}
// Returns a d - b c.
static inline YkDisc yk_disc_determinant(YkDisc a, YkDisc b, YkDisc c, YkDisc d)
{
    return yk_disc_sub(yk_disc_mul(a, d), yk_disc_mul(b, c));
}
// Rounds the centre to double.
static inline YkBall yk_disc_round(YkDisc a)
{
    return yk_ball(a.at, YK_BALL_OUT(a.radius + yk_sum_norm(a.rest)));
}

// alt_disc.c: encloses the equation of one place at discs of the unknowns, x[8], and its derivatives, row[8] or NULL.
YkDisc yk_alt_enclose(YkDisc place, YkDisc hat, const YkDisc *x, YkDisc *row);

#endif
