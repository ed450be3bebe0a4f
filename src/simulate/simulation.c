// Makes a simulation: from a model to its start.
#include "simulate/simulation.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"

YkSimulationOptions yk_default_simulation_options(void)
{
    return (YkSimulationOptions){.integrator = YK_INTEGRATOR_DOP853, .tolerance = 1e-9, .step = 1e-3};
}

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
        size_t c = yk_coordinate_find(sim->mech, value->coordinate);
        if (c == YK_NOT_FOUND) {
            yk_problem(problems, YK_CODE_UNKNOWN_INPUT, (YkPlace){0}, "there is no coordinate %q", value->coordinate);
            return false;
        }
        if (value->is_rate) continue;
        s->guess[c] = value->value;
        s->is_guessed[c] = true;
        int32_t input = sim->mech->coordinates[c].input;
        if (input != YK_NONE && sim->dynamics->is_free[input]) s->input[3 * input] = value->value;
    }
    const YkState *pose = sim->options.pose;
    YkStatus status = pose ? yk_state_adopt(s, pose) : yk_state_assemble(s);
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
        double size = 1;
        const char *unit =
            yk_model_unit(sim->mech->model, item->is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE, &size);
        yk_problem(problems, YK_CODE_STOP_EXCLUDES_START, item->stop->place,
                   "%q starts at %e %s, outside its stops (%e to %e %s)", item->name, value / size, unit,
                   item->stop->low / size, item->stop->high / size, unit);
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

