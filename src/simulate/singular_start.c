// Starts in a singular pose. A dead point of the intended starting coordinates is not one of other coordinates. A
// change point, where a linkage lies flat and two branches meet, is left as the rates of `start:` say. At rest it is
// left as the accelerations say, if they do: the machine moves from rest along one of the branches only if the loads
// push it along that branch, and its joint forces stay finite there.
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "elementary/elementary.h"
#include "simulate/crossing.h"

// A branch through the pose: the coordinates' rates for a unit rate of the free input, and the angle between the
// columns of the singular block.
typedef struct Branch {
    int sign; // of the block ahead; behind it has the other
    double *tangent;
    double level, slope; // of the angle: its value at the pose, and its derivative by the input
    double acceleration; // from rest
    bool is_finite;      // its joint forces are finite, too
} Branch;

bool yk_simulation_is_singular(const YkSimulation *sim)
{
    return !sim->state->has_rates;
}

// --- other coordinates

// Exchanges coordinates one by one until the pose is not singular. Returns false if a machine could not be made.
static bool try_others(YkSimulation *sim, size_t *order)
{
    enum { TRIALS_MAX = 400 };
    size_t n = sim->mech->coordinate_count, f = sim->free_count, trials = 0;
    size_t *own = order + f;
    for (size_t k = 0; k < f; k++) own[k] = (size_t)sim->mech->inputs[sim->free_input[k]];
    for (size_t c = 0; c < n; c++)
        for (size_t k = 0; k < f && trials < TRIALS_MAX; k++) {
            bool is_free = sim->mech->coordinates[c].drive == YK_NONE, changed = false;
            for (size_t j = 0; j < f; j++) is_free = is_free && own[j] != c;
            if (!is_free) continue;
            memcpy(order, own, f * sizeof *order);
            order[k] = c;
            trials++;
            if (!yk_simulation_take(sim, order, &changed)) return false;
            if (changed && yk_state_solve(sim->state) >= 0 && yk_simulation_margin(sim) > 1e-4) return true;
        }
    bool changed;
    return yk_simulation_take(sim, own, &changed);
}

// --- two branches

// Returns the one singular block; YK_NONE if there is none, or several.
static int32_t flat_block(const YkSimulation *sim)
{
    int32_t found = YK_NONE;
    for (size_t b = 0; b < sim->mech->block_count; b++) {
        if (!yk_has_columns(&sim->mech->blocks[b]) || sim->state->space.block_margin[b] > 1e-9) continue;
        if (found != YK_NONE) return YK_NONE;
        found = (int32_t)b;
    }
    return found;
}

// Solves a pose a little along a branch, at rest.
static bool go_along(YkSimulation *sim, size_t block, int sign, double ahead)
{
    YkState *s = sim->state;
    size_t input = (size_t)sim->free_input[0];
    s->branch[block] = (signed char)(ahead < 0 ? -sign : sign);
    double here = s->input[3 * input];
    s->input[3 * input] = here + ahead;
    bool ok = yk_state_solve(s) >= 0 && s->has_rates;
    s->input[3 * input] = here;
    return ok;
}

static double angle_here(const YkSimulation *sim, size_t block)
{
    YkRun run = yk_state_run(sim->state, &sim->state->space);
    return yk_between_columns(&run, &sim->mech->blocks[block]).angle;
}

// Finds the tangent by differences over +-h and +-2h, without their leading error.
static bool find_tangent(YkSimulation *sim, size_t block, Branch *branch)
{
    static const double place[] = {1, -1, 2, -2}, weight[] = {2.0 / 3, -2.0 / 3, -1.0 / 12, 1.0 / 12};
    const YkMechanism *mech = sim->mech;
    double h = 3e-3 * yk_simulation_input_scale(sim, 0);
    memset(branch->tangent, 0, mech->coordinate_count * sizeof *branch->tangent);
    for (int p = 0; p < 4; p++) {
        if (!go_along(sim, block, branch->sign, place[p] * h)) return false;
        for (size_t c = 0; c < mech->coordinate_count; c++) {
            YkState *s = sim->state;
            double here = c == (size_t)mech->inputs[sim->free_input[0]]
                              ? s->input[3 * sim->free_input[0]] + place[p] * h
                              : yk_coordinate_in(s, &s->space, c).position;
            branch->tangent[c] += weight[p] / h * here;
        }
        if (p > 0) continue;
        double angle = angle_here(sim, block);
        branch->level = YK_PI * round(angle / YK_PI);
        branch->slope = (angle - branch->level) / h;
    }
    return true;
}

