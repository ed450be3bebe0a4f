// Questions that all passes of inference ask about expressions and dimensions.
#include <math.h>
#include "elementary/elementary.h"
#include "expr/dimension.h"

bool yk_dim_is_bare(const YkExpr *expr)
{
    return expr->state == YK_DIM_BARE || expr->state == YK_DIM_BARE_PI;
}

bool yk_dim_literal(const YkExpr *expr, double *value)
{
    double a = 0, b = 0;
    if (expr->kind == YK_EXPR_NUMBER) {
        *value = expr->number;
        return !expr->has_unit;
    }
    if (expr->kind == YK_EXPR_NAME || expr->kind == YK_EXPR_CALL) return false;
    if (!yk_dim_literal(expr->a, &a) || (expr->b && !yk_dim_literal(expr->b, &b))) return false;
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        *value = -a;
        break;
    case YK_EXPR_ADD:
        *value = a + b;
        break;
    case YK_EXPR_SUBTRACT:
        *value = a - b;
        break;
    case YK_EXPR_MULTIPLY:
        *value = a * b;
        break;
    case YK_EXPR_DIVIDE:
        *value = a / b;
        break;
    default:
        *value = yk_pow(a, b);
        break;
    }
    return isfinite(*value);
}

static bool power_of(signed char exponent, double power, signed char *result)
{
    double product = exponent * power;
    *result = 0;
    if (product != rint(product) || fabs(product) > 100) return false;
    *result = (signed char)product;
    return true;
}

bool yk_dim_power(YkDimension dimension, double power, YkDimension *result)
{
    power_of(dimension.angle, power, &result->angle);
    bool is_length_whole = power_of(dimension.length, power, &result->length);
    bool is_mass_whole = power_of(dimension.mass, power, &result->mass);
    return power_of(dimension.time, power, &result->time) && is_length_whole && is_mass_whole;
}

YkDimension yk_dim_richer(YkDimension a, YkDimension b)
{
    return a.angle != 0 ? a : b;
}
