// Interpolates accelerations next to a singular position between poses before and after it along the motion.
#include <string.h>
#include "elementary/elementary.h"
#include "simulate/crossing.h"

#define SMOOTH 1e-8 // where the motion is smooth: share of the largest acceleration that the outermost nodes may change
#define NODES 8

// Sines below which accelerations are interpolated, by nodes about as far away: the wider, the less rounding.
static const double ZONES[] = {0.03, 0.02, 0.01};

// Returns the near block whose sine is least at time t, and that sine.
static const YkNear *nearest(const YkSimulation *sim, double t, double *sine)
{
    const YkNear *found = NULL;
    *sine = 2;
    for (size_t k = 0; k < sim->near_count && !sim->keeps_apart; k++) {
        double s = fabs(yk_sin(yk_near_angle(&sim->near[k], t - sim->near_time)));
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
    return sine < ZONES[0];
}

// The way along which accelerations are interpolated: with the motion; or along one input, at the present time and
// rates, if the motion hardly leaves the singular position (at rest, or about to reverse).
typedef struct Way {
    int32_t input; // YK_NONE: with the motion
    double slope;  // of the nearest angle, per unit of the way
} Way;

// Finds how the angle of a block changes with each free input.
static void look_along(YkSimulation *sim, double t, const double *y, const YkNear *near, Way *way)
{
    size_t n = sim->free_count;
    YkState *s = sim->state;
    if (!yk_simulation_set(sim, t, y)) return;
    double most = 0;
    for (size_t k = 0; k < n; k++) {
        for (size_t i = 0; i < sim->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
        s->input[3 * sim->free_input[k] + 1] = 1;
        bool has_rates =
            yk_state_solve(s) >= 0 && (s->is_regular || s->space.margin[0] > YK_SINGULAR_MARGIN); // two digits suffice
        if (!has_rates && sim->is_flat) *way = (Way){sim->free_input[0], sim->flat_slope};        // the start itself
        if (!has_rates) return;
        YkRun run = yk_state_run(s, &s->space);
        double slope = yk_between_columns(&run, &sim->mech->blocks[near->block]).rate;
        if (!(fabs(slope) * yk_simulation_input_scale(sim, k) > most)) continue;
        most = fabs(slope) * yk_simulation_input_scale(sim, k);
        *way = (Way){sim->free_input[k], slope};
    }
}

// Does the same where drives determine the motion, and only one input moves: from the rates of both, since near the
// singular position the pose shows nothing, and time leads only to one side of it if the drive turns back there.
static void look_along_drive(YkSimulation *sim, double t, const double *y, const YkNear *near, Way *way)
{
    YkState *s = sim->state;
    if (!yk_simulation_set(sim, t, y)) return;
    size_t moving = 0, count = 0;
    for (size_t i = 0; i < sim->mech->input_count; i++) {
        if (s->input[3 * i + 1] == 0 && s->input[3 * i + 2] == 0) continue;
        moving = i;
        count++;
    }
    double v = s->input[3 * moving + 1], a = s->input[3 * moving + 2];
    double rate = near->rate + (t - sim->near_time) * near->acceleration;
    if (count == 1) *way = (Way){(int32_t)moving, (rate * v + near->acceleration * a) / (v * v + a * a)};
}

static Way find_way(YkSimulation *sim, double t, const double *y, const YkNear *near)
{
    double rate = near->rate + (t - sim->near_time) * near->acceleration;
    Way way = {YK_NONE, rate};
    bool turns_round = rate * rate < 2 * 0.1 * fabs(near->acceleration); // within 0.1 rad
    if (turns_round || rate == 0) (sim->free_count > 0 ? look_along : look_along_drive)(sim, t, y, near, &way);
    return way;
}

// Moves the inputs by `ahead` along the way, and sets the sign that the block has there.
static bool move(YkSimulation *sim, double t, const double *y, const YkNear *near, const Way *way, double ahead)
{
    size_t n = sim->free_count;
    double *moved = sim->moved, angle = yk_near_angle(near, t - sim->near_time) + ahead * way->slope;
    memcpy(moved, y, (2 * n + sim->work_count) * sizeof *moved);
    for (size_t k = 0; k < n && way->input == YK_NONE; k++) moved[k] += ahead * y[n + k];
    if (!yk_simulation_set(sim, way->input == YK_NONE ? t + ahead : t, moved)) return false;
    if (way->input != YK_NONE) sim->state->input[3 * way->input] += ahead;
    sim->state->branch[near->block] = yk_sin(angle) < 0 ? -1 : 1;
    return true;
}

// Computes accelerations at the inputs moved by `ahead` along the way.
static bool sample(YkSimulation *sim, double t, const double *y, const YkNear *near, const Way *way, double ahead,
                   double *dydt)
{
    size_t n = sim->free_count;
    if (!move(sim, t, y, near, way, ahead)) return false;
    YkStatus status = yk_simulation_accelerate(sim);
    if (status < 0 || status == YK_SINGULAR) {
        sim->report = sim->dynamics->report;
        return false;
    }
    for (size_t k = 0; k < n; k++) dydt[n + k] = sim->dynamics->acceleration[sim->free_input[k]];
    yk_simulation_powers(sim, dydt + 2 * n);
    return true;
}

// Computes Lagrange's weights at 0 for nodes [first, last), 0 for the others.
static void weigh(const double *node, int first, int last, double *weight)
{
    for (int j = 0; j < NODES; j++) {
        weight[j] = j >= first && j < last ? 1 : 0;
        for (int k = first; k < last; k++)
            if (k != j) weight[j] *= node[k] / (node[k] - node[j]);
    }
}

// The places of the nodes: on both sides of the singular position, `apart` from it and from each other.
typedef struct Fit {
    const YkNear *near;
    Way way;
    double center, apart;
} Fit;

static void place_nodes(const Fit *fit, double *node)
{
    for (int j = 0; j < NODES; j++)
        node[j] = fit->center + fit->apart * (j < NODES / 2 ? j - NODES / 2 : j - NODES / 2 + 1);
}

// Places the nodes around the singular position next to (t, y); returns false if no way leads through it.
static bool find_fit(YkSimulation *sim, double t, const double *y, Fit *fit)
{
    double sine;
    fit->near = nearest(sim, t, &sine);
    fit->way = find_way(sim, t, y, fit->near);
    double angle = yk_near_angle(fit->near, t - sim->near_time),
           gap = yk_asin(yk_sin(angle)) * (yk_cos(angle) < 0 ? -1 : 1);
    fit->center = -gap / fit->way.slope;
    return isfinite(fit->center) && isfinite(1 / fit->way.slope);
}

// Interpolates into dydt. Returns what the outermost nodes change in an acceleration, over the largest one; INFINITY if
// a node has none.
static double interpolate(YkSimulation *sim, double t, const double *y, const Fit *fit, double *dydt)
{
    size_t n = sim->free_count, all = 2 * n + sim->work_count;
    double node[NODES], weight[NODES], inner[NODES], most = 0, change = 0;
    place_nodes(fit, node);
    weigh(node, 0, NODES, weight);
    weigh(node, 1, NODES - 1, inner);
    memset(dydt, 0, all * sizeof *dydt);
    for (int j = 0; j < NODES; j++) {
        if (!sample(sim, t, y, fit->near, &fit->way, node[j], sim->sampled)) return INFINITY;
        for (size_t k = n; k < all; k++) dydt[k] += weight[j] * sim->sampled[k];
        for (size_t k = 0; k < n; k++) {
            dydt[k] += (weight[j] - inner[j]) * sim->sampled[n + k];
            most = fmax(most, fabs(sim->sampled[n + k]));
        }
    }
    for (size_t k = 0; k < n; k++) change = fmax(change, fabs(dydt[k]));
    memcpy(dydt, y + n, n * sizeof *dydt);
    dydt[all - 1] = 0;
    return most > 0 ? change / most : 0;
}

// Interpolates with nodes ever nearer, until the motion is smooth enough there; otherwise with those that fitted best.
YkInterpolation yk_simulation_interpolate(YkSimulation *sim, double t, const double *y, double *dydt)
{
    double sine, off = INFINITY, least = INFINITY;
    Fit fit, best;
    bool has_way = find_fit(sim, t, y, &fit);
    best = fit;
    nearest(sim, t, &sine);
    if (!has_way) sim->report = sim->state->report;
    for (size_t k = 0; k < sizeof ZONES / sizeof *ZONES && !(off <= SMOOTH); k++) {
        if (sine >= ZONES[k]) {
            sim->report.message[0] = 0;
            return YK_INTERPOLATION_LEFT;
        }
        fit.apart = 1.7 * ZONES[k] / fabs(fit.way.slope);
        off = has_way ? interpolate(sim, t, y, &fit, dydt) : INFINITY;
        if (!(off < least)) continue;
        least = off;
        best = fit;
    }
    if (least == INFINITY) return YK_INTERPOLATION_FAILED;
    sim->report.message[0] = 0;
    if (off > least) interpolate(sim, t, y, &best, dydt);
    return YK_INTERPOLATION_DONE;
}

// --- poses

static const double POSE_BLIND = 0.01; // sine, as predicted, below which a pose is interpolated too

// Returns how many numbers a pose has without the ground's: turns, slides and nodes, with their rates.
static size_t pose_count(const YkSpace *space)
{
    return 4 * (space->slots - 1) + 3 * space->distances + 6 * space->nodes;
}

static void set_accelerations(YkSimulation *sim, const double *acceleration)
{
    for (size_t k = 0; k < sim->free_count; k++) sim->state->input[3 * sim->free_input[k] + 2] = acceleration[k];
}

// Sums up the poses at the nodes. The rates and accelerations of the inputs are those of (t, y) at all of them, so that
// the result for (t, y) has them too.
static bool sum_poses(YkSimulation *sim, double t, const double *y, const double *acceleration, const Fit *fit)
{
    YkState *s = sim->state;
    double node[NODES], weight[NODES], *sum = sim->pose_sum;
    size_t count = pose_count(&s->space);
    place_nodes(fit, node);
    weigh(node, 0, NODES, weight);
    memset(sum, 0, count * sizeof *sum);
    for (int j = 0; j < NODES; j++) {
        if (!move(sim, t, y, fit->near, &fit->way, node[j])) return false;
        set_accelerations(sim, acceleration);
        if (yk_state_solve(s) < 0 || !s->has_rates) return false;
        const double *pose = s->space.data + 4;
        for (size_t k = 0; k < count; k++) sum[k] += weight[j] * pose[k];
    }
    return true;
}

bool yk_simulation_sum_poses(YkSimulation *sim, double t, const double *y, const double *acceleration)
{
    double sine;
    Fit fit;
    if (sim->near_count == 0) return false;
    nearest(sim, t, &sine);
    if (sine >= POSE_BLIND || !find_fit(sim, t, y, &fit)) return false;
    fit.apart = 1.7 * ZONES[2] / fabs(fit.way.slope);
    return sum_poses(sim, t, y, acceleration, &fit);
}

// Returns whether the loops close in a pose that is a sum, as exactly as interpolation can make it.
static bool closes(YkState *s)
{
    const double MOST = 1e-7; // of the size
    return yk_state_gap(s) <= MOST * s->mech->size;
}

bool yk_simulation_take_sum(YkSimulation *sim)
{
    YkState *s = sim->state;
    memcpy(s->space.data + 4, sim->pose_sum, pose_count(&s->space) * sizeof *sim->pose_sum);
    for (size_t k = 1; k < s->space.slots; k++) {
        YkTurn t = yk_space_turn(&s->space, (int32_t)k);
        double per = 1 / yk_hypot(*t.c, *t.s);
        *t.c *= per, *t.s *= per;
    }
    s->has_rates = true;
    return closes(s);
}
