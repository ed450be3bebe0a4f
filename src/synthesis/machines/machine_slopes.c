// Derivatives of the misses of a machine task by its parameters.
#include <math.h>
#include <string.h>
#include "compile/closure.h"
#include "synthesis/machines/machine_fit.h"

enum { LANES = YK_FIT_LANES };

// --- room

// Makes the channels that are the variables of the loops: angles of orientations, then distances.
static bool make_placing(YkMachineFit *fit, YkArena *arena)
{
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    size_t o = mech->orientation_count - 1;
    YkChannel *channel = YK_NEW(arena, YkChannel, fit->variables + 1);
    if (!channel) return false;
    for (size_t k = 1; k <= o; k++)
        channel[k - 1] = (YkChannel){YK_CHANNEL_BODY, mech->orientation_body[k], 0, YK_QUANTITY_ANGLE};
    for (size_t j = 0; j < mech->model->joint_count; j++)
        if (mech->joint_distance[j] != YK_NONE)
            channel[o + (size_t)mech->joint_distance[j]] =
                (YkChannel){YK_CHANNEL_JOINT_DISTANCE, (int)j, 0, YK_QUANTITY_LENGTH};
    fit->placing = yk_batch_new(fit->state, channel, fit->variables);
    return fit->placing != NULL;
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
    fit->place = lanes_new(arena, fit->variables);
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

// Returns whether the value of a share has exact derivatives; the loops of very large machines are not factored densely.
static bool is_exact(const YkMachineFit *fit, const YkShare *share)
{
    return fit->variables <= YK_CLOSURE_MAX && yk_gradient_covers(fit->task->machine.channel[share->channel]);
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

// --- positions: exact

static bool linearise(YkMachineFit *fit, size_t lane)
{
    const YkMechanism *mech = yk_variant_mechanism(fit->variant);
    double x[YK_CLOSURE_MAX];
    for (size_t v = 0; v < fit->variables; v++) x[v] = fit->place[v][lane];
    for (size_t o = 1; o < mech->orientation_count; o++)
        x[o - 1] -= mech->bodies[mech->orientation_body[o]].turn; // 0 for the body of an orientation
    fit->poses++;
    return yk_gradient_pose(fit->gradient, x);
}

// Adds the shares of one row, miss by miss.
static void add_row(YkMachineFit *fit, const Rows *rows, size_t *at, size_t row)
{
    enum { PARTS = 8 };
    const YkMachineTask *machine = &fit->task->machine;
    while (*at < rows->end && fit->shares.item[*at].row == row) {
        size_t miss = fit->shares.item[*at].miss, count = 0;
        YkWeighted part[PARTS];
        for (; *at < rows->end && fit->shares.item[*at].row == row && fit->shares.item[*at].miss == miss; ++*at) {
            const YkShare *share = &fit->shares.item[*at];
            if (is_exact(fit, share) && count < PARTS)
                part[count++] = (YkWeighted){machine->channel[share->channel], share->weight};
        }
        if (count > 0) yk_gradient_add(fit->gradient, part, count, fit->row + miss * machine->free_count);
    }
}

static bool add_exact(YkMachineFit *fit)
{
    Rows rows = {.end = 0};
    bool is_first = true;
    while (next_rows(fit, true, &rows)) {
        if (is_first && !yk_gradient_design(fit->gradient)) return false;
        is_first = false;
        fit->poses += rows.count;
        yk_batch_run(fit->placing, fit->pick, fit->place, fit->status, rows.count);
        size_t at = rows.first;
        for (size_t lane = 0; lane < rows.count; lane++) {
            if (fit->status[lane] < 0 || !linearise(fit, lane)) return false;
            while (at < rows.end && fit->shares.item[at].row < rows.row[lane]) at++;
            add_row(fit, &rows, &at, rows.row[lane]);
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
