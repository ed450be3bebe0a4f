// Derivatives of positions by parameters: one transposed solution of the loops for each answer.
#include "compile/gradient.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "compile/variant.h"
#include "num/dense.h"

struct YkGradient {
    const YkMechanism *mech;
    const YkModel *model;
    const YkRedesign *redesign;
    size_t parameters, variables, rows;
    // Of the design:
    int32_t *point, *joint; // points that vary; joints whose direction does
    size_t point_count, joint_count;
    double *by_point, *by_joint; // [point][x, y][parameter]; [joint][parameter]
    double *direction;           // [parameter of the model]: a change of all of them
    // Of the pose:
    YkVec *turn; // [body]
    double *x, *J, *tau;
    size_t *order;
    // Of an answer, collected backwards:
    double *by_x, *lambda;
    YkVec *at_origin, *at_point; // [body], [point]
    double *at_direction;        // [joint]: by its angle
};

bool yk_gradient_covers(YkChannel c)
{
    return c.order == 0 && c.kind <= YK_CHANNEL_POINT_Y;
}

// --- making

static bool make_room(YkGradient *g)
{
    size_t n = g->variables, m = g->rows, bodies = g->model->body_count, points = g->model->point_count,
           joints = g->model->joint_count;
    g->point = calloc(points + 1, sizeof *g->point);
    g->joint = calloc(joints + 1, sizeof *g->joint);
    g->by_point = calloc(2 * points * g->parameters + 1, sizeof *g->by_point);
    g->by_joint = calloc(joints * g->parameters + 1, sizeof *g->by_joint);
    g->direction = calloc(g->model->parameter_count + 1, sizeof *g->direction);
    g->turn = calloc(bodies + 1, sizeof *g->turn);
    g->x = calloc(n + 1, sizeof *g->x);
    g->J = calloc(m * n + 1, sizeof *g->J);
    g->tau = calloc(n + 1, sizeof *g->tau);
    g->order = calloc(n + 1, sizeof *g->order);
    g->by_x = calloc(n + 1, sizeof *g->by_x);
    g->lambda = calloc(m + n + 1, sizeof *g->lambda);
    g->at_origin = calloc(bodies + 1, sizeof *g->at_origin);
    g->at_point = calloc(points + 1, sizeof *g->at_point);
    g->at_direction = calloc(joints + 1, sizeof *g->at_direction);
    return g->point && g->joint && g->by_point && g->by_joint && g->direction && g->turn && g->x && g->J && g->tau &&
           g->order && g->by_x && g->lambda && g->at_origin && g->at_point && g->at_direction;
}

YkGradient *yk_gradient_new(const YkVariant *variant)
{
    YkGradient *g = calloc(1, sizeof *g);
    if (!g) return NULL;
    g->mech = yk_variant_mechanism(variant);
    g->model = g->mech->model;
    g->redesign = variant->redesign;
    g->parameters = yk_redesign_count(variant->redesign);
    g->variables = yk_variable_count(g->mech);
    g->rows = 2 * g->mech->loop_count + g->mech->relation_count + g->mech->input_count;
    if (!make_room(g)) {
        yk_gradient_free(g);
        return NULL;
    }
    for (size_t p = 0; p < g->model->point_count; p++)
        if (yk_redesign_point_varies(g->redesign, (int32_t)p)) g->point[g->point_count++] = (int32_t)p;
    for (size_t j = 0; j < g->model->joint_count; j++)
        if (yk_redesign_along_varies(g->redesign, (int32_t)j)) g->joint[g->joint_count++] = (int32_t)j;
    return g;
}

