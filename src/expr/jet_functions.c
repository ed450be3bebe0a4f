// Powers and functions of Taylor series, each from the differential equation that it satisfies.
#include <math.h>
#include "elementary/elementary.h"
#include "expr/jet.h"

enum { N = YK_JET_ORDER };

// Returns coefficient k of y, with y' = g x', from g up to k - 1: k y_k = sum over j = 1..k of j x_j g_(k-j).
static double next(const YkSeries *x, const YkSeries *g, int k)
{
    double sum = 0;
    for (int j = 1; j <= k; j++) sum += j * x->c[j] * g->c[k - j];
    return sum / k;
}

// Returns y with y(0) = start and y' = slope x' for a known slope.
static YkSeries integrate(double start, const YkSeries *x, const YkSeries *slope)
{
    YkSeries y = {{start}};
    for (int k = 1; k <= N; k++) y.c[k] = next(x, slope, k);
    return y;
}

// Solves s' = c x', c' = sign s x': sine and cosine with sign -1, the hyperbolic ones with 1.
static void sine_pair(const YkSeries *x, double sign, YkSeries *s, YkSeries *c)
{
    *s = yk_series_constant(sign < 0 ? yk_sin(x->c[0]) : yk_sinh(x->c[0]));
    *c = yk_series_constant(sign < 0 ? yk_cos(x->c[0]) : yk_cosh(x->c[0]));
    for (int k = 1; k <= N; k++) {
        s->c[k] = next(x, c, k);
        c->c[k] = sign * next(x, s, k);
    }
}

// Solves y' = (1 + sign y^2) x': tangent with sign 1, hyperbolic tangent with -1.
static YkSeries tangent(const YkSeries *x, double sign)
{
    YkSeries y = yk_series_constant(sign > 0 ? yk_tan(x->c[0]) : yk_tanh(x->c[0])), slope = {{0}};
    for (int k = 0; k < N; k++) {
        slope.c[k] = k == 0 ? 1 : 0;
        for (int j = 0; j <= k; j++) slope.c[k] += sign * y.c[j] * y.c[k - j];
        y.c[k + 1] = next(x, &slope, k + 1);
    }
    return y;
}

static YkSeries exponential(const YkSeries *x)
{
    YkSeries y = yk_series_constant(yk_exp(x->c[0]));
    for (int k = 1; k <= N; k++) y.c[k] = next(x, &y, k);
    return y;
}

static YkSeries reciprocal(const YkSeries *x)
{
    YkSeries one = yk_series_constant(1);
    return yk_series_quotient(&one, x);
}

static const char *logarithm(const YkSeries *x, YkSeries *result)
{
    if (x->c[0] == 0) return "logarithm of zero";
    if (x->c[0] < 0) return "logarithm of a negative number";
    YkSeries slope = reciprocal(x);
    *result = integrate(yk_log(x->c[0]), x, &slope);
    return NULL;
}

// log10 x = log x / log 10; the value itself is computed directly, so that powers of ten are exact.
static const char *decimal_logarithm(const YkSeries *x, YkSeries *result)
{
    const char *why = logarithm(x, result);
    if (why) return why;
    *result = yk_series_scaled(result, 0.43429448190325182765);
    result->c[0] = yk_log10(x->c[0]);
    return NULL;
}

static const char *square_root(const YkSeries *x, YkSeries *result)
{
    *result = yk_series_constant(sqrt(x->c[0]));
    if (x->c[0] < 0) return "square root of a negative number";
    if (x->c[0] == 0) return yk_series_is_constant(x) ? NULL : "the square root has no derivative at zero";
    for (int k = 1; k <= N; k++) {
        double rest = x->c[k]; // coefficient k of y y = x
        for (int j = 1; j < k; j++) rest -= result->c[j] * result->c[k - j];
        result->c[k] = rest / (2 * result->c[0]);
    }
    return NULL;
}

static const char *arc_tangent(const YkSeries *x, YkSeries *result)
{
    YkSeries slope = yk_series_product(x, x);
    slope.c[0] += 1;
    slope = reciprocal(&slope);
    *result = integrate(yk_atan(x->c[0]), x, &slope);
    return NULL;
}

// Computes asin, and acos, whose slope is the opposite.
static const char *arc_sine(const YkSeries *x, bool is_cosine, YkSeries *result)
{
    double start = is_cosine ? yk_acos(x->c[0]) : yk_asin(x->c[0]);
    *result = yk_series_constant(start);
    if (fabs(x->c[0]) > 1) return is_cosine ? "acos of a number beyond 1" : "asin of a number beyond 1";
    if (yk_series_is_constant(x)) return NULL;
    if (fabs(x->c[0]) == 1) return is_cosine ? "acos has no derivative at 1" : "asin has no derivative at 1";
    // Written as a product, 1 - x^2 keeps its digits near 1.
    YkSeries below = yk_series_scaled(x, -1), above = *x, root;
    below.c[0] += 1;
    above.c[0] += 1;
    YkSeries product = yk_series_product(&below, &above);
    const char *why = square_root(&product, &root);
    if (why) return why;
    YkSeries slope = reciprocal(&root);
    if (is_cosine) slope = yk_series_scaled(&slope, -1);
    *result = integrate(start, x, &slope);
    return NULL;
}

