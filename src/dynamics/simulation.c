// The entry: from a model at its start through time.
#include "dynamics/simulation.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"

YkSimulationOptions yk_default_simulation_options(void)
{
    return (YkSimulationOptions){.integrator = YK_INTEGRATOR_DOP853, .tolerance = 1e-9, .step = 1e-3};
}

// --- the start
// --------------------------------------------------------------------------------------------------------

static bool refuse(YkSimulation *sim, YkProblems *problems, YkStatus status, const char *message)
{
    YkCode code = status == YK_LIMIT         ? YK_CODE_POSE_LIMIT
                  : status == YK_NO_ASSEMBLY ? YK_CODE_POSE_NO_ASSEMBLY
                                             : YK_CODE_CANNOT_START;
    yk_problem(problems, code, (YkPlace){0}, "the simulation cannot start: %s", message);
    sim->status = status;
    return false;
}

static bool set_positions(YkSimulation *sim, YkProblems *problems)
{
    YkState *s = sim->state;
    if (yk_state_set_time(s, sim->options.start, problems) < 0) return false;
    for (size_t k = 0; k < sim->options.value_count; k++) {
        const YkStartValue *value = &sim->options.values[k];
        int c = yk_coordinate_find(sim->mech, value->coordinate);
        if (c < 0) {
            yk_problem(problems, YK_CODE_UNKNOWN_INPUT, (YkPlace){0}, "there is no coordinate %q", value->coordinate);
            return false;
        }
        if (value->is_rate) continue;
        s->guess[c] = value->value;
        s->is_guessed[c] = true;
        int32_t input = sim->mech->coordinates[c].input;
        if (input != YK_NONE && sim->dynamics->is_free[input]) s->input[3 * input] = value->value;
    }
    YkStatus status = yk_state_assemble(s);
    if (status < 0) return refuse(sim, problems, status, s->report.message);
    yk_state_refer(s);
    return true;
}

static bool check_stops(YkSimulation *sim, YkProblems *problems)
{
    bool ok = true;
    for (size_t k = 0; k < sim->item_count; k++) {
        const YkLoadItem *item = &sim->dynamics->loads->items[k];
        if (item->kind != YK_LOAD_STOP) continue;
        double value = yk_loads_coordinate(sim->state, &sim->state->space, item->coordinate).position;
        double off = fmax(item->stop->low - value, value - item->stop->high);
        if (off <= 1e-9 * (item->is_distance ? sim->mech->size : 1)) continue;
        yk_problem(problems, YK_CODE_STOP_EXCLUDES_START, item->stop->place,
                   "%q starts at %g, outside of its stops (%g to %g, SI)", item->name, value, item->stop->low,
                   item->stop->high);
        ok = false;
    }
    return ok;
}

static void read_inputs(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->free_count; k++) {
        sim->y[k] = sim->state->input[3 * sim->free_input[k]];
        sim->y[sim->free_count + k] = sim->state->input[3 * sim->free_input[k] + 1];
    }
}

static void count_energy(YkSimulation *sim)
{
    YkEnergy e = yk_dynamics_energy_at(sim->dynamics, sim->state);
    YkSimulationSummary *s = &sim->summary;
    double total = e.kinetic + e.potential, works = 0;
    for (size_t k = 0; k < sim->work_count; k++) works += sim->work[k];
    if (!sim->has_energy) {
        s->energy_start = total;
        sim->energy_low = sim->energy_high = e.potential;
        sim->has_energy = true;
    }
    s->energy_end = total;
    sim->energy_low = fmin(sim->energy_low, e.potential);
    sim->energy_high = fmax(sim->energy_high, e.potential);
    sim->kinetic_high = fmax(sim->kinetic_high, e.kinetic);
    sim->energy_off = fmax(sim->energy_off, fabs(total - s->energy_start - works));
    s->worst_residual = fmax(s->worst_residual, yk_state_residuals(sim->state).position);
}

// The pose at (t, y), counted.
static bool stand(YkSimulation *sim, double t, const double *y)
{
    if (!yk_simulation_pose(sim, t, y)) return false;
    sim->is_elsewhere = true;
    memcpy(sim->work, y + 2 * sim->free_count, sim->work_count * sizeof *sim->work);
    count_energy(sim);
    return true;
}

