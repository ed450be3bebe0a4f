// log, log2 and log10.
#include "elementary/logarithm.h"
#include "elementary/elementary.h"

double yk_log(double x)
{
    if (logarithm_is_rare(x)) return rare_logarithm(x);
    Logarithm l = logarithm(x);
    DoubleDouble sum = dd_ordered_sum(l.high, l.r);
    return sum.high + (sum.low + (l.low + l.r_low + (logarithm_cubic(l.r) - 0.5 * (l.r * l.r))));
}

static double by_base(double x, DoubleDouble per)
{
    if (logarithm_is_rare(x)) return rare_logarithm(x);
    return dd_value(dd_times(logarithm_pair(logarithm(x)), per));
}

double yk_log2(double x)
{
    return by_base(x, (DoubleDouble){PER_LN_2_HIGH, PER_LN_2_LOW});
}

double yk_log10(double x)
{
    return by_base(x, (DoubleDouble){PER_LN_10_HIGH, PER_LN_10_LOW});
}
