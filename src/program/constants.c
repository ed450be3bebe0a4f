// Numbers of the model as values: parameters by name, expressions, points, the turns of bodies, the vectors of terms.
#include <string.h>
#include "base/letters.h"
#include "program/program.h"
#include "model/laws/laws.h"
#include "model/transmissions/cam_arcs.h"
#include "model/transmissions/cam_place.h"

// --- expressions

typedef struct Reading {
    YkProgram *program;
    const YkMotionRef *motion; // per coordinate of the tree, or NULL
    const YkRef *own;          // the length and the rate of the spring at hand, or NULL
} Reading;

// Finds the tree's coordinate for NAME, JOINT.angle or JOINT.distance.
static int32_t find_coordinate(const YkProgram *p, char *name)
{
    int32_t found = yk_names_find(&p->model->coordinate_names, name);
    if (found != YK_NONE)
        return yk_tree_coordinate(p->mech, p->model->coordinates[found].joint,
                                  p->model->coordinates[found].is_distance);
    bool is_angle = yk_cut_ending(name, ".angle");
    if (!is_angle && !yk_cut_ending(name, ".distance")) return YK_NONE;
    int32_t joint = yk_names_find(&p->model->joint_names, name);
    return joint == YK_NONE ? YK_NONE : yk_tree_coordinate(p->mech, joint, !is_angle);
}

static YkRef read_name(const Reading *r, const YkExpr *expr)
{
    YkProgram *p = r->program;
    int32_t parameter = yk_names_find(&p->model->parameter_names, expr->name);
    if (parameter != YK_NONE) return p->parameter[parameter];
    if (strcmp(expr->name, "pi") == 0) return yk_graph_number(&p->graph, YK_PI);
    if (strcmp(expr->name, "t") == 0) return p->time;
    int own = yk_model_own_name(expr->name);
    if (own != YK_NONE && r->own) return r->own[own];
    char *name = yk_arena_copy(p->arena, expr->name, strlen(expr->name));
    if (!name) return yk_graph_number(&p->graph, 0);
    bool is_rate = yk_cut_ending(name, ".rate");
    int32_t coordinate = find_coordinate(p, name);
    if (coordinate == YK_NONE || !r->motion) { // of a joint that closes a loop: the loader or the printer refuses it
        p->failed = true;
        return yk_graph_number(&p->graph, 0);
    }
    return is_rate ? r->motion[coordinate].velocity : r->motion[coordinate].position;
}

static YkRef read(const Reading *r, const YkExpr *expr)
{
    YkGraph *g = &r->program->graph;
    if (expr->kind == YK_EXPR_NUMBER)
        return yk_graph_number(g, expr->number * (expr->has_unit ? expr->unit_size : expr->value_scale));
    if (expr->kind == YK_EXPR_NAME) return read_name(r, expr);
    YkRef a = read(r, expr->a), b = expr->b ? read(r, expr->b) : -1;
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        return yk_graph_minus(g, a);
    case YK_EXPR_ADD:
        return yk_graph_add(g, a, b);
    case YK_EXPR_SUBTRACT:
        return yk_graph_subtract(g, a, b);
    case YK_EXPR_MULTIPLY:
        return yk_graph_multiply(g, a, b);
    case YK_EXPR_DIVIDE:
        return yk_graph_divide(g, a, b);
    case YK_EXPR_POWER:
        return yk_graph_power(g, a, b);
    default:
        return yk_graph_function(g, expr->function, a, b);
    }
}

YkRef yk_program_expr(YkProgram *p, const YkExpr *expr)
{
    return yk_program_expr_of(p, expr, NULL, NULL);
}

YkRef yk_program_expr_of(YkProgram *p, const YkExpr *expr, const YkMotionRef *motion, const YkRef *own)
{
    return expr ? read(&(Reading){p, motion, own}, expr) : yk_graph_number(&p->graph, 0);
}

// --- parameters

// Laws and the constants of gears, racks, belts and cams keep the file's values, since the printed program cannot
// compute them anew; a parameter that they use is fixed.
static void fix_name(void *context, const YkExpr *name)
{
    YkProgram *p = context;
    int32_t parameter = yk_names_find(&p->model->parameter_names, name->name);
    if (parameter == YK_NONE || p->is_fixed[parameter]) return;
    p->is_fixed[parameter] = true;
    if (p->model->parameters[parameter].expr) yk_expr_names(p->model->parameters[parameter].expr, fix_name, p);
}

static void fix(YkProgram *p, const YkExpr *expr)
{
    if (expr) yk_expr_names(expr, fix_name, p);
}

