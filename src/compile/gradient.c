// Derivatives of answers by parameters: a design, a pose, and the transposed solutions of the loops for each answer.
#include "compile/gradient.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "compile/gradient_inside.h"
#include "num/dense.h"

// --- making

static bool make_room(YkGradient *g)
{
    size_t n = g->variables, m = g->rows, points = g->model->point_count, joints = g->model->joint_count;
    YkArena *a = g->arena = yk_arena_new();
    g->point = yk_arena_alloc(a, points + 1, sizeof *g->point);
    g->joint = yk_arena_alloc(a, joints + 1, sizeof *g->joint);
    g->by_point = yk_arena_alloc(a, 2 * points * g->parameters + 1, sizeof *g->by_point);
    g->by_joint = yk_arena_alloc(a, joints * g->parameters + 1, sizeof *g->by_joint);
    g->by_parameter = yk_arena_alloc(a, g->model->parameter_count * g->parameters + 1, sizeof *g->by_parameter);
    g->direction = yk_arena_alloc(a, g->model->parameter_count + 1, sizeof *g->direction);
    g->slot = yk_arena_alloc(a, g->mech->slot_count + 1, sizeof *g->slot);
    g->turn = yk_arena_alloc(a, g->mech->slot_count + 1, sizeof *g->turn);
    g->node = yk_arena_alloc(a, g->mech->node_count + 1, sizeof *g->node);
    g->x = yk_arena_alloc(a, YK_JET * n + 1, sizeof *g->x);
    g->J = yk_arena_alloc(a, m * n + 1, sizeof *g->J);
    g->tau = yk_arena_alloc(a, n + 1, sizeof *g->tau);
    g->order = yk_arena_alloc(a, n + 1, sizeof *g->order);
    g->by_x = yk_arena_alloc(a, YK_JET * n + 1, sizeof *g->by_x);
    g->lambda = yk_arena_alloc(a, m + n + 1, sizeof *g->lambda);
    g->at_node = yk_arena_alloc(a, g->mech->node_count + 1, sizeof *g->at_node);
    g->at_vector = yk_arena_alloc(a, g->recipe->node_count + 1, sizeof *g->at_vector);
    g->at_point = yk_arena_alloc(a, points + 1, sizeof *g->at_point);
    g->at_direction = yk_arena_alloc(a, joints + 1, sizeof *g->at_direction);
    g->at_parameter = yk_arena_alloc(a, g->model->parameter_count + 1, sizeof *g->at_parameter);
    return !yk_arena_failed(a);
}

// Slots are the orientations, and the angles of some of them to the roots of their groups.
static void list_slots(YkGradient *g)
{
    for (size_t o = 0; o < g->mech->orientation_count; o++) {
        g->slot[o] = (YkSlotAngle){(int32_t)o, 0};
        int32_t relative = g->mech->relative_slot[o];
        if (relative > 0) g->slot[relative] = (YkSlotAngle){(int32_t)o, g->mech->group_root[o]};
    }
}

YkGradient *yk_gradient_new(const YkVariant *variant)
{
    YkGradient *g = calloc(1, sizeof *g);
    if (!g) return NULL;
    g->mech = yk_variant_mechanism(variant);
    g->model = g->mech->model;
    g->redesign = variant->redesign;
    g->recipe = &variant->recipe;
    g->parameters = yk_redesign_count(variant->redesign);
    g->variables = yk_variable_count(g->mech);
    g->rows = 2 * g->mech->loop_count + g->mech->relation_count + g->mech->input_count;
    if (!make_room(g)) {
        yk_gradient_free(g);
        return NULL;
    }
    list_slots(g);
    for (size_t p = 0; p < g->model->point_count; p++)
        if (yk_redesign_point_varies(g->redesign, (int32_t)p)) g->point[g->point_count++] = (int32_t)p;
    for (size_t j = 0; j < g->model->joint_count; j++)
        if (yk_redesign_along_varies(g->redesign, (int32_t)j)) g->joint[g->joint_count++] = (int32_t)j;
    return g;
}

void yk_gradient_free(YkGradient *g)
{
    if (!g) return;
    yk_arena_free(g->arena);
    free(g);
}

// --- a design

// Returns the derivative of a value of the model in the present direction of the parameters.
static double slope_of(const YkGradient *g, const double *value)
{
    const YkFormula *formula = yk_redesign_formula(g->redesign, value);
    return formula ? yk_formula_slope(formula, yk_redesign_values(g->redesign), g->direction) : 0;
}

// Sets the direction in which parameter k changes, and all that follow it.
static void set_direction(YkGradient *g, size_t k)
{
    const YkFormula *formula;
    int32_t index;
    memset(g->direction, 0, g->model->parameter_count * sizeof *g->direction);
    g->direction[yk_redesign_parameter(g->redesign, k)] = 1;
    for (size_t d = 0; (index = yk_redesign_derived(g->redesign, d, &formula)) != YK_NONE; d++)
        g->direction[index] = yk_formula_slope(formula, yk_redesign_values(g->redesign), g->direction);
}

