// Prepares the loads of a machine once: their points, formulas, laws and variables.
#include "loads/loads.h"
#include <stdlib.h>
#include "loads/point.h"
#include "model/formulas.h"

// Returns the variable of a coordinate, or with YK_NONE that of the length of the spring at hand.
static int variable_of(void *context, int32_t declared, bool is_rate)
{
    YkLoads *loads = context;
    int32_t coordinate = YK_NONE;
    if (declared != YK_NONE) {
        const YkCoordinate *c = &loads->mech->model->coordinates[declared];
        coordinate = yk_tree_coordinate(loads->mech, c->joint, c->is_distance);
        if (coordinate == YK_NONE) return -2;
    }
    for (size_t k = 1; k < loads->variable_count; k++)
        if (loads->variables[k].coordinate == coordinate && loads->variables[k].is_rate == is_rate) return (int)k;
    if (!YK_ROOM(loads->variables, loads->variable_count, loads->variable_capacity)) {
        loads->failed = true;
        return -2;
    }
    loads->variables[loads->variable_count] = (YkVariable){coordinate, is_rate};
    return (int)loads->variable_count++;
}

static YkLoadValue value_of(YkLoads *loads, const YkStrength *strength)
{
    const YkModel *model = loads->mech->model;
    YkLoadValue value = {.law = strength->law == YK_NONE ? NULL : model->laws[strength->law].law};
    if (!strength->expr) return (YkLoadValue){0};
    const YkFormula *formula = yk_model_formula(model, strength->expr, variable_of, loads, loads->arena);
    if (!formula) {
        loads->failed = true;
    } else if (yk_formula_is_constant(formula)) {
        value.constant = yk_formula_eval(formula, NULL);
    } else {
        value.formula = formula;
    }
    loads->varies = loads->varies || value.formula || value.law;
    return value;
}

static YkLoadItem *add_item(YkLoads *loads, YkLoadKind kind, const char *name)
{
    YkLoadItem *item = &loads->items[loads->item_count++];
    *item = (YkLoadItem){.kind = kind, .name = name, .joint = YK_NONE, .coordinate = YK_NONE, .input = YK_NONE};
    return item;
}

static void act_on(YkLoads *loads, int32_t a, int32_t b)
{
    loads->is_loaded[a] = loads->is_loaded[b] = true;
}

static YkLoadItem *add_along(YkLoads *loads, YkLoadKind kind, const char *name, int32_t joint, bool is_distance)
{
    const YkModel *model = loads->mech->model;
    YkLoadItem *item = add_item(loads, kind, name);
    item->joint = joint;
    item->is_distance = is_distance;
    item->coordinate = yk_tree_coordinate(loads->mech, joint, is_distance);
    if (item->coordinate != YK_NONE) item->input = loads->mech->coordinates[item->coordinate].input;
    item->body[0] = yk_joint_end(model, (size_t)joint, 0)->body[0];
    item->body[1] = yk_joint_end(model, (size_t)joint, 1)->body[1];
    YkJointAngle angle = yk_joint_angle(loads->mech, joint);
    item->slot[0] = angle.a;
    item->slot[1] = angle.b;
    act_on(loads, item->body[0], item->body[1]);
    return item;
}

static void add_efforts(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    for (size_t k = 0; k < model->effort_count; k++) {
        const YkEffort *effort = &model->efforts[k];
        const YkCoordinate *c = &model->coordinates[effort->coordinate];
        YkLoadItem *item = add_along(loads, YK_LOAD_EFFORT, c->name, c->joint, c->is_distance);
        item->value[0] = value_of(loads, &effort->strength);
    }
}

static void add_forces(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    for (size_t k = 0; k < model->force_count; k++) {
        const YkForce *force = &model->forces[k];
        YkLoadItem *item = add_item(loads, YK_LOAD_FORCE, force->name);
        item->body[0] = force->body;
        item->end[0] = yk_load_end(loads->mech, force->body, force->at);
        item->in_body_axes = force->in_body_axes;
        item->value[0] = value_of(loads, &force->x);
        item->value[1] = value_of(loads, &force->y);
        item->value[2] = value_of(loads, &force->moment);
        act_on(loads, force->body, force->body);
    }
}

