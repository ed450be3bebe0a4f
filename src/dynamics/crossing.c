// Singular positions that the motion passes: a parallelogram flat on the line of its pivots, where two branches meet.
//
// The angle between the two columns of a dyad goes through 0 (or half a turn) there, smoothly on the branch that
// momentum takes: its sine, with its sign, is the determinant. So the sign of a stage follows from that angle as
// predicted from the last accepted step by its rate and acceleration. Next to the singular position, where the two
// unknowns are known to rounding over the sine only, accelerations are interpolated between poses before and after it
// along the motion.
#include <stdlib.h>
#include <string.h>
#include "dynamics/simulation.h"

#define NEAR_SINE2 0.06 // sin^2 from which a block is watched
#define ZONE 0.02       // sine below which accelerations are interpolated
#define WIDE 0.03       // the same, where the motion is smooth enough for it
#define SMOOTH 1e-8     // what the outermost nodes may change then, of the largest acceleration
#define BLIND 1e-4      // sine below which the pose does not tell its own rates well enough
#define NODES 8

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
    return (Direction){yk_nearest_turn(two.angle - one.angle, 0), two.rate - one.rate,
                       two.acceleration - one.acceleration};
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

// A block as it was at the last look, or NULL. Both lists go by ascending blocks: `cursor` follows.
static const YkNear *last_look(const YkSimulation *sim, size_t block, size_t *cursor)
{
    while (*cursor < sim->near_count && sim->near[*cursor].block < block) ++*cursor;
    return *cursor < sim->near_count && sim->near[*cursor].block == block ? &sim->near[*cursor] : NULL;
}

// What was predicted stands where the pose itself cannot tell.
static YkNear known_near(const YkSimulation *sim, const YkRun *run, size_t block, const YkNear *old, double t)
{
    Direction d = between_columns(run, &sim->mech->blocks[block]);
    YkNear near = {block, d.angle, d.rate, d.acceleration};
    double dt = t - sim->near_time;
    if (!old || fabs(sin(predicted(old, dt))) >= BLIND) return near;
    near.rate = old->rate + dt * old->acceleration;
    near.acceleration = old->acceleration;
    if (fabs(sin(d.angle)) < 0.1 * BLIND) near.angle = predicted(old, dt);
    return near;
}

// When the angle passed 0 or half a turn between two looks: on the quintic through angles, rates and accelerations.
static double time_of_passage(const YkNear *old, const YkNear *now, double from, double to)
{
    double h = to - from, a = old->angle, b = yk_nearest_turn(now->angle, predicted(old, h));
    double level = YK_PI * round(0.5 * (a + b) / YK_PI), low = 0, high = 1;
    for (int k = 0; k < 60; k++) {
        double s = 0.5 * (low + high), r = 1 - s;
        double value = r * r * r *
                           ((1 + 3 * s + 6 * s * s) * (a - level) +
                            s * h * ((1 + 3 * s) * old->rate + 0.5 * s * h * old->acceleration)) +
                       s * s * s *
                           ((1 + 3 * r + 6 * r * r) * (b - level) -
                            r * h * ((1 + 3 * r) * now->rate - 0.5 * r * h * now->acceleration));
        *(value * (a - level) > 0 ? &low : &high) = s;
    }
    return from + low * h;
}

static void note_passage(YkSimulation *sim, const YkNear *old, const YkNear *now, double t)
{
    if (!old || !(sin(old->angle) * sin(now->angle) < 0)) return;
    double at = time_of_passage(old, now, sim->near_time, t);
    yk_simulation_note(sim, YK_HAPPENING_CHANGE_POINT, at, sim->mech->blocks[now->block].label, 0);
}

void yk_simulation_look_near(YkSimulation *sim, double t)
{
    YkState *s = sim->state;
    size_t count = 0, cursor = 0;
    YkRun run = yk_state_run(s, &s->space);
    if (s->space.margin[0] < NEAR_SINE2 || sim->near_count > 0)
        for (size_t b = 0; b < sim->mech->block_count; b++) {
            const YkNear *old = last_look(sim, b, &cursor);
            bool is_near = has_columns(&sim->mech->blocks[b]) && s->space.block_margin[b] < NEAR_SINE2;
            if (!is_near && !old) continue;
            YkNear now = known_near(sim, &run, b, old, t);
            note_passage(sim, old, &now, t);
            if (is_near) sim->near_next[count++] = now;
        }
    YkNear *spare = sim->near;
    sim->near = sim->near_next;
    sim->near_next = spare;
    sim->near_count = count;
    sim->near_time = t;
}

