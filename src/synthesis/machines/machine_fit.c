// Moves a machine with other parameters, and improves these by least squares.
#include "synthesis/machines/machine_fit.h"
#include <math.h>
#include <string.h>
#include "synthesis/least_squares.h"

enum { POSE = 200, GRADIENT = 5 }; // work of a pose; poses of a step for each row

static size_t count_misses(const YkMachineTask *machine, size_t rows)
{
    size_t count = machine->claim_count;
    for (size_t k = 0; k < machine->goal_count; k++) {
        const YkGoal *goal = &machine->goal[k];
        count += goal->kind == YK_GOAL_LEAST ? 1 : goal->kind == YK_GOAL_EQUALS ? rows : 2 * goal->count;
    }
    return count;
}

static bool make_room(YkArena *arena, YkMachineFit *fit)
{
    const YkMachineTask *machine = &fit->task->machine;
    size_t rows = fit->rows, n = machine->free_count, inputs = yk_input_count(machine->mech);
    fit->misses = count_misses(machine, rows);
    fit->at = YK_NEW(arena, double, rows);
    fit->value = YK_NEW(arena, double *, machine->channel_count + 1);
    fit->inputs = YK_NEW(arena, const double *, 3 * inputs);
    fit->status = YK_NEW(arena, signed char, rows);
    fit->miss = YK_NEW(arena, double, fit->misses);
    fit->next_miss = YK_NEW(arena, double, fit->misses);
    fit->row = YK_NEW(arena, double, fit->misses *n);
    fit->A = YK_NEW(arena, double, (fit->misses + n) * n);
    fit->b = YK_NEW(arena, double, fit->misses + n);
    bool good = fit->at && fit->value && fit->inputs && fit->status && fit->miss && fit->next_miss && fit->row &&
                fit->A && fit->b;
    for (size_t c = 0; good && c < machine->channel_count; c++)
        good = (fit->value[c] = YK_NEW(arena, double, rows)) != NULL;
    if (!good) return false;
    for (size_t r = 0; r < rows; r++) {
        double part = (double)r / (double)(rows - 1);
        fit->at[r] = machine->over.low + part * (machine->over.high - machine->over.low);
    }
    memset(fit->inputs, 0, 3 * inputs * sizeof *fit->inputs);
    for (size_t i = 0; i < inputs; i++)
        if (yk_input_coordinate(machine->mech, i) == machine->coordinate) fit->inputs[3 * i] = fit->at;
    return true;
}

// Lists the positions that `start:` gives and that the inputs do not determine alone.
static bool make_starting(YkArena *arena, YkMachineFit *fit)
{
    const YkModel *model = fit->task->machine.model;
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    YkChannel *channel = YK_NEW(arena, YkChannel, model->start_count + 1);
    fit->start = YK_NEW(arena, size_t, model->start_count + 1);
    fit->still = YK_NEW(arena, const double *, 3 * yk_input_count(mech) + 1);
    if (!channel || !fit->start || !fit->still) return false;
    memset(fit->still, 0, 3 * yk_input_count(mech) * sizeof *fit->still);
    for (size_t k = 0; k < model->start_count; k++) {
        size_t c = yk_coordinate_find(mech, model->coordinates[model->starts[k].coordinate].name);
        if (model->starts[k].is_rate || c == YK_NOT_FOUND || mech->coordinates[c].input != YK_NONE) continue;
        channel[fit->start_count] = (YkChannel){YK_CHANNEL_COORDINATE, (int)c, 0, YK_QUANTITY_NUMBER};
        fit->start[fit->start_count++] = k;
    }
    fit->starting = yk_batch_new(fit->state, channel, fit->start_count);
    return fit->starting != NULL;
}

bool yk_machine_start(YkMachineFit *fit, const double *parameters, double *value)
{
    double *out[YK_STARTS_MAX];
    if (fit->start_count > YK_STARTS_MAX || yk_variant_set(fit->variant, parameters) != YK_OK) return false;
    for (size_t k = 0; k < fit->start_count; k++) out[k] = &value[k];
    return yk_batch_run(fit->starting, fit->still, out, NULL, 1) >= 0;
}

