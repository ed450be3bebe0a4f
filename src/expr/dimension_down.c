// Determines what an expression must be in its place: from the root down, after yk_dim_up.
#include "elementary/elementary.h"
#include "expr/dimension.h"

static void down(YkDimensions *dims, const YkExpr *expr, const YkDimension *want, bool is_direct)
{
    yk_dim_down(dims, (YkExpr *)expr, want, is_direct);
}

// Returns whether a function takes its argument as it stands: sin, exp, sign, ...
static bool is_function_of_numbers(const YkExpr *expr)
{
    if (expr->kind != YK_EXPR_CALL) return false;
    return expr->function != YK_SQRT && expr->function != YK_ABS && expr->function != YK_MIN &&
           expr->function != YK_MAX;
}

// Returns whether a factor on the value of a bare expression can go into its numbers. It cannot go into pi, cos(...),
// 2^cos(...).
static bool takes_scale(const YkExpr *expr)
{
    const YkExpr *a = expr->a, *b = expr->b;
    double power;
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        return !expr->has_unit;
    case YK_EXPR_NAME:
        return false;
    case YK_EXPR_MULTIPLY:
    case YK_EXPR_DIVIDE:
        return takes_scale(a) || takes_scale(b);
    case YK_EXPR_POWER:
        return yk_dim_literal(b, &power) && power != 0 && takes_scale(a);
    case YK_EXPR_CALL:
        if (is_function_of_numbers(expr)) return false;
        break;
    case YK_EXPR_NEGATE:
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
        break;
    }
    return takes_scale(a) && (!b || takes_scale(b));
}

// Turns `x` into the product `1 * x`, whose 1 takes the scale.
static void scale_whole(YkDimensions *dims, YkExpr *expr, double scale)
{
    YkExpr *parts = YK_NEW(dims->arena, YkExpr, 2);
    if (!parts) {
        dims->failed = true;
        return;
    }
    parts[0] = (YkExpr){.kind = YK_EXPR_NUMBER, .place = expr->place, .number = 1, .mantissa = 1, .is_exact = true};
    parts[0].unit_size = 1;
    parts[0].value_scale = scale;
    parts[0].is_literal = true;
    parts[0].state = YK_DIM_BARE;
    parts[1] = *expr;
    *expr = (YkExpr){.kind = YK_EXPR_MULTIPLY, .place = expr->place, .unit_size = 1, .value_scale = 1};
    expr->a = &parts[0];
    expr->b = &parts[1];
    expr->state = parts[1].state;
    expr->is_literal = true;
}

// Multiplies the value of an expression of bare numbers by `scale`, through one of its numbers if it has one.
static void scale_bare(YkDimensions *dims, YkExpr *expr, double scale)
{
    YkExpr *a = (YkExpr *)expr->a, *b = (YkExpr *)expr->b;
    double power = 1;
    if (!takes_scale(expr)) {
        if (dims->phase == YK_PHASE_FINAL && scale != 1) scale_whole(dims, expr, scale);
        return;
    }
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        expr->value_scale = scale;
        return;
    case YK_EXPR_MULTIPLY:
        scale_bare(dims, takes_scale(a) ? a : b, scale);
        return;
    case YK_EXPR_DIVIDE:
        scale_bare(dims, takes_scale(a) ? a : b, takes_scale(a) ? scale : 1 / scale);
        return;
    case YK_EXPR_POWER:
        yk_dim_literal(b, &power);
        scale_bare(dims, a, yk_pow(scale, 1 / power));
        return;
    case YK_EXPR_CALL:
        if (expr->function == YK_SQRT) scale *= scale;
        break;
    case YK_EXPR_NAME:
    case YK_EXPR_NEGATE:
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
        break;
    }
    scale_bare(dims, a, scale); // in sums, abs, min and max both take it
    if (b) scale_bare(dims, b, scale);
}

static void clear_scales(YkExpr *expr)
{
    expr->value_scale = 1;
    if (expr->a) clear_scales((YkExpr *)expr->a);
    if (expr->b) clear_scales((YkExpr *)expr->b);
}

