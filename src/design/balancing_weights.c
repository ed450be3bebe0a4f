// Counterweights by least squares over a cycle.
//
// The frame is shaken by no force if the centre of mass stands still: the sum of m r over the bodies, and of the
// counterweights p e^(i phi) in the axes of their bodies, is constant. Each pose gives two equations, linear in p.
// Bodies pinned to the ground come first; the pin of any other body moves, and with it the counterweight's mass, which
// is then found by repetition. If the unit vectors of the bodies are linearly independent and suffice, the residual
// vanishes: these are the counterweights of Berkof and Lowen (1969) and of Tepper and Lowen (1972).
#include "design/balancing.h"
#include <math.h>
#include "num/dense.h"

enum { ROUNDS = 60 };

static const double vanishes = 1e-9; // of the unbalanced motion

typedef struct Weighing {
    YkArena *arena; // of all arrays
    const YkModel *model;
    YkCycle cycle;
    size_t bodies;
    YkVec *sum;   // [count]: of m r
    YkVec *e;     // [body * count + k]: body's x axis
    YkVec *pivot; // likewise: its pin
    size_t *pin;  // [body]: a joint, or YK_NOT_FOUND
    bool *on_ground;
    double *A, *b, *x, *tau;
    size_t *order;
    size_t chosen[YK_WEIGHTS_MAX], count;
    double mass[YK_WEIGHTS_MAX], size;
} Weighing;

static bool allocate(Weighing *w)
{
    size_t count = w->cycle.count, columns = 2 * YK_WEIGHTS_MAX;
    YkArena *a = w->arena = yk_arena_new();
    w->sum = yk_arena_alloc(a, count, sizeof *w->sum);
    w->e = yk_arena_alloc(a, count * w->bodies, sizeof *w->e);
    w->pivot = yk_arena_alloc(a, count * w->bodies, sizeof *w->pivot);
    w->pin = yk_arena_alloc(a, w->bodies, sizeof *w->pin);
    w->on_ground = yk_arena_alloc(a, w->bodies, sizeof *w->on_ground);
    w->A = yk_arena_alloc(a, 2 * count * columns, sizeof *w->A);
    w->b = yk_arena_alloc(a, 2 * count, sizeof *w->b);
    w->x = yk_arena_alloc(a, columns, sizeof *w->x);
    w->tau = yk_arena_alloc(a, columns, sizeof *w->tau);
    w->order = yk_arena_alloc(a, columns, sizeof *w->order);
    return !yk_arena_failed(a);
}

// Finds each body's pin: one with the ground if there is any.
static void find_pins(Weighing *w)
{
    for (size_t b = 0; b < w->bodies; b++) w->pin[b] = YK_NOT_FOUND;
    for (size_t k = 0; k < w->model->joint_count; k++) {
        const YkJoint *joint = &w->model->joints[k];
        for (int side = 0; side < 2 && joint->kind == YK_PIN; side++) {
            size_t b = (size_t)joint->body[side];
            bool is_ground = joint->body[1 - side] == 0;
            if (b == 0 || (w->pin[b] != YK_NOT_FOUND && (w->on_ground[b] || !is_ground))) continue;
            w->pin[b] = k;
            w->on_ground[b] = is_ground;
        }
    }
}

static YkStatus gather(Weighing *w, const YkState *state)
{
    YkState *moving = yk_state_new(state->mech);
    YkStatus status = moving ? yk_state_copy(moving, state) : YK_NO_MEMORY;
    for (size_t k = 0; k < w->cycle.count && status >= 0; k++) {
        status = yk_cycle_pose(&w->cycle, moving, k);
        for (size_t b = 1; b < w->bodies && status >= 0; b++) {
            const YkBody *body = &w->model->bodies[b];
            YkBodyMotion m = yk_body_motion(state->mech, &moving->space, b);
            if (body->has_mass) w->sum[k] = yk_add(w->sum[k], yk_scale(body->mass, m.at));
            w->e[b * w->cycle.count + k] = m.e;
            if (w->pin[b] == YK_NOT_FOUND) continue;
            const YkJoint *pin = &w->model->joints[w->pin[b]];
            YkVec arm = yk_sub(pin->at[pin->body[1] == (int32_t)b], yk_reference_point(w->model, b));
            w->pivot[b * w->cycle.count + k] = yk_add(m.at, yk_mul(m.e, arm));
        }
    }
    yk_state_free(moving);
    return status;
}

