// Finds the parameters and expressions that depend on some parameters.
#include "model/redesign.h"

typedef struct Look {
    const YkModel *model;
    const bool *varies;
    bool found;
} Look;

static void look(void *context, const YkExpr *name)
{
    Look *l = context;
    int32_t index = yk_names_find(&l->model->parameter_names, name->name);
    if (index != YK_NONE && l->varies[index]) l->found = true;
}

bool yk_model_depends(const YkModel *model, const bool *varies, const YkExpr *expr)
{
    Look l = {.model = model, .varies = varies};
    yk_expr_names(expr, look, &l);
    return l.found;
}

void yk_model_mark_dependents(const YkModel *model, bool *varies)
{
    for (bool more = true; more;) {
        more = false;
        for (size_t i = 0; i < model->parameter_count; i++) {
            if (varies[i] || !yk_model_depends(model, varies, model->parameters[i].expr)) continue;
            varies[i] = more = true;
        }
    }
}
