// Determines what an expression is by itself: from the leaves up.
#include <string.h>
#include "expr/dimension.h"

static void become(YkExpr *expr, YkDimState state, YkDimension dimension)
{
    expr->state = (uint8_t)state;
    expr->dimension = dimension;
}

static void become_number(YkExpr *expr)
{
    become(expr, YK_DIM_KNOWN, YK_DIM_NONE);
}

static void up_name(const YkDimensions *dims, YkExpr *expr)
{
    if (expr->parameter < 0) {
        become(expr, YK_DIM_SKIP, YK_DIM_NONE);
        return;
    }
    const YkDimName *name = &dims->names[expr->parameter];
    bool is_pi = !name->expr && strcmp(expr->name, "pi") == 0;
    become(expr, is_pi ? YK_DIM_BARE_PI : name->is_known ? YK_DIM_KNOWN : YK_DIM_OPEN, name->dimension);
}

// Makes a number of literals alone a bare number.
static void become_bare_if_literal(YkExpr *expr)
{
    if (expr->is_literal && expr->state == YK_DIM_KNOWN && yk_dimension_equal(expr->dimension, YK_DIM_NONE) &&
        expr->dimension.angle == 0)
        become(expr, YK_DIM_BARE, YK_DIM_NONE);
}

static bool is_angle(YkDimension dimension)
{
    return yk_dimension_equal(dimension, YK_DIM_NONE) && dimension.angle == 1;
}

static bool is_literal(const YkExpr *expr)
{
    if (expr->kind == YK_EXPR_NUMBER) return !expr->has_unit || is_angle(expr->unit);
    if (expr->kind == YK_EXPR_NAME) return expr->state == YK_DIM_BARE_PI;
    return expr->a->is_literal && (!expr->b || expr->b->is_literal);
}

// Handles two that must have equal dimensions: terms of a sum, arguments of min, max and atan2.
static void up_equal(YkDimensions *dims, YkExpr *expr)
{
    const YkExpr *a = expr->a, *b = expr->b;
    if (a->state == YK_DIM_SKIP || b->state == YK_DIM_SKIP) {
        become(expr, YK_DIM_SKIP, YK_DIM_NONE);
    } else if (a->state == YK_DIM_KNOWN && b->state == YK_DIM_KNOWN) {
        bool fits = yk_dimension_equal(a->dimension, b->dimension);
        if (!fits) yk_dim_report_pair(dims, expr);
        become(expr, fits ? YK_DIM_KNOWN : YK_DIM_SKIP, yk_dim_richer(a->dimension, b->dimension));
    } else if (a->state == YK_DIM_KNOWN || b->state == YK_DIM_KNOWN) {
        become(expr, YK_DIM_KNOWN, a->state == YK_DIM_KNOWN ? a->dimension : b->dimension);
    } else if (a->state == YK_DIM_OPEN || b->state == YK_DIM_OPEN) {
        become(expr, YK_DIM_OPEN, YK_DIM_NONE);
    } else {
        become(expr, a->state == YK_DIM_BARE ? b->state : YK_DIM_BARE_PI, YK_DIM_NONE);
    }
}

static void up_product(YkExpr *expr)
{
    const YkExpr *a = expr->a, *b = expr->b;
    if (a->state == YK_DIM_SKIP || b->state == YK_DIM_SKIP)
        become(expr, YK_DIM_SKIP, YK_DIM_NONE);
    else if (yk_dim_is_bare(a) && yk_dim_is_bare(b))
        become(expr, a->state == YK_DIM_BARE ? b->state : YK_DIM_BARE_PI, YK_DIM_NONE);
    else if (a->state == YK_DIM_OPEN || b->state == YK_DIM_OPEN)
        become(expr, YK_DIM_OPEN, YK_DIM_NONE);
    else // A bare part has the dimension of a number.
        become(expr, YK_DIM_KNOWN,
               yk_dimension_times(a->dimension, b->dimension, expr->kind == YK_EXPR_DIVIDE ? -1 : 1));
}