// How far a block's angle may go on before it comes so close to a singular position that it must be watched.
static double way_left(Direction d)
{
    const double CLOSE = 0.12; // within the zone that is watched
    double above = d.angle < 0 ? -d.angle : YK_PI - d.angle, gap = d.rate > 0 ? above : YK_PI - above;
    if (sin(gap) * sin(gap) < NEAR_SINE2 && gap < 1) gap += YK_PI; // that one is watched
    return gap - CLOSE;
}

// The estimates of DOP853 now and then overlook a step of most of a radian that is a thousand times worse than asked
// for: half a radian at a tolerance of 1e-9 is about what good steps of turning links have.
static double longest_turn(const YkSimulation *sim)
{
    double fastest = 0;
    if (sim->options.integrator != YK_INTEGRATOR_DOP853) return HUGE_VAL;
    for (size_t k = 0; k < sim->free_count; k++) {
        bool is_distance = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].is_distance;
        if (!is_distance) fastest = fmax(fastest, fabs(sim->state->input[3 * sim->free_input[k] + 1]));
    }
    double eighth = sqrt(sqrt(sqrt(sim->options.tolerance * 1e9)));
    return fastest > 0 ? 0.5 * eighth / fastest : HUGE_VAL;
}

double yk_simulation_reach(YkSimulation *sim)
{
    double reach = HUGE_VAL;
    YkRun run = yk_state_run(sim->state, &sim->state->space);
    for (size_t b = 0; b < sim->mech->block_count; b++) {
        if (!has_columns(&sim->mech->blocks[b])) continue;
        Direction d = between_columns(&run, &sim->mech->blocks[b]);
        if (d.rate != 0 && isfinite(d.rate) && isfinite(d.angle)) reach = fmin(reach, way_left(d) / fabs(d.rate));
    }
    return fmin(reach, longest_turn(sim));
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
    return sine < WIDE;
}

// The way along which accelerations are interpolated: on with the motion; or, where that hardly leaves the singular
// position - at rest, or about to turn round - along one input, at the present time and rates.
typedef struct Way {
    int32_t input; // of the free ones; YK_NONE: with the motion
    double slope;  // of the nearest angle, per unit of the way
} Way;

// How the angle of a block goes with each free input.
static void look_along(YkSimulation *sim, double t, const double *y, const YkNear *near, Way *way)
{
    size_t n = sim->free_count;
    YkState *s = sim->state;
    if (!yk_simulation_set(sim, t, y)) return;
    double most = 0;
    for (size_t k = 0; k < n; k++) {
        for (size_t i = 0; i < sim->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
        s->input[3 * sim->free_input[k] + 1] = 1;
        if (yk_state_solve(s) < 0 || !s->has_rates) return;
        YkRun run = yk_state_run(s, &s->space);
        double slope = between_columns(&run, &sim->mech->blocks[near->block]).rate;
        double scale = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].is_distance ? sim->mech->size : 1;
        if (!(fabs(slope) * scale > most)) continue;
        most = fabs(slope) * scale;
        *way = (Way){(int32_t)k, slope};
    }
}

static Way find_way(YkSimulation *sim, double t, const double *y, const YkNear *near)
{
    double rate = near->rate + (t - sim->near_time) * near->acceleration;
    Way way = {YK_NONE, rate};
    if (rate * rate < 10 * ZONE * fabs(near->acceleration) || rate == 0) look_along(sim, t, y, near, &way);
    return way;
}

