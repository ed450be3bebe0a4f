// Makes a copy of a model whose values follow some of its parameters, and sets them again and again.
#include "model/redesign.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "elementary/elementary.h"
#include "model/load.h"
#include "model/size.h"
#include "model/transmissions/cam_place.h"

// An array of the model and its copy.
typedef struct Span {
    const char *from;
    size_t size;
    char *to;
} Span;

enum { SPANS = 9 };

typedef struct Follower { // a value of the copy
    double *target;
    const YkFormula *formula;
} Follower;

typedef struct Derived { // a parameter that follows others
    int32_t parameter;
    const YkFormula *formula;
} Derived;

struct YkRedesign {
    YkArena *arena;
    const YkModel *original;
    YkModel *model;
    Span span[SPANS];
    int32_t *chosen; // parameters that vary
    size_t chosen_count;
    double *value; // [parameter]
    bool *varies;  // [parameter]
    Derived *derived;
    size_t derived_count;
    Follower *follower; // by target
    size_t follower_count;
    bool *point_varies, *along_varies;
    // The size follows too: the bodies with points that vary, compared with the largest of all others.
    int32_t *extended;
    size_t extended_count;
    bool *has_origin; // [body]
    YkVec *room;
    double fixed_size;
    YkCam *cam;     // the copy's: their places follow
    double *lowest; // [cam] least value of its law
    bool failed;
};

// --- the copy

static void *duplicate(YkRedesign *r, size_t span, const void *items, size_t count, size_t size)
{
    char *copy = yk_arena_alloc(r->arena, count + 1, size);
    if (copy && count > 0) memcpy(copy, items, count * size);
    r->span[span] = (Span){items, count * size, copy};
    return copy;
}

#define DUPLICATE(span, items, count)                                                                                  \
    r->model->items = duplicate(r, span, model->items, model->count, sizeof *model->items)

static bool copy_model(YkRedesign *r)
{
    const YkModel *model = r->original;
    r->model = YK_NEW(r->arena, YkModel, 1);
    if (!r->model) return false;
    *r->model = *model;
    DUPLICATE(0, parameters, parameter_count);
    DUPLICATE(1, bodies, body_count);
    DUPLICATE(2, points, point_count);
    DUPLICATE(3, joints, joint_count);
    DUPLICATE(4, springs, spring_count);
    DUPLICATE(5, stops, stop_count);
    DUPLICATE(6, starts, start_count);
    DUPLICATE(7, forces, force_count);
    r->span[8] = (Span){(const char *)&model->gravity, sizeof model->gravity, (char *)&r->model->gravity};
    return !yk_arena_failed(r->arena);
}

// Returns the copy's counterpart of a value of the original; NULL if it is not copied.
static double *moved(const YkRedesign *r, const double *target)
{
    const char *at = (const char *)target;
    for (size_t k = 0; k < SPANS; k++)
        if (r->span[k].from && at >= r->span[k].from && at < r->span[k].from + r->span[k].size)
            return (double *)(void *)(r->span[k].to + (at - r->span[k].from));
    return NULL;
}

// --- dependences

bool yk_redesign_expression_varies(const YkRedesign *r, const YkExpr *expr)
{
    return yk_model_depends(r->original, r->varies, expr);
}

static int resolve(void *context, const YkExpr *name, double *value)
{
    const YkRedesign *r = context;
    int32_t index = yk_names_find(&r->original->parameter_names, name->name);
    if (index == YK_NONE) return -2;
    if (r->varies[index]) return index;
    *value = r->original->parameters[index].value;
    return -1;
}

const YkFormula *yk_redesign_compile(YkRedesign *r, const YkExpr *expr)
{
    return yk_formula_compile(expr, resolve, r, r->arena);
}

bool yk_redesign_ran_out(const YkRedesign *r)
{
    return yk_arena_failed(r->arena);
}

static const YkFormula *formula_of(YkRedesign *r, const YkExpr *expr)
{
    const YkFormula *formula = yk_redesign_compile(r, expr);
    if (!formula) r->failed = true;
    return formula;
}

static bool is_chosen(const YkRedesign *r, int32_t parameter)
{
    for (size_t k = 0; k < r->chosen_count; k++)
        if (r->chosen[k] == parameter) return true;
    return false;
}

typedef struct Wait {
    const YkRedesign *r;
    const bool *is_ready;
    bool waits;
} Wait;

static void look_ready(void *context, const YkExpr *name)
{
    Wait *w = context;
    int32_t index = yk_names_find(&w->r->original->parameter_names, name->name);
    if (index != YK_NONE && w->r->varies[index] && !w->is_ready[index]) w->waits = true;
}

