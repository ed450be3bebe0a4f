// Balancing as a caller asks for it: the peaks before, the counterweights, the model with them, and the peaks after.
#include "design/balancing.h"
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"

enum { STEPS = 360, STEPS_MAX = 20000, STEPS_MIN = 8 * YK_SHAKING_ORDERS }; // fewer would take high orders for low ones

YkBalancingOptions yk_default_balancing_options(void)
{
    return (YkBalancingOptions){.steps = STEPS, .fluctuation = 0.05};
}

// Measures the model with its counterweights, read again and assembled as the machine stands.
static YkStatus measure_after(YkBalancing *balancing, const YkCycle *cycle, const YkState *state, YkVec *forces)
{
    YkModel *model = yk_model_parse(yk_text_get(&balancing->model), balancing->model.length, "balanced", NULL, NULL);
    const char *input = yk_coordinate_info(state->mech, yk_input_coordinate(state->mech, 0)).name;
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = &input;
    options.input_count = 1;
    YkMechanism *mech = model ? yk_mechanism_compile(model, &options, NULL) : NULL;
    YkState *own = mech ? yk_state_new(mech) : NULL;
    YkStatus status = own ? yk_state_set_time(own, 0, NULL) : YK_NO_MEMORY;
    if (status >= 0) status = yk_state_assemble(own);
    if (status >= 0) status = yk_cycle_peaks(cycle, own, &balancing->after, NULL, forces);
    if (status >= 0) yk_cycle_orders(cycle, forces, balancing->order[1]);
    yk_state_free(own);
    yk_mechanism_free(mech);
    yk_model_free(model);
    return status;
}

static YkStatus balance(YkBalancing *balancing, const YkState *state, const YkBalancingOptions *options)
{
    size_t steps = options->steps < STEPS_MIN ? STEPS_MIN : options->steps > STEPS_MAX ? STEPS_MAX : options->steps;
    YkCycle cycle;
    YkStatus status = yk_cycle_find(state, steps, &cycle);
    if (status >= 0 && cycle.turns > 0) status = yk_cycle_repeat(state, &cycle);
    if (status < 0) return status;
    double *torques = calloc(cycle.count, sizeof *torques);
    YkVec *forces = calloc(cycle.count, sizeof *forces);
    cycle.laws = options->laws;
    status = torques && forces ? yk_cycle_peaks(&cycle, state, &balancing->before, torques, forces) : YK_NO_MEMORY;
    cycle.laws = NULL; // the model with its counterweights has the same laws
    if (status >= 0) {
        balancing->turns = cycle.repeats ? cycle.turns : 0;
        yk_cycle_orders(&cycle, forces, balancing->order[0]);
        balancing->flywheel = cycle.repeats && options->fluctuation > 0
                                  ? yk_cycle_swing(&cycle, torques) / (options->fluctuation * cycle.rate * cycle.rate)
                                  : (double)NAN;
        const double *weight = options->weight;
        bool is_compromise = weight[0] + weight[1] + weight[2] > 0;
        status = is_compromise ? yk_balancing_compromise(&cycle, state, torques, weight, balancing)
                               : yk_balancing_weigh(&cycle, state, balancing);
    }
    if (status >= 0 && !yk_balancing_write(state->mech->model, balancing)) status = YK_NO_MEMORY;
    if (status >= 0) status = measure_after(balancing, &cycle, state, forces);
    free(torques);
    free(forces);
    return status;
}

YkBalancing *yk_balancing_new(const YkState *state, const YkBalancingOptions *options, YkProblems *problems)
{
    YkBalancingOptions defaults = yk_default_balancing_options();
    if (!state || !yk_state_has_pose(state)) return NULL;
    const YkModel *model = state->mech->model;
    const char *why = yk_input_count(state->mech) != 1    ? "it does not have exactly one freedom"
                      : yk_model_loads(model).masses == 0 ? "it has no masses"
                                                          : NULL;
    YkBalancing *balancing = why ? NULL : calloc(1, sizeof *balancing);
    YkStatus status = balancing ? balance(balancing, state, options ? options : &defaults)
                      : why     ? YK_BAD_ARGUMENT
                                : YK_NO_MEMORY;
    if (status >= 0) return balancing;
    if (status == YK_NO_MEMORY)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while balancing");
    else
        yk_problem(problems, YK_CODE_NO_BALANCE, (YkPlace){0}, "the machine cannot be balanced: %s",
                   why ? why : "its forces are not determined at every pose of a cycle");
    yk_balancing_free(balancing);
    return NULL;
}

void yk_balancing_free(YkBalancing *balancing)
{
    if (!balancing) return;
    yk_text_free(&balancing->model);
    free(balancing);
}

bool yk_balancing_is_full(const YkBalancing *b)
{
    return b && b->is_full;
}

size_t yk_balancing_count(const YkBalancing *b)
{
    return b ? b->count : 0;
}

YkCounterweight yk_balancing_at(const YkBalancing *b, size_t index)
{
    return index < yk_balancing_count(b) ? b->weight[index] : (YkCounterweight){.body = YK_NOT_FOUND};
}

YkShakingPeaks yk_balancing_before(const YkBalancing *b)
{
    return b ? b->before : (YkShakingPeaks){0};
}

YkShakingPeaks yk_balancing_after(const YkBalancing *b)
{
    return b ? b->after : (YkShakingPeaks){0};
}

YkShakingOrder yk_balancing_order(const YkBalancing *b, size_t order, bool with_counterweights)
{
    bool is_there = b && order >= 1 && order <= YK_SHAKING_ORDERS;
    return is_there ? b->order[with_counterweights][order - 1]
                    : (YkShakingOrder){(double)NAN, (double)NAN, (double)NAN};
}

size_t yk_balancing_turns(const YkBalancing *b)
{
    return b ? b->turns : 0;
}

double yk_balancing_flywheel(const YkBalancing *b)
{
    return b ? b->flywheel : (double)NAN;
}

const char *yk_balancing_model(const YkBalancing *b)
{
    return b ? yk_text_get(&b->model) : NULL;
}