// Accelerations at the inputs moved on by `ahead` along the way.
static bool sample(YkSimulation *sim, double t, const double *y, const YkNear *near, const Way *way, double ahead,
                   double *dydt)
{
    size_t n = sim->free_count;
    double *moved = sim->moved, angle = predicted(near, t - sim->near_time) + ahead * way->slope;
    memcpy(moved, y, (2 * n + sim->work_count) * sizeof *moved);
    for (size_t k = 0; k < n && way->input == YK_NONE; k++) moved[k] += ahead * y[n + k];
    if (way->input != YK_NONE) moved[way->input] += ahead;
    if (!yk_simulation_set(sim, way->input == YK_NONE ? t + ahead : t, moved)) return false;
    sim->state->branch[near->block] = sin(angle) < 0 ? -1 : 1;
    YkStatus status = yk_simulation_accelerate(sim);
    if (status < 0 || status == YK_SINGULAR) {
        sim->report = sim->dynamics->report;
        return false;
    }
    for (size_t k = 0; k < n; k++) dydt[n + k] = sim->dynamics->acceleration[sim->free_input[k]];
    yk_simulation_powers(sim, dydt + 2 * n);
    return true;
}

// Lagrange's weights at 0 of nodes [first, last), 0 for the others.
static void weigh(const double *node, int first, int last, double *weight)
{
    for (int j = 0; j < NODES; j++) {
        weight[j] = j >= first && j < last ? 1 : 0;
        for (int k = first; k < last; k++)
            if (k != j) weight[j] *= node[k] / (node[k] - node[j]);
    }
}

// Where the nodes stand: on both sides of the singular position, `apart` from it and from each other.
typedef struct Fit {
    const YkNear *near;
    Way way;
    double center, apart;
} Fit;

// Interpolates into dydt. *off: what the outermost nodes change in an acceleration, over the largest one.
static bool interpolate(YkSimulation *sim, double t, const double *y, const Fit *fit, double *dydt, double *off)
{
    size_t n = sim->free_count, all = 2 * n + sim->work_count;
    double node[NODES], weight[NODES], inner[NODES], most = 0, change = 0;
    for (int j = 0; j < NODES; j++)
        node[j] = fit->center + fit->apart * (j < NODES / 2 ? j - NODES / 2 : j - NODES / 2 + 1);
    weigh(node, 0, NODES, weight);
    weigh(node, 1, NODES - 1, inner);
    memset(dydt, 0, all * sizeof *dydt);
    for (int j = 0; j < NODES; j++) {
        if (!sample(sim, t, y, fit->near, &fit->way, node[j], sim->sampled)) return false;
        for (size_t k = n; k < all; k++) dydt[k] += weight[j] * sim->sampled[k];
        for (size_t k = 0; k < n; k++) {
            dydt[k] += (weight[j] - inner[j]) * sim->sampled[n + k];
            most = fmax(most, fabs(sim->sampled[n + k]));
        }
    }
    for (size_t k = 0; k < n; k++) change = fmax(change, fabs(dydt[k]));
    *off = most > 0 ? change / most : 0;
    memcpy(dydt, y + n, n * sizeof *dydt);
    dydt[all - 1] = 0;
    return true;
}

YkInterpolation yk_simulation_interpolate(YkSimulation *sim, double t, const double *y, double *dydt)
{
    double sine, off;
    Fit fit = {.near = nearest(sim, t, &sine)};
    fit.way = find_way(sim, t, y, fit.near);
    double angle = predicted(fit.near, t - sim->near_time), gap = asin(sin(angle)) * (cos(angle) < 0 ? -1 : 1);
    fit.center = -gap / fit.way.slope;
    fit.apart = 1.7 * WIDE / fabs(fit.way.slope);
    bool has_way = isfinite(fit.center) && isfinite(fit.apart);
    if (!has_way && sine < ZONE) {
        sim->report = sim->state->report;
        return YK_INTERPOLATION_FAILED;
    }
    if (has_way && interpolate(sim, t, y, &fit, dydt, &off) && off <= SMOOTH) return YK_INTERPOLATION_DONE;
    sim->report.message[0] = 0;
    if (sine >= ZONE) return YK_INTERPOLATION_LEFT;
    fit.apart = 1.7 * ZONE / fabs(fit.way.slope);
    return interpolate(sim, t, y, &fit, dydt, &off) ? YK_INTERPOLATION_DONE : YK_INTERPOLATION_FAILED;
}