static YkVec mean_of(const YkVec *v, size_t count)
{
    YkVec mean = yk_vec(0, 0);
    for (size_t k = 0; k < count; k++) mean = yk_add(mean, yk_scale(1 / (double)count, v[k]));
    return mean;
}

double yk_balancing_radius(const YkModel *model, size_t joint, size_t body, double size)
{
    const YkBody *own = &model->bodies[body];
    const YkJoint *pin = &model->joints[joint];
    YkVec at = pin->at[pin->body[1] == (int32_t)body];
    double reach = 0;
    for (int32_t p = own->first_point; p < own->first_point + own->point_count; p++)
        reach = fmax(reach, yk_norm(yk_sub(model->points[p].at, at)));
    return reach > 0 ? reach / 2 : size / 10;
}

static double radius_of(const Weighing *w, size_t body)
{
    return yk_balancing_radius(w->model, w->pin[body], body, w->size);
}

// Fills b with what is to be balanced: the sum of m r of the machine and of the counterweights' masses at their pins,
// less its mean, negative. Returns its root mean square, kg m.
static double right_side(Weighing *w)
{
    size_t count = w->cycle.count;
    YkVec mean = yk_vec(0, 0);
    double square = 0;
    for (size_t k = 0; k < count; k++) {
        YkVec sum = w->sum[k];
        for (size_t i = 0; i < w->count; i++)
            sum = yk_add(sum, yk_scale(w->mass[i], w->pivot[w->chosen[i] * count + k]));
        mean = yk_add(mean, yk_scale(1 / (double)count, sum));
        w->b[2 * k] = -sum.x;
        w->b[2 * k + 1] = -sum.y;
    }
    for (size_t k = 0; k < count; k++) {
        w->b[2 * k] += mean.x;
        w->b[2 * k + 1] += mean.y;
        square += w->b[2 * k] * w->b[2 * k] + w->b[2 * k + 1] * w->b[2 * k + 1];
    }
    return sqrt(square / (double)count);
}

// Solves for the chosen bodies' products with their present masses. Returns the rest that moves, kg m (RMS).
static double solve_once(Weighing *w)
{
    size_t count = w->cycle.count, n = 2 * w->count, m = 2 * count;
    right_side(w);
    for (size_t i = 0; i < w->count; i++) {
        const YkVec *e = &w->e[w->chosen[i] * count];
        YkVec mean = mean_of(e, count);
        for (size_t k = 0; k < count; k++) {
            YkVec off = yk_sub(e[k], mean);
            double *row = &w->A[2 * k * n + 2 * i];
            row[0] = off.x;
            row[1] = -off.y;
            row[n] = off.y;
            row[n + 1] = off.x;
        }
    }
    size_t rank = n > 0 ? yk_qr_factor(m, n, w->A, w->order, w->tau, 1e-10) : 0;
    if (n > 0) yk_qr_solve(m, n, w->A, w->order, w->tau, rank, w->b, w->x);
    right_side(w); // the factors took its place
    double square = 0;
    for (size_t k = 0; k < count; k++) {
        YkVec rest = yk_vec(w->b[2 * k], w->b[2 * k + 1]);
        for (size_t i = 0; i < w->count; i++) {
            const YkVec *e = &w->e[w->chosen[i] * count];
            rest = yk_sub(rest, yk_mul(yk_sub(e[k], mean_of(e, count)), yk_vec(w->x[2 * i], w->x[2 * i + 1])));
        }
        square += yk_dot(rest, rest);
    }
    return sqrt(square / (double)count);
}

