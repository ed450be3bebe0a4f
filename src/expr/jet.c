// Arithmetic of truncated Taylor series.
#include "expr/jet.h"
#include <math.h>

enum { N = YK_JET_ORDER };

YkSeries yk_series_of_jet(const YkJet *jet)
{
    YkSeries series;
    double factorial = 1;
    for (int k = 0; k <= N; factorial *= ++k) series.c[k] = jet->d[k] / factorial;
    return series;
}

YkJet yk_jet_of_series(const YkSeries *series)
{
    YkJet jet;
    double factorial = 1;
    for (int k = 0; k <= N; factorial *= ++k) jet.d[k] = series->c[k] * factorial;
    return jet;
}

YkSeries yk_series_constant(double value)
{
    return (YkSeries){{value}};
}

bool yk_series_is_constant(const YkSeries *x)
{
    for (int k = 1; k <= N; k++)
        if (x->c[k] != 0) return false;
    return true;
}

bool yk_series_is_finite(const YkSeries *x)
{
    for (int k = 0; k <= N; k++)
        if (!isfinite(x->c[k])) return false;
    return true;
}

YkSeries yk_series_sum(const YkSeries *a, const YkSeries *b, double sign)
{
    YkSeries sum;
    for (int k = 0; k <= N; k++) sum.c[k] = a->c[k] + sign * b->c[k];
    return sum;
}

YkSeries yk_series_scaled(const YkSeries *a, double factor)
{
    YkSeries scaled;
    for (int k = 0; k <= N; k++) scaled.c[k] = a->c[k] * factor;
    return scaled;
}

YkSeries yk_series_product(const YkSeries *a, const YkSeries *b)
{
    YkSeries product = {{0}};
    for (int k = 0; k <= N; k++)
        for (int j = 0; j <= k; j++) product.c[k] += a->c[j] * b->c[k - j];
    return product;
}

YkSeries yk_series_quotient(const YkSeries *a, const YkSeries *b)
{
    YkSeries quotient;
    for (int k = 0; k <= N; k++) {
        double rest = a->c[k];
        for (int j = 1; j <= k; j++) rest -= b->c[j] * quotient.c[k - j];
        quotient.c[k] = rest / b->c[0];
    }
    return quotient;
}

double yk_series_sign_after(const YkSeries *x)
{
    for (int k = 0; k <= N; k++)
        if (x->c[k] != 0) return x->c[k] > 0 ? 1 : -1;
    return 0;
}