// Computes phi = atan2(y, x) from phi' = (x y' - y x') / (x^2 + y^2), after scaling both to size 1.
static const char *arc_tangent2(const YkSeries *y, const YkSeries *x, YkSeries *result)
{
    double size = fmax(fabs(y->c[0]), fabs(x->c[0]));
    if (size == 0) return "atan2 of two zeros";
    int exponent;
    frexp(size, &exponent);
    YkSeries a = *y, b = *x;
    for (int k = 0; k <= N; k++) {
        a.c[k] = ldexp(a.c[k], -exponent);
        b.c[k] = ldexp(b.c[k], -exponent);
    }
    YkSeries aa = yk_series_product(&a, &a), bb = yk_series_product(&b, &b);
    YkSeries below = yk_series_sum(&aa, &bb, 1), inverse = reciprocal(&below);
    YkSeries to_a = yk_series_product(&b, &inverse), to_b = yk_series_product(&a, &inverse);
    YkSeries with_a = integrate(0, &a, &to_a), with_b = integrate(0, &b, &to_b);
    *result = yk_series_sum(&with_a, &with_b, -1);
    result->c[0] = yk_atan2(y->c[0], x->c[0]);
    return NULL;
}

// Returns the larger (sign 1) or smaller (-1); of two equal ones, the one that will be just after.
static YkSeries extreme(const YkSeries *a, const YkSeries *b, double sign)
{
    YkSeries difference = yk_series_sum(a, b, -1);
    return sign * yk_series_sign_after(&difference) >= 0 ? *a : *b;
}

// Computes a power by repeated squaring, so that a base of zero needs no special care.
static YkSeries whole_power(YkSeries base, double exponent)
{
    YkSeries power = yk_series_constant(1);
    for (double left = exponent; left > 0; left = floor(left / 2)) {
        if (yk_fmod(left, 2) == 1) power = yk_series_product(&power, &base);
        if (left > 1) base = yk_series_product(&base, &base);
    }
    return power;
}

// Computes y = x^n for a constant n that is not whole, from x y' = n y x'.
static const char *broken_power(const YkSeries *x, double n, YkSeries *result)
{
    if (x->c[0] < 0) return "a broken power of a negative number";
    *result = yk_series_constant(yk_pow(x->c[0], n));
    if (yk_series_is_constant(x)) return x->c[0] == 0 && n < 0 ? "division by zero" : NULL;
    if (x->c[0] == 0) return n < 0 ? "division by zero" : "a broken power has no derivatives at zero";
    for (int k = 1; k <= N; k++) {
        double sum = 0;
        for (int j = 1; j <= k; j++) sum += (n * j - (k - j)) * x->c[j] * result->c[k - j];
        result->c[k] = sum / (k * x->c[0]);
    }
    return NULL;
}

const char *yk_series_power(const YkSeries *base, const YkSeries *exponent, YkSeries *result)
{
    double n = exponent->c[0];
    if (!yk_series_is_constant(exponent)) {
        YkSeries log_base;
        if (base->c[0] <= 0) return "a variable power of zero or a negative number";
        const char *why = logarithm(base, &log_base);
        if (why) return why;
        YkSeries product = yk_series_product(exponent, &log_base);
        *result = exponential(&product);
        return NULL;
    }
    if (n != floor(n)) return broken_power(base, n, result);
    if (n < 0 && base->c[0] == 0) return "division by zero";
    if (yk_series_is_constant(base)) {
        *result = yk_series_constant(yk_pow(base->c[0], n));
        return NULL;
    }
    *result = whole_power(*base, fabs(n));
    if (n < 0) *result = reciprocal(result);
    return NULL;
}

const char *yk_series_function(YkFunction function, const YkSeries *a, const YkSeries *b, YkSeries *result)
{
    YkSeries other;
    switch (function) {
    case YK_SIN:
        sine_pair(a, -1, result, &other);
        return NULL;
    case YK_COS:
        sine_pair(a, -1, &other, result);
        return NULL;
    case YK_TAN:
        *result = tangent(a, 1);
        return NULL;
    case YK_ASIN:
        return arc_sine(a, false, result);
    case YK_ACOS:
        return arc_sine(a, true, result);
    case YK_ATAN:
        return arc_tangent(a, result);
    case YK_ATAN2:
        return arc_tangent2(a, b, result);
    case YK_SINH:
        sine_pair(a, 1, result, &other);
        return NULL;
    case YK_COSH:
        sine_pair(a, 1, &other, result);
        return NULL;
    case YK_TANH:
        *result = tangent(a, -1);
        return NULL;
    case YK_SQRT:
        return square_root(a, result);
    case YK_EXP:
        *result = exponential(a);
        return NULL;
    case YK_LOG:
        return logarithm(a, result);
    case YK_LOG10:
        return decimal_logarithm(a, result);
    case YK_ABS:
        *result = yk_series_scaled(a, yk_series_sign_after(a));
        return NULL;
    case YK_SIGN:
        *result = yk_series_constant((a->c[0] > 0) - (a->c[0] < 0));
        return NULL;
    case YK_MIN:
        *result = extreme(a, b, -1);
        return NULL;
    case YK_MAX:
        *result = extreme(a, b, 1);
        return NULL;
    case YK_FUNCTION_COUNT:
        break;
    }
    return "an unknown function";
}