// Contacts that cannot hold let go at once.
static bool settle_contacts(YkSimulation *sim)
{
    if (sim->contact_count == 0) return true;
    do {
        if (!yk_simulation_pose(sim, sim->time, sim->y)) return false;
    } while (yk_simulation_contacts_check(sim));
    return true;
}

// Starts the stepper at the time and inputs that stand.
static bool restart(YkSimulation *sim)
{
    double end = sim->options.horizon > sim->time ? sim->options.horizon : sim->target;
    yk_simulation_contacts_start(sim);
    if (!settle_contacts(sim)) return false;
    if (!(end > sim->time)) end = sim->time + 1;
    sim->is_new_step = false;
    YkOdeStatus status = yk_ode_start(sim->ode, sim->time, sim->y, end, false);
    if (status == YK_ODE_OK) return true;
    sim->status = YK_NOT_CONVERGED;
    if (sim->report.message[0] == 0) sim->report = sim->dynamics->report;
    return false;
}

static const double POOR = 0.2; // sin^2 of the worst block, from which other coordinates are looked for

// Better coordinates where these are near a dead point; which blocks are near a singular position.
static bool look_round(YkSimulation *sim)
{
    bool changed = false;
    if (yk_simulation_margin(sim) < POOR) {
        if (yk_simulation_margin(sim) > 1e-8 && !yk_simulation_recoordinate(sim, &changed)) return false;
        if (changed && !yk_simulation_pose(sim, sim->time, sim->y)) return false;
    }
    yk_simulation_look_near(sim, sim->time);
    return !changed || restart(sim);
}

static bool begin(YkSimulation *sim, YkProblems *problems)
{
    if (!set_positions(sim, problems)) return false;
    sim->time = sim->target = sim->options.start;
    bool has_dead_points = sim->free_count == 1 && sim->mech->block_count > 0;
    sim->first = has_dead_points ? (int32_t)sim->mech->inputs[sim->free_input[0]] : YK_NONE;
    if (!yk_simulation_start_rates(sim, problems))
        return refuse(sim, problems, YK_SINGULAR,
                      "it stands at a dead point, where the rates of `start:` are not determined");
    read_inputs(sim);
    if (!check_stops(sim, problems)) return false;
    return true;
}

// On first use, when efforts are set and watches known.
static bool start_moving(YkSimulation *sim)
{
    sim->has_begun = true;
    yk_simulation_contacts_start(sim);
    yk_simulation_look_near(sim, sim->time);
    if (!stand(sim, sim->time, sim->y)) return false;
    sim->near_count = 0; // with accelerations they are known better
    yk_simulation_look_near(sim, sim->time);
    if (!restart(sim) || !yk_simulation_pose(sim, sim->time, sim->y) || !look_round(sim)) return false;
    yk_simulation_watch_start(sim);
    return true;
}

static bool are_options_good(const YkSimulationOptions *o, YkProblems *problems)
{
    bool is_fixed = o->integrator == YK_INTEGRATOR_RK4;
    double size = is_fixed ? o->step : o->tolerance;
    bool good =
        o->integrator <= YK_INTEGRATOR_RK4 && size > 0 && isfinite(size) && isfinite(o->start) && !isnan(o->horizon);
    for (size_t k = 0; k < o->value_count; k++) good = good && isfinite(o->values[k].value);
    if (!good)
        yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
                   "the simulation cannot start: the %s must be positive and all times and values finite",
                   is_fixed ? "step" : "tolerance");
    return good;
}

YkSimulation *yk_simulation_new(const YkModel *model, const YkSimulationOptions *options, YkProblems *problems)
{
    YkSimulation *sim = calloc(1, sizeof *sim);
    if (!sim) return NULL;
    sim->model = model;
    sim->options = options ? *options : yk_default_simulation_options();
    sim->arena = yk_arena_new();
    if (!are_options_good(&sim->options, problems)) {
        yk_simulation_free(sim);
        return NULL;
    }
    bool ok = sim->arena && yk_simulation_build(sim, sim->options.compile, problems) && yk_simulation_stepper(sim);
    if (ok && !sim->dynamics->has_mass) {
        yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
                   "no body has mass or inertia, so nothing says how the machine moves");
        yk_problem_hint(problems,
                        "give bodies `mass:` and `inertia:`, or use `yoke sweep` for motion that drives prescribe");
        ok = false;
    }
    if (ok && begin(sim, problems)) return sim;
    if (problems && yk_problems_error_count(problems) == 0)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing the simulation");
    yk_simulation_free(sim);
    return NULL;
}