static bool begin(YkSimulation *sim, YkProblems *problems)
{
    if (!set_positions(sim, problems)) return false;
    sim->time = sim->target = sim->options.start;
    sim->is_flat = false;
    if (sim->free_count > 0 && yk_simulation_is_singular(sim) && !yk_simulation_start_singular(sim, problems))
        return false;
    bool has_dead_points = sim->free_count == 1 && sim->mech->block_count > 0;
    sim->first = has_dead_points ? (int32_t)sim->mech->inputs[sim->free_input[0]] : YK_NONE;
    if (!sim->is_flat && !yk_simulation_start_rates(sim, problems))
        return !yk_problems_ran_out(problems) &&
               refuse(sim, problems, YK_SINGULAR,
                      "it stands at a dead point, where the rates of `start:` are not determined");
    read_inputs(sim);
    if (!check_stops(sim, problems)) return false;
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

// Those of the start.
static bool copy_efforts(YkSimulation *to, const YkSimulation *from)
{
    size_t n = from->mech->coordinate_count;
    if (!from->has_effort || !from->effort) return true;
    to->has_effort = malloc(2 * n * sizeof *to->has_effort);
    to->effort = malloc(2 * n * sizeof *to->effort);
    if (!to->has_effort || !to->effort) return false;
    for (size_t k = 0; k < 2; k++) {
        memcpy(to->has_effort + k * n, from->has_effort + n, n * sizeof *to->has_effort);
        memcpy(to->effort + k * n, from->effort + n, n * sizeof *to->effort);
    }
    return true;
}

static bool take_over(YkSimulation *to, const YkSimulation *from)
{
    bool ok = copy_efforts(to, from);
    for (size_t k = 0; ok && k < from->watch_count; k++) {
        const YkEventWatch *w = &from->watches[k];
        ok = yk_simulation_watch(to, w->name, w->channel, w->level, w->direction) == YK_OK;
    }
    to->sampling = from->sampling;
    to->sampling.from = to->options.start;
    to->sampling.count = 0;
    return ok;
}

YkSimulation *yk_simulation_blank(const YkModel *model, const YkSimulationOptions *options, const YkSimulation *like)
{
    YkSimulation *sim = calloc(1, sizeof *sim);
    if (!sim) return NULL;
    sim->model = model;
    sim->sweeps_max = 5000;
    sim->options = *options;
    sim->arena = yk_arena_new();
    sim->laws = yk_law_watch_new(model);
    sim->open = calloc(model->cam_count + 1, sizeof *sim->open);
    sim->flights = calloc(model->cam_count + 1, sizeof *sim->flights);
    if (sim->arena && sim->laws && sim->open && sim->flights && (!like || take_over(sim, like))) return sim;
    yk_simulation_free(sim);
    return NULL;
}

YkSimulation *yk_simulation_new(const YkModel *model, const YkSimulationOptions *options, YkProblems *problems)
{
    YkSimulationOptions defaults = yk_default_simulation_options();
    if (!are_options_good(options ? options : &defaults, problems)) return NULL;
    YkSimulation *sim = yk_simulation_blank(model, options ? options : &defaults, NULL);
    bool ok = sim && yk_simulation_build(sim, sim->options.compile, problems) && yk_simulation_stepper(sim);
    if (ok && !sim->dynamics->has_mass) {
        yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
                   "no body has mass or inertia, so nothing determines how the machine moves");
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

static void end(YkSimulation *sim)
{
    if (sim->witness) sim->witness->change(sim->witness, NULL, NULL);
    yk_simulation_unbuild(sim);
    yk_arena_free(sim->arena);
    yk_law_watch_free(sim->laws);
    free(sim->open);
    free(sim->flights);
    free(sim->watches);
    free(sim->happenings);
    free(sim->effort);
    free(sim->has_effort);
    free(sim->commands);
}

void yk_simulation_free(YkSimulation *sim)
{
    if (!sim) return;
    end(sim);
    free(sim);
}

void yk_simulation_replace(YkSimulation *sim, YkSimulation *by)
{
    by->witness = sim->witness;
    end(sim);
    *sim = *by;
    free(by);
    if (sim->ode) yk_ode_set_context(sim->ode, sim);
    if (sim->has_begun) yk_simulation_tell_start(sim, NULL);
}

YkStatus yk_simulation_reset(YkSimulation *sim)
{
    if (sim->is_in_control) return YK_BAD_ARGUMENT;
    YkSimulation *fresh = yk_simulation_blank(sim->model, &sim->options, sim);
    YkProblems *quiet = yk_problems_new();
    bool ok = fresh && quiet && yk_simulation_build(fresh, fresh->options.compile, quiet) &&
              yk_simulation_stepper(fresh) && begin(fresh, quiet);
    yk_problems_free(quiet);
    if (ok)
        yk_simulation_replace(sim, fresh);
    else
        yk_simulation_free(fresh);
    return ok ? YK_OK : YK_NO_MEMORY;
}

YkStatus yk_simulation_watch(YkSimulation *sim, const char *name, YkChannel channel, double value, int direction)
{
    if (!YK_ROOM(sim->watches, sim->watch_count, sim->watch_capacity)) return YK_NO_MEMORY;
    const char *kept = yk_arena_copy(sim->arena, name, strlen(name));
    if (!kept) return YK_NO_MEMORY;
    sim->watches[sim->watch_count++] = (YkEventWatch){kept, channel, value, direction, 0};
    return YK_OK;
}

YkStatus yk_simulation_set_effort(YkSimulation *sim, const char *coordinate, double effort)
{
    if (sim->status != YK_OK) return sim->status;
    size_t n = sim->mech->coordinate_count;
    size_t c = yk_coordinate_find(sim->mech, coordinate);
    if (c == YK_NOT_FOUND || sim->has_begun || !isfinite(effort)) return YK_BAD_ARGUMENT;
    if (!yk_simulation_make_efforts(sim)) return YK_NO_MEMORY;
    sim->has_effort[c] = sim->has_effort[n + c] = true;
    sim->effort[c] = sim->effort[n + c] = effort;
    YkProblems *quiet = yk_problems_new();
    yk_simulation_unbuild(sim);
    bool ok = yk_simulation_build(sim, sim->options.compile, quiet) && yk_simulation_stepper(sim) && begin(sim, quiet);
    yk_problems_free(quiet);
    if (!ok) sim->status = YK_NO_MEMORY; // it can only be freed now
    return sim->status;
}
