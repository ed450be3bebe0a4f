// Actions of the host while the machine moves: efforts, drives, pulls on points, a control that samples.
#include <stdlib.h>
#include "loads/point.h"
#include "simulate/simulation.h"

static bool is_coordinate(const YkSimulation *sim, size_t coordinate)
{
    return coordinate < sim->mech->coordinate_count;
}

// --- efforts --------------------------------------------------------------------------------------

static YkLoadItem *effort_item(const YkSimulation *sim, size_t coordinate)
{
    const YkLoads *loads = sim->dynamics->loads;
    for (size_t k = 0; k < loads->item_count; k++)
        if (loads->items[k].kind == YK_LOAD_EFFORT && loads->items[k].coordinate == (int32_t)coordinate)
            return &loads->items[k];
    return NULL;
}

bool yk_simulation_make_efforts(YkSimulation *sim)
{
    size_t n = sim->mech->coordinate_count;
    if (!sim->has_effort) sim->has_effort = calloc(2 * n, sizeof *sim->has_effort);
    if (!sim->effort) sim->effort = calloc(2 * n, sizeof *sim->effort);
    return sim->has_effort && sim->effort;
}

YkStatus yk_simulation_act_effort(YkSimulation *sim, size_t coordinate, double effort)
{
    if (sim->status != YK_OK) return sim->status;
    YkLoadItem *item = is_coordinate(sim, coordinate) && isfinite(effort) ? effort_item(sim, coordinate) : NULL;
    if (!item) return YK_BAD_ARGUMENT;
    if (!yk_simulation_make_efforts(sim)) return YK_NO_MEMORY;
    bool is_same = sim->has_effort[coordinate] && sim->effort[coordinate] == effort;
    sim->has_effort[coordinate] = true;
    sim->effort[coordinate] = effort;
    item->value[0] = (YkLoadValue){.constant = effort};
    sim->has_acted = sim->has_acted || !is_same;
    return YK_OK;
}

// --- drives ---------------------------------------------------------------------------------------

static YkMotion commanded(const YkCommand *c, double time)
{
    double t = time - c->time, rate = c->rate + t * c->acceleration;
    return (YkMotion){c->position + t * (c->rate + 0.5 * t * c->acceleration), rate, c->acceleration};
}

YkStatus yk_simulation_set_time(const YkSimulation *sim, YkState *state, double time, YkProblems *problems)
{
    YkStatus status = yk_state_set_time(state, time, problems);
    for (size_t i = 0; sim->commands && i < sim->mech->input_count; i++) {
        const YkCommand *command = &sim->commands[sim->mech->inputs[i]];
        if (command->is_set) yk_state_set_input(state, i, commanded(command, time));
    }
    return status;
}

YkStatus yk_simulation_act_drive(YkSimulation *sim, size_t coordinate, double acceleration)
{
    if (sim->status != YK_OK) return sim->status;
    int32_t input = is_coordinate(sim, coordinate) ? sim->mech->coordinates[coordinate].input : YK_NONE;
    if (input == YK_NONE || sim->dynamics->is_free[input] || !isfinite(acceleration)) return YK_BAD_ARGUMENT;
    if (!sim->commands) sim->commands = calloc(sim->mech->coordinate_count, sizeof *sim->commands);
    if (!sim->commands) return YK_NO_MEMORY;
    YkCommand *command = &sim->commands[coordinate];
    if (command->is_set && command->acceleration == acceleration) return YK_OK;
    YkMotion now = yk_state_input(sim->state, (size_t)input);
    *command = (YkCommand){true, sim->time, now.position, now.velocity, acceleration};
    sim->has_acted = true;
    return YK_OK;
}

// --- pulls ----------------------------------------------------------------------------------------

static bool is_good(const YkSimulation *sim, const YkPull *p)
{
    double sum = p->stiffness + p->damping;
    for (int k = 0; k < 2; k++) sum += p->place[k] + p->target[k] + p->force[k];
    return p->body > 0 && p->body < sim->model->body_count && isfinite(sum);
}

static bool is_same_handle(const YkHandle *a, const YkHandle *b)
{
    return a->is_on == b->is_on && a->end.body == b->end.body && a->end.from_origin.x == b->end.from_origin.x &&
           a->end.from_origin.y == b->end.from_origin.y && a->target.x == b->target.x && a->target.y == b->target.y &&
           a->force.x == b->force.x && a->force.y == b->force.y && a->stiffness == b->stiffness &&
           a->damping == b->damping;
}

YkStatus yk_simulation_act_pull(YkSimulation *sim, size_t index, const YkPull *p)
{
    if (sim->status != YK_OK) return sim->status;
    if (index >= sim->dynamics->loads->handle_count || (p && !is_good(sim, p))) return YK_BAD_ARGUMENT;
    YkHandle *handle = &sim->dynamics->loads->handles[index], set = {0};
    if (p)
        set = (YkHandle){.is_on = true,
                         .end = yk_load_end(sim->mech, (int32_t)p->body, yk_vec(p->place[0], p->place[1])),
                         .target = yk_vec(p->target[0], p->target[1]),
                         .force = yk_vec(p->force[0], p->force[1]),
                         .stiffness = p->stiffness,
                         .damping = p->damping};
    sim->has_acted = sim->has_acted || !is_same_handle(handle, &set);
    *handle = set;
    return YK_OK;
}

// --- control --------------------------------------------------------------------------------------

YkStatus yk_simulation_set_control(YkSimulation *sim, double period, YkControl control, void *context)
{
    if (control && !(period > 0 && isfinite(period))) return YK_BAD_ARGUMENT;
    sim->sampling = (YkSampling){control, context, sim->time, period, 0};
    sim->has_acted = true; // the present step may reach beyond the second sample
    return YK_OK;
}

double yk_simulation_sample_time(const YkSimulation *sim, size_t index)
{
    return sim->sampling.from + (double)index * sim->sampling.period;
}

size_t yk_simulation_sample_count(const YkSimulation *sim)
{
    return sim->sampling.count;
}

double yk_simulation_next_sample(const YkSimulation *sim)
{
    return sim->sampling.control ? yk_simulation_sample_time(sim, sim->sampling.count) : HUGE_VAL;
}