void yk_gradient_free(YkGradient *g)
{
    if (!g) return;
    free(g->point);
    free(g->joint);
    free(g->by_point);
    free(g->by_joint);
    free(g->direction);
    free(g->turn);
    free(g->x);
    free(g->J);
    free(g->tau);
    free(g->order);
    free(g->by_x);
    free(g->lambda);
    free(g->at_origin);
    free(g->at_point);
    free(g->at_direction);
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

static size_t distance_variable(const YkGradient *g, int32_t distance)
{
    return g->mech->orientation_count - 1 + (size_t)distance;
}

// Writes one row for each input, which does not change.
static void add_inputs(YkGradient *g, double *row)
{
    const YkMechanism *mech = g->mech;
    for (size_t i = 0; i < mech->input_count; i++, row += g->variables) {
        const YkTreeCoordinate *q = &mech->coordinates[mech->inputs[i]];
        if (q->is_distance) row[distance_variable(g, q->distance)] = 1;
        if (!q->is_distance && q->angle.b > 0) row[q->angle.b - 1] += 1;
        if (!q->is_distance && q->angle.a > 0) row[q->angle.a - 1] -= 1;
    }
}

bool yk_gradient_pose(YkGradient *g, const double *x)
{
    const YkMechanism *mech = g->mech;
    size_t n = g->variables, loops = 2 * mech->loop_count;
    double *relation = g->J + loops * n;
    memcpy(g->x, x, n * sizeof *x);
    memset(g->J, 0, g->rows * n * sizeof *g->J);
    yk_closure(mech, x, g->lambda, g->J);
    for (size_t r = 0; r < mech->relation_count; r++)
        yk_closure_relation(mech, r, x, g->lambda, relation + r * n, NULL);
    add_inputs(g, relation + mech->relation_count * n);
    for (size_t b = 0; b < g->model->body_count; b++) {
        int32_t o = mech->bodies[b].orientation;
        g->turn[b] = yk_mul(o > 0 ? yk_unit(x[o - 1]) : yk_vec(1, 0), mech->bodies[b].turn_unit);
    }
    return yk_qr_factor(g->rows, n, g->J, g->order, g->tau, 1e-10) == n;
}

// --- an answer, backwards

static void take_origin(YkGradient *g, int32_t body, YkVec by)
{
    g->at_origin[body] = yk_add(g->at_origin[body], by);
}

// Takes the share `by` of the vector from a body's origin to a point, which is `at` in its axes.
static void take_point(YkGradient *g, int32_t body, int32_t point, YkVec at, YkVec by)
{
    int32_t o = g->mech->bodies[body].orientation;
    YkVec turn = g->turn[body];
    if (o > 0) g->by_x[o - 1] += yk_dot(by, yk_quarter(yk_mul(turn, at)));
    if (point != YK_NONE) g->at_point[point] = yk_add(g->at_point[point], yk_mul(yk_conj(turn), by));
}

// Takes the share `by` of the vector from the origin of a joint's first body to that of the second.
static void take_joint(YkGradient *g, int32_t joint, YkVec by)
{
    const YkJoint *j = &g->model->joints[joint];
    int32_t d = g->mech->joint_distance[joint], o = g->mech->bodies[j->body[0]].orientation;
    take_point(g, j->body[0], j->point[0], j->at[0], by);
    take_point(g, j->body[1], j->point[1], j->at[1], yk_scale(-1, by));
    if (d == YK_NONE) return;
    size_t v = distance_variable(g, d);
    YkVec line = yk_mul(g->turn[j->body[0]], j->along);
    double turning = g->x[v] * yk_dot(by, yk_quarter(line));
    g->by_x[v] += yk_dot(by, line);
    g->at_direction[joint] += turning;
    if (o > 0) g->by_x[o - 1] += turning;
}

// Hands the shares of all origins down the tree to its root.
static void take_origins(YkGradient *g)
{
    const YkMechanism *mech = g->mech;
    for (size_t k = g->model->body_count; k-- > 0;) {
        int32_t b = mech->tree_order[k], j = mech->tree.joint[b];
        YkVec by = g->at_origin[b];
        if (mech->tree.parent[b] == YK_NONE || (by.x == 0 && by.y == 0)) continue;
        take_origin(g, mech->tree.parent[b], by);
        take_joint(g, j, g->model->joints[j].body[1] == b ? by : yk_scale(-1, by));
    }
}

// Takes the share of the error of a loop.
static void take_loop(YkGradient *g, size_t loop)
{
    int32_t joint = g->mech->loops[loop].joint;
    const YkJoint *j = &g->model->joints[joint];
    YkVec by = yk_vec(-g->lambda[2 * loop], -g->lambda[2 * loop + 1]);
    take_origin(g, j->body[0], by);
    take_origin(g, j->body[1], yk_scale(-1, by));
    take_joint(g, joint, by);
}

static void take_channel(YkGradient *g, YkWeighted part)
{
    const YkMechanism *mech = g->mech;
    YkChannel c = part.channel;
    YkJointAngle angle = {0};
    int32_t distance = YK_NONE;
    if (c.kind == YK_CHANNEL_COORDINATE) {
        const YkTreeCoordinate *q = &mech->coordinates[c.index];
        if (q->is_distance)
            distance = q->distance;
        else
            angle = q->angle;
    } else if (c.kind == YK_CHANNEL_JOINT_ANGLE) {
        angle = yk_joint_angle(mech, c.index);
    } else if (c.kind == YK_CHANNEL_BODY) {
        angle.b = mech->bodies[c.index].orientation;
    } else if (c.kind == YK_CHANNEL_JOINT_DISTANCE) {
        distance = mech->joint_distance[c.index];
    } else if (c.kind != YK_CHANNEL_TIME) {
        const YkPoint *p = &g->model->points[c.index];
        bool is_x = c.kind == YK_CHANNEL_POINT_X;
        YkVec by = yk_vec(is_x ? part.weight : 0, is_x ? 0 : part.weight);
        take_origin(g, p->body, by);
        take_point(g, p->body, c.index, p->at, by);
    }
    if (angle.b > 0) g->by_x[angle.b - 1] += part.weight;
    if (angle.a > 0) g->by_x[angle.a - 1] -= part.weight;
    if (distance != YK_NONE) g->by_x[distance_variable(g, distance)] += part.weight;
}

void yk_gradient_add(YkGradient *g, const YkWeighted *sum, size_t count, double *slope)
{
    const YkMechanism *mech = g->mech;
    size_t n = g->parameters;
    memset(g->by_x, 0, g->variables * sizeof *g->by_x);
    memset(g->at_origin, 0, g->model->body_count * sizeof *g->at_origin);
    memset(g->at_point, 0, g->model->point_count * sizeof *g->at_point);
    memset(g->at_direction, 0, g->model->joint_count * sizeof *g->at_direction);
    for (size_t k = 0; k < count; k++) take_channel(g, sum[k]);
    take_origins(g);
    yk_qr_solve_transposed(g->rows, g->variables, g->J, g->order, g->tau, g->by_x, g->lambda);
    memset(g->at_origin, 0, g->model->body_count * sizeof *g->at_origin);
    for (size_t l = 0; l < mech->loop_count; l++) take_loop(g, l);
    take_origins(g);
    for (size_t i = 0; i < g->point_count; i++) {
        YkVec by = g->at_point[g->point[i]];
        const double *x = g->by_point + 2 * i * n, *y = x + n;
        for (size_t k = 0; k < n; k++) slope[k] += by.x * x[k] + by.y * y[k];
    }
    for (size_t i = 0; i < g->joint_count; i++)
        for (size_t k = 0; k < n; k++) slope[k] += g->at_direction[g->joint[i]] * g->by_joint[i * n + k];
}
