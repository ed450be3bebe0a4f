// Arithmetic of truncated Taylor series x(t + h) = c0 + c1 h + ... + c4 h^4, so that c[k] is the k-th derivative over
// k!. Products and quotients are those of polynomials; a function y = f(x) follows from its differential equation y' =
// f'(x) x' coefficient by coefficient. Source: Griewank & Walther 2008, Evaluating Derivatives, ch. 13; Moore 1979.
#ifndef EXPR_JET_H
#define EXPR_JET_H
#include "expr/expr.h"

typedef struct YkSeries {
    double c[YK_JET_ORDER + 1];
} YkSeries;

YkSeries yk_series_of_jet(const YkJet *jet);
YkJet yk_jet_of_series(const YkSeries *series);
YkSeries yk_series_constant(double value);
bool yk_series_is_constant(const YkSeries *x);
bool yk_series_is_finite(const YkSeries *x);

YkSeries yk_series_sum(const YkSeries *a, const YkSeries *b, double sign); // a + sign b
YkSeries yk_series_scaled(const YkSeries *a, double factor);
YkSeries yk_series_product(const YkSeries *a, const YkSeries *b);
YkSeries yk_series_quotient(const YkSeries *a, const YkSeries *b); // b.c[0] != 0
// Returns the sign of x just after its time: that of its first nonzero coefficient; 0 for the constant 0.
double yk_series_sign_after(const YkSeries *x);

// These return NULL, or what went wrong: "square root of a negative number".
const char *yk_series_power(const YkSeries *base, const YkSeries *exponent, YkSeries *result);
const char *yk_series_function(YkFunction function, const YkSeries *a, const YkSeries *b, YkSeries *result);

#endif
