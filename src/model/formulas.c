// Resolves the names in an expression of a loaded model.
#include "model/formulas.h"
#include "base/letters.h"
#include <string.h>

enum { UNKNOWN = -2, CONSTANT = -1, TIME = 0, NAME_ROOM = 128 }; // a name of the file has at most 100 characters

typedef struct Names {
    const YkModel *model;
    YkCoordinateVariable coordinate_variable;
    void *context;
} Names;

// Returns the declared coordinate that NAME, JOINT.angle or JOINT.distance refers to. Changes the text.
static int32_t find_coordinate(const YkModel *model, char *name)
{
    int32_t found = yk_names_find(&model->coordinate_names, name);
    if (found != YK_NONE) return found;
    bool is_angle = yk_cut_ending(name, ".angle");
    if (!is_angle && !yk_cut_ending(name, ".distance")) return YK_NONE;
    int32_t joint = yk_names_find(&model->joint_names, name);
    if (joint == YK_NONE) return YK_NONE;
    return is_angle ? model->joints[joint].angle : model->joints[joint].distance;
}

static int resolve_coordinate(const Names *names, const char *name)
{
    char text[NAME_ROOM];
    size_t length = strlen(name);
    if (length >= sizeof text || !names->coordinate_variable) return UNKNOWN;
    memcpy(text, name, length + 1);
    bool is_rate = yk_cut_ending(text, ".rate");
    int32_t coordinate = find_coordinate(names->model, text);
    int variable = coordinate == YK_NONE ? UNKNOWN : names->coordinate_variable(names->context, coordinate, is_rate);
    return variable < 0 ? UNKNOWN : variable;
}

int yk_model_own_name(const char *name)
{
    return strcmp(name, YK_OWN_LENGTH) == 0 ? 0 : strcmp(name, YK_OWN_RATE) == 0 ? 1 : YK_NONE;
}

static int resolve_own(const Names *names, int own)
{
    int variable = names->coordinate_variable ? names->coordinate_variable(names->context, YK_NONE, own == 1) : UNKNOWN;
    return variable < 0 ? UNKNOWN : variable;
}

static int resolve(void *context, const YkExpr *name, double *value)
{
    const Names *names = context;
    if (strcmp(name->name, "t") == 0) return TIME;
    int own = yk_model_own_name(name->name);
    if (own != YK_NONE) return resolve_own(names, own);
    int32_t parameter = yk_names_find(&names->model->parameter_names, name->name);
    if (parameter == YK_NONE) return resolve_coordinate(names, name->name);
    *value = names->model->parameters[parameter].value;
    return CONSTANT;
}

YkFormula *yk_model_formula(const YkModel *model, const YkExpr *expr, YkCoordinateVariable coordinate_variable,
                            void *context, YkArena *arena)
{
    Names names = {.model = model, .coordinate_variable = coordinate_variable, .context = context};
    return yk_formula_compile(expr, resolve, &names, arena);
}