// Orders the parameters that depend on the chosen ones, after those they need: passes until nothing changes.
static void order_derived(YkRedesign *r)
{
    const YkModel *model = r->original;
    size_t n = model->parameter_count;
    bool *is_ready = YK_NEW(r->arena, bool, n + 1);
    r->derived = YK_NEW(r->arena, Derived, n + 1);
    if (yk_arena_failed(r->arena)) return;
    yk_model_mark_dependents(model, r->varies);
    for (size_t k = 0; k < r->chosen_count; k++) is_ready[r->chosen[k]] = true;
    for (bool more = true; more;) {
        more = false;
        for (size_t i = 0; i < n; i++) {
            Wait w = {.r = r, .is_ready = is_ready};
            if (!r->varies[i] || is_ready[i] || is_chosen(r, (int32_t)i)) continue;
            yk_expr_names(model->parameters[i].expr, look_ready, &w);
            if (w.waits) continue;
            is_ready[i] = more = true;
            r->derived[r->derived_count++] = (Derived){(int32_t)i, formula_of(r, model->parameters[i].expr)};
        }
    }
}

// --- values that cannot follow

static void refuse(const YkExpr *expr, const char *what, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_CANNOT_VARY, expr->place, "a parameter that varies enters %s here", what);
    yk_redesign_hint(problems);
}

void yk_redesign_hint(YkProblems *problems)
{
    yk_problem_hint(problems, "points, masses, gravity, springs and directions can vary here; `--param` changes any "
                              "parameter, one value at a time");
}

static bool is_turned(const YkModel *model, const double *target)
{
    for (size_t j = 0; j < model->joint_count; j++)
        if (target == &model->joints[j].turned) return true;
    return false;
}

static int by_target(const void *a, const void *b)
{
    const Follower *x = a, *y = b;
    return (x->target > y->target) - (x->target < y->target);
}

static bool list_followers(YkRedesign *r, YkProblems *problems)
{
    const YkModel *model = r->original;
    bool can = true;
    r->follower = YK_NEW(r->arena, Follower, model->use_count + 1);
    if (!r->follower) return false;
    for (size_t k = 0; k < model->use_count; k++) {
        const YkModelUse *use = &model->uses[k];
        if (!yk_redesign_expression_varies(r, use->expr)) continue;
        double *target = moved(r, use->target);
        if (!target || is_turned(model, use->target)) {
            refuse(use->expr, target ? "the constant angle of a joint" : "a wheel, a cam or a law", problems);
            can = false;
            continue;
        }
        r->follower[r->follower_count++] = (Follower){target, formula_of(r, use->expr)};
    }
    qsort(r->follower, r->follower_count, sizeof *r->follower, by_target);
    return can;
}

const YkFormula *yk_redesign_formula(const YkRedesign *r, const double *value)
{
    Follower key = {.target = (double *)(uintptr_t)value};
    const Follower *found = bsearch(&key, r->follower, r->follower_count, sizeof key, by_target);
    return found ? found->formula : NULL;
}

static void mark(YkRedesign *r)
{
    const YkModel *model = r->model;
    r->point_varies = YK_NEW(r->arena, bool, model->point_count + 1);
    r->along_varies = YK_NEW(r->arena, bool, model->joint_count + 1);
    if (yk_arena_failed(r->arena)) return;
    for (size_t p = 0; p < model->point_count; p++)
        r->point_varies[p] =
            yk_redesign_formula(r, &model->points[p].at.x) || yk_redesign_formula(r, &model->points[p].at.y);
    for (size_t j = 0; j < model->joint_count; j++)
        r->along_varies[j] = yk_redesign_formula(r, &model->joints[j].along_angle) != NULL;
}

static bool body_varies(const YkRedesign *r, const YkBody *body)
{
    for (int32_t k = 0; k < body->point_count; k++)
        if (r->point_varies[body->first_point + k]) return true;
    return false;
}

static void prepare_cams(YkRedesign *r)
{
    YkModel *model = r->model;
    r->cam = YK_NEW(r->arena, YkCam, model->cam_count + 1);
    r->lowest = YK_NEW(r->arena, double, model->cam_count + 1);
    if (yk_arena_failed(r->arena)) return;
    for (size_t k = 0; k < model->cam_count; k++) {
        const YkCam *cam = &model->cams[k];
        const YkLaw *law = cam->law == YK_NONE ? NULL : model->laws[cam->law].law;
        r->cam[k] = *cam;
        r->lowest[k] = law && !cam->oscillates ? yk_cam_lowest_lift(law) : 0;
    }
    model->cams = r->cam;
}