// Repeats until the masses on moving pins are those of their products.
static double solve(Weighing *w)
{
    double rest = 0;
    for (size_t i = 0; i < w->count; i++) w->mass[i] = 0;
    for (int round = 0; round < ROUNDS; round++) {
        double change = 0;
        rest = solve_once(w);
        for (size_t i = 0; i < w->count; i++) {
            if (w->on_ground[w->chosen[i]]) continue;
            double mass = yk_norm(yk_vec(w->x[2 * i], w->x[2 * i + 1])) / radius_of(w, w->chosen[i]);
            change = fmax(change, fabs(mass - w->mass[i]) / (mass + 1e-300));
            w->mass[i] = mass;
        }
        if (change < 1e-14) return rest;
    }
    return rest;
}

static bool turns(const Weighing *w, size_t body)
{
    const YkVec *e = &w->e[body * w->cycle.count];
    double most = 0;
    for (size_t k = 1; k < w->cycle.count; k++) most = fmax(most, yk_norm(yk_sub(e[k], e[0])));
    return w->pin[body] != YK_NOT_FOUND && most > 1e-9;
}

// Chooses bodies: those pinned to the ground, then one after the other that which leaves least. Returns what is left.
static double choose(Weighing *w, double unbalanced)
{
    for (size_t b = 1; b < w->bodies && w->count < YK_WEIGHTS_MAX; b++)
        if (w->on_ground[b] && turns(w, b)) w->chosen[w->count++] = b;
    double rest = solve(w);
    while (rest > vanishes * unbalanced && w->count < YK_WEIGHTS_MAX) {
        size_t best = 0;
        double least = 0.99 * rest; // what helps less is not worth a counterweight
        w->count++;
        for (size_t b = 1; b < w->bodies; b++) {
            if (w->on_ground[b] || !turns(w, b)) continue;
            w->chosen[w->count - 1] = b;
            double own = solve(w);
            if (own >= least) continue;
            least = own;
            best = b;
        }
        w->chosen[w->count - 1] = best;
        if (best == 0) w->count--;
        rest = solve(w);
        if (best == 0) break;
    }
    return rest;
}

static void take_weights(const Weighing *w, YkBalancing *balancing)
{
    double largest = 0;
    for (size_t i = 0; i < w->count; i++) largest = fmax(largest, yk_norm(yk_vec(w->x[2 * i], w->x[2 * i + 1])));
    for (size_t i = 0; i < w->count; i++) {
        YkVec p = yk_vec(w->x[2 * i], w->x[2 * i + 1]);
        YkCounterweight weight = {.body = w->chosen[i], .joint = w->pin[w->chosen[i]], .product = yk_norm(p)};
        if (!(weight.product > 1e-12 * largest)) continue;
        weight.angle = yk_atan2(p.y, p.x);
        weight.radius = radius_of(w, weight.body);
        weight.mass = weight.product / weight.radius;
        balancing->weight[balancing->count++] = weight;
    }
}

YkStatus yk_balancing_weigh(const YkCycle *cycle, const YkState *state, YkBalancing *balancing)
{
    const YkModel *model = state->mech->model;
    Weighing w = {.model = model, .cycle = *cycle, .bodies = model->body_count - model->carriage_count};
    w.size = state->mech->size;
    YkStatus status = allocate(&w) ? YK_OK : YK_NO_MEMORY;
    if (status >= 0) {
        find_pins(&w);
        status = gather(&w, state);
    }
    if (status >= 0) {
        double unbalanced = right_side(&w), rest = choose(&w, unbalanced);
        balancing->is_full = rest <= vanishes * unbalanced;
        take_weights(&w, balancing);
    }
    yk_arena_free(w.arena);
    return status;
}
