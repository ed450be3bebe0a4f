// Counterweights that compromise between shaking force, shaking moment and the input's effort.
//
// A counterweight of product p, as a vector in the axes of a body that turns about a pin P of the ground with w and a,
// has the inertia force -(i a - w^2) e p at radius rho from P, and |p| rho a about P. Misses are linear in p and |p|.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "design/balancing.h"
#include "num/dense.h"

enum { PER_POSE = 4, N_MAX = 2 * YK_WEIGHTS_MAX, STEPS = 200 }; // force x, y, moment, effort

typedef struct Compromise {
    const YkCycle *cycle;
    const YkModel *model;
    size_t body[YK_WEIGHTS_MAX], joint[YK_WEIGHTS_MAX], count, rows;
    double radius[YK_WEIGHTS_MAX];
    double *miss;  // [rows]: without counterweights
    double *by;    // [rows][3 * count]: by x, y and size of each product
    double *A, *b; // scratch: [rows + N_MAX][n], [rows + N_MAX]
    double p[N_MAX];
    bool is_left_out[YK_WEIGHTS_MAX]; // its product stays 0
} Compromise;

static void find_bodies(Compromise *c, double size)
{
    for (size_t k = 0; k < c->model->joint_count; k++) {
        const YkJoint *joint = &c->model->joints[k];
        bool is_pin = joint->kind == YK_PIN && !joint->is_free && (joint->body[0] == 0) != (joint->body[1] == 0);
        if (!is_pin || c->count == YK_WEIGHTS_MAX) continue;
        c->body[c->count] = (size_t)(joint->body[0] == 0 ? joint->body[1] : joint->body[0]);
        c->joint[c->count] = k;
        c->radius[c->count] = yk_balancing_radius(c->model, k, c->body[c->count], size);
        c->count++;
    }
}

// Adds what unit products of one counterweight do at a pose: by x, y and size.
static void add_effects(Compromise *c, const YkState *state, size_t k, size_t i)
{
    YkBodyMotion m = yk_body_motion(state->mech, &state->space, c->body[i]);
    const YkJoint *joint = &c->model->joints[c->joint[i]];
    int side = joint->body[1] == (int32_t)c->body[i];
    YkVec at = yk_add(m.at, yk_mul(m.e, yk_sub(joint->at[side], yk_reference_point(c->model, c->body[i]))));
    YkVec arm = yk_sub(at, yk_cycle_pivot(state));
    for (int axis = 0; axis < 2; axis++) {
        YkVec e = axis == 0 ? m.e : yk_quarter(m.e),
              force = yk_sub(yk_scale(m.w * m.w, e), yk_scale(m.a, yk_quarter(e)));
        double *column = &c->by[PER_POSE * k * 3 * c->count + 3 * i + (size_t)axis];
        column[0] = force.x;
        column[3 * c->count] = force.y;
        column[6 * c->count] = yk_cross(arm, force);
        column[9 * c->count] = -m.w * yk_dot(c->model->gravity, yk_quarter(e)) / c->cycle->rate;
    }
    double *column = &c->by[PER_POSE * k * 3 * c->count + 3 * i + 2];
    column[6 * c->count] = -c->radius[i] * m.a;
    column[9 * c->count] = c->radius[i] * m.a * m.w / c->cycle->rate;
}

static YkStatus gather(Compromise *c, const YkState *state, const double *torques)
{
    YkState *moving = yk_state_new(state->mech);
    YkStatus status = moving ? yk_state_copy(moving, state) : YK_NO_MEMORY;
    for (size_t k = 0; k < c->cycle->count && status >= 0; k++) {
        status = yk_cycle_pose(c->cycle, moving, k);
        if (status < 0) break;
        double *miss = &c->miss[PER_POSE * k];
        YkVec force = yk_cycle_shaking(moving, &miss[2]);
        miss[0] = force.x;
        miss[1] = force.y;
        miss[3] = torques[k];
        for (size_t i = 0; i < c->count; i++) add_effects(c, moving, k, i);
    }
    yk_state_free(moving);
    return status;
}

// Weighs the rows: each kind over its mean square before. A kind that is absent does not count.
static void weigh(Compromise *c, const double weight[3])
{
    static const int kind[PER_POSE] = {0, 0, 1, 2};
    double square[3] = {0};
    for (size_t r = 0; r < c->rows; r++) square[kind[r % PER_POSE]] += c->miss[r] * c->miss[r];
    for (size_t r = 0; r < c->rows; r++) {
        int own = kind[r % PER_POSE];
        double factor = square[own] > 0 ? sqrt(weight[own] / square[own]) : 0;
        c->miss[r] *= factor;
        for (size_t j = 0; j < 3 * c->count; j++) c->by[r * 3 * c->count + j] *= factor;
    }
}

