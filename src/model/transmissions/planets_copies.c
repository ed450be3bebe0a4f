// Counts the copies of a planet: their inertia, their pins' friction, and their masses as a body on the carrier.
#include "model/transmissions/planets.h"

// --- expressions

static YkExpr *number(YkLoader *loader, double value, YkPlace place)
{
    YkExpr *e = YK_NEW(loader->arena, YkExpr, 1);
    if (!e) return NULL;
    *e = (YkExpr){.kind = YK_EXPR_NUMBER, .place = place, .number = value, .unit_size = 1, .value_scale = 1};
    e->is_exact = true;
    e->mantissa = (int64_t)value;
    e->parameter = YK_NONE;
    return e;
}

static YkExpr *join(YkLoader *loader, YkExprKind kind, const YkExpr *a, const YkExpr *b)
{
    YkExpr *e = YK_NEW(loader->arena, YkExpr, 1);
    if (!a || !b || !e) return NULL;
    *e = (YkExpr){.kind = kind, .place = a->place, .a = a, .b = b, .value_scale = 1, .unit_size = 1};
    e->parameter = YK_NONE;
    return e;
}

static YkExpr *ratio(YkLoader *loader, int32_t over, int32_t under, YkPlace place)
{
    YkExpr *top = number(loader, over, place);
    return under == 1 ? top : join(loader, YK_EXPR_DIVIDE, top, number(loader, under, place));
}

// Returns a coordinate of the axis less that of the pin, on the carrier. A NULL expression is 0.
static YkExpr *way(YkLoader *loader, const YkExpr *axis, const YkExpr *pin, YkPlace place)
{
    const YkExpr *from = axis ? axis : number(loader, 0, place);
    return join(loader, YK_EXPR_SUBTRACT, from, pin ? pin : number(loader, 0, place));
}

// Sets a value by an expression, now and in redesigns.
static void set(YkLoader *loader, YkExpr **own, double *target, YkExpr *expr)
{
    YkModel *model = loader->model;
    YkJet jet;
    size_t k = 0;
    if (!expr || !model->uses) {
        loader->failed = true;
        return;
    }
    *own = expr;
    if (yk_load_eval(model, expr, 0, &jet, loader->problems)) *target = jet.d[0];
    while (k < model->use_count && model->uses[k].target != target) k++;
    if (k == model->use_count && !yk_expr_has_names(expr)) return;
    model->uses[k] = (YkModelUse){expr, target};
    if (k == model->use_count) model->use_count++;
}

// Multiplies a value that may be missing.
static void multiply(YkLoader *loader, YkExpr **own, double *target, int32_t copies)
{
    if (*own) set(loader, own, target, join(loader, YK_EXPR_MULTIPLY, number(loader, copies, (*own)->place), *own));
}

static const char *name_of(YkLoader *loader, const char *planet)
{
    YkText *text = &loader->text;
    const YkModel *model = loader->model;
    yk_text_clear(text);
    yk_text_format(text, "%s_others", planet);
    while (!text->failed && (yk_names_find(&model->joint_names, yk_text_get(text)) != YK_NONE ||
                             yk_names_find(&model->body_names, yk_text_get(text)) != YK_NONE))
        yk_text_puts(text, "_");
    return yk_arena_copy(loader->arena, yk_text_get(text), text->length);
}

// Sets the masses of the other planets as one body whose origin is the planet's pin.
static void weigh(YkLoader *loader, const YkPlanet *planet, const YkBody *of, YkBody *others)
{
    YkModel *model = loader->model;
    const YkJoint *pin = &model->joints[planet->joint];
    int32_t n = planet->copies, own = pin->point[!planet->side];
    YkPlace place = of->mass_expr->place;
    const YkPoint *axis = planet->axis == YK_NONE ? NULL : &model->points[planet->axis],
                  *at = own == YK_NONE ? NULL : &model->points[own];
    YkExpr *x = way(loader, axis ? axis->x : NULL, at ? at->x : NULL, place),
           *y = way(loader, axis ? axis->y : NULL, at ? at->y : NULL, place);
    YkExpr *square = join(loader, YK_EXPR_MULTIPLY, x, x);
    square = join(loader, YK_EXPR_ADD, square, join(loader, YK_EXPR_MULTIPLY, y, y));
    YkExpr *ring = join(loader, YK_EXPR_MULTIPLY, of->mass_expr, square);
    others->has_mass = true;
    set(loader, &others->mass_expr, &others->mass,
        join(loader, YK_EXPR_MULTIPLY, ratio(loader, n - 1, 1, place), of->mass_expr));
    set(loader, &others->center_x, &others->center.x,
        join(loader, YK_EXPR_MULTIPLY, ratio(loader, n, n - 1, place), x));
    set(loader, &others->center_y, &others->center.y,
        join(loader, YK_EXPR_MULTIPLY, ratio(loader, n, n - 1, place), y));
    set(loader, &others->inertia_expr, &others->inertia,
        join(loader, YK_EXPR_MULTIPLY, ratio(loader, n * (n - 2), n - 1, place), ring));
}

static void add_others(YkLoader *loader, const YkPlanet *planet, int32_t body)
{
    YkModel *model = loader->model;
    const YkBody *of = &model->bodies[body];
    const YkJoint *pin = &model->joints[planet->joint];
    const char *name = name_of(loader, of->name);
    YkBody *others = &model->bodies[model->body_count];
    YkJoint *weld = &model->joints[model->joint_count];
    int32_t existing, carrier = pin->body[!planet->side];
    if (!name) return;
    *others = (YkBody){.name = name, .place = of->place, .rod = {YK_NONE, YK_NONE}, .copies_of = body};
    others->first_point = (int32_t)model->point_count;
    *weld = (YkJoint){.name = name,
                      .place = of->place,
                      .kind = YK_WELD,
                      .body = {carrier, (int32_t)model->body_count},
                      .point = {pin->point[!planet->side], YK_NONE},
                      .at = {pin->at[!planet->side], {0, 0}},
                      .along = {1, 0},
                      .angle = YK_NONE,
                      .distance = YK_NONE};
    loader->failed |= !yk_names_add(&model->body_names, name, (int32_t)model->body_count, &existing) ||
                      !yk_names_add(&model->joint_names, name, (int32_t)model->joint_count, &existing);
    weigh(loader, planet, of, others);
    model->body_count++;
    model->joint_count++;
    model->shown_joints++;
}

void yk_load_copy_planet(YkLoader *loader, const YkPlanet *planet, int32_t index)
{
    YkModel *model = loader->model;
    YkBody *body = &model->bodies[index];
    YkJoint *pin = &model->joints[planet->joint];
    pin->copies = body->copies = planet->copies;
    pin->copied_side = planet->side;
    multiply(loader, &pin->friction.viscous_expr, &pin->friction.viscous, planet->copies);
    if (body->mass_expr) add_others(loader, planet, index);
    multiply(loader, &body->inertia_expr, &body->inertia, planet->copies);
}