// Finds the largest joint force a little along a branch, at rest, and the acceleration of the input there.
static bool find_force(YkSimulation *sim, size_t block, const Branch *branch, double ahead, double *force,
                       double *acceleration)
{
    YkDynamics *d = sim->dynamics;
    size_t input = (size_t)sim->free_input[0];
    double here = sim->state->input[3 * input];
    if (!go_along(sim, block, branch->sign, ahead)) return false;
    sim->state->input[3 * input] = here + ahead;
    YkStatus status = yk_dynamics_reduce(d, sim->state);
    if (status >= 0 && status != YK_SINGULAR) {
        *acceleration = d->acceleration[input];
        status = yk_dynamics_apply(d, sim->state);
    }
    sim->state->input[3 * input] = here;
    sim->state->input[3 * input + 2] = 0;
    *force = 0;
    for (size_t j = 0; j < sim->model->joint_count; j++)
        *force = fmax(*force, yk_hypot(d->joint[j].force[0], d->joint[j].force[1]));
    return status >= 0 && status != YK_SINGULAR;
}

static bool look_from_rest(YkSimulation *sim, size_t block, Branch *branch)
{
    double scale = yk_simulation_input_scale(sim, 0), far, near, a;
    if (!find_force(sim, block, branch, 1e-2 * scale, &far, &a) ||
        !find_force(sim, block, branch, 1e-4 * scale, &near, &branch->acceleration))
        return false;
    branch->is_finite = fabs(near - far) <= 0.1 * far;
    return true;
}

// --- the choice

static bool refuse(YkSimulation *sim, YkProblems *problems, size_t block, const char *why)
{
    yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
               "the simulation cannot start: two branches meet at its pose, where joint %q lies flat, and %s",
               sim->mech->blocks[block].label, why);
    sim->status = YK_SINGULAR;
    return false;
}

// Names the coordinate whose rate differs most between the branches.
static void hint_at_rates(const YkSimulation *sim, const Branch *branches, YkProblems *problems)
{
    size_t best = 0;
    double most = -1;
    for (size_t c = 0; c < sim->mech->coordinate_count; c++) {
        double apart = fabs(branches[0].tangent[c] - branches[1].tangent[c]);
        if (sim->mech->coordinates[c].is_distance) apart /= sim->mech->size;
        if (apart <= most) continue;
        most = apart;
        best = c;
    }
    yk_problem_hint(problems, "give %q a rate under `start:` too: %e or %e times that of %q",
                    sim->mech->coordinates[best].name, branches[0].tangent[best], branches[1].tangent[best],
                    sim->mech->coordinates[sim->mech->inputs[sim->free_input[0]]].name);
}

static int choose_at_rest(YkSimulation *sim, size_t block, Branch *branches, YkProblems *problems)
{
    for (int k = 0; k < 2; k++) {
        if (look_from_rest(sim, block, &branches[k])) continue;
        refuse(sim, problems, block, "its accelerations are not determined next to that pose");
        return -1;
    }
    if (branches[0].is_finite != branches[1].is_finite) return branches[0].is_finite ? 0 : 1;
    // It stays at rest.
    if (branches[0].is_finite && branches[0].acceleration == 0 && branches[1].acceleration == 0) return 0;
    refuse(sim, problems, block,
           branches[0].is_finite ? "at rest nothing determines on which of them it moves"
                                 : "at rest the loads push it off both");
    hint_at_rates(sim, branches, problems);
    return -1;
}

// Finds the rate of the input that fits the given rates best, on a branch; returns the residual over the rates.
static double fit_rates(const Branch *branch, const YkStartRate *given, size_t count, double *rate)
{
    double up = 0, down = 0, off = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        up += given[k].rate * branch->tangent[given[k].coordinate];
        down += branch->tangent[given[k].coordinate] * branch->tangent[given[k].coordinate];
    }
    *rate = down > 0 ? up / down : 0;
    for (size_t k = 0; k < count; k++) {
        off = fmax(off, fabs(given[k].rate - *rate * branch->tangent[given[k].coordinate]));
        size = fmax(size, fabs(given[k].rate));
    }
    return off / size;
}

