// Reads `gravity: [gx, gy]` in the world's axes.
#include <math.h>
#include "elementary/elementary.h"
#include "model/load.h"

enum { PARAMETERS_DEEP = 64, LOOKS_MAX = 20000 };

// From the smallest round body of the solar system (Ceres, 0.28 m/s^2) to more than the largest planet.
static const double planet_least = 0.25, planet_most = 30, earth_least = 9.7, earth_most = 9.9; // m/s^2

void yk_load_gravity(YkLoader *loader)
{
    const YkNode *node = yk_node_get(loader->root, "gravity");
    YkModel *model = loader->model;
    if (!node) return;
    YkWant want = {.dimension = YK_DIM_ACCELERATION, .subject = {.noun = "gravity"}};
    YkExpr *expr[2] = {NULL, NULL};
    model->has_gravity = yk_load_pair(loader, node, &want, expr, &model->gravity);
    model->gravity_x = expr[0];
    model->gravity_y = expr[1];
}

// One walk. Parameters that are each twice another, in a long chain, stand for more numbers than can be visited.
typedef struct Walk {
    const YkModel *model;
    size_t looks_left;
} Walk;

// Returns whether the value depends on the file's units alone: no number in it, nor in its parameters, has a unit.
// Returns false if that takes too many looks.
static bool is_bare(Walk *walk, const YkExpr *expr, int depth)
{
    if (!expr) return true;
    if (walk->looks_left == 0) return false;
    walk->looks_left--;
    if (expr->kind == YK_EXPR_NUMBER) return !expr->has_unit || yk_dimension_equal(expr->unit, YK_DIM_NUMBER);
    if (expr->kind != YK_EXPR_NAME) return is_bare(walk, expr->a, depth) && is_bare(walk, expr->b, depth);
    int32_t index = yk_names_find(&walk->model->parameter_names, expr->name);
    if (index == YK_NONE) return true;
    return depth < PARAMETERS_DEEP && is_bare(walk, walk->model->parameters[index].expr, depth + 1);
}

// Returns the unit in which this number is earth's gravity, or at least a planet's; NULL if there is none.
static const char *unit_meant(double number)
{
    static const struct {
        const char *name;
        double size;
    } units[] = {{"m/s^2", 1}, {"mm/s^2", 1e-3}, {"cm/s^2", 1e-2}, {"ft/s^2", 0.3048}, {"in/s^2", 0.0254}};
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
            double g = number * units[i].size;
            if (pass == 0 ? g > earth_least && g < earth_most : g >= planet_least && g <= planet_most)
                return units[i].name;
        }
    return NULL;
}

void yk_load_check_gravity(YkLoader *loader)
{
    const YkModel *model = loader->model;
    double size = yk_units_size(&model->units, YK_DIM_ACCELERATION), g = yk_hypot(model->gravity.x, model->gravity.y);
    if (!model->has_gravity || !(g > 0) || loader->has_bad_units) return;
    double in_file = g / size;
    bool is_earths_number = size != 1 && in_file > earth_least && in_file < earth_most;
    if (g >= planet_least && g <= planet_most && !is_earths_number) return;
    Walk walk = {model, LOOKS_MAX};
    if (!is_bare(&walk, model->gravity_x, 0) || !is_bare(&walk, model->gravity_y, 0)) return;
    YkText unit = {0};
    const char *meant = unit_meant(in_file);
    double down = model->gravity.x == 0 ? model->gravity.y / size : in_file; // usually as the file has it
    yk_units_name(&model->units, YK_DIM_ACCELERATION, &unit);
    const YkExpr *expr = fabs(model->gravity.y) >= fabs(model->gravity.x) ? model->gravity_y : model->gravity_x;
    yk_problem(loader->problems, YK_CODE_ODD_GRAVITY, expr ? expr->place : (YkPlace){0},
               size == 1 ? "gravity is %e %s here" : "gravity is %e %s here, which is %e m/s^2", in_file,
               yk_text_get(&unit), g);
    if (meant)
        yk_problem_hint(loader->problems, "did you mean `%e %s`? A bare number is in %s", down, meant,
                        yk_text_get(&unit));
    else
        yk_problem_hint(loader->problems, "write its unit after it, as in `-9.81 m/s^2`");
    loader->failed |= unit.failed;
    yk_text_free(&unit);
}
