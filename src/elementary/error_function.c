// erfc: 1 - erf(x) near 0, beyond e^-x^2 times a function that is nearly 1/x (Cody 1969, "Rational Chebyshev
// approximations for the error function", Math. Comp. 23, has the same two ranges).
#include "elementary/elementary.h"
#include "elementary/exponential.h"

static double near_zero(double x)
{
    double t = x * x, t2 = t * t, t4 = t2 * t2;
    double low = (ERF_0 + t * ERF_1) + t2 * (ERF_2 + t * ERF_3);
    double rest = low + t4 * ((ERF_4 + t * ERF_5) + t2 * (ERF_6 + t * ERF_7) + t4 * ERF_8);
    DoubleDouble erf = dd_product(x, TWO_PER_ROOT_PI_HIGH), sum = dd_ordered_sum(1, -erf.high);
    return sum.high + (sum.low - (erf.low + x * (TWO_PER_ROOT_PI_LOW + t * rest)));
}

// e^(x^2) erfc(x) for 1/2 <= x < 32.
static DoubleDouble scaled_erfc(double x)
{
    const YkErfcPiece *piece = &yk_erfc_pieces[(bits_of(x) - bits_of(0.5)) >> 50];
    double u = x - piece->center, sum = piece->by_power[13];
    for (int k = 12; k >= 1; k--) sum = piece->by_power[k] + u * sum;
    return dd_ordered_sum(piece->by_power[0], piece->rest + u * sum);
}

// erfc(x) = value 2^exponent for 1/2 <= x < 28.
static DoubleDouble beyond(double x, int64_t *exponent)
{
    DoubleDouble square = dd_square(x), scaled = scaled_erfc(x);
    Exponential e = exponential(-square.high, -square.low);
    *exponent = e.exponent;
    return dd_times(exponential_pair(e), scaled);
}

double yk_erfc(double x)
{
    double a = fabs(x);
    if (a < 0.5) return near_zero(x);
    if (!(a < 28)) return isnan(x) ? NAN : x > 0 ? 0 : 2;
    int64_t exponent;
    DoubleDouble value = beyond(a, &exponent);
    if (x > 0 && exponent > -900) return dd_value(value) * power_of_two(exponent);
    if (x > 0) return yk_scaled(value, exponent);
    if (a > 6) return 2;
    double scale = power_of_two(exponent);
    DoubleDouble sum = dd_ordered_sum(2, -value.high * scale);
    return sum.high + (sum.low - value.low * scale);
}
