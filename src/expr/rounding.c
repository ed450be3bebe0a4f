// Bounds how much rounding may have changed the value of an expression. Source: Higham 2002, Accuracy and Stability of
// Numerical Algorithms, 3.3 (running error analysis).
#include <float.h>
#include <math.h>
#include <string.h>
#include "base/vec.h"
#include "expr/jet.h"

typedef struct Source {
    YkLookup lookup;
    const void *context;
} Source;

typedef struct Rounded { // |true value - value| <= error, to first order
    double value, error;
} Rounded;

static const Rounded unknown = {NAN, INFINITY};

static Rounded rounded(double value, double carried)
{
    return (Rounded){value, carried + DBL_EPSILON * fabs(value)};
}

static Rounded number(const YkExpr *expr)
{
    double scale = expr->has_unit ? expr->unit_size : expr->value_scale;
    if (scale == 1 && expr->number == rint(expr->number)) return (Rounded){expr->number, 0};
    return rounded(expr->number * scale, 0);
}

// Handles a name: the time is exact; a parameter was rounded.
static Rounded name(const Source *source, const YkExpr *expr)
{
    YkJet jet = {{0}};
    bool has_value = source->lookup && source->lookup(source->context, expr, &jet);
    if (!has_value && strcmp(expr->name, "pi") == 0) jet.d[0] = YK_PI;
    if (!has_value && strcmp(expr->name, "pi") != 0) return unknown;
    if (jet.d[1] != 0 || jet.d[0] == rint(jet.d[0])) return (Rounded){jet.d[0], 0};
    return rounded(jet.d[0], 0);
}

// Propagates the operand's error through a function by its slope there, taken from the function's own series.
static double carried(const YkExpr *expr, YkSeries a, YkSeries b, double error)
{
    YkSeries result = {{0}};
    if (error == 0) return 0;
    const char *why = expr->kind == YK_EXPR_POWER ? yk_series_power(&a, &b, &result)
                                                  : yk_series_function(expr->function, &a, &b, &result);
    return why ? INFINITY : fabs(result.c[1]) * error;
}

static Rounded call(const YkExpr *expr, Rounded a, Rounded b)
{
    YkSeries x = yk_series_constant(a.value), y = yk_series_constant(b.value), result = {{0}};
    YkSeries x_varies = {{a.value, 1}}, y_varies = {{b.value, 1}};
    const char *why = expr->kind == YK_EXPR_POWER ? yk_series_power(&x, &y, &result)
                                                  : yk_series_function(expr->function, &x, &y, &result);
    if (why) return unknown;
    return rounded(result.c[0], carried(expr, x_varies, y, a.error) + carried(expr, x, y_varies, b.error));
}

static Rounded operate(const Source *source, const YkExpr *expr);

static Rounded evaluate(const Source *source, const YkExpr *expr)
{
    if (expr->kind == YK_EXPR_NUMBER) return number(expr);
    if (expr->kind == YK_EXPR_NAME) return name(source, expr);
    return operate(source, expr);
}

static Rounded operate(const Source *source, const YkExpr *expr)
{
    Rounded a = evaluate(source, expr->a), b = expr->b ? evaluate(source, expr->b) : (Rounded){0, 0};
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        return (Rounded){-a.value, a.error};
    case YK_EXPR_ADD:
        return rounded(a.value + b.value, a.error + b.error);
    case YK_EXPR_SUBTRACT:
        return rounded(a.value - b.value, a.error + b.error);
    case YK_EXPR_MULTIPLY:
        return rounded(a.value * b.value, fabs(a.value) * b.error + fabs(b.value) * a.error);
    case YK_EXPR_DIVIDE:
        return rounded(a.value / b.value, (a.error + fabs(a.value / b.value) * b.error) / fabs(b.value));
    default:
        return call(expr, a, b);
    }
}

double yk_expr_rounding(const YkExpr *expr, YkLookup lookup, const void *context)
{
    Source source = {lookup, context};
    Rounded result = evaluate(&source, expr);
    return result.error >= 0 ? result.error : INFINITY; // also NaN
}
