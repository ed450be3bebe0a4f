// The value of an expression of parameters and time.
#include <math.h>
#include <string.h>
#include "model/load.h"

typedef struct Values {
    const YkModel *model;
    double t;
} Values;

static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    const Values *values = context;
    *jet = (YkJet){{0}};
    if (strcmp(name->name, "t") == 0) {
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
    } // otherwise a parameter without a value, which is reported where it stands
}

bool yk_load_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems)
{
    Values values = {.model = model, .t = t};
    const char *why = "no value";
    const YkExpr *fault = yk_expr_eval(expr, lookup, &values, jet, &why);
    if (fault) report(model, fault, why, problems);
    return !fault;
}

YkStatus yk_model_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems)
{
    return yk_load_eval(model, expr, t, jet, problems) ? YK_OK : YK_BAD_MODEL;
}