void yk_simulation_free(YkSimulation *sim)
{
    if (!sim) return;
    yk_simulation_unbuild(sim);
    yk_arena_free(sim->arena);
    free(sim->watches);
    free(sim->happenings);
    free(sim->effort);
    free(sim->has_effort);
    free(sim->work_name);
    free(sim);
}

YkStatus yk_simulation_watch(YkSimulation *sim, const char *name, YkChannel channel, double value, int direction)
{
    if (!YK_ROOM(sim->watches, sim->watch_count, sim->watch_capacity)) return YK_NO_MEMORY;
    const char *kept = yk_arena_copy(sim->arena, name, strlen(name));
    if (!kept) return YK_NO_MEMORY;
    sim->watches[sim->watch_count++] = (YkWatch){kept, channel, value, direction, 0};
    return YK_OK;
}

YkStatus yk_simulation_set_effort(YkSimulation *sim, const char *coordinate, double effort)
{
    if (sim->status != YK_OK) return sim->status;
    size_t n = sim->mech->coordinate_count;
    int c = yk_coordinate_find(sim->mech, coordinate);
    if (c < 0 || sim->has_begun || !isfinite(effort)) return YK_BAD_ARGUMENT;
    if (!sim->has_effort) sim->has_effort = calloc(n, sizeof *sim->has_effort);
    if (!sim->effort) sim->effort = calloc(n, sizeof *sim->effort);
    if (!sim->has_effort || !sim->effort) return YK_NO_MEMORY;
    sim->has_effort[c] = true;
    sim->effort[c] = effort;
    YkProblems *quiet = yk_problems_new();
    yk_simulation_unbuild(sim);
    bool ok = yk_simulation_build(sim, sim->options.compile, quiet) && yk_simulation_stepper(sim) && begin(sim, quiet);
    yk_problems_free(quiet);
    if (!ok) sim->status = YK_NO_MEMORY; // nothing but freeing it is left to do
    return sim->status;
}

// --- through time
// -----------------------------------------------------------------------------------------------------

static void take_step_end(YkSimulation *sim)
{
    memcpy(sim->y, yk_ode_state(sim->ode), (2 * sim->free_count + sim->work_count) * sizeof *sim->y);
    sim->time = yk_ode_time(sim->ode);
}

static YkStatus give_up(YkSimulation *sim, YkStatus status, const char *why)
{
    yk_dynamics_fail(sim->dynamics, status, why, "", "");
    sim->report = sim->dynamics->report;
    return sim->status = status;
}

static YkStatus fail(YkSimulation *sim, YkOdeStatus status)
{
    if (sim->status == YK_OK) sim->status = status == YK_ODE_NO_MEMORY ? YK_NO_MEMORY : YK_NOT_CONVERGED;
    yk_simulation_stand_still(sim);
    if (sim->report.message[0] == 0) yk_simulation_explain(sim);
    return sim->status;
}

static bool has_contacts(const YkSimulation *sim)
{
    for (size_t k = 0; k < sim->item_count; k++)
        if (sim->dynamics->loads->items[k].kind >= YK_LOAD_COULOMB) return true;
    return false;
}

// Events that follow each other in no time at all would go on for ever.
static bool is_going_on(YkSimulation *sim)
{
    enum { STALLED_MAX = 500 };
    bool same = sim->events > 0 && sim->pending_time - sim->last_event <= 1e-15 * fabs(sim->pending_time);
    sim->stalled = same ? sim->stalled + 1 : 0;
    sim->last_event = sim->pending_time;
    sim->events++;
    if (sim->stalled <= STALLED_MAX) return true;
    give_up(sim, YK_NOT_CONVERGED, "stops and dry friction follow each other without end at this time");
    return false;
}

// A happening that ends a step: the state is put there, changed, and the stepper started anew.
static bool take_pending(YkSimulation *sim)
{
    size_t all = 2 * sim->free_count + sim->work_count;
    if (!is_going_on(sim) || yk_ode_dense(sim->ode, sim->pending_time, sim->dense) != YK_ODE_OK) return false;
    memcpy(sim->y, sim->dense, all * sizeof *sim->y);
    sim->pending = YK_PENDING_NONE;
    if (!yk_simulation_pose(sim, sim->pending_time, sim->y) || !yk_simulation_hit(sim, sim->pending_item)) return false;
    sim->near_count = 0; // its rates have changed
    sim->first_rate = 0;
    return stand(sim, sim->time, sim->y) && restart(sim) && yk_simulation_pose(sim, sim->time, sim->y) &&
           look_round(sim);
}

