// Singular positions that the motion passes: a parallelogram flat on the line of its pivots, where two branches meet.
//
// The angle between the two columns of a dyad goes through 0 (or half a turn) there, smoothly on the branch that momentum
// takes: its sine, with its sign, is the determinant. So the sign of a stage follows from that angle as predicted from the
// last accepted step by its rate and acceleration. Next to the singular position, where the two unknowns are known to
// rounding over the sine only, accelerations are interpolated between poses before and after it along the motion.
#include <stdlib.h>
#include <string.h>
#include "dynamics/simulation.h"

#define NEAR_SINE2 0.06 // sin^2 from which a block is watched
#define ZONE 0.02       // sine below which accelerations are interpolated
#define NODES 6

typedef struct Direction {
    double angle, rate, acceleration;
} Direction;

static Direction of_plane(YkPlane p)
{
    double x = p.x[0], y = p.y[0], vx = p.vx[0], vy = p.vy[0], r2 = x * x + y * y;
    double rate = (x * vy - y * vx) / r2;
    return (Direction){yk_atan2(y, x), rate, (x * p.ay[0] - y * p.ax[0]) / r2 - 2 * (x * vx + y * vy) / r2 * rate};
}

static Direction turned(Direction d, const YkSpace *space, int32_t slot)
{
    if (slot == 0) return d;
    YkTurn t = yk_space_turn(space, slot);
    return (Direction){d.angle + yk_atan2(t.s[0], t.c[0]), d.rate + t.w[0], d.acceleration + t.a[0]};
}

static Direction of_vector(YkVec v)
{
    return (Direction){yk_atan2(v.y, v.x), 0, 0};
}

static Direction of_sum(const YkRun *run, const YkSum *sum)
{
    YkPlane p = yk_space_scratch(run->space, YK_SCRATCH_ARM_1);
    yk_run_sum(run, sum, p);
    return of_plane(p);
}

static Direction of_arm(const YkRun *run, const YkBlock *b, int k)
{
    Direction d = b->arm_is_constant[k] ? of_vector(b->arm[k].constant) : of_sum(run, &b->arm[k]);
    return turned(d, run->space, b->column[b->kind == YK_BLOCK_RRR ? k : 0].index);
}

// From the block's first column to its second, as the kernels order them.
static Direction between_columns(const YkRun *run, const YkBlock *b)
{
    Direction one, two;
    if (b->kind == YK_BLOCK_RRR) {
        one = of_arm(run, b, 0);
        two = of_arm(run, b, 1);
    } else {
        one = turned(of_vector(b->line[0]), run->space, b->line_slot[0]);
        if (b->kind == YK_BLOCK_RRP) {
            two = of_arm(run, b, 0);
            two.angle += YK_PI / 2;
        } else {
            one = turned(one, run->space, b->column[0].index);
            two = of_sum(run, &b->known);
            two.angle -= YK_PI / 2; // i p, p = -K
        }
    }
    return (Direction){yk_nearest_turn(two.angle - one.angle, 0), two.rate - one.rate, two.acceleration - one.acceleration};
}

static bool has_columns(const YkBlock *b)
{
    return b->kind <= YK_BLOCK_RPR;
}

double yk_simulation_margin(const YkSimulation *sim)
{
    return sim->state->space.margin[0];
}

static double predicted(const YkNear *near, double dt)
{
    return near->angle + dt * (near->rate + 0.5 * dt * near->acceleration);
}

// What was predicted stands where the pose itself cannot tell.
static YkNear known_near(const YkSimulation *sim, const YkRun *run, size_t block, double t)
{
    Direction d = between_columns(run, &sim->mech->blocks[block]);
    YkNear near = {block, d.angle, d.rate, d.acceleration};
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *old = &sim->near[k];
        double dt = t - sim->near_time;
        if (old->block != block || fabs(sin(predicted(old, dt))) >= ZONE) continue;
        near.rate = old->rate + dt * old->acceleration;
        near.acceleration = old->acceleration;
        if (fabs(sin(d.angle)) < 1e-5) near.angle = predicted(old, dt);
    }
    return near;
}