bool yk_gradient_design(YkGradient *g)
{
    size_t n = g->parameters;
    double sum = 0;
    for (size_t k = 0; k < n; k++) {
        set_direction(g, k);
        for (size_t i = 0; i < g->model->parameter_count; i++) g->by_parameter[i * n + k] = g->direction[i];
        for (size_t i = 0; i < g->point_count; i++) {
            const YkVec *at = &g->model->points[g->point[i]].at;
            sum += g->by_point[2 * i * n + k] = slope_of(g, &at->x);
            sum += g->by_point[(2 * i + 1) * n + k] = slope_of(g, &at->y);
        }
        for (size_t i = 0; i < g->joint_count; i++)
            sum += g->by_joint[i * n + k] = slope_of(g, &g->model->joints[g->joint[i]].along_angle);
    }
    return isfinite(sum);
}

// --- a pose

// Writes one row for each input, which does not change.
static void add_inputs(YkGradient *g, double *row)
{
    const YkMechanism *mech = g->mech;
    for (size_t i = 0; i < mech->input_count; i++, row += g->variables) {
        const YkTreeCoordinate *q = &mech->coordinates[mech->inputs[i]];
        if (q->is_distance) row[yk_gradient_variable(g, q->distance)] = 1;
        if (!q->is_distance && q->angle.b > 0) row[q->angle.b - 1] += 1;
        if (!q->is_distance && q->angle.a > 0) row[q->angle.a - 1] -= 1;
    }
}

bool yk_gradient_pose(YkGradient *g, const double *x, const double *rates, const double *accelerations)
{
    const YkMechanism *mech = g->mech;
    size_t n = g->variables, loops = 2 * mech->loop_count;
    double *relation = g->J + loops * n;
    const double *order[YK_JET] = {x, rates, accelerations};
    for (size_t k = 0; k < YK_JET; k++) {
        if (order[k])
            memcpy(g->x + k * n, order[k], n * sizeof *x);
        else
            memset(g->x + k * n, 0, n * sizeof *x);
    }
    yk_gradient_place(g);
    memset(g->J, 0, g->rows * n * sizeof *g->J);
    yk_closure(mech, x, g->lambda, g->J);
    for (size_t r = 0; r < mech->relation_count; r++)
        yk_closure_relation(mech, r, x, g->lambda, relation + r * n, NULL);
    add_inputs(g, relation + mech->relation_count * n);
    return yk_qr_factor(g->rows, n, g->J, g->order, g->tau, 1e-10) == n;
}

// --- an answer

void yk_gradient_start(YkGradient *g)
{
    memset(g->by_x, 0, YK_JET * g->variables * sizeof *g->by_x);
    memset(g->at_node, 0, g->mech->node_count * sizeof *g->at_node);
    memset(g->at_vector, 0, g->recipe->node_count * sizeof *g->at_vector);
    memset(g->at_point, 0, g->model->point_count * sizeof *g->at_point);
    memset(g->at_direction, 0, g->model->joint_count * sizeof *g->at_direction);
    memset(g->at_parameter, 0, g->model->parameter_count * sizeof *g->at_parameter);
}

// Takes the shares that an answer has by the loops, whose derivative of this order depends on what all lower ones do.
static void solve_order(YkGradient *g, size_t order)
{
    const YkMechanism *mech = g->mech;
    size_t n = g->variables;
    bool has_some = false;
    for (size_t v = 0; v < n; v++) has_some |= g->by_x[order * n + v] != 0;
    if (!has_some) return;
    yk_qr_solve_transposed(g->rows, n, g->J, g->order, g->tau, g->by_x + order * n, g->lambda);
    for (size_t l = 0; l < mech->loop_count; l++) {
        YkVecJet by = {{{0, 0}}};
        by.v[order] = yk_vec(-g->lambda[2 * l], -g->lambda[2 * l + 1]);
        yk_gradient_take_sum(g, &mech->loops[l].sum, &by);
    }
    for (size_t r = 0; r < mech->relation_count && order > 0; r++)
        yk_gradient_take_relation(g, r, order, -g->lambda[2 * mech->loop_count + r]);
}

static void add_slopes(const YkGradient *g, double share, const double *by, double *slope)
{
    for (size_t k = 0; k < g->parameters && share != 0; k++) slope[k] += share * by[k];
}

void yk_gradient_finish(YkGradient *g, double *slope)
{
    size_t n = g->parameters;
    yk_gradient_settle_nodes(g);
    for (size_t order = YK_JET; order-- > 0;) solve_order(g, order);
    yk_gradient_settle_vectors(g);
    for (size_t i = 0; i < g->point_count; i++) {
        YkVec by = g->at_point[g->point[i]];
        add_slopes(g, by.x, g->by_point + 2 * i * n, slope);
        add_slopes(g, by.y, g->by_point + (2 * i + 1) * n, slope);
    }
    for (size_t i = 0; i < g->joint_count; i++) add_slopes(g, g->at_direction[g->joint[i]], g->by_joint + i * n, slope);
    for (size_t k = 0; k < n; k++) { // those that vary alone; then those that follow them
        double *own = &g->at_parameter[yk_redesign_parameter(g->redesign, k)];
        slope[k] += *own;
        *own = 0;
    }
    for (size_t i = 0; i < g->model->parameter_count; i++)
        add_slopes(g, g->at_parameter[i], g->by_parameter + i * n, slope);
}
