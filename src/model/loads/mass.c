// Reads mass, centre of mass and inertia of a body; or a uniform rod, which gives centre and inertia.
#include <math.h>
#include "elementary/elementary.h"
#include "model/load.h"

static YkExpr *read_scalar(YkLoader *loader, YkBody *body, const YkNode *node, const char *key, YkDimension dimension,
                           double *target)
{
    const YkNode *value = yk_node_get(node, key);
    if (!value) return NULL;
    YkWant want = {.dimension = dimension, .subject = {.noun = key, .owner = body->name}};
    return yk_load_value(loader, value, &want, target);
}

static void read_center(YkLoader *loader, YkBody *body, const YkNode *value)
{
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "center", .owner = body->name}};
    YkExpr *expr[2] = {NULL, NULL};
    yk_load_pair(loader, value, &want, expr, &body->center);
    body->center_x = expr[0];
    body->center_y = expr[1];
}

static void read_rod(YkLoader *loader, int32_t index, const YkNode *value)
{
    YkBody *body = &loader->model->bodies[index];
    YkSubject subject = {.noun = "rod", .owner = body->name};
    if (!yk_load_expect(loader, value, YK_NODE_LIST, &subject)) return;
    if (value->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, value->place, "%s lies between two points; here are %z",
                   yk_load_subject(loader, &subject), value->count);
        return;
    }
    for (int k = 0; k < 2; k++) body->rod[k] = yk_load_point(loader, index, value->items[k]);
    if (body->rod[0] == body->rod[1] && body->rod[0] != YK_NONE) {
        yk_problem(loader->problems, YK_CODE_ZERO_ROD, value->place, "%s lies between a point and itself",
                   yk_load_subject(loader, &subject));
        body->rod[0] = body->rod[1] = YK_NONE;
    }
}

static void refuse(YkLoader *loader, const YkNode *node, const char *key, YkCode code, const char *message,
                   const char *body)
{
    const YkNode *found = yk_load_key(node, key);
    if (found) yk_problem(loader->problems, code, found->place, message, body, key);
}

// Checks for keys that make no sense together.
static bool keys_agree(YkLoader *loader, int32_t index, const YkNode *node)
{
    const char *name = loader->model->bodies[index].name;
    size_t before = yk_problems_count(loader->problems);
    if (index == 0) {
        static const char *const keys[] = {"mass", "center", "inertia", "rod"};
        for (size_t i = 0; i < 4; i++)
            refuse(loader, node, keys[i], YK_CODE_GROUND_KEY, "%q is fixed and has no %s", name);
    } else if (yk_node_get(node, "rod")) {
        if (!yk_node_get(node, "mass")) {
            refuse(loader, node, "rod", YK_CODE_NEEDS_MASS, "%q has no mass, so `%s` has no meaning", name);
        }
        refuse(loader, node, "center", YK_CODE_RIVAL_KEYS, "%q is a rod: its `%s` follows from that", name);
        refuse(loader, node, "inertia", YK_CODE_RIVAL_KEYS, "%q is a rod: its `%s` follows from that", name);
    } else if (!yk_node_get(node, "mass")) {
        refuse(loader, node, "center", YK_CODE_NEEDS_MASS, "%q has no mass, so `%s` has no meaning", name);
    }
    return yk_problems_count(loader->problems) == before;
}

void yk_load_mass(YkLoader *loader, int32_t index, const YkNode *node)
{
    YkBody *body = &loader->model->bodies[index];
    if (!keys_agree(loader, index, node)) return;
    body->mass_expr = read_scalar(loader, body, node, "mass", YK_DIM_MASS, &body->mass);
    body->inertia_expr = read_scalar(loader, body, node, "inertia", YK_DIM_INERTIA, &body->inertia);
    body->has_mass = body->mass_expr || body->inertia_expr;
    const YkNode *center = yk_node_get(node, "center"), *rod = yk_node_get(node, "rod");
    if (center) read_center(loader, body, center);
    if (rod) read_rod(loader, index, rod);
}

// Finishes a uniform rod of length L: centre at the midpoint, inertia m L^2 / 12 about it.
static void finish_rod(YkLoader *loader, YkBody *body)
{
    const YkPoint *p = &loader->model->points[body->rod[0]], *q = &loader->model->points[body->rod[1]];
    YkVec along = yk_sub(q->at, p->at);
    double length = yk_hypot(along.x, along.y);
    double reach = fmax(yk_hypot(p->at.x, p->at.y), yk_hypot(q->at.x, q->at.y));
    if (length <= 1e-12 * reach) {
        yk_problem(loader->problems, YK_CODE_ZERO_ROD, body->place, "the rod of %q has no length: %q and %q coincide",
                   body->name, p->name, q->name);
    }
    body->center = yk_scale(0.5, yk_add(p->at, q->at));
    body->inertia = body->mass * length * length / 12;
}

// Returns the largest distance of a point of the body from its centre of mass.
static double extent_of(const YkModel *model, const YkBody *body)
{
    double most = 0;
    for (int32_t k = 0; k < body->point_count; k++)
        most = fmax(most, yk_norm(yk_sub(model->points[body->first_point + k].at, body->center)));
    return most;
}

// Warns of a doubtful inertia: mistaken units change it by a factor of 1e6 (kg m^2 for kg mm^2), which shows in the
// radius of gyration. Says nothing in a file with errors: a point may stand where one of them put it.
static void doubt_inertia(YkLoader *loader, const YkBody *body)
{
    if (yk_problems_error_count(loader->problems) > 0) return;
    static const double LEAST = 1e-2, MOST = 1e2;
    double gyration = sqrt(body->inertia / body->mass), extent = extent_of(loader->model, body);
    if (extent == 0 || (gyration >= LEAST * extent && gyration <= MOST * extent)) return;
    yk_problem(loader->problems, YK_CODE_ODD_INERTIA, body->inertia_expr->place,
               "%q has a radius of gyration of %e m, but its points lie up to %e m from its centre of mass", body->name,
               gyration, extent);
    yk_problem_hint(loader->problems, "is the unit of the inertia right? It is %e kg*m^2", body->inertia);
}

static void finish_body(YkLoader *loader, YkBody *body)
{
    if (body->mass_expr && body->mass <= 0) {
        yk_load_refuse_amount(loader, YK_CODE_BAD_MASS, body->mass_expr, body->mass, YK_DIM_MASS,
                              "the %s of %q is %e %s; it must be positive", "mass", body->name);
        if (body->mass == 0) yk_problem_hint(loader->problems, "for a body without mass leave `mass` out");
    }
    if (body->inertia_expr && body->inertia < 0)
        yk_load_refuse_amount(loader, YK_CODE_BAD_INERTIA, body->inertia_expr, body->inertia, YK_DIM_INERTIA,
                              "the %s of %q is %e %s; it cannot be negative", "inertia", body->name);
    if (body->inertia_expr && body->inertia > 0 && body->mass > 0) doubt_inertia(loader, body);
    if (body->rod[0] != YK_NONE && body->rod[1] != YK_NONE) finish_rod(loader, body);
}

void yk_load_finish_masses(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->body_count; i++) finish_body(loader, &model->bodies[i]);
}