static void up_power(YkDimensions *dims, YkExpr *expr)
{
    const YkExpr *a = expr->a, *b = expr->b;
    double power = 0;
    bool is_literal = yk_dim_literal(b, &power);
    if (a->state == YK_DIM_SKIP || b->state == YK_DIM_SKIP) {
        become(expr, YK_DIM_SKIP, YK_DIM_NONE);
    } else if (b->state == YK_DIM_KNOWN && !yk_dimension_equal(b->dimension, YK_DIM_NONE)) {
        yk_dim_report_exponent(dims, b);
        become(expr, YK_DIM_SKIP, YK_DIM_NONE);
    } else if (a->state != YK_DIM_KNOWN) {
        become_number(expr);
        if (a->state == YK_DIM_OPEN || (is_literal && power != 0)) become(expr, (YkDimState)a->state, YK_DIM_NONE);
    } else if (!is_literal && yk_dimension_equal(a->dimension, YK_DIM_NONE)) {
        become_number(expr);
    } else {
        YkDimension result;
        bool fits = is_literal && yk_dim_power(a->dimension, power, &result);
        if (!fits) yk_dim_report_power(dims, expr);
        become(expr, fits ? YK_DIM_KNOWN : YK_DIM_SKIP, fits ? result : YK_DIM_NONE);
    }
}

static void up_root(YkDimensions *dims, YkExpr *expr)
{
    YkDimension half = YK_DIM_NONE;
    become(expr, (YkDimState)expr->a->state, YK_DIM_NONE);
    if (expr->a->state != YK_DIM_KNOWN) return;
    bool fits = yk_dim_power(expr->a->dimension, 0.5, &half);
    if (!fits) yk_dim_report_power(dims, expr);
    become(expr, fits ? YK_DIM_KNOWN : YK_DIM_SKIP, half);
}

// Handles a function of a plain number or an angle, which have equal dimensions.
static void up_argument(YkDimensions *dims, YkExpr *expr, YkDimension argument, YkDimension result)
{
    if (expr->a->state == YK_DIM_KNOWN && !yk_dimension_equal(expr->a->dimension, argument))
        yk_dim_report_argument(dims, expr, argument);
    become(expr, YK_DIM_KNOWN, result);
}

static void up_call(YkDimensions *dims, YkExpr *expr)
{
    const YkDimension angle = {0, 0, 0, 1};
    switch (expr->function) {
    case YK_SIN:
    case YK_COS:
    case YK_TAN:
        up_argument(dims, expr, angle, YK_DIM_NONE);
        break;
    case YK_ASIN:
    case YK_ACOS:
    case YK_ATAN:
        up_argument(dims, expr, YK_DIM_NONE, angle);
        break;
    case YK_ATAN2:
        up_equal(dims, expr);
        become(expr, YK_DIM_KNOWN, angle);
        break;
    case YK_SQRT:
        up_root(dims, expr);
        break;
    case YK_ABS:
        become(expr, (YkDimState)expr->a->state, expr->a->dimension);
        break;
    case YK_SIGN:
        become_number(expr);
        break;
    case YK_MIN:
    case YK_MAX:
        up_equal(dims, expr);
        break;
    default:
        up_argument(dims, expr, YK_DIM_NONE, YK_DIM_NONE);
        break;
    }
}

void yk_dim_up(YkDimensions *dims, YkExpr *expr)
{
    if (expr->a) yk_dim_up(dims, (YkExpr *)expr->a);
    if (expr->b) yk_dim_up(dims, (YkExpr *)expr->b);
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        become(expr, expr->has_unit ? YK_DIM_KNOWN : YK_DIM_BARE, expr->has_unit ? expr->unit : YK_DIM_NONE);
        break;
    case YK_EXPR_NAME:
        up_name(dims, expr);
        break;
    case YK_EXPR_NEGATE:
        become(expr, (YkDimState)expr->a->state, expr->a->dimension);
        break;
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
        up_equal(dims, expr);
        break;
    case YK_EXPR_MULTIPLY:
    case YK_EXPR_DIVIDE:
        up_product(expr);
        break;
    case YK_EXPR_POWER:
        up_power(dims, expr);
        break;
    case YK_EXPR_CALL:
        up_call(dims, expr);
        break;
    }
    expr->is_literal = is_literal(expr);
    become_bare_if_literal(expr);
}
