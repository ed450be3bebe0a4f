// sinh, cosh and tanh: from e^x with the bits that rounding took; near 0, where these cancel, by polynomials.
#include "elementary/elementary.h"
#include "elementary/exponential.h"

// (e^a + e^-a) / 2 for 0 <= a < 25, and (e^a - e^-a) / 2.
typedef struct Halves {
    DoubleDouble sum, difference;
} Halves;

static inline Halves halves(double a)
{
    Exponential up = exponential(a, 0), down = exponential(-a, 0);
    double grow = power_of_two(up.exponent - 1), shrink = power_of_two(down.exponent - 1);
    DoubleDouble p = exponential_pair(up), m = exponential_pair(down);
    p = (DoubleDouble){grow * p.high, grow * p.low};
    m = (DoubleDouble){shrink * m.high, shrink * m.low};
    DoubleDouble sum = dd_ordered_sum(p.high, m.high), difference = dd_ordered_sum(p.high, -m.high);
    return (Halves){{sum.high, sum.low + (p.low + m.low)}, {difference.high, difference.low + (p.low - m.low)}};
}

// e^a / 2 for a >= 25.
static double half_exponential(double a)
{
    if (a > 711) return a + (double)INFINITY;
    Exponential e = exponential(a, 0);
    e.exponent--;
    return exponential_value(e);
}

double yk_cosh(double x)
{
    double a = fabs(x);
    if (!(a < 25)) return isnan(x) ? NAN : half_exponential(a);
    return dd_value(halves(a).sum);
}

double yk_sinh(double x)
{
    double a = fabs(x), t = x * x, t2 = t * t;
    if (a <= 0.5) {
        double rest = (SINH_0 + t * SINH_1) + t2 * ((SINH_2 + t * SINH_3) + t2 * (SINH_4 + t * SINH_5));
        return x + x * (t * rest);
    }
    if (!(a < 25)) return isnan(x) ? NAN : copysign(half_exponential(a), x);
    return copysign(dd_value(halves(a).difference), x);
}

double yk_tanh(double x)
{
    double a = fabs(x), t = x * x, t2 = t * t;
    if (a <= 0.25) {
        double rest = (TANH_0 + t * TANH_1) + t2 * ((TANH_2 + t * TANH_3) + t2 * ((TANH_4 + t * TANH_5) + t2 * TANH_6));
        return copysign(x + x * (t * rest), x);
    }
    if (!(a < 22)) return isnan(x) ? NAN : copysign(1, x);
    Halves of = halves(a);
    return copysign(dd_value(dd_quotient(of.difference, of.sum)), x);
}
