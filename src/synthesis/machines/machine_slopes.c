// Derivatives of the misses of a machine task by its parameters.
#include <math.h>
#include <string.h>
#include "compile/closure.h"
#include "synthesis/machines/machine_fit.h"

enum { LANES = YK_FIT_LANES };

// --- room

// Makes the channels that are the variables of the loops: angles of orientations, then distances; then their rates and
// accelerations, if answers depend on any.
static bool make_placing(YkMachineFit *fit, YkArena *arena)
{
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    size_t o = mech->orientation_count - 1, n = fit->variables;
    YkChannel *channel = YK_NEW(arena, YkChannel, fit->orders * n + 1);
    if (!channel) return false;
    for (size_t order = 0; order < fit->orders; order++) {
        for (size_t k = 1; k <= o; k++)
            channel[order * n + k - 1] =
                (YkChannel){YK_CHANNEL_BODY, mech->orientation_body[k], (int)order, YK_QUANTITY_ANGLE};
        for (size_t j = 0; j < mech->model->joint_count; j++)
            if (mech->joint_distance[j] != YK_NONE)
                channel[order * n + o + (size_t)mech->joint_distance[j]] =
                    (YkChannel){YK_CHANNEL_JOINT_DISTANCE, (int)j, (int)order, YK_QUANTITY_LENGTH};
    }
    fit->placing = yk_batch_new(fit->state, channel, fit->orders * n);
    return fit->placing != NULL;
}

// Makes the derivatives of the channels of forces, where the machine has them. Returns false when out of memory.
static bool make_forces(YkMachineFit *fit, YkArena *arena)
{
    const YkMachineTask *machine = &fit->task->machine;
    YkChannel *channel = YK_NEW(arena, YkChannel, machine->channel_count + 1);
    bool fits = true;
    fit->force = YK_NEW(arena, size_t, machine->channel_count + 1);
    if (!channel || !fit->force) return false;
    for (size_t c = 0; c < machine->channel_count; c++) {
        bool is_force = yk_channel_needs_forces(machine->channel[c]);
        if (is_force || machine->channel[c].order > 0 || machine->channel[c].kind == YK_CHANNEL_POINT_SPEED)
            fit->orders = 3;
        if (is_force) channel[fit->force[c] = fit->force_count++] = machine->channel[c];
    }
    if (fit->force_count == 0) return true;
    fit->forces = yk_force_slopes_new(yk_variant_mechanism(fit->variant), channel, fit->force_count, &fits);
    if (!fit->forces) return !fits;
    size_t count = yk_force_slopes_count(fit->forces);
    fit->weights = YK_NEW(arena, double, fit->force_count);
    fit->by = YK_NEW(arena, double, count + 1);
    fit->input_values = YK_NEW(arena, double, 3 * yk_input_count(machine->mech) + 1);
    return fit->weights && fit->by && fit->input_values;
}

static double **lanes_new(YkArena *arena, size_t count)
{
    double **lanes = YK_NEW(arena, double *, count + 1);
    for (size_t k = 0; lanes && k < count; k++)
        if (!(lanes[k] = YK_NEW(arena, double, LANES))) return NULL;
    return lanes;
}

bool yk_machine_slopes_new(YkMachineFit *fit, YkArena *arena)
{
    const YkMachineTask *machine = &fit->task->machine;
    size_t inputs = yk_input_count(machine->mech);
    fit->variables = yk_variable_count(yk_variant_mechanism(fit->variant));
    fit->gradient = yk_gradient_new(fit->variant);
    fit->orders = 1;
    if (!make_forces(fit, arena)) return false;
    fit->place = lanes_new(arena, fit->orders * fit->variables);
    fit->low = lanes_new(arena, machine->channel_count);
    fit->high = lanes_new(arena, machine->channel_count);
    fit->pick_at = YK_NEW(arena, double, LANES);
    fit->pick = YK_NEW(arena, const double *, 3 * inputs + 1);
    fit->shares.item = YK_NEW(arena, YkShare, 6 * fit->misses + 1); // a miss of a point: three rows of x and y
    if (!fit->gradient || !fit->place || !fit->low || !fit->high || !fit->pick_at || !fit->pick || !fit->shares.item)
        return false;
    for (size_t i = 0; i < 3 * inputs; i++) fit->pick[i] = fit->inputs[i] ? fit->pick_at : NULL;
    return make_placing(fit, arena);
}

