// Visits the names in an expression.
#include <string.h>
#include "expr/expr.h"

bool yk_expr_mentions(const YkExpr *expr, const char *name)
{
    if (!expr) return false;
    if (expr->kind == YK_EXPR_NAME) return strcmp(expr->name, name) == 0;
    return yk_expr_mentions(expr->a, name) || yk_expr_mentions(expr->b, name);
}

bool yk_expr_has_names(const YkExpr *expr)
{
    return expr && (expr->kind == YK_EXPR_NAME || yk_expr_has_names(expr->a) || yk_expr_has_names(expr->b));
}

void yk_expr_names(const YkExpr *expr, void (*visit)(void *context, const YkExpr *name), void *context)
{
    if (!expr) return;
    if (expr->kind == YK_EXPR_NAME) visit(context, expr);
    yk_expr_names(expr->a, visit, context);
    yk_expr_names(expr->b, visit, context);
}