bool yk_machine_fit_new(const YkTask *task, YkArena *arena, YkMachineFit *fit, YkProblems *problems)
{
    const YkMachineTask *machine = &task->machine;
    *fit = (YkMachineFit){.task = task, .rows = machine->steps + 1};
    fit->variant = yk_variant_new(machine->mech, machine->name, machine->free_count, problems);
    if (!fit->variant) return false;
    fit->state = yk_state_new(yk_variant_mechanism(fit->variant));
    bool good = fit->state && make_room(arena, fit);
    YkStatus status = good ? yk_state_set_time(fit->state, 0, problems) : YK_NO_MEMORY;
    if (status >= 0) status = yk_state_assemble(fit->state);
    if (status < 0 && status != YK_NO_MEMORY) {
        yk_problem(problems, YK_CODE_TASK_MACHINE, machine->place,
                   "the machine cannot be assembled as its file gives it");
        return false;
    }
    if (status >= 0) fit->batch = yk_batch_new(fit->state, machine->channel, machine->channel_count);
    bool is_ready = fit->batch && make_starting(arena, fit) && yk_machine_slopes_new(fit, arena);
    if (!is_ready) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory during the synthesis");
    return is_ready;
}

void yk_machine_fit_free(YkMachineFit *fit)
{
    yk_lane_forces_free(fit->forces);
    yk_gradient_free(fit->gradient);
    yk_batch_free(fit->placing);
    yk_batch_free(fit->starting);
    yk_batch_free(fit->batch);
    yk_state_free(fit->state);
    yk_variant_free(fit->variant);
}

bool yk_machine_measure(YkMachineFit *fit, double *miss, YkMachineTry *try)
{
    try->cost = try->error = INFINITY;
    if (yk_variant_set(fit->variant, try->value) != YK_OK) return false;
    fit->poses += fit->rows;
    yk_batch_run(fit->batch, fit->inputs, fit->value, fit->status, fit->rows);
    for (size_t r = 0; r < fit->rows; r++)
        if (fit->status[r] < 0 || fit->status[r] == YK_SINGULAR) return false;
    yk_machine_judge(fit, fit->value, miss, try);
    return isfinite(try->cost);
}

bool yk_machine_improve(YkMachineFit *fit, YkMachineTry *try, size_t steps)
{
    static const double damping_max = 1e8;
    const YkMachineTask *machine = &fit->task->machine;
    double low[YK_FREE_MAX], high[YK_FREE_MAX], damping = 1e-3;
    size_t n = machine->free_count, still = 0;
    bool is_new = true;
    for (size_t j = 0; j < n; j++) {
        low[j] = machine->range[j].low;
        high[j] = machine->range[j].high;
    }
    if (!yk_machine_measure(fit, fit->miss, try)) return false;
    for (size_t k = 0; k < steps && still < 5 && damping < damping_max && try->cost > 0; k++) {
        double step[YK_FREE_MAX];
        if (!yk_pace_spend(fit->pace, POSE * fit->rows * GRADIENT)) return true;
        YkMachineTry next = *try;
        if (is_new && !yk_machine_differentiate(fit, try)) return true;
        YkLinear linear = {n, fit->misses, fit->row, fit->miss, try->value, low, high, fit->A, fit->b};
        yk_linear_step(&linear, damping, step);
        for (size_t j = 0; j < n; j++) next.value[j] = fmin(fmax(try->value[j] + step[j], low[j]), high[j]);
        is_new = yk_machine_measure(fit, fit->next_miss, &next) && next.cost < try->cost;
        damping = is_new ? fmax(damping * 0.2, 1e-14) : damping * 5;
        if (!is_new) continue;
        still = next.cost > (1 - 1e-6) * try->cost ? still + 1 : 0;
        memcpy(fit->miss, fit->next_miss, fit->misses * sizeof *fit->miss);
        *try = next;
    }
    return true;
}