static void add_springs(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    for (size_t k = 0; k < model->spring_count; k++) {
        const YkSpring *spring = &model->springs[k];
        YkLoadItem *item;
        if (spring->coordinate != YK_NONE) {
            const YkCoordinate *c = &model->coordinates[spring->coordinate];
            item = add_along(loads, YK_LOAD_ALONG, spring->name, c->joint, c->is_distance);
        } else {
            item = add_item(loads, YK_LOAD_SPRING, spring->name);
            for (int end = 0; end < 2; end++) {
                item->body[end] = spring->body[end];
                item->end[end] = yk_load_end(loads->mech, spring->body[end], spring->at[end]);
            }
            act_on(loads, spring->body[0], spring->body[1]);
        }
        item->stiffness = spring->stiffness;
        item->length = spring->length;
        item->damping = spring->damping;
        item->value[0] = value_of(loads, &spring->force);
    }
}

static void add_friction(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        bool slides = yk_part(joint->kind)->slides;
        if (joint->friction.viscous != 0)
            add_along(loads, YK_LOAD_VISCOUS, joint->name, (int32_t)j, slides)->damping = joint->friction.viscous;
        if (joint->friction.coulomb == 0) continue;
        YkLoadItem *item = add_along(loads, YK_LOAD_COULOMB, joint->name, (int32_t)j, slides);
        item->coulomb = joint->friction.coulomb;
        item->radius = slides ? 1 : joint->friction.radius;
        loads->has_dry = true;
    }
}

static void add_stops(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    for (size_t k = 0; k < model->stop_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->stops[k].coordinate];
        add_along(loads, YK_LOAD_STOP, c->name, c->joint, c->is_distance)->stop = &model->stops[k];
    }
}

static bool allocate(YkLoads *loads)
{
    const YkModel *model = loads->mech->model;
    size_t items = model->effort_count + model->force_count + model->spring_count + model->stop_count +
                   loads->mech->coordinate_count;
    for (size_t j = 0; j < model->joint_count; j++) items += model->joints[j].has_friction ? 2 : 0;
    loads->arena = yk_arena_new();
    loads->items = calloc(items + 1, sizeof *loads->items); // room for efforts that are set later
    loads->is_loaded = calloc(model->body_count, sizeof *loads->is_loaded);
    if (!loads->arena || !loads->items || !loads->is_loaded) return false;
    if (!YK_ROOM(loads->variables, loads->variable_count, loads->variable_capacity)) return false;
    loads->variables[loads->variable_count++] = (YkVariable){YK_NONE, false};
    return true;
}

YkLoads *yk_loads_new(const YkMechanism *mech)
{
    YkLoads *loads = calloc(1, sizeof *loads);
    if (!loads) return NULL;
    loads->mech = mech;
    bool ok = allocate(loads);
    if (ok) {
        add_efforts(loads);
        add_forces(loads);
        add_springs(loads);
        add_friction(loads);
        add_stops(loads);
        for (size_t k = 1; k < loads->variable_count; k++)
            if (loads->variables[k].coordinate == YK_NONE) loads->own[loads->variables[k].is_rate] = k;
        loads->value = calloc(loads->variable_count, sizeof *loads->value);
        ok = loads->value && !loads->failed && !yk_arena_failed(loads->arena);
    }
    if (!ok) {
        yk_loads_free(loads);
        return NULL;
    }
    return loads;
}

void yk_loads_free(YkLoads *loads)
{
    if (!loads) return;
    yk_arena_free(loads->arena);
    free(loads->items);
    free(loads->is_loaded);
    free(loads->variables);
    free(loads->value);
    free(loads->handles);
    free(loads);
}

bool yk_loads_set_handles(YkLoads *loads, size_t count)
{
    loads->handles = calloc(count, sizeof *loads->handles);
    if (!loads->handles) return false;
    loads->handle_count = count;
    for (size_t b = 1; b < loads->mech->model->body_count; b++) loads->is_loaded[b] = true;
    return true;
}

bool yk_loads_set_effort(YkLoads *loads, size_t coordinate, double effort)
{
    const YkTreeCoordinate *c = &loads->mech->coordinates[coordinate];
    YkLoadItem *item = NULL;
    for (size_t k = 0; k < loads->item_count; k++)
        if (loads->items[k].kind == YK_LOAD_EFFORT && loads->items[k].coordinate == (int32_t)coordinate)
            item = &loads->items[k];
    const int32_t *body = loads->mech->model->joints[c->joint].body;
    bool is_new = !item && !(loads->is_loaded[body[0]] && loads->is_loaded[body[1]]);
    if (!item) item = add_along(loads, YK_LOAD_EFFORT, c->name, c->joint, c->is_distance);
    item->value[0] = (YkLoadValue){.constant = effort};
    item->is_given = true;
    return is_new;
}
