// Values that replace those of parameters in the file. They have no place in the file, so each message names the value.
#include <string.h>
#include "model/load.h"

static YkExpr *parse_override(YkLoader *loader, const YkOverride *override)
{
    YkProblems *found = yk_problems_new();
    if (!found) {
        loader->failed = true;
        return NULL;
    }
    size_t length = strlen(override->value);
    YkExpr *expr = NULL;
    char *text = yk_arena_copy(loader->arena, override->value, length); // the caller's may not live as long
    if (text) expr = yk_expr_parse(text, length, (YkPlace){0}, loader->arena, found);
    yk_load_pass_on(loader->problems, found, override->value, override->name);
    yk_problems_free(found);
    return expr;
}

static void apply_override(YkLoader *loader, const YkOverride *override)
{
    YkModel *model = loader->model;
    int32_t index = yk_names_find(&model->parameter_names, override->name);
    if (index == YK_NONE) {
        yk_problem(loader->problems, YK_CODE_UNKNOWN_OVERRIDE, (YkPlace){0}, "the file has no parameter %q",
                   override->name);
        yk_load_hint_nearest(loader->problems, override->name, model->parameters, model->parameter_count,
                             sizeof *model->parameters);
        return;
    }
    YkParameter *parameter = &model->parameters[index];
    if (!loader->replaced[index]) loader->replaced[index] = parameter->expr;
    parameter->expr = parse_override(loader, override);
}

void yk_load_overrides(YkLoader *loader)
{
    if (!loader->options) return;
    for (size_t i = 0; i < loader->options->parameter_count; i++) {
        apply_override(loader, &loader->options->parameters[i]);
    }
}

typedef struct Fixing {
    const YkModel *model;
    YkDimensions *dimensions;
} Fixing;

static void fix_parameter(void *context, const YkExpr *name)
{
    const Fixing *fixing = context;
    int32_t index = yk_names_find(&fixing->model->parameter_names, name->name);
    if (index != YK_NONE) {
        yk_dimensions_fix(fixing->dimensions, name->name, fixing->model->parameters[index].dimension);
    }
}

// Returns whether the parameter's expression in the file has the dimension of its new value. Asks a fresh inference in
// which the names have the dimensions found.
static bool fits_the_file(YkLoader *loader, const YkParameter *parameter, const YkExpr *replaced)
{
    YkProblems *found = yk_problems_new();
    YkDimensions *dimensions = found ? yk_dimensions_new(loader->arena, &loader->model->units) : NULL;
    YkExpr *copy = YK_NEW(loader->arena, YkExpr, 1);
    bool fits = true;
    if (dimensions && copy) {
        *copy = *replaced; // the inference marks its top node
        Fixing fixing = {.model = loader->model, .dimensions = dimensions};
        yk_dimensions_fix(dimensions, "pi", YK_DIM_NUMBER);
        yk_expr_names(copy, fix_parameter, &fixing);
        yk_dimensions_use(dimensions, copy, parameter->dimension, parameter->name);
        fits = yk_dimensions_run(dimensions, found);
    } else {
        loader->failed = true;
    }
    yk_problems_free(found);
    return fits;
}

void yk_load_check_overrides(YkLoader *loader)
{
    const YkModel *model = loader->model;
    for (size_t i = 0; i < model->parameter_count; i++) {
        const YkParameter *parameter = &model->parameters[i];
        if (!loader->replaced[i] || !parameter->expr) continue;
        if (fits_the_file(loader, parameter, loader->replaced[i])) continue;
        yk_problem(loader->problems, YK_CODE_OVERRIDE_DIMENSION, (YkPlace){0},
                   "the value given for %q is %s, but the file's is not", parameter->name,
                   yk_dimension_name(parameter->dimension));
        yk_problem_hint(loader->problems, "the file defines it in line %u", parameter->place.line);
    }
}
