// Evaluates an expression in SI, with its derivatives in time.
#include <string.h>
#include "base/vec.h"
#include "expr/jet.h"

typedef struct Evaluation {
    YkLookup lookup;
    const void *context;
    const YkExpr *fault;
    const char *why;
} Evaluation;

static bool fails(Evaluation *evaluation, const YkExpr *expr, const char *why)
{
    evaluation->fault = expr;
    evaluation->why = why;
    return false;
}

static bool evaluate(Evaluation *evaluation, const YkExpr *expr, YkSeries *result);

static bool evaluate_name(Evaluation *evaluation, const YkExpr *expr, YkSeries *result)
{
    YkJet jet = {{0}};
    if (evaluation->lookup && evaluation->lookup(evaluation->context, expr, &jet))
        *result = yk_series_of_jet(&jet);
    else if (strcmp(expr->name, "pi") == 0)
        *result = yk_series_constant(YK_PI);
    else
        return fails(evaluation, expr, "this name has no value here");
    return true;
}

static const char *operate(const YkExpr *expr, const YkSeries *a, const YkSeries *b, YkSeries *result)
{
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        *result = yk_series_scaled(a, -1);
        return NULL;
    case YK_EXPR_ADD:
        *result = yk_series_sum(a, b, 1);
        return NULL;
    case YK_EXPR_SUBTRACT:
        *result = yk_series_sum(a, b, -1);
        return NULL;
    case YK_EXPR_MULTIPLY:
        *result = yk_series_product(a, b);
        return NULL;
    case YK_EXPR_DIVIDE:
        if (b->c[0] == 0) return "division by zero";
        *result = yk_series_quotient(a, b);
        return NULL;
    case YK_EXPR_POWER:
        return yk_series_power(a, b, result);
    case YK_EXPR_CALL:
        return yk_series_function(expr->function, a, b, result);
    case YK_EXPR_NUMBER:
    case YK_EXPR_NAME:
        break;
    }
    return "not an operation";
}

static bool evaluate(Evaluation *evaluation, const YkExpr *expr, YkSeries *result)
{
    if (expr->kind == YK_EXPR_NUMBER) {
        *result = yk_series_constant(expr->number * (expr->has_unit ? expr->unit_size : expr->value_scale));
    } else if (expr->kind == YK_EXPR_NAME) {
        if (!evaluate_name(evaluation, expr, result)) return false;
    } else {
        YkSeries a, b = {{0}};
        if (!evaluate(evaluation, expr->a, &a) || (expr->b && !evaluate(evaluation, expr->b, &b))) return false;
        const char *why = operate(expr, &a, &b, result);
        if (why) return fails(evaluation, expr, why);
    }
    return yk_series_is_finite(result) || fails(evaluation, expr, "the value is too large");
}

const YkExpr *yk_expr_eval(const YkExpr *expr, YkLookup lookup, const void *context, YkJet *result, const char **why)
{
    Evaluation evaluation = {.lookup = lookup, .context = context};
    YkSeries series;
    *result = (YkJet){{0}};
    *why = NULL;
    if (evaluate(&evaluation, expr, &series)) {
        *result = yk_jet_of_series(&series);
        if (yk_series_is_finite(&(YkSeries){{result->d[0], result->d[1], result->d[2], result->d[3], result->d[4]}}))
            return NULL;
        fails(&evaluation, expr, "the value is too large");
    }
    *result = (YkJet){{0}};
    *why = evaluation.why;
    return evaluation.fault;
}