// Fills b with the misses, negative, and A with their derivatives (unless it is NULL). Returns the sum of squares.
static double misses(const Compromise *c, const double *p, double *b, double *A)
{
    double sum = 0;
    size_t n = 2 * c->count;
    for (size_t r = 0; r < c->rows; r++) {
        double miss = c->miss[r];
        for (size_t i = 0; i < c->count; i++) {
            const double *by = &c->by[(r * c->count + i) * 3], *own = &p[2 * i];
            double size = yk_hypot(own[0], own[1]);
            miss += by[0] * own[0] + by[1] * own[1] + by[2] * size;
            for (size_t axis = 0; axis < 2 && A; axis++)
                A[r * n + 2 * i + axis] = c->is_left_out[i] ? 0 : by[axis] + (size > 0 ? by[2] * own[axis] / size : 0);
        }
        b[r] = -miss;
        sum += miss * miss;
    }
    return sum;
}

// One damped step from p. Returns false if there is none that helps.
static bool step(Compromise *c, double *damping, double *sum)
{
    double x[N_MAX], tau[N_MAX], next[N_MAX];
    size_t order[N_MAX], n = 2 * c->count, rows = c->rows + n;
    for (; *damping < 1e6; *damping = fmax(10 * *damping, 1e-12)) {
        double scale[N_MAX] = {0};
        misses(c, c->p, c->b, c->A);
        for (size_t r = 0; r < c->rows; r++)
            for (size_t j = 0; j < n; j++) scale[j] += c->A[r * n + j] * c->A[r * n + j];
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++) c->A[(c->rows + i) * n + j] = i == j ? sqrt(*damping * scale[j]) : 0;
        for (size_t i = 0; i < n; i++) c->b[c->rows + i] = 0;
        size_t rank = yk_qr_factor(rows, n, c->A, order, tau, 1e-12);
        yk_qr_solve(rows, n, c->A, order, tau, rank, c->b, x);
        for (size_t j = 0; j < n; j++) next[j] = c->p[j] + x[j];
        double then = misses(c, next, c->b, NULL);
        if (!(then < *sum)) continue;
        bool goes_on = then < *sum * (1 - 1e-15);
        for (size_t j = 0; j < n; j++) c->p[j] = next[j];
        *sum = then;
        *damping *= 0.1;
        return goes_on;
    }
    return false;
}

static double improve(Compromise *c)
{
    double damping = 0, sum = misses(c, c->p, c->b, NULL);
    for (size_t k = 0; k < STEPS && step(c, &damping, &sum); k++) {}
    return sum;
}

// Finds the products. At 0 a product's size has an edge, on which the least may lie: each counterweight is left out
// where that is better.
static void find_products(Compromise *c)
{
    double sum = improve(c);
    for (size_t i = 0; i < c->count; i++) {
        double before[N_MAX];
        memcpy(before, c->p, sizeof before);
        c->is_left_out[i] = true;
        c->p[2 * i] = c->p[2 * i + 1] = 0;
        double then = improve(c);
        if (then < sum) {
            sum = then;
            continue;
        }
        c->is_left_out[i] = false;
        memcpy(c->p, before, sizeof before);
    }
}

static void take_weights(const Compromise *c, YkBalancing *balancing)
{
    double largest = 0;
    for (size_t i = 0; i < c->count; i++) largest = fmax(largest, yk_hypot(c->p[2 * i], c->p[2 * i + 1]));
    for (size_t i = 0; i < c->count; i++) {
        YkCounterweight w = {.body = c->body[i], .joint = c->joint[i], .radius = c->radius[i]};
        w.product = yk_hypot(c->p[2 * i], c->p[2 * i + 1]);
        w.angle = yk_atan2(c->p[2 * i + 1], c->p[2 * i]);
        w.mass = w.product / w.radius;
        if (w.product > 1e-9 * largest) balancing->weight[balancing->count++] = w;
    }
}

YkStatus yk_balancing_compromise(const YkCycle *cycle, const YkState *state, const double *torques,
                                 const double weight[3], YkBalancing *balancing)
{
    Compromise c = {.cycle = cycle, .model = state->mech->model, .rows = PER_POSE * cycle->count};
    find_bodies(&c, state->mech->size);
    if (c.count == 0) return YK_OK;
    c.miss = calloc(c.rows, sizeof *c.miss);
    c.by = calloc(c.rows * 3 * c.count, sizeof *c.by);
    c.A = calloc((c.rows + N_MAX) * 2 * c.count, sizeof *c.A);
    c.b = calloc(c.rows + N_MAX, sizeof *c.b);
    YkStatus status = c.miss && c.by && c.A && c.b ? gather(&c, state, torques) : YK_NO_MEMORY;
    if (status >= 0) {
        weigh(&c, weight);
        find_products(&c);
        take_weights(&c, balancing);
    }
    free(c.miss);
    free(c.by);
    free(c.A);
    free(c.b);
    return status;
}
