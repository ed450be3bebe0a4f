// Loops over the library's calls that would be slow in Python, and the ways from C back into Python.
#include <math.h>
#include <time.h>
#include "host.h"

extern bool yk_host_ask(double part); // written in Python

static _Thread_local double last_asked; // s

// A clock decides when Python is asked, never what is computed.
static bool is_due(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    double seconds = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
    if (seconds - last_asked < 0.02) return false;
    last_asked = seconds;
    return true;
}

bool yk_host_goes_on(void *context, double part)
{
    (void)context;
    return !is_due() || yk_host_ask(part);
}

bool yk_host_goes_on_in_time(void *context, double time)
{
    const double *span = context;
    return !is_due() || yk_host_ask(span[1] > span[0] ? (time - span[0]) / (span[1] - span[0]) : 0);
}

YkProgress yk_host_progress(void)
{
    return (YkProgress){yk_host_goes_on, NULL};
}

// --- a pose

YkStatus yk_host_reach(YkState *state, const YkState *entry, const YkInputHold *holds, size_t count, double time,
                       YkMove *move, YkProblems *problems)
{
    YkStatus status = yk_state_copy(state, entry);
    return status < 0 ? status : yk_state_reach(state, holds, count, time, NULL, move, problems);
}

static bool is_rate(YkChannel channel)
{
    return !yk_channel_needs_forces(channel) && (channel.order > 0 || channel.kind == YK_CHANNEL_POINT_SPEED);
}

void yk_host_read(const YkState *state, const YkDynamics *dynamics, const YkChannel *channels, size_t count,
                  bool has_accelerations, double *values)
{
    bool has_rates = yk_state_has_rates(state);
    for (size_t c = 0; c < count; c++) {
        bool is_lost = (is_rate(channels[c]) && !has_rates) || (channels[c].order == 2 && !has_accelerations);
        if (yk_channel_needs_forces(channels[c]))
            values[c] = dynamics ? yk_dynamics_channel(dynamics, state, channels[c]) : NAN;
        else
            values[c] = is_lost ? NAN : yk_state_channel(state, channels[c]);
    }
}

// --- many rows

void yk_host_blank_rates(YkSweep *sweep, const YkChannel *channels, size_t count)
{
    double *rows = (double *)(size_t)yk_sweep_rows(sweep); // no other code reads this sweep
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++) {
        if (yk_sweep_row_status(sweep, row) != YK_SINGULAR) continue;
        for (size_t c = 0; c < count; c++)
            if (is_rate(channels[c])) rows[row * (1 + count) + 1 + c] = NAN;
    }
}

static double time_of(const YkHostRows *rows, size_t row)
{
    if (row >= rows->steps) return rows->to;
    if (rows->every > 0) return rows->from + rows->every * (double)row;
    return rows->from + (rows->to - rows->from) * (double)row / (double)rows->steps;
}

YkStatus yk_host_simulate(YkSimulation *simulation, YkHostRows *rows)
{
    for (rows->done = 0; rows->done <= rows->steps; rows->done++) {
        double time = time_of(rows, rows->done), *row = rows->rows + rows->done * (1 + rows->channel_count);
        YkStatus status = yk_simulation_advance(simulation, time);
        if (status < 0) return status;
        if (yk_simulation_time(simulation) < time) return YK_STOPPED;
        row[0] = yk_simulation_time(simulation);
        for (size_t c = 0; c < rows->channel_count; c++)
            row[1 + c] = yk_simulation_channel(simulation, rows->channels[c]);
    }
    return YK_OK;
}

// --- many simulations

static YkStatus act(const YkHostMany *many, size_t index)
{
    const double *efforts = many->efforts + index * many->coordinate_count;
    YkStatus worst = YK_OK;
    for (size_t k = 0; k < many->coordinate_count; k++) {
        YkStatus status = yk_simulation_act_effort(many->simulations[index], many->coordinates[k], efforts[k]);
        worst = status < worst ? status : worst;
    }
    return worst;
}

static YkStatus step_one(const YkHostMany *many, size_t index)
{
    YkSimulation *simulation = many->simulations[index];
    YkStatus status = many->efforts ? act(many, index) : YK_OK;
    if (status < 0) return status;
    if (many->span <= 0) return YK_OK;
    double due = yk_simulation_time(simulation) + many->span;
    status = yk_simulation_step(simulation, many->span);
    return status >= 0 && yk_simulation_time(simulation) < due ? YK_STOPPED : status;
}

YkStatus yk_host_step_many(const YkHostMany *many, size_t begin, size_t end)
{
    YkStatus worst = YK_OK;
    for (size_t k = begin; k < end; k++) {
        if (!yk_host_goes_on(NULL, (double)(k - begin) / (double)(end - begin))) return YK_STOPPED;
        if (many->status[k] < 0) continue;
        YkStatus status = step_one(many, k);
        many->status[k] = (signed char)status;
        worst = status < worst ? status : worst;
        double *values = many->values + k * many->channel_count;
        for (size_t c = 0; c < many->channel_count; c++)
            values[c] = yk_simulation_channel(many->simulations[k], many->channels[c]);
    }
    return worst;
}

void yk_host_draw(const YkDistribution *distribution, uint64_t seed, uint64_t parameter, double *values, size_t count)
{
    for (size_t k = 0; k < count; k++) values[k] = yk_distribution_draw(distribution, seed, k, parameter);
}

void yk_host_time_solve(YkState *state, const YkState *entry, YkInputHold *holds, YkMove *move, const double *values,
                        size_t count)
{
    for (size_t k = 0; k < count; k++) {
        holds[0].value = values[k];
        yk_host_reach(state, entry, holds, 1, 0, move, NULL);
    }
}

void yk_host_time_steps(YkSimulation *simulation, double span, size_t count)
{
    for (size_t k = 0; k < count; k++) yk_simulation_step(simulation, span);
}
