// A batch of a machine's search: parameters are drawn, and the best of them improved. It depends on its number alone.
#include <math.h>
#include <string.h>
#include "base/mix.h"
#include "synthesis/machines/machine_fit.h"

enum { STARTS = 20, STEPS = 100 };

static const double weight_at_first = 100, weight_at_last = 1e8, harder = 100; // of claims

// Takes the parameters of the file.
static void take_own(const YkMachineTask *machine, YkMachineTry *try)
{
    for (size_t j = 0; j < machine->free_count; j++) {
        const YkBound *range = &machine->range[j];
        try->value[j] = fmin(fmax(yk_model_parameter(machine->model, machine->name[j]), range->low), range->high);
    }
}

static void draw(const YkMachineTask *machine, uint64_t *seed, YkMachineTry *try)
{
    for (size_t j = 0; j < machine->free_count; j++) {
        const YkBound *range = &machine->range[j];
        try->value[j] = range->low + (range->high - range->low) * yk_mix_unit(seed);
    }
}

size_t yk_machine_batch_work(const YkTask *task)
{
    return (task->machine.steps + 1) * STARTS / 5; // some 0.2 us a pose
}

bool yk_machine_batch(YkMachineFit *fit, uint64_t seed, size_t batch, YkMachineTry *best)
{
    const YkMachineTask *machine = &fit->task->machine;
    YkMachineTry try = {.cost = INFINITY};
    *best = try;
    if (batch > 0) seed += YK_MIX_STEP * (uint64_t)(batch - 1) * STARTS * (uint64_t)machine->free_count;
    fit->weight = weight_at_first;
    for (size_t k = 0; k < (batch == 0 ? 1 : STARTS); k++) {
        if (batch == 0) // the parameters of the file
            take_own(machine, &try);
        else
            draw(machine, &seed, &try);
        if (yk_machine_measure(fit, fit->miss, &try) && try.cost < best->cost) *best = try;
    }
    if (!isfinite(best->cost)) return false;
    for (fit->weight = weight_at_first; fit->weight <= weight_at_last; fit->weight *= harder) {
        yk_machine_improve(fit, best, STEPS); // claims that hold it back are kept more and more strictly
        if (best->lack <= 0) break;
    }
    return true;
}

// --- as numbers

size_t yk_machine_width(const YkTask *task)
{
    return 5 + task->machine.free_count;
}

void yk_machine_pack(const YkTask *task, const YkMachineTry *try, bool is_found, double *numbers)
{
    memset(numbers, 0, yk_machine_width(task) * sizeof *numbers);
    if (!is_found) return;
    const double own[] = {1, try->error, try->cost, try->worst, try->lack};
    memcpy(numbers, own, sizeof own);
    memcpy(numbers + 5, try->value, task->machine.free_count * sizeof *numbers);
}

bool yk_machine_unpack(const YkTask *task, const double *numbers, YkMachineTry *try)
{
    if (numbers[0] != 1) return false;
    *try = (YkMachineTry){.error = numbers[1], .cost = numbers[2], .worst = numbers[3], .lack = numbers[4]};
    memcpy(try->value, numbers + 5, task->machine.free_count * sizeof *numbers);
    return true;
}
