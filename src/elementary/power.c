// pow: e^(y log x), with the logarithm to 67 bits (Muller 2016, "Elementary Functions", ch. 14).
#include "elementary/elementary.h"
#include "elementary/exponential.h"
#include "elementary/logarithm.h"

// 0: not an integer; 1: odd; 2: even.
static int kind_of_integer(double y)
{
    double a = fabs(y);
    if (a >= 0x1p53) return 2;
    if (a != floor(a)) return 0;
    return (int64_t)a % 2 == 0 ? 2 : 1;
}

// x^y for a positive, finite x; sign 1 or -1.
YK_INLINE double positive_power(double x, double y, double sign)
{
    DoubleDouble log_x = logarithm_pair(logarithm(x));
    double rough = y * log_x.high;
    if (!(fabs(rough) < 746)) return sign * (rough > 0 ? (double)INFINITY : 0);
    if (fabs(rough) < 0x1p-60) return sign;
    DoubleDouble product = dd_product(y, log_x.high);
    return sign * exponential_value(exponential(product.high, product.low + y * log_x.low));
}

// Zeros, infinities, NaN and negative bases.
YK_APART double rare_power(double x, double y)
{
    if (y == 0 || x == 1) return 1;
    if (isnan(x) || isnan(y)) return NAN;
    double a = fabs(x);
    if (isinf(y)) return a == 1 ? 1 : (a > 1) == (y > 0) ? (double)INFINITY : 0;
    int kind = kind_of_integer(y);
    double sign = signbit(x) && kind == 1 ? -1 : 1;
    if (a == 0 || isinf(a)) return sign * ((a == 0) == (y > 0) ? 0 : (double)INFINITY);
    if (x < 0 && kind == 0) return NAN;
    return positive_power(a, y, sign);
}

double yk_pow(double x, double y)
{
    return x > 0 && isfinite(x) && isfinite(y) ? positive_power(x, y, 1) : rare_power(x, y);
}
