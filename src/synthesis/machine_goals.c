// How far a motion is from the goals and claims of a machine task.
#include <math.h>
#include "synthesis/machine_fit.h"

// The vector from a wanted point to the nearest place of the path, whose rows are joined by parabolas.
static YkVec miss_of(const double *x, const double *y, size_t rows, YkVec wanted)
{
    enum { NEWTON = 6 };
    size_t best = 0;
    double least = INFINITY;
    for (size_t r = 0; r < rows; r++) {
        double d = (x[r] - wanted.x) * (x[r] - wanted.x) + (y[r] - wanted.y) * (y[r] - wanted.y);
        if (d < least) {
            least = d;
            best = r;
        }
    }
    size_t m = best < 1 ? 1 : best + 2 > rows ? rows - 2 : best;
    YkVec a = yk_vec(x[m - 1], y[m - 1]), b = yk_vec(x[m], y[m]), c = yk_vec(x[m + 1], y[m + 1]);
    YkVec slope = yk_scale(0.5, yk_sub(c, a)), bend = yk_sub(yk_add(a, c), yk_scale(2, b));
    double t = (double)best - (double)m;
    YkVec off = {0};
    for (int k = 0; k <= NEWTON; k++) {
        YkVec speed = yk_add(slope, yk_scale(t, bend));
        off = yk_sub(yk_add(b, yk_add(yk_scale(t, slope), yk_scale(t * t / 2, bend))), wanted);
        double push = yk_dot(off, speed), stiff = yk_dot(speed, speed) + yk_dot(off, bend);
        if (k < NEWTON && stiff > 0) t = fmin(fmax(t - push / stiff, -1), 1);
    }
    return off;
}

static double measured(YkMeasure measure, const double *value, size_t rows)
{
    double result = measure == YK_MEASURE_MIN ? INFINITY : measure == YK_MEASURE_MAX ? -INFINITY : 0;
    for (size_t r = 0; r < rows; r++) {
        if (measure == YK_MEASURE_MIN) result = fmin(result, value[r]);
        if (measure == YK_MEASURE_MAX) result = fmax(result, value[r]);
        if (measure == YK_MEASURE_MAX_ABS) result = fmax(result, fabs(value[r]));
    }
    return result;
}

// Writes the misses of one goal, and returns where the next begin.
static double *take_goal(const YkMachineFit *fit, const YkGoal *goal, double *const *value, double *miss, double *worst)
{
    const double *x = value[goal->channel[0]];
    double weight = sqrt(goal->weight);
    bool is_ahead = fit->task->machine.over.high > fit->task->machine.over.low;
    if (goal->kind == YK_GOAL_LEAST) {
        *miss++ = weight * measured(YK_MEASURE_MAX_ABS, x, fit->rows);
        return miss;
    }
    for (size_t k = 0; goal->kind == YK_GOAL_THROUGH && k < goal->count; k++) {
        YkVec off = miss_of(x, value[goal->channel[1]], fit->rows, goal->point[k]);
        *worst = fmax(*worst, yk_norm(off));
        *miss++ = weight * off.x;
        *miss++ = weight * off.y;
    }
    for (size_t r = 0; goal->kind == YK_GOAL_EQUALS && r < fit->rows; r++) {
        double room = 1e-9 * fabs(fit->at[r]), low = is_ahead ? goal->where.low : goal->where.high;
        double high = is_ahead ? goal->where.high : goal->where.low;
        bool counts = !goal->where.is_given || (fit->at[r] >= low - room && fit->at[r] <= high + room);
        double off = counts ? x[r] - goal->equals : 0;
        *worst = fmax(*worst, fabs(off));
        *miss++ = weight * off;
    }
    return miss;
}

// Returns whether every value is a number: an effort may not be one where friction holds the machine.
static bool is_known(const YkMachineFit *fit, double *const *value)
{
    for (size_t c = 0; c < fit->task->machine.channel_count; c++)
        for (size_t r = 0; r < fit->rows; r++)
            if (!isfinite(value[c][r])) return false;
    return true;
}

void yk_machine_judge(const YkMachineFit *fit, double *const *value, double *miss, YkMachineTry *try)
{
    static const double strict = 1e-6; // claims are met with a little to spare
    const YkMachineTask *machine = &fit->task->machine;
    double *end = miss, scale = 0;
    try->error = try->worst = try->lack = 0;
    if (!is_known(fit, value)) {
        try->error = try->cost = INFINITY;
        return;
    }
    for (size_t k = 0; k < machine->goal_count; k++) end = take_goal(fit, &machine->goal[k], value, end, &try->worst);
    for (double *m = miss; m < end; m++) try->error += *m * *m;
    try->cost = try->error;
    scale = fit->weight * yk_mechanism_size(machine->mech);
    for (size_t k = 0; k < machine->claim_count; k++) {
        const YkClaim *claim = &machine->claim[k];
        double is = measured(claim->measure, value[claim->channel], fit->rows);
        double size = fabs(claim->limit) > 0 ? fabs(claim->limit) : 1;
        double lack = (claim->is_below ? is - claim->limit : claim->limit - is) / size;
        try->lack = k == 0 ? lack : fmax(try->lack, lack);
        *end = scale * fmax(lack + strict, 0);
        try->cost += *end * *end;
        end++;
    }
}
