// Evaluates expressions of parameters and time.
#include <float.h>
#include <math.h>
#include <string.h>
#include "model/load.h"

typedef struct Values {
    const YkModel *model;
    const char *variable; // the name that has the value t: the time, or the argument of a law
    double t;
} Values;

static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    const Values *values = context;
    *jet = (YkJet){{0}};
    if (strcmp(name->name, values->variable) == 0) {
        jet->d[0] = values->t;
        jet->d[1] = 1;
        return true;
    }
    if (strcmp(name->name, "pi") == 0) {
        jet->d[0] = YK_PI;
        return true;
    }
    int32_t index = yk_names_find(&values->model->parameter_names, name->name);
    if (index == YK_NONE) return false;
    jet->d[0] = values->model->parameters[index].value;
    return !isnan(jet->d[0]);
}

static void report(const YkModel *model, const YkExpr *fault, const char *why, YkProblems *problems)
{
    if (fault->kind != YK_EXPR_NAME) {
        yk_problem(problems, YK_CODE_EVALUATION, fault->place, "%s", why);
    } else if (yk_names_find(&model->parameter_names, fault->name) == YK_NONE) {
        yk_problem(problems, YK_CODE_EVALUATION, fault->place, "%q has no value here", fault->name);
    } // otherwise a parameter without a value, which is reported at its own place
}

bool yk_load_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems)
{
    Values values = {.model = model, .variable = "t", .t = t};
    const char *why = "no value";
    const YkExpr *fault = yk_expr_eval(expr, lookup, &values, jet, &why);
    if (fault) report(model, fault, why, problems);
    return !fault;
}

const YkExpr *yk_load_eval_of(const YkModel *model, const YkExpr *expr, const char *variable, double x, YkJet *jet,
                              const char **why)
{
    Values values = {.model = model, .variable = variable, .t = x};
    return yk_expr_eval(expr, lookup, &values, jet, why);
}

YkStatus yk_model_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems)
{
    return yk_load_eval(model, expr, t, jet, problems) ? YK_OK : YK_BAD_MODEL;
}

// Computes law(u(t)) with its derivatives: Faa di Bruno's formula to the fourth order.
static void apply_law(const YkLaw *law, const double *u, double *out)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(law, u[0], d);
    out[0] = d[0];
    out[1] = d[1] * u[1];
    out[2] = d[1] * u[2] + d[2] * u[1] * u[1];
    double third = d[1] * u[3] + 3 * d[2] * u[1] * u[2] + d[3] * u[1] * u[1] * u[1];
    out[4] = d[1] * u[4] + d[2] * (4 * u[1] * u[3] + 3 * u[2] * u[2]) + 6 * d[3] * u[1] * u[1] * u[2] +
             d[4] * u[1] * u[1] * u[1] * u[1];
    out[3] = third;
}

YkStatus yk_model_drive(const YkModel *model, size_t drive, double t, YkJet *jet, YkProblems *problems)
{
    const YkDrive *d = &model->drives[drive];
    YkJet argument;
    if (d->law == YK_NONE) return yk_model_eval(model, d->expr, t, jet, problems);
    YkStatus status = yk_model_eval(model, d->expr, t, &argument, problems);
    if (status == YK_OK) apply_law(model->laws[d->law].law, argument.d, jet->d);
    return status;
}

double yk_model_drive_rounding(const YkModel *model, size_t drive, double t)
{
    const YkDrive *d = &model->drives[drive];
    Values values = {.model = model, .variable = "t", .t = t};
    double rounding = yk_expr_rounding(d->expr, lookup, &values), law[YK_LAW_ORDER + 1];
    YkJet argument;
    if (d->law == YK_NONE || !(rounding < INFINITY)) return rounding;
    if (yk_model_eval(model, d->expr, t, &argument, NULL) != YK_OK) return INFINITY;
    yk_law_eval(model->laws[d->law].law, argument.d[0], law);
    // A law repeats after a period that is rounded too.
    return fabs(law[1]) * (rounding + DBL_EPSILON * fabs(argument.d[0])) + DBL_EPSILON * fabs(law[0]);
}

static bool is_linear(const YkExpr *e)
{
    if (!yk_expr_mentions(e, "t")) return true;
    switch (e->kind) {
    case YK_EXPR_NAME:
        return true;
    case YK_EXPR_NEGATE:
        return is_linear(e->a);
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
        return is_linear(e->a) && is_linear(e->b);
    case YK_EXPR_MULTIPLY:
        return yk_expr_mentions(e->a, "t") ? is_linear(e->a) && !yk_expr_mentions(e->b, "t") : is_linear(e->b);
    case YK_EXPR_DIVIDE:
        return is_linear(e->a) && !yk_expr_mentions(e->b, "t");
    default:
        return false;
    }
}

bool yk_model_drive_is_steady(const YkModel *model, size_t drive)
{
    const YkDrive *d = &model->drives[drive];
    return yk_expr_mentions(d->expr, "t") ? d->law == YK_NONE && is_linear(d->expr) : true;
}