// Right after an accepted step: what happened in it. Rows within the step may still be asked for.
static void look_back(YkSimulation *sim)
{
    if (sim->is_lean && sim->watch_count == 0) return;
    if (sim->watch_count == 0 && !has_contacts(sim)) return;
    yk_simulation_look(sim);
    sim->is_elsewhere = true;
}

// The pose at the end of the last step; most often the last evaluation left it there, without accelerations.
static bool return_to_end(YkSimulation *sim, double t)
{
    memcpy(sim->y, yk_ode_state(sim->ode), (2 * sim->free_count + sim->work_count) * sizeof *sim->y);
    if (sim->contact_count > 0 || sim->near_count > 0 || yk_simulation_margin(sim) < 0.25)
        return yk_simulation_pose(sim, t, sim->y);
    if (sim->is_elsewhere && (!yk_simulation_set(sim, t, sim->y) || yk_state_solve(sim->state) < 0)) return false;
    if (sim->is_elsewhere && yk_simulation_margin(sim) < 0.25) return yk_simulation_pose(sim, t, sim->y);
    sim->time = t;
    yk_state_refer(sim->state);
    return true;
}

// Before the next step: contacts that let go, coordinates that no longer do, positions where branches meet.
static bool look_ahead(YkSimulation *sim)
{
    double t = yk_ode_time(sim->ode);
    size_t before = sim->contact_count;
    sim->is_new_step = false;
    if (sim->is_lean) return true;
    if (!return_to_end(sim, t)) return false;
    if (yk_simulation_look_dead(sim)) {
        sim->is_elsewhere = true;
        if (!return_to_end(sim, t)) return false;
    }
    sim->is_elsewhere = false;
    if (before > 0) {
        if (!settle_contacts(sim)) return false;
        if (sim->contact_count < before) return restart(sim) && yk_simulation_pose(sim, t, sim->y) && look_round(sim);
    }
    return yk_simulation_margin(sim) < 0.25 || sim->near_count > 0 ? look_round(sim) : true;
}

static bool is_spent(const YkSimulation *sim)
{
    size_t most = sim->options.steps_max;
    return most > 0 && yk_ode_counts(sim->ode).steps + sim->counts.steps + sim->events >= most;
}

// A step must not pass a singular position that is not watched yet: branches might change unseen.
static void set_end(YkSimulation *sim, double to)
{
    double end = sim->options.horizon >= to ? sim->options.horizon : to, t = yk_ode_time(sim->ode);
    bool may_cross = !sim->is_lean && sim->options.integrator != YK_INTEGRATOR_RK4 && sim->mech->block_count > 0;
    if (may_cross) end = fmin(end, fmax(t + yk_simulation_reach(sim), t + 1e-9 * fabs(t)));
    yk_ode_set_end(sim->ode, end);
}

static bool is_passed(const YkSimulation *sim, double to)
{
    double reached = yk_ode_time(sim->ode);
    return sim->pending != YK_PENDING_NONE ? sim->pending_time >= to : reached >= to;
}

// Rows may all meet the machine at the same phase of its motion - every one at standstill -, so the energy is looked at
// between them too: at the end of each of the first steps, then of some.
static bool sample_energy(YkSimulation *sim)
{
    enum { EACH = 64, SOME = 16 };
    size_t steps = yk_ode_counts(sim->ode).steps;
    if (sim->pending != YK_PENDING_NONE || (steps > EACH && steps % SOME != 0)) return true;
    return stand(sim, yk_ode_time(sim->ode), yk_ode_state(sim->ode));
}

