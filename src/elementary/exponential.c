// exp and exp2.
#include "elementary/exponential.h"
#include "elementary/elementary.h"

double yk_exp(double x)
{
    if (!(fabs(x) < 746)) return x > 0 ? INFINITY : x < 0 ? 0 : NAN;
    return exponential_value(exponential(x, 0));
}

double yk_exp2(double x)
{
    if (!(fabs(x) < 1076)) return x > 0 ? INFINITY : x < 0 ? 0 : NAN;
    double shifted = 128 * x + YK_TO_INTEGER, k = shifted - YK_TO_INTEGER;
    return exponential_value(exponential_step(integer_in(shifted), PLAIN_LN_2 * (x - k * 0x1p-7)));
}
