// The second pass over expressions: checks the names in them, infers their dimensions, computes their values.
#include <string.h>
#include "model/laws/laws.h"
#include "model/load.h"

typedef struct NameCheck {
    YkLoader *loader;
    YkScope scope;
    bool is_bad;
} NameCheck;

static void report_not_here(NameCheck *check, const YkExpr *name, const char *why, const char *hint)
{
    yk_problem(check->loader->problems, YK_CODE_NAME_NOT_HERE, name->place, "%q cannot be used here: %s", name->name,
               why);
    yk_problem_hint(check->loader->problems, "%s", hint);
    check->is_bad = true;
}

// Fixes the dimension of a name once, however often it is mentioned.
static void fix_once(YkLoader *loader, const char *name, YkDimension dimension)
{
    int32_t existing;
    if (!yk_names_add(&loader->fixed, name, 0, &existing)) {
        loader->failed = true;
    } else if (existing == YK_NONE) {
        yk_dimensions_fix(loader->dimensions, name, dimension);
    }
}

// Fixes the dimension of a law's argument in its formula; returns false if this is none.
static bool is_argument(YkLoader *loader, const char *name)
{
    size_t length = strlen(YK_LAW_ARGUMENT);
    if (strncmp(name, YK_LAW_ARGUMENT, length) != 0) return false;
    for (size_t i = 0; i < loader->model->law_count; i++) {
        const YkModelLaw *law = &loader->model->laws[i];
        if (strcmp(name + length, law->name) == 0) fix_once(loader, name, law->of);
    }
    return true;
}

static void check_coordinate(NameCheck *check, const YkExpr *name)
{
    YkLoader *loader = check->loader;
    bool is_rate = false;
    if (strcmp(name->name, YK_OWN_ARGUMENT) == 0) {
        fix_once(loader, name->name, YK_DIM_NUMBER);
        return;
    }
    if (is_argument(loader, name->name)) return;
    int own = yk_model_own_name(name->name);
    if (own != YK_NONE) {
        fix_once(loader, name->name, own == 0 ? YK_DIM_LENGTH : YK_DIM_SPEED);
        return;
    }
    int32_t index = yk_load_coordinate(loader, name->name, name->place, &is_rate);
    if (index == YK_NONE) {
        yk_problem(loader->problems, YK_CODE_UNKNOWN_NAME, name->place, "there is no parameter or coordinate %q",
                   name->name);
        yk_load_hint_nearest_symbol(loader, name->name);
        check->is_bad = true;
    } else if (index < 0) {
        check->is_bad = true;
    } else if (check->scope == YK_SCOPE_TIME) {
        report_not_here(check, name, "it is a coordinate", "a drive depends on `t` and parameters only");
    } else if (check->scope == YK_SCOPE_CONSTANT) {
        report_not_here(check, name, "it is a coordinate", "only parameters and numbers are constant");
    } else {
        bool is_distance = loader->model->coordinates[index].is_distance;
        fix_once(loader, name->name,
                 is_distance ? (is_rate ? YK_DIM_SPEED : YK_DIM_LENGTH) : (is_rate ? YK_DIM_ANGLE_RATE : YK_DIM_ANGLE));
    }
}

static void check_name(void *context, const YkExpr *name)
{
    NameCheck *check = context;
    if (strcmp(name->name, "pi") == 0) return;
    if (strcmp(name->name, "t") == 0) {
        if (check->scope == YK_SCOPE_CONSTANT) {
            report_not_here(check, name, "it is the time", "only parameters and numbers are constant");
        }
    } else if (yk_names_find(&check->loader->model->parameter_names, name->name) == YK_NONE) {
        check_coordinate(check, name);
    }
}

static bool names_are_known(YkLoader *loader, const YkExpr *expr, YkScope scope)
{
    NameCheck check = {.loader = loader, .scope = scope};
    yk_expr_names(expr, check_name, &check);
    return !check.is_bad;
}

void yk_load_check_uses(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->parameter_count; i++) {
        YkParameter *parameter = &model->parameters[i];
        if (parameter->expr && !names_are_known(loader, parameter->expr, YK_SCOPE_CONSTANT)) parameter->expr = NULL;
    }
    for (size_t i = 0; i < loader->use_count && yk_load_goes_on(loader); i++) {
        YkUse *use = &loader->uses[i];
        use->is_bad = !names_are_known(loader, use->expr, use->scope);
    }
}

void yk_load_infer(YkLoader *loader)
{
    YkModel *model = loader->model;
    YkDimensions *dimensions = loader->dimensions;
    yk_dimensions_fix(dimensions, "pi", YK_DIM_NUMBER);
    yk_dimensions_fix(dimensions, "t", YK_DIM_TIME);
    for (size_t i = 0; i < model->parameter_count; i++) {
        YkParameter *parameter = &model->parameters[i];
        if (parameter->expr) yk_dimensions_parameter(dimensions, parameter->name, parameter->expr);
    }
    for (size_t i = 0; i < loader->use_count && yk_load_goes_on(loader); i++) {
        YkUse *use = &loader->uses[i];
        if (!use->is_bad) yk_dimensions_use(dimensions, use->expr, use->dimension, use->what);
    }
    yk_dimensions_run(dimensions, loader->problems);
    for (size_t i = 0; i < model->parameter_count; i++) {
        YkParameter *parameter = &model->parameters[i];
        if (!yk_dimensions_of(dimensions, parameter->name, &parameter->dimension)) parameter->dimension = YK_DIM_NUMBER;
    }
}

void yk_load_eval_uses(YkLoader *loader)
{
    for (size_t i = 0; i < loader->use_count && yk_load_goes_on(loader); i++) {
        const YkUse *use = &loader->uses[i];
        YkJet jet;
        if (!use->target || use->is_bad) continue;
        if (!yk_load_eval(loader->model, use->expr, 0, &jet, loader->problems)) continue;
        if (yk_load_in_range(loader, use->expr->place, jet.d[0])) *use->target = jet.d[0];
    }
}

void yk_load_keep_uses(YkLoader *loader)
{
    YkModel *model = loader->model;
    size_t formulas = 0;
    for (size_t i = 0; i < model->law_count; i++) formulas += model->laws[i].source->part_count;
    model->uses = YK_NEW(loader->arena, YkModelUse, loader->use_count + formulas + 8 * model->gear_count + 1);
    for (size_t i = 0; model->uses && i < loader->use_count; i++) {
        const YkUse *use = &loader->uses[i];
        if (use->target) model->uses[model->use_count++] = (YkModelUse){use->expr, use->target};
    }
    for (size_t i = 0; model->uses && i < model->law_count; i++)
        for (size_t k = 0; k < model->laws[i].source->part_count; k++) {
            YkLawPart *part = &model->laws[i].source->parts[k];
            if (part->formula) model->uses[model->use_count++] = (YkModelUse){part->formula, &part->formula_value};
        }
}