// --- some rows

typedef struct Rows {
    size_t row[LANES], count;
    size_t first, end; // of the shares at these rows
} Rows;

// Returns whether a share's value has exact derivatives; the loops of very large machines are not factored densely.
static bool is_exact(const YkMachineFit *fit, const YkShare *share)
{
    const YkMachineTask *machine = &fit->task->machine;
    YkChannel channel = machine->channel[share->channel];
    if (fit->variables > YK_CLOSURE_MAX) return false;
    return yk_channel_needs_forces(channel) ? fit->forces != NULL
                                            : yk_gradient_covers(yk_variant_mechanism(fit->variant), channel);
}

// Takes the next rows that have shares, exact ones or others, and sets the swept coordinate there.
static bool next_rows(YkMachineFit *fit, bool exact, Rows *rows)
{
    rows->count = 0;
    for (rows->first = rows->end; rows->end < fit->shares.count; rows->end++) {
        const YkShare *share = &fit->shares.item[rows->end];
        if (is_exact(fit, share) != exact) continue;
        if (rows->count > 0 && rows->row[rows->count - 1] == share->row) continue;
        if (rows->count == LANES) break;
        fit->pick_at[rows->count] = fit->at[share->row];
        rows->row[rows->count++] = share->row;
    }
    return rows->count > 0;
}

static size_t lane_of(const Rows *rows, size_t row)
{
    size_t low = 0, high = rows->count;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (rows->row[middle] <= row)
            low = middle;
        else
            high = middle;
    }
    return low;
}

// --- exact

static bool linearise(YkMachineFit *fit, size_t lane)
{
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    double x[3][YK_CLOSURE_MAX];
    size_t n = fit->variables;
    for (size_t k = 0; k < fit->orders; k++)
        for (size_t v = 0; v < n; v++) x[k][v] = fit->place[k * n + v][lane];
    for (size_t o = 1; o < mech->orientation_count; o++)
        x[0][o - 1] -= mech->bodies[mech->orientation_body[o]].turn; // 0 for the body of an orientation
    fit->poses++;
    return yk_gradient_pose(fit->gradient, x[0], fit->orders > 1 ? x[1] : NULL, fit->orders > 1 ? x[2] : NULL);
}

// Takes the forces of a miss, by their weights.
static bool take_forces(YkMachineFit *fit, size_t row)
{
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    for (size_t i = 0; i < yk_input_count(mech); i++) {
        YkMotion own = yk_state_input(fit->state, i);
        const double value[3] = {fit->inputs[3 * i] ? fit->at[row] : own.position, own.velocity, own.acceleration};
        memcpy(fit->input_values + 3 * i, value, sizeof value);
    }
    YkSlopesAt at = {fit->input_values, 0, fit->weights};
    fit->backwards++;
    return yk_force_slopes_take(fit->forces, fit->gradient, &at, fit->by);
}

// Adds the shares of one row, miss by miss. Returns false if a force has no derivative there.
static bool add_row(YkMachineFit *fit, const Rows *rows, size_t *at, size_t row)
{
    const YkMachineTask *machine = &fit->task->machine;
    while (*at < rows->end && fit->shares.item[*at].row == row) {
        size_t miss = fit->shares.item[*at].miss;
        bool has_force = false;
        yk_gradient_start(fit->gradient);
        for (size_t k = 0; k < fit->force_count && fit->forces; k++) fit->weights[k] = 0;
        for (; *at < rows->end && fit->shares.item[*at].row == row && fit->shares.item[*at].miss == miss; ++*at) {
            const YkShare *share = &fit->shares.item[*at];
            YkChannel channel = machine->channel[share->channel];
            if (!is_exact(fit, share)) continue;
            if (yk_channel_needs_forces(channel)) {
                fit->weights[fit->force[share->channel]] += share->weight;
                has_force = true;
            } else {
                yk_gradient_take(fit->gradient, (YkWeighted){channel, share->weight});
            }
        }
        if (has_force && !take_forces(fit, row)) return false;
        yk_gradient_finish(fit->gradient, fit->row + miss * machine->free_count);
    }
    return true;
}