static void prepare_size(YkRedesign *r)
{
    const YkModel *model = r->model;
    r->extended = YK_NEW(r->arena, int32_t, model->body_count + 1);
    r->has_origin = YK_NEW(r->arena, bool, model->body_count + 1);
    r->room = YK_NEW(r->arena, YkVec, yk_size_room(model));
    if (yk_arena_failed(r->arena)) return;
    yk_size_origins(model, r->has_origin);
    for (size_t b = 0; b < model->body_count; b++) {
        if (body_varies(r, &model->bodies[b]))
            r->extended[r->extended_count++] = (int32_t)b;
        else
            r->fixed_size = fmax(r->fixed_size, yk_size_of_body(model, b, r->has_origin[b], r->room));
    }
}

// --- making

static bool choose(YkRedesign *r, const char *const *names, size_t count, YkProblems *problems)
{
    const YkModel *model = r->original;
    bool good = true;
    r->chosen = YK_NEW(r->arena, int32_t, count + 1);
    r->varies = YK_NEW(r->arena, bool, model->parameter_count + 1);
    r->value = YK_NEW(r->arena, double, model->parameter_count + 1);
    if (yk_arena_failed(r->arena)) return false;
    for (size_t i = 0; i < model->parameter_count; i++) r->value[i] = model->parameters[i].value;
    for (size_t k = 0; k < count; k++) {
        int32_t index = yk_names_find(&model->parameter_names, names[k]);
        if (index == YK_NONE) {
            yk_problem(problems, YK_CODE_UNKNOWN_OVERRIDE, (YkPlace){0}, "the file has no parameter %q", names[k]);
            yk_load_hint_nearest(problems, names[k], model->parameters, model->parameter_count,
                                 sizeof *model->parameters);
            good = false;
            continue;
        }
        if (is_chosen(r, index)) {
            yk_problem(problems, YK_CODE_OPTION_REPEATED, (YkPlace){0}, "parameter %q is given twice", names[k]);
            good = false;
        }
        r->chosen[r->chosen_count++] = index;
        r->varies[index] = true;
    }
    return good;
}

YkRedesign *yk_redesign_new(const YkModel *model, const char *const *names, size_t count, YkProblems *problems)
{
    YkRedesign *r = calloc(1, sizeof *r);
    if (r) r->arena = yk_arena_new();
    bool good = r && r->arena;
    if (good) {
        r->original = model;
        good = copy_model(r) && choose(r, names, count, problems);
    }
    if (good) {
        order_derived(r);
        good = !yk_arena_failed(r->arena) && list_followers(r, problems);
    }
    if (good) mark(r);
    if (good && !yk_arena_failed(r->arena)) {
        prepare_cams(r);
        prepare_size(r);
    }
    if (!r || !r->arena || r->failed || yk_arena_failed(r->arena)) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing what varies");
        good = false;
    }
    if (good) return r;
    yk_redesign_free(r);
    return NULL;
}

void yk_redesign_free(YkRedesign *r)
{
    if (!r) return;
    yk_arena_free(r->arena);
    free(r);
}

YkModel *yk_redesign_model(YkRedesign *r)
{
    return r->model;
}
double yk_redesign_value(const YkRedesign *r, size_t index)
{
    return r->value[r->chosen[index]];
}
int32_t yk_redesign_parameter(const YkRedesign *r, size_t k)
{
    return r->chosen[k];
}
bool yk_redesign_varies(const YkRedesign *r, int32_t parameter)
{
    return r->varies[parameter];
}
double yk_redesign_now(const YkRedesign *r, int32_t parameter)
{
    return r->value[parameter];
}
bool yk_redesign_point_varies(const YkRedesign *r, int32_t point)
{
    return point != YK_NONE && r->point_varies[point];
}
bool yk_redesign_along_varies(const YkRedesign *r, int32_t joint)
{
    return r->along_varies[joint];
}
size_t yk_redesign_count(const YkRedesign *r)
{
    return r->chosen_count;
}
const double *yk_redesign_values(const YkRedesign *r)
{
    return r->value;
}
int32_t yk_redesign_derived(const YkRedesign *r, size_t k, const YkFormula **formula)
{
    if (k >= r->derived_count) return YK_NONE;
    *formula = r->derived[k].formula;
    return r->derived[k].parameter;
}

// --- a design

static bool fits(double value)
{
    return fabs(value) <= YK_VALUE_MAX; // false for NaN
}

