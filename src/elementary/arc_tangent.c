// atan and atan2: by a quotient with the bits that rounding took.
#include "elementary/arc.h"
#include "elementary/double_double.h"
#include "elementary/elementary.h"

// The angle of (x, y) for magnitudes from 2^-400 to 2^400, signs apart. The smaller over the larger magnitude u, turned
// by pi/4 where that is closer; then unfolded by octants: j pi/4 +- atan(u).
YK_INLINE double moderate_angle(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    double large = ay > ax ? ay : ax, small = ay > ax ? ax : ay;
    bool is_diagonal = small > 0.41421356237309503 * large; // tan(pi/8)
    DoubleDouble over = {small, 0}, under = {large, 0};
    if (is_diagonal) over = dd_ordered_sum(-large, small), under = dd_ordered_sum(large, small);
    DoubleDouble u = dd_quotient(over, under);
    double z = u.high * u.high, rest = u.low * (1 - z) - u.high * atan_rest(z);
    double j = is_diagonal ? 1 : 0;
    j = ay > ax ? 2 - j : j;
    uint64_t left = bits_of(x) & YK_SIGN_BIT, turned = (ay > ax ? YK_SIGN_BIT : 0) ^ left;
    j = left ? 4 - j : j;
    // pi/4 in two parts: the first product is exact
    DoubleDouble angle = dd_ordered_sum(j * 0x1.921fb54442d1p-1, flipped(u.high, turned));
    return angle.high + (angle.low + (flipped(rest, turned) + j * 0x1.08d313198a2ep-50));
}

YK_INLINE bool is_moderate(double magnitude)
{
    return bits_of(magnitude) - bits_of(0x1p-400) <= bits_of(0x1p400) - bits_of(0x1p-400);
}

// Zeros, infinities, NaN and magnitudes far from 1 or from each other.
YK_APART double rare_angle(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    if (isnan(x) || isnan(y)) return NAN;
    if (ay == 0 || (isinf(ax) && !isinf(ay))) return signbit(x) ? PI_HIGH : 0;
    if (ax == 0 || (isinf(ay) && !isinf(ax))) return HALF_PI_HIGH;
    if (isinf(ax)) ax = ay = 1;
    int ex, ey;
    double mx = frexp(ax, &ex), my = frexp(ay, &ey);
    if (ey - ex > 60) return HALF_PI_HIGH;
    if (ey - ex < -60) return signbit(x) ? PI_HIGH : ay / ax;
    return moderate_angle(ldexp(my, ey - ex), copysign(mx, x));
}

double yk_atan2(double y, double x)
{
    double angle = is_moderate(fabs(x)) && is_moderate(fabs(y)) ? moderate_angle(y, x) : rare_angle(y, x);
    return copysign(angle, y);
}

double yk_atan(double x)
{
    if (!(fabs(x) <= 0.41421356237309503)) return yk_atan2(x, 1);
    return copysign(x - x * atan_rest(x * x), x);
}
