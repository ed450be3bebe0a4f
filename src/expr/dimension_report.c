// What does not fit, in words.
#include <string.h>
#include "expr/dimension.h"
#include "expr/function.h"

// Nothing is final before the last phase, so nothing is reported.
static bool is_silent(YkDimensions *dims)
{
    if (dims->phase == YK_PHASE_FINAL) dims->has_errors = true;
    return dims->phase != YK_PHASE_FINAL;
}

// "mass of `link1`", or "parameter `a`".
static const char *describe(const YkDimensions *dims, const YkConstraint *constraint)
{
    if (constraint->parameter < 0) return constraint->what ? constraint->what : "a value";
    const char *name = dims->names[constraint->parameter].name;
    size_t length = strlen(name);
    static const char before[] = "parameter `";
    char *text = yk_arena_alloc(dims->arena, sizeof before + length + 1, 1);
    if (!text) return "a parameter";
    memcpy(text, before, sizeof before - 1);
    memcpy(text + sizeof before - 1, name, length);
    text[sizeof before - 1 + length] = '`';
    return text;
}

// The parameter, without a unit of its own, that an expression is but for its sign and a factor; or NULL.
static const YkExpr *parameter_in(const YkDimensions *dims, const YkExpr *expr)
{
    while (expr->kind != YK_EXPR_NAME) {
        bool is_product = expr->kind == YK_EXPR_MULTIPLY || expr->kind == YK_EXPR_DIVIDE;
        if (expr->kind == YK_EXPR_NEGATE || (is_product && yk_dim_is_bare(expr->b)))
            expr = expr->a;
        else if (expr->kind == YK_EXPR_MULTIPLY && yk_dim_is_bare(expr->a))
            expr = expr->b;
        else
            return NULL;
    }
    return expr->parameter >= 0 && dims->names[expr->parameter].origin ? expr : NULL;
}

void yk_dim_report_two_ways(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    if (is_silent(dims)) return;
    const YkDimName *name = &dims->names[expr->parameter];
    const char *here = describe(dims, dims->current), *there = describe(dims, name->origin);
    yk_problem(dims->problems, YK_CODE_TWO_DIMENSIONS, expr->place,
               "%q is used as %s here (%s) but as %s elsewhere (%s)", expr->name, yk_dimension_name(wanted), here,
               yk_dimension_name(name->dimension), there);
    if (name->origin_place.line > 0)
        yk_problem_hint(dims->problems, "the other use is on line %u, column %u; give %q a unit, or use two parameters",
                        (unsigned)name->origin_place.line, (unsigned)name->origin_place.column, expr->name);
    else
        yk_problem_hint(dims->problems, "give %q a unit, or use two parameters", expr->name);
}

// The expression's dimension is not the wanted one because a parameter in it has got its dimension elsewhere.
static bool is_two_ways(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    const YkExpr *name = parameter_in(dims, expr);
    if (name) yk_dim_report_two_ways(dims, name, wanted);
    return name != NULL;
}

static bool is_bare_number(const YkExpr *expr)
{
    return expr->kind == YK_EXPR_NUMBER && !expr->has_unit;
}

// A term of the sum that has a number without a unit as a factor, such as `0.02 * theta.rate`; NULL: there is none.
static const YkExpr *bare_factor(const YkExpr *expr)
{
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        return bare_factor(expr->a);
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT: {
        const YkExpr *found = bare_factor(expr->a);
        return found ? found : bare_factor(expr->b);
    }
    case YK_EXPR_MULTIPLY: {
        if (is_bare_number(expr->a)) return expr->a;
        if (is_bare_number(expr->b)) return expr->b;
        const YkExpr *found = bare_factor(expr->a);
        return found ? found : bare_factor(expr->b);
    }
    case YK_EXPR_DIVIDE:
        return is_bare_number(expr->a) ? expr->a : bare_factor(expr->a);
    default:
        return NULL;
    }
}

static void hint_at_bare_factor(YkDimensions *dims)
{
    yk_problem_hint(dims->problems, "in a product a bare number is a plain number: give it its unit");
}

void yk_dim_report_use(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    if (is_silent(dims) || is_two_ways(dims, expr, wanted)) return;
    const YkConstraint *current = dims->current;
    yk_problem(dims->problems, YK_CODE_WRONG_DIMENSION, expr->place, "%s must be %s, this is %s",
               describe(dims, current), yk_dimension_name(wanted), yk_dimension_name(expr->dimension));
    const YkDimName *owner = current->parameter >= 0 ? &dims->names[current->parameter] : NULL;
    if (owner && owner->origin)
        yk_problem_hint(dims->problems, "it is used as %s on line %u, column %u", yk_dimension_name(wanted),
                        (unsigned)owner->origin_place.line, (unsigned)owner->origin_place.column);
    else if (yk_dimension_equal(expr->dimension, YK_DIM_NONE) || bare_factor(expr))
        hint_at_bare_factor(dims);
}

void yk_dim_report_pair(YkDimensions *dims, const YkExpr *expr)
{
    if (is_silent(dims)) return;
    YkDimension a = expr->a->dimension, b = expr->b->dimension;
    if (is_two_ways(dims, expr->b, a) || is_two_ways(dims, expr->a, b)) return;
    const char *name_a = yk_dimension_name(a), *name_b = yk_dimension_name(b);
    YkPlace place = expr->b->place;
    if (expr->kind == YK_EXPR_ADD)
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "cannot add %s and %s", name_a, name_b);
    else if (expr->kind == YK_EXPR_SUBTRACT)
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "cannot subtract %s from %s", name_b, name_a);
    else
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "%q needs two of the same kind, not %s and %s",
                   yk_function_name(expr->function), name_a, name_b);
    if (bare_factor(expr->a) || bare_factor(expr->b)) hint_at_bare_factor(dims);
}

void yk_dim_report_argument(YkDimensions *dims, const YkExpr *call, YkDimension wanted)
{
    if (is_silent(dims) || is_two_ways(dims, call->a, wanted)) return;
    yk_problem(dims->problems, YK_CODE_WRONG_ARGUMENT, call->a->place, "%q takes %s, this is %s",
               yk_function_name(call->function), yk_dimension_name(wanted), yk_dimension_name(call->a->dimension));
}

void yk_dim_report_power(YkDimensions *dims, const YkExpr *expr)
{
    if (is_silent(dims)) return;
    const char *base = yk_dimension_name(expr->a->dimension);
    double power;
    if (expr->kind == YK_EXPR_CALL)
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->place, "cannot take the square root of %s", base);
    else if (yk_dim_literal(expr->b, &power))
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->place, "cannot raise %s to the power %g", base, power);
    else
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->b->place, "the exponent of %s must be a plain whole number",
                   base);
}

void yk_dim_report_exponent(YkDimensions *dims, const YkExpr *exponent)
{
    if (is_silent(dims) || is_two_ways(dims, exponent, YK_DIM_NONE)) return;
    yk_problem(dims->problems, YK_CODE_BAD_POWER, exponent->place, "an exponent must be a number, this is %s",
               yk_dimension_name(exponent->dimension));
}