static YkDimension without_angle(YkDimension dimension)
{
    dimension.angle = 0;
    return dimension;
}

static void down_call(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct);

// Gives the arguments of functions in a bare expression their dimensions: angles, plain numbers.
static void down_arguments(YkDimensions *dims, const YkExpr *expr)
{
    if (is_function_of_numbers(expr)) {
        down_call(dims, (YkExpr *)expr, NULL, true);
        return;
    }
    if (expr->a) down_arguments(dims, expr->a);
    if (expr->b) down_arguments(dims, expr->b);
}

// Gives a product, power or function of bare numbers as a whole the wanted dimension, or makes it a number.
static void down_bare(YkDimensions *dims, YkExpr *expr, const YkDimension *want)
{
    clear_scales(expr);
    if (want) {
        YkDimension dimension = expr->state == YK_DIM_BARE_PI ? without_angle(*want) : *want;
        bool is_number = yk_dimension_equal(dimension, YK_DIM_NONE) && dimension.angle == 0;
        if (!is_number) yk_dim_warn_of_unit(dims, expr, dimension);
        if (!is_number) scale_bare(dims, expr, yk_units_size(&dims->units, dimension));
    }
    down_arguments(dims, expr);
}

// Gives an open parameter the wanted dimension. One that took another kind of angle before would have another scale.
static void down_name(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct)
{
    if (!want || expr->parameter < 0) return;
    const YkDimName *name = &dims->names[expr->parameter];
    if (!name->is_known) {
        yk_dim_set(dims, expr->parameter, *want, dims->current, expr->place);
        return;
    }
    bool differs = yk_dimension_equal(name->dimension, *want) && name->dimension.angle != want->angle;
    if (is_direct && differs && name->origin && dims->units.angle != 1) yk_dim_report_two_ways(dims, expr, *want);
}

// Handles a product with one bare operand, which is a plain number; the other takes what is wanted of the product.
static void down_multiple(YkDimensions *dims, const YkExpr *expr, const YkExpr *bare, const YkDimension *want,
                          bool is_direct)
{
    const YkExpr *other = expr->a == bare ? expr->b : expr->a;
    down(dims, bare, NULL, is_direct);
    if (!want) {
        down(dims, other, NULL, is_direct);
        return;
    }
    YkDimension rest = bare->state == YK_DIM_BARE_PI ? without_angle(*want) : *want;
    if (expr->kind == YK_EXPR_DIVIDE && bare == expr->a) rest = yk_dimension_times(YK_DIM_NONE, rest, -1);
    down(dims, other, other->state == YK_DIM_OPEN ? &rest : NULL, is_direct);
}

static void down_product(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct)
{
    const YkExpr *a = expr->a, *b = expr->b;
    if (yk_dim_is_bare(a) || yk_dim_is_bare(b)) {
        down_multiple(dims, expr, yk_dim_is_bare(a) ? a : b, want, is_direct);
        return;
    }
    bool is_quotient = expr->kind == YK_EXPR_DIVIDE, may_solve = want && dims->phase >= YK_PHASE_SOLVE;
    YkDimension for_a, for_b;
    bool solves_a = may_solve && a->state == YK_DIM_OPEN && b->state == YK_DIM_KNOWN;
    bool solves_b = may_solve && b->state == YK_DIM_OPEN && a->state == YK_DIM_KNOWN;
    if (solves_a) for_a = yk_dimension_times(*want, b->dimension, is_quotient ? 1 : -1);
    if (solves_b)
        for_b = is_quotient ? yk_dimension_times(a->dimension, *want, -1) : yk_dimension_times(*want, a->dimension, -1);
    down(dims, a, solves_a ? &for_a : NULL, false);
    down(dims, b, solves_b ? &for_b : NULL, false);
}

