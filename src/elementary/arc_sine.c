// asin and acos. Beyond 1/2 by the half angle: 1 - cos(a) = 2 sin^2(a/2) (Cody & Waite 1980, ch. 10).
#include "elementary/coefficients.h"
#include "elementary/double_double.h"
#include "elementary/elementary.h"

// asin(s) / s - 1 for t = s^2 <= 1/4.
static double asin_rest(double t)
{
    double t2 = t * t, t4 = t2 * t2;
    double low = (ASIN_0 + t * ASIN_1) + t2 * (ASIN_2 + t * ASIN_3);
    double middle = (ASIN_4 + t * ASIN_5) + t2 * (ASIN_6 + t * ASIN_7);
    double high = (ASIN_8 + t * ASIN_9) + t2 * (ASIN_10 + t * ASIN_11) + t4 * ASIN_12;
    return t * (low + t4 * (middle + t4 * high));
}

// acos(x) for 1/2 <= x <= 1: 2 asin(s) with s^2 = (1 - x) / 2.
static DoubleDouble half_angle_acos(double x)
{
    double t = 0.5 * (1 - x), s = sqrt(t);
    if (s == 0) return (DoubleDouble){0, 0};
    DoubleDouble square = dd_square(s);
    double lost = ((t - square.high) - square.low) / (2 * s);
    return (DoubleDouble){2 * s, 2 * (lost + s * asin_rest(t))};
}

double yk_asin(double x)
{
    double a = fabs(x);
    if (a <= 0.5) return x + x * asin_rest(x * x);
    if (!(a <= 1)) return NAN;
    DoubleDouble rest = half_angle_acos(a), angle = dd_ordered_sum(HALF_PI_HIGH, -rest.high);
    return copysign(angle.high + (angle.low + (HALF_PI_LOW - rest.low)), x);
}

double yk_acos(double x)
{
    double a = fabs(x);
    if (a <= 0.5) {
        DoubleDouble angle = dd_ordered_sum(HALF_PI_HIGH, -x);
        return angle.high + (angle.low + (HALF_PI_LOW - x * asin_rest(x * x)));
    }
    if (!(a <= 1)) return NAN;
    DoubleDouble angle = half_angle_acos(a);
    if (x > 0) return dd_value(angle);
    DoubleDouble other = dd_ordered_sum(PI_HIGH, -angle.high);
    return other.high + (other.low + (PI_LOW - angle.low));
}