static bool add_exact(YkMachineFit *fit)
{
    Rows rows = {.end = 0};
    bool is_first = true;
    while (next_rows(fit, true, &rows)) {
        if (is_first && !yk_gradient_design(fit->gradient)) return false;
        if (is_first && fit->forces) yk_lane_forces_redesign(fit->forces);
        is_first = false;
        fit->poses += rows.count;
        yk_batch_run(fit->placing, fit->pick, fit->place, fit->status, rows.count);
        size_t at = rows.first;
        for (size_t lane = 0; lane < rows.count; lane++) {
            if (fit->status[lane] < 0 || !linearise(fit, lane)) return false;
            while (at < rows.end && fit->shares.item[at].row < rows.row[lane]) at++;
            if (!add_row(fit, &rows, &at, rows.row[lane])) return false;
        }
    }
    return true;
}

// --- others: by differences, at the rows on which a miss depends

// Computes the channels at the rows beside the try. Returns false if one of them is not there.
static bool values_beside(YkMachineFit *fit, const Rows *rows, const double *value, double **out)
{
    if (yk_variant_set(fit->variant, value) != YK_OK) return false;
    fit->poses += rows->count;
    fit->differenced += rows->count;
    yk_batch_run(fit->batch, fit->pick, out, fit->status, rows->count);
    for (size_t k = 0; k < rows->count; k++)
        if (fit->status[k] < 0 || fit->status[k] == YK_SINGULAR) return false;
    return true;
}

static bool add_differences(YkMachineFit *fit, const YkMachineTry *try, const Rows *rows, size_t j)
{
    static const double step = 1e-6; // of the range
    const YkMachineTask *machine = &fit->task->machine;
    double h = step * (machine->range[j].high - machine->range[j].low);
    YkMachineTry low = *try, high = *try;
    low.value[j] -= h;
    high.value[j] += h;
    bool has_low = values_beside(fit, rows, low.value, fit->low);
    bool has_high = values_beside(fit, rows, high.value, fit->high);
    if (!has_low && !has_high) return false;
    double width = (has_high ? high.value[j] : try->value[j]) - (has_low ? low.value[j] : try->value[j]);
    for (size_t k = rows->first; k < rows->end; k++) {
        const YkShare *share = &fit->shares.item[k];
        if (is_exact(fit, share)) continue;
        size_t lane = lane_of(rows, share->row);
        double own = fit->value[share->channel][share->row];
        double from = has_low ? fit->low[share->channel][lane] : own;
        double to = has_high ? fit->high[share->channel][lane] : own;
        if (!isfinite(to - from)) return false;
        fit->row[share->miss * machine->free_count + j] += share->weight * (to - from) / width;
    }
    return true;
}

bool yk_machine_differentiate(YkMachineFit *fit, const YkMachineTry *try)
{
    const YkMachineTask *machine = &fit->task->machine;
    Rows rows = {.end = 0};
    memset(fit->row, 0, fit->misses * machine->free_count * sizeof *fit->row);
    yk_machine_share(fit, fit->value, &fit->shares);
    if (yk_variant_set(fit->variant, try->value) != YK_OK || !add_exact(fit)) return false;
    while (next_rows(fit, false, &rows))
        for (size_t j = 0; j < machine->free_count; j++)
            if (!add_differences(fit, try, &rows, j)) return false;
    return true;
}
