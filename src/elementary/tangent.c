// tan: the quotient of sine and cosine, each with the bits that rounding took.
#include "elementary/double_double.h"
#include "elementary/elementary.h"
#include "elementary/turn.h"

double yk_tan(double x)
{
    Reduced r = sincos_is_far(sincos_far_bits(x)) ? yk_reduce_far(x) : reduce_near(x);
    DoubleDouble y2 = dd_square(r.y);
    if (y2.high < 0x1p-600) return r.y; // x itself: multiples of a quarter turn are never so close
    double y4 = y2.high * y2.high;
    DoubleDouble c = dd_ordered_sum(1, -0.5 * y2.high);
    DoubleDouble s = dd_ordered_sum(r.y, -(r.lost * c.high + y2.high * r.y * sin_cubic(y2.high)));
    c = dd_ordered_sum(c.high, c.low + (y4 * cos_quartic(y2.high, y4) + (r.y * r.lost - 0.5 * y2.low)));
    if ((r.q & 1) == 0) return dd_value(dd_quotient(s, c));
    return -dd_value(dd_quotient(c, s));
}
