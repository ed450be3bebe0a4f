// hypot: the root of the sum of both squares, with the bits that rounding took.
#include "elementary/double_double.h"
#include "elementary/elementary.h"

// For magnitudes whose squares neither overflow nor lose bits.
YK_INLINE DoubleDouble moderate_length(double large, double small)
{
    DoubleDouble a = dd_square(large), b = dd_square(small), sum = dd_ordered_sum(a.high, b.high);
    double low = sum.low + (a.low + b.low), root = sqrt(sum.high);
    DoubleDouble back = dd_square(root);
    return (DoubleDouble){root, ((sum.high - back.high) - back.low + low) / (2 * root)};
}

// Infinities, NaN, and magnitudes far from 1 or from each other.
YK_APART double rare_length(double large, double small)
{
    if (isinf(large) || isinf(small)) return INFINITY;
    if (isnan(large) || isnan(small)) return NAN;
    if (small <= large * 0x1p-54) return large + small;
    if (large > 0x1p500) return yk_scaled(moderate_length(large * 0x1p-600, small * 0x1p-600), 600);
    return yk_scaled(moderate_length(large * 0x1p600, small * 0x1p600), -600);
}

double yk_hypot(double x, double y)
{
    double a = fabs(x), b = fabs(y), large = b > a ? b : a, small = b > a ? a : b;
    bool is_moderate = large <= 0x1p500 && small >= 0x1p-400;
    return is_moderate ? dd_value(moderate_length(large, small)) : rare_length(large, small);
}