void yk_simulation_look_near(YkSimulation *sim, double t)
{
    YkState *s = sim->state;
    size_t count = 0;
    YkRun run = yk_state_run(s, &s->space);
    if (s->space.margin[0] < NEAR_SINE2)
        for (size_t b = 0; b < sim->mech->block_count; b++) {
            if (!has_columns(&sim->mech->blocks[b]) || !(s->space.block_margin[b] < NEAR_SINE2)) continue;
            sim->near_next[count++] = known_near(sim, &run, b, t);
        }
    YkNear *spare = sim->near;
    sim->near = sim->near_next;
    sim->near_next = spare;
    sim->near_count = count;
    sim->near_time = t;
}

void yk_simulation_set_signs(YkSimulation *sim, double t)
{
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *near = &sim->near[k];
        sim->state->branch[near->block] = sin(predicted(near, t - sim->near_time)) < 0 ? -1 : 1;
    }
}

// The near block whose sine is least at time t, and that sine.
static const YkNear *nearest(const YkSimulation *sim, double t, double *sine)
{
    const YkNear *found = NULL;
    *sine = 2;
    for (size_t k = 0; k < sim->near_count; k++) {
        double s = fabs(sin(predicted(&sim->near[k], t - sim->near_time)));
        if (s >= *sine) continue;
        *sine = s;
        found = &sim->near[k];
    }
    return found;
}

bool yk_simulation_in_zone(const YkSimulation *sim, double t)
{
    double sine;
    nearest(sim, t, &sine);
    return sine < ZONE;
}

// Accelerations at the inputs moved on by `ahead` seconds at their present rates.
static bool sample(YkSimulation *sim, double t, const double *y, double ahead, double *dydt)
{
    size_t n = sim->free_count;
    double *moved = sim->moved;
    memcpy(moved, y, (2 * n + sim->work_count) * sizeof *moved);
    for (size_t k = 0; k < n; k++) moved[k] += ahead * y[n + k];
    if (!yk_simulation_set(sim, t + ahead, moved)) return false;
    YkStatus status = yk_simulation_accelerate(sim);
    if (status < 0 || status == YK_SINGULAR) {
        sim->report = sim->dynamics->report;
        return false;
    }
    for (size_t k = 0; k < n; k++) dydt[n + k] = sim->dynamics->acceleration[sim->free_input[k]];
    yk_simulation_powers(sim, dydt + 2 * n);
    return true;
}

bool yk_simulation_interpolate(YkSimulation *sim, double t, const double *y, double *dydt)
{
    size_t n = sim->free_count, all = 2 * n + sim->work_count;
    double sine;
    const YkNear *near = nearest(sim, t, &sine);
    double dt = t - sim->near_time, rate = near->rate + dt * near->acceleration;
    double angle = predicted(near, dt), off = asin(sin(angle)) * (cos(angle) < 0 ? -1 : 1);
    double center = -off / rate, h = 1.7 * ZONE / fabs(rate), node[NODES], weight[NODES];
    if (!isfinite(center) || !isfinite(h)) return false;
    for (int j = 0; j < NODES; j++) node[j] = center + h * (j < NODES / 2 ? j - NODES / 2 : j - NODES / 2 + 1);
    for (int j = 0; j < NODES; j++) { // Lagrange's weights at 0
        weight[j] = 1;
        for (int k = 0; k < NODES; k++)
            if (k != j) weight[j] *= node[k] / (node[k] - node[j]);
    }
    memset(dydt, 0, all * sizeof *dydt);
    for (int j = 0; j < NODES; j++) {
        if (!sample(sim, t, y, node[j], sim->sampled)) return false;
        for (size_t k = n; k < all; k++) dydt[k] += weight[j] * sim->sampled[k];
    }
    memcpy(dydt, y + n, n * sizeof *dydt);
    dydt[all - 1] = 0;
    return true;
}