static bool set_parameters(YkRedesign *r, const double *values)
{
    bool good = true;
    for (size_t k = 0; k < r->chosen_count; k++) r->value[r->chosen[k]] = values[k];
    for (size_t k = 0; k < r->chosen_count; k++) good = fits(values[k]) && good;
    for (size_t k = 0; good && k < r->derived_count; k++) {
        double value = yk_formula_eval(r->derived[k].formula, r->value);
        r->value[r->derived[k].parameter] = value;
        good = fits(value);
    }
    for (size_t k = 0; k < r->chosen_count; k++) r->model->parameters[r->chosen[k]].value = r->value[r->chosen[k]];
    for (size_t k = 0; k < r->derived_count; k++)
        r->model->parameters[r->derived[k].parameter].value = r->value[r->derived[k].parameter];
    return good;
}

// Computes what the loader derives from values, with the same refusals.
static bool finish_joints(YkModel *model)
{
    bool good = true;
    for (size_t j = 0; j < model->joint_count; j++) {
        YkJoint *joint = &model->joints[j];
        for (int k = 0; k < 2; k++)
            if (joint->point[k] != YK_NONE) joint->at[k] = model->points[joint->point[k]].at;
        if (joint->along_expr) joint->along = yk_unit(joint->along_angle);
        if (!joint->has_friction) continue;
        const YkFriction *f = &joint->friction;
        good = good && f->coulomb >= 0 && f->radius >= 0 && f->viscous >= 0;
    }
    return good;
}

static bool finish_bodies(YkModel *model)
{
    bool good = true;
    for (size_t b = 1; b < model->body_count; b++) {
        YkBody *body = &model->bodies[b];
        good = good && (!body->mass_expr || body->mass > 0);
        if (body->rod[0] == YK_NONE || body->rod[1] == YK_NONE) {
            good = good && !(body->inertia < 0);
            continue;
        }
        YkVec p = model->points[body->rod[0]].at, q = model->points[body->rod[1]].at, along = yk_sub(q, p);
        double length = yk_hypot(along.x, along.y);
        good = good && length > 1e-12 * fmax(yk_hypot(p.x, p.y), yk_hypot(q.x, q.y));
        body->center = yk_scale(0.5, yk_add(p, q));
        body->inertia = body->mass * length * length / 12;
    }
    return good;
}

static bool finish_loads(YkModel *model)
{
    bool good = true;
    for (size_t k = 0; k < model->spring_count; k++) {
        YkSpring *spring = &model->springs[k];
        for (int e = 0; spring->coordinate == YK_NONE && e < 2; e++)
            if (spring->point[e] != YK_NONE) spring->at[e] = model->points[spring->point[e]].at;
        bool has_length = spring->coordinate == YK_NONE; // along a coordinate it may be any value
        good = good && spring->damping >= 0 && !(has_length && spring->length < 0);
    }
    for (size_t k = 0; k < model->force_count; k++) {
        YkForce *force = &model->forces[k];
        if (force->point != YK_NONE) force->at = model->points[force->point].at;
    }
    for (size_t k = 0; k < model->stop_count; k++) {
        const YkStop *stop = &model->stops[k];
        good = good && !(stop->low >= stop->high) && stop->restitution >= 0 && stop->restitution <= 1;
    }
    return good;
}

static bool finish_cams(YkRedesign *r)
{
    bool good = true;
    for (size_t k = 0; k < r->model->cam_count; k++) {
        YkCam *cam = &r->cam[k];
        yk_cam_place(r->model, cam);
        good =
            good && (!cam->centers_expr || yk_cam_centers_agree(cam)) && yk_cam_fault(cam, r->lowest[k]) == YK_CAM_FITS;
    }
    return good;
}

// The side of its pinion on which a rack lies is that of the file.
static bool finish_racks(const YkModel *model)
{
    bool good = true;
    for (size_t k = 0; k < model->rack_count; k++) good = good && yk_rack_keeps_side(model, &model->racks[k]);
    return good;
}

static void finish_size(YkRedesign *r)
{
    double size = fmax(r->fixed_size, yk_size_of_start(r->model));
    for (size_t k = 0; k < r->extended_count; k++) {
        size_t body = (size_t)r->extended[k];
        size = fmax(size, yk_size_of_body(r->model, body, r->has_origin[body], r->room));
    }
    r->model->size = size > 0 ? size : yk_size_of_values(r->model);
}

YkStatus yk_redesign_set(YkRedesign *r, const double *values)
{
    if (!set_parameters(r, values)) return YK_BAD_MODEL;
    bool good = true;
    for (size_t k = 0; k < r->follower_count; k++) {
        double value = yk_formula_eval(r->follower[k].formula, r->value);
        *r->follower[k].target = value;
        good = good && fits(value);
    }
    good = finish_joints(r->model) && good;
    good = finish_bodies(r->model) && good;
    good = finish_loads(r->model) && good;
    good = finish_cams(r) && finish_racks(r->model) && good;
    finish_size(r);
    return good ? YK_OK : YK_BAD_MODEL;
}