static void fix_number(YkProgram *p, const YkLawNumber *number)
{
    fix(p, number->expr);
}

static void fix_given(YkProgram *p, const YkLawGiven *given)
{
    fix_number(p, &given->at);
    for (int k = 0; k <= YK_LAW_ORDER; k++) fix_number(p, &given->d[k]);
}

static void fix_law(YkProgram *p, const YkLawSource *law)
{
    fix_number(p, &law->from);
    fix_number(p, &law->period);
    for (size_t k = 0; k < law->part_count; k++) {
        const YkLawPart *part = &law->parts[k];
        const YkLawNumber *numbers[] = {&part->to, &part->by, &part->v, &part->blend,
                                        &part->b,  &part->c,  &part->d, &part->degree};
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) fix_number(p, numbers[i]);
        fix(p, part->formula);
        for (size_t i = 0; i < part->given_count; i++) fix_given(p, &part->given[i]);
    }
    for (size_t k = 0; k < law->point_count; k++)
        for (int i = 0; i < 2; i++) fix_number(p, &law->points[k][i]);
}

static void fix_arcs(YkProgram *p, const YkCamArcs *arcs)
{
    fix(p, arcs->from_expr);
    fix(p, arcs->nose_expr);
    fix(p, arcs->lift_expr);
    fix(p, arcs->angle_expr);
    fix(p, arcs->flank_expr);
    for (size_t k = 0; k < arcs->count; k++)
        for (int i = 0; i < 3; i++) fix(p, arcs->items[k].exprs[i]);
}

static void fix_wheels(YkProgram *p)
{
    const YkModel *m = p->model;
    for (size_t k = 0; k < m->gear_count; k++) {
        const YkGear *g = &m->gears[k];
        const YkExpr *all[] = {g->teeth_expr[0], g->teeth_expr[1], g->module_expr, g->pressure_angle_expr,
                               g->planets_expr};
        for (size_t i = 0; i < sizeof all / sizeof *all; i++) fix(p, all[i]);
    }
    for (size_t k = 0; k < m->rack_count; k++) fix(p, m->racks[k].radius_expr);
    for (size_t k = 0; k < m->belt_count; k++)
        for (int i = 0; i < 2; i++) fix(p, m->belts[k].radius_expr[i]);
    for (size_t k = 0; k < m->cam_count; k++) {
        const YkCam *c = &m->cams[k];
        const YkExpr *all[] = {c->base_expr,       c->roller_expr,    c->offset_expr,
                               c->arm_expr,        c->centers_expr,   c->other_roller_expr,
                               c->other_span_expr, c->other_arm_expr, c->other_angle_expr};
        for (size_t i = 0; i < sizeof all / sizeof *all; i++) fix(p, all[i]);
        if (c->arcs) fix_arcs(p, c->arcs);
        const YkExpr *place[YK_CAM_EXPRS];
        for (size_t i = yk_cam_pair_exprs(m, c, place); i-- > 0;) fix(p, place[i]);
    }
}

void yk_program_fix(YkProgram *p)
{
    const YkModel *m = p->model;
    for (size_t k = 0; k < m->law_count; k++) fix_law(p, m->laws[k].source);
    for (size_t k = 0; k < m->joint_count; k++) fix(p, m->joints[k].turned_expr);
    fix_wheels(p);
    if (m->gear_count + m->rack_count + m->belt_count == 0) return;
    for (size_t k = 0; k < m->start_count; k++) fix(p, m->starts[k].expr); // the position of teeth
    for (size_t k = 0; k < m->drive_count; k++) fix(p, m->drives[k].expr);
}

static void add_parameter(YkProgram *p, size_t index, int depth)
{
    const YkParameter *parameter = &p->model->parameters[index];
    YkGraph *g = &p->graph;
    if (p->parameter[index] != -1) return;
    if (p->is_fixed[index] || depth > 100) {
        p->parameter[index] = yk_graph_number(g, parameter->value);
        return;
    }
    bool hangs_on_others = false;
    for (size_t k = 0; k < p->model->parameter_count; k++) {
        if (p->takes_all || !parameter->expr || !yk_expr_mentions(parameter->expr, p->model->parameters[k].name))
            continue;
        hangs_on_others = true;
        add_parameter(p, k, depth + 1);
    }
    if (hangs_on_others) {
        p->parameter[index] = yk_program_expr(p, parameter->expr);
        yk_graph_name(g, p->parameter[index], "%s", p->names.parameter[index]);
    } else {
        p->parameter[index] = yk_graph_leaf(g, YK_LEAF_PARAMETER, p->names.parameter[index]);
    }
}