YkStatus yk_simulation_advance(YkSimulation *sim, double to)
{
    if (sim->status != YK_OK) return sim->status;
    if (!isfinite(to) || to < sim->time) return YK_BAD_ARGUMENT;
    sim->target = to;
    if (!sim->has_begun && !start_moving(sim)) return fail(sim, YK_ODE_FAILED);
    if (to == sim->options.start && yk_ode_time(sim->ode) == to) // the first row
        return stand(sim, to, yk_ode_state(sim->ode)) ? YK_OK : fail(sim, YK_ODE_FAILED);
    while (!is_passed(sim, to)) {
        if (sim->pending != YK_PENDING_NONE) {
            if (!take_pending(sim)) return fail(sim, YK_ODE_FAILED);
            continue;
        }
        if (sim->is_new_step && !look_ahead(sim)) return fail(sim, YK_ODE_FAILED);
        if (is_spent(sim)) {
            give_up(sim, YK_NOT_CONVERGED, "the steps allowed are used up");
            take_step_end(sim);
            return fail(sim, YK_ODE_FAILED);
        }
        set_end(sim, to);
        YkOdeStatus status = yk_ode_step(sim->ode);
        if (status != YK_ODE_OK) {
            take_step_end(sim);
            return fail(sim, status);
        }
        sim->report.message[0] = 0;
        sim->is_new_step = true;
        look_back(sim);
        if (!sample_energy(sim)) return fail(sim, YK_ODE_FAILED);
        double reached = sim->pending != YK_PENDING_NONE ? sim->pending_time : yk_ode_time(sim->ode);
        if (sim->options.goes_on && !sim->options.goes_on(sim->options.context, reached)) to = fmin(to, reached);
    }
    if (yk_ode_dense(sim->ode, to, sim->dense) != YK_ODE_OK) return fail(sim, YK_ODE_FAILED);
    return stand(sim, to, sim->dense) ? YK_OK : fail(sim, YK_ODE_FAILED);
}

// --- answers
// ------------------------------------------------------------------------------------------------------------

double yk_simulation_time(const YkSimulation *sim)
{
    return sim->time;
}
YkState *yk_simulation_state(YkSimulation *sim)
{
    return sim->state;
}
const YkReport *yk_simulation_report(const YkSimulation *sim)
{
    return &sim->report;
}

YkDynamics *yk_simulation_dynamics(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    if (sim->has_forces) return d;
    for (size_t k = 0; k < sim->free_count; k++)
        d->acceleration[sim->free_input[k]] = sim->state->input[3 * sim->free_input[k] + 2];
    yk_dynamics_apply(d, sim->state);
    sim->has_forces = true;
    return d;
}

double yk_simulation_channel(YkSimulation *sim, YkChannel channel)
{
    bool is_gone = channel.kind == YK_CHANNEL_TRANSMISSION && (size_t)channel.index >= sim->mech->block_count;
    if (is_gone) return 0; // other coordinates make other blocks
    if (!yk_channel_needs_forces(channel)) return yk_state_channel(sim->state, channel);
    if (channel.kind >= YK_CHANNEL_ENERGY && channel.kind <= YK_CHANNEL_POTENTIAL) {
        YkEnergy e = yk_dynamics_energy_at(sim->dynamics, sim->state);
        return (channel.kind != YK_CHANNEL_POTENTIAL ? e.kinetic : 0) +
               (channel.kind != YK_CHANNEL_KINETIC ? e.potential : 0);
    }
    return yk_dynamics_channel(yk_simulation_dynamics(sim), sim->state, channel);
}

size_t yk_simulation_happening_count(const YkSimulation *sim)
{
    return sim->happening_count;
}
YkHappening yk_simulation_happening(const YkSimulation *sim, size_t index)
{
    return sim->happenings[index];
}

YkSimulationSummary yk_simulation_summary(const YkSimulation *sim)
{
    YkSimulationSummary s = sim->summary;
    YkOdeCounts c = sim->ode ? yk_ode_counts(sim->ode) : (YkOdeCounts){0};
    s.steps = c.steps + sim->counts.steps;
    s.rejected = c.rejected + sim->counts.rejected;
    s.evaluations = c.evaluations + sim->counts.evaluations;
    double span = sim->kinetic_high + (sim->energy_high - sim->energy_low);
    s.energy_error = span > 0 ? sim->energy_off / span : sim->energy_off;
    return s;
}

// Works that are nothing but the potential's are left out: the first `item_count` that may take or give energy.
size_t yk_simulation_work_count(const YkSimulation *sim)
{
    return sim->work_count;
}

const char *yk_simulation_work_name(const YkSimulation *sim, size_t index)
{
    if (index < sim->item_count) return sim->dynamics->loads->items[index].name;
    if (index + 1 == sim->work_count) return "stops";
    size_t at = sim->item_count;
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (!sim->dynamics->is_free[i] && at++ == index) return sim->mech->coordinates[sim->mech->inputs[i]].name;
    return "";
}

double yk_simulation_work(const YkSimulation *sim, size_t index)
{
    return sim->work[index];
}