static void down_power(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct)
{
    const YkDimension none = YK_DIM_NONE;
    double power = 0;
    YkDimension base = none;
    bool is_literal = yk_dim_literal(expr->b, &power);
    bool may_solve = want && is_literal && power != 0 && dims->phase >= YK_PHASE_SOLVE;
    bool solves =
        expr->a->state == YK_DIM_OPEN && (!is_literal || (may_solve && yk_dim_power(*want, 1 / power, &base)));
    down(dims, expr->b, &none, is_direct);
    down(dims, expr->a, solves ? &base : NULL, !is_literal);
}

static void down_root(YkDimensions *dims, YkExpr *expr, const YkDimension *want)
{
    bool solves = want && expr->a->state == YK_DIM_OPEN && dims->phase >= YK_PHASE_SOLVE;
    YkDimension square;
    if (solves) square = yk_dimension_times(*want, *want, 1);
    down(dims, expr->a, solves ? &square : NULL, false);
}

// Handles atan2, whose arguments have equal dimensions; two bare ones are plain numbers.
static void down_atan2(YkDimensions *dims, YkExpr *expr)
{
    const YkExpr *a = expr->a, *b = expr->b;
    const YkDimension *known = a->state == YK_DIM_KNOWN   ? &a->dimension
                               : b->state == YK_DIM_KNOWN ? &b->dimension
                                                          : NULL;
    YkDimension both = known ? *known : YK_DIM_NONE;
    down(dims, a, known ? &both : NULL, true);
    down(dims, b, known ? &both : NULL, true);
}

static void down_call(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct)
{
    const YkDimension angle = {0, 0, 0, 1}, none = YK_DIM_NONE;
    switch (expr->function) {
    case YK_SIN:
    case YK_COS:
    case YK_TAN:
        down(dims, expr->a, &angle, true);
        break;
    case YK_ATAN2:
        down_atan2(dims, expr);
        break;
    case YK_SQRT:
        down_root(dims, expr, want);
        break;
    case YK_MIN:
    case YK_MAX:
        down(dims, expr->a, want, is_direct);
        down(dims, expr->b, want, is_direct);
        break;
    case YK_ABS:
        down(dims, expr->a, want, is_direct);
        break;
    case YK_SIGN:
        down(dims, expr->a, NULL, is_direct);
        break;
    default:
        down(dims, expr->a, &none, true);
        break;
    }
}

void yk_dim_down(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct)
{
    YkDimension own = expr->dimension;
    if (expr->state == YK_DIM_SKIP) want = NULL;
    if (expr->state == YK_DIM_KNOWN) {
        bool is_same = want && yk_dimension_equal(*want, own) && expr->kind != YK_EXPR_NAME;
        if (is_same && want->angle != own.angle) yk_dim_warn_of_factor(dims, expr);
        if (is_same) own = yk_dim_richer(*want, own);
        if (!want || !yk_dimension_equal(*want, own) || expr->kind != YK_EXPR_NAME) want = &own;
    }
    bool is_sum = expr->kind == YK_EXPR_ADD || expr->kind == YK_EXPR_SUBTRACT || expr->kind == YK_EXPR_NEGATE ||
                  (expr->kind == YK_EXPR_CALL && !is_function_of_numbers(expr) && expr->function != YK_SQRT);
    if (yk_dim_is_bare(expr) && !is_sum) {
        down_bare(dims, expr, want);
        return;
    }
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        break;
    case YK_EXPR_NAME:
        down_name(dims, expr, want, is_direct);
        break;
    case YK_EXPR_NEGATE:
        down(dims, expr->a, want, is_direct);
        break;
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
        down(dims, expr->a, want, is_direct);
        down(dims, expr->b, want, is_direct);
        break;
    case YK_EXPR_MULTIPLY:
    case YK_EXPR_DIVIDE:
        down_product(dims, expr, want, is_direct);
        break;
    case YK_EXPR_POWER:
        down_power(dims, expr, want, is_direct);
        break;
    case YK_EXPR_CALL:
        down_call(dims, expr, want, is_direct);
        break;
    }
}
