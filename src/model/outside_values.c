// Reads values from outside the file, such as the command line, in the model's units and with its parameters.
#include <math.h>
#include <string.h>
#include "model/load.h"
#include "model/shown_unit.h"

YkDimension yk_quantity_dimension(YkQuantity quantity)
{
    switch (quantity) {
    case YK_QUANTITY_ANGLE:
        return YK_DIM_ANGLE;
    case YK_QUANTITY_LENGTH:
        return YK_DIM_LENGTH;
    case YK_QUANTITY_TIME:
        return YK_DIM_TIME;
    case YK_QUANTITY_ANGLE_RATE:
        return YK_DIM_ANGLE_RATE;
    case YK_QUANTITY_SPEED:
        return YK_DIM_SPEED;
    case YK_QUANTITY_ANGLE_ACCELERATION:
        return YK_DIM_ANGLE_ACCELERATION;
    case YK_QUANTITY_ACCELERATION:
        return YK_DIM_ACCELERATION;
    case YK_QUANTITY_FORCE:
        return YK_DIM_FORCE;
    case YK_QUANTITY_TORQUE:
    case YK_QUANTITY_ENERGY: // the same dimension
        return YK_DIM_TORQUE;
    case YK_QUANTITY_MASS:
        return YK_DIM_MASS;
    case YK_QUANTITY_UNBALANCE:
        return YK_DIM(1, 1, 0, 0);
    case YK_QUANTITY_INERTIA:
        return YK_DIM_INERTIA;
    case YK_QUANTITY_NUMBER:
        break;
    }
    return YK_DIM_NUMBER;
}

typedef struct Reading {
    const YkModel *model;
    YkDimensions *dimensions;
    YkProblems *found;
    bool is_bad;
} Reading;

// Checks a name in the value: a parameter, whose dimension is now known, or pi.
static void check_name(void *context, const YkExpr *name)
{
    Reading *reading = context;
    const YkModel *model = reading->model;
    int32_t index = yk_names_find(&model->parameter_names, name->name);
    if (index != YK_NONE) {
        yk_dimensions_fix(reading->dimensions, name->name, model->parameters[index].dimension);
    } else if (strcmp(name->name, "pi") == 0) {
        yk_dimensions_fix(reading->dimensions, name->name, YK_DIM_NUMBER);
    } else {
        yk_problem(reading->found, YK_CODE_UNKNOWN_NAME, (YkPlace){0}, "there is no parameter %q", name->name);
        yk_load_hint_nearest(reading->found, name->name, model->parameters, model->parameter_count,
                             sizeof *model->parameters);
        reading->is_bad = true;
    }
}

static bool read_value(Reading *reading, const char *text, YkDimension dimension, YkArena *arena, double *value)
{
    YkExpr *expr = yk_expr_parse(text, strlen(text), (YkPlace){0}, arena, reading->found);
    reading->dimensions = yk_dimensions_new(arena, &reading->model->units);
    if (!expr || !reading->dimensions) return false;
    yk_expr_names(expr, check_name, reading);
    if (reading->is_bad) return false;
    yk_dimensions_use(reading->dimensions, expr, dimension, "the value");
    YkJet jet;
    if (!yk_dimensions_run(reading->dimensions, reading->found)) return false;
    if (!yk_load_eval(reading->model, expr, 0, &jet, reading->found)) return false;
    if (!(fabs(jet.d[0]) <= YK_VALUE_MAX)) {
        yk_problem(reading->found, YK_CODE_VALUE_RANGE, (YkPlace){0}, "it is beyond 1e100 in SI units");
        return false;
    }
    *value = jet.d[0];
    return true;
}

// Reads a value of this dimension; its problems have no place, or `place`.
static bool read_apart(const YkModel *model, const char *text, YkDimension dimension, double *value, YkProblems *found)
{
    YkArena *arena = yk_arena_new();
    Reading reading = {.model = model, .found = found};
    bool done = arena && read_value(&reading, text, dimension, arena, value);
    if (!arena || yk_arena_failed(arena))
        yk_problem(found, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while reading it");
    yk_arena_free(arena);
    return done;
}

YkStatus yk_model_value_of(const YkModel *model, const char *text, YkDimension dimension, YkPlace place, double *value,
                           YkProblems *problems)
{
    YkProblems *found = yk_problems_new();
    bool done = found && read_apart(model, text, dimension, value, found);
    if (!found) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, place, "out of memory while reading %q", text);
    for (size_t i = 0; found && i < yk_problems_count(found); i++) {
        const YkProblem *problem = yk_problems_get(found, i);
        yk_problem(problems, (YkCode)problem->code, place, "%s", problem->message);
        if (problem->hint) yk_problem_hint(problems, "%s", problem->hint);
    }
    yk_problems_free(found);
    return done ? YK_OK : YK_BAD_ARGUMENT;
}

YkStatus yk_model_value(const YkModel *model, const char *text, YkQuantity quantity, double *value,
                        YkProblems *problems)
{
    YkProblems *found = yk_problems_new();
    bool done = found && read_apart(model, text, yk_quantity_dimension(quantity), value, found);
    if (found) {
        yk_load_pass_on(problems, found, text, NULL);
    } else {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while reading %q", text);
    }
    yk_problems_free(found);
    return done ? YK_OK : YK_BAD_ARGUMENT;
}

double yk_model_parameter(const YkModel *model, const char *name)
{
    int32_t index = yk_names_find(&model->parameter_names, name);
    return index == YK_NONE ? NAN : model->parameters[index].value;
}

YkStatus yk_model_parameter_read(const YkModel *model, const char *name, const char *text, double *value,
                                 YkProblems *problems)
{
    int32_t index = yk_names_find(&model->parameter_names, name);
    if (index != YK_NONE)
        return yk_model_value_of(model, text, model->parameters[index].dimension, (YkPlace){0}, value, problems);
    yk_problem(problems, YK_CODE_UNKNOWN_OVERRIDE, (YkPlace){0}, "the file has no parameter %q", name);
    yk_load_hint_nearest(problems, name, model->parameters, model->parameter_count, sizeof *model->parameters);
    return YK_BAD_ARGUMENT;
}

double yk_model_parameter_unit(const YkModel *model, const char *name)
{
    int32_t index = yk_names_find(&model->parameter_names, name);
    return index == YK_NONE ? 1 : yk_units_size(&model->units, model->parameters[index].dimension);
}

const char *yk_model_unit(const YkModel *model, YkQuantity quantity, double *size)
{
    if ((unsigned)quantity >= YK_QUANTITY_COUNT) return NULL;
    if (size) *size = yk_units_size(&model->units, yk_quantity_dimension(quantity));
    return model->unit_names[quantity];
}

const char *yk_model_shown_unit(const YkModel *model, YkQuantity quantity, double *size)
{
    static const char *const si[] = {
        [YK_QUANTITY_FORCE] = "N", [YK_QUANTITY_TORQUE] = "N*m", [YK_QUANTITY_ENERGY] = "J"};
    double own = 1;
    const char *unit = yk_model_unit(model, quantity, &own);
    bool is_of_force = quantity >= YK_QUANTITY_FORCE && quantity <= YK_QUANTITY_ENERGY;
    bool is_joule = quantity == YK_QUANTITY_ENERGY && own == 1;
    if (is_of_force && (strchr(unit, '/') || is_joule)) {
        own = 1;
        unit = si[quantity];
    }
    if (size) *size = own;
    return unit;
}