static int choose_by_rates(YkSimulation *sim, size_t block, const Branch *branches, const YkStartRate *given,
                           size_t count, YkProblems *problems, double *rate)
{
    const double FITS = 1e-6;
    double rates[2], off[2];
    for (int k = 0; k < 2; k++) off[k] = fit_rates(&branches[k], given, count, &rates[k]);
    if ((off[0] <= FITS) != (off[1] <= FITS)) {
        int chosen = off[0] <= FITS ? 0 : 1;
        *rate = rates[chosen];
        return chosen;
    }
    refuse(sim, problems, block,
           off[0] <= FITS ? "the rates of `start:` fit both" : "the rates of `start:` fit neither of them");
    hint_at_rates(sim, branches, problems);
    return -1;
}

// Finds the kinetic energy from both sides of the pose, without the leading error.
static double find_kinetic(YkSimulation *sim, size_t block, const Branch *branch)
{
    static const double place[] = {1, -1, 2, -2}, weight[] = {2.0 / 3, 2.0 / 3, -1.0 / 6, -1.0 / 6};
    double sum = 0, h = 3e-3 * yk_simulation_input_scale(sim, 0);
    for (int p = 0; p < 4; p++)
        if (go_along(sim, block, branch->sign, place[p] * h))
            sum += weight[p] * yk_dynamics_energy_at(sim->dynamics, sim->state).kinetic;
    return sum;
}

static void set_out(YkSimulation *sim, size_t block, const Branch *branch, double rate)
{
    size_t input = (size_t)sim->free_input[0];
    double *own = sim->state->input + 3 * input;
    own[1] = rate;
    own[2] = 0;
    sim->flat_kinetic = rate != 0 ? find_kinetic(sim, block, branch) : 0;
    double ahead = rate != 0 ? rate : branch->acceleration;
    sim->state->branch[block] = (signed char)(ahead < 0 ? -branch->sign : branch->sign);
    yk_state_solve(sim->state);
    sim->near[0] =
        (YkNear){block, branch->level, branch->slope * rate, rate != 0 ? 0 : branch->slope * branch->acceleration};
    sim->near_count = 1;
    sim->near_time = sim->time;
    sim->flat_slope = branch->slope;
    sim->is_flat = true;
}

static bool choose_branch(YkSimulation *sim, size_t block, double *memory, YkProblems *problems)
{
    size_t n = sim->mech->coordinate_count, moving = 0;
    Branch branches[2] = {{.sign = 1, .tangent = memory}, {.sign = -1, .tangent = memory + n}};
    YkStartRate *given = calloc(sim->model->start_count + sim->options.value_count + 1, sizeof *given);
    if (!given) return false;
    size_t count = yk_simulation_given_rates(sim, given);
    for (size_t k = 0; k < count; k++) moving += given[k].rate != 0;
    double rate = 0, *own = sim->state->input + 3 * sim->free_input[0];
    int chosen = -1;
    own[1] = own[2] = 0;
    if (!find_tangent(sim, block, &branches[0]) || !find_tangent(sim, block, &branches[1]))
        refuse(sim, problems, block, "no motion leads through that pose");
    else
        chosen = moving > 0 ? choose_by_rates(sim, block, branches, given, count, problems, &rate)
                            : choose_at_rest(sim, block, branches, problems);
    if (chosen >= 0) set_out(sim, block, &branches[chosen], rate);
    free(given);
    return chosen >= 0;
}

bool yk_simulation_start_singular(YkSimulation *sim, YkProblems *problems)
{
    size_t n = sim->mech->coordinate_count;
    size_t *order = calloc(2 * sim->free_count + 1, sizeof *order);
    double *memory = calloc(2 * n + 1, sizeof *memory);
    size_t recoordinations = sim->summary.recoordinations;
    bool ok = order && memory && try_others(sim, order);
    sim->summary.recoordinations = recoordinations; // it has not moved yet
    if (ok && yk_simulation_is_singular(sim)) {
        yk_state_solve(sim->state);
        int32_t block = sim->free_count == 1 && !sim->has_drives ? flat_block(sim) : YK_NONE;
        if (block != YK_NONE) {
            ok = choose_branch(sim, (size_t)block, memory, problems);
        } else {
            yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
                       "the simulation cannot start: it stands at a dead point of every choice of coordinates, where "
                       "rates are not determined");
            yk_problem_hint(problems, "start a little away from that pose");
            sim->status = YK_SINGULAR;
            ok = false;
        }
    }
    free(order);
    free(memory);
    return ok;
}