// --- bodies and vectors

void yk_program_constants(YkProgram *p)
{
    const YkModel *m = p->model;
    for (size_t k = 0; k < m->parameter_count; k++) p->parameter[k] = -1;
    for (size_t k = 0; k < m->parameter_count; k++) add_parameter(p, k, 0);
    for (size_t b = 0; b < m->body_count; b++) {
        const YkPlacing *placing = &p->mech->bodies[b];
        p->turn[b] = yk_graph_number(&p->graph, placing->turn);
        p->turn_unit[b] = yk_graph_vec_number(&p->graph, placing->turn_unit.x, placing->turn_unit.y);
    }
}

YkRefVec yk_program_point(YkProgram *p, int32_t point)
{
    if (point == YK_NONE) return yk_graph_vec_number(&p->graph, 0, 0);
    const YkPoint *at = &p->model->points[point];
    YkRef x = at->x ? yk_program_expr(p, at->x) : yk_graph_number(&p->graph, at->at.x);
    YkRef y = at->y ? yk_program_expr(p, at->y) : yk_graph_number(&p->graph, at->at.y);
    return (YkRefVec){x, y};
}

YkRefVec yk_program_along(YkProgram *p, const YkJoint *joint)
{
    if (!joint->along_expr) return yk_graph_vec_number(&p->graph, joint->along.x, joint->along.y);
    return yk_graph_unit(&p->graph, yk_program_expr(p, joint->along_expr));
}

static YkRefVec in_orientation(YkProgram *p, int32_t body, YkRefVec v)
{
    return yk_graph_vec_multiply(&p->graph, p->turn_unit[body], v);
}

// Evaluates a vector by its recipe: points and lines of joints, in the axes of their bodies' orientations, added.
static YkRefVec by_recipe(YkProgram *p, int32_t index)
{
    YkGraph *g = &p->graph;
    const YkRecipeNode *node = &p->recipe->nodes[index];
    switch (node->kind) {
    case YK_RECIPE_POINT: {
        const YkJoint *joint = &p->model->joints[node->a];
        return in_orientation(p, joint->body[node->b], yk_program_point(p, joint->point[node->b]));
    }
    case YK_RECIPE_ALONG:
        return in_orientation(p, p->model->joints[node->a].body[0], yk_program_along(p, &p->model->joints[node->a]));
    case YK_RECIPE_NEGATE: {
        YkRef minus_one = yk_graph_number(g, -1);
        return yk_graph_vec_scale(g, minus_one, by_recipe(p, node->a));
    }
    case YK_RECIPE_ADD: {
        YkRefVec a = by_recipe(p, node->a);
        return yk_graph_vec_add(g, a, by_recipe(p, node->b));
    }
    case YK_RECIPE_FIXED:
        break;
    }
    return yk_graph_vec_number(g, node->value.x, node->value.y);
}

static YkRefVec as_it_is(YkProgram *p, YkVec v)
{
    return yk_graph_vec_number(&p->graph, v.x, v.y);
}

YkRefVec yk_program_term(YkProgram *p, size_t term)
{
    return p->recipe ? by_recipe(p, p->recipe->of_term[term]) : as_it_is(p, p->mech->terms[term].v);
}

YkRefVec yk_program_constant(YkProgram *p, const YkSum *sum)
{
    if (!p->recipe) return as_it_is(p, sum->constant);
    return by_recipe(p, yk_recipe_constant(p->recipe, sum->first, sum->plus != YK_NONE));
}

YkRefVec yk_program_line(YkProgram *p, int32_t distance, YkVec value)
{
    for (size_t j = 0; j < p->model->joint_count; j++) {
        if (p->mech->joint_distance[j] != distance) continue;
        const YkJoint *joint = &p->model->joints[j];
        YkVec along = yk_mul(p->mech->bodies[joint->body[0]].turn_unit, joint->along);
        double sign = yk_dot(along, value) < 0 ? -1 : 1;
        YkRefVec v = in_orientation(p, joint->body[0], yk_program_along(p, joint));
        return yk_graph_vec_scale(&p->graph, yk_graph_number(&p->graph, sign), v);
    }
    return yk_graph_vec_number(&p->graph, value.x, value.y);
}

// Returns the angle from the first to the second body, from those of their orientations, as in compile.
YkRef yk_program_joint_offset(YkProgram *p, int32_t joint)
{
    const YkJoint *j = &p->model->joints[joint];
    return yk_graph_subtract(&p->graph, p->turn[j->body[1]], p->turn[j->body[0]]);
}
