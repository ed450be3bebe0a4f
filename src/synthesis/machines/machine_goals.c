// How far a motion is from the goals and claims of a machine task.
#include <math.h>
#include <stdlib.h>
#include "synthesis/machines/machine_fit.h"

// The place of a path nearest to a wanted point. Three successive rows are joined by a parabola, at the parameter t
// from -1 to 1.
typedef struct Nearest {
    size_t middle; // row
    double t, stiff;
    YkVec off, speed; // from the wanted point; along the parabola
    bool is_inside;   // t follows the rows; otherwise it is an end of the parabola
} Nearest;

static Nearest nearest_to(const double *x, const double *y, size_t rows, YkVec wanted)
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
    Nearest n = {.middle = m, .t = (double)best - (double)m};
    for (int k = 0; k <= NEWTON; k++) {
        n.speed = yk_add(slope, yk_scale(n.t, bend));
        n.off = yk_sub(yk_add(b, yk_add(yk_scale(n.t, slope), yk_scale(n.t * n.t / 2, bend))), wanted);
        double push = yk_dot(n.off, n.speed);
        n.stiff = yk_dot(n.speed, n.speed) + yk_dot(n.off, bend);
        if (k < NEWTON && n.stiff > 0) n.t = fmin(fmax(n.t - push / n.stiff, -1), 1);
    }
    n.is_inside = n.stiff > 0 && fabs(n.t) < 1;
    return n;
}

// Returns the row at which a measure is taken.
static size_t row_of(YkMeasure measure, const double *value, size_t rows)
{
    size_t best = 0;
    for (size_t r = 1; r < rows; r++) {
        bool is_beyond = measure == YK_MEASURE_MIN   ? value[r] < value[best]
                         : measure == YK_MEASURE_MAX ? value[r] > value[best]
                                                     : fabs(value[r]) > fabs(value[best]);
        if (is_beyond) best = r;
    }
    return best;
}

static double measured(YkMeasure measure, const double *value, size_t rows)
{
    double result = value[row_of(measure, value, rows)];
    return measure == YK_MEASURE_MAX_ABS ? fabs(result) : result;
}

// Returns whether a value counts at this row.
static bool counts_at(const YkMachineFit *fit, const YkGoal *goal, size_t row)
{
    bool is_ahead = fit->task->machine.over.high > fit->task->machine.over.low;
    double at = fit->at[row], room = 1e-9 * fabs(at);
    double low = is_ahead ? goal->where.low : goal->where.high, high = is_ahead ? goal->where.high : goal->where.low;
    return !goal->where.is_given || (at >= low - room && at <= high + room);
}

// Writes the misses of one goal, and returns where the next begin.
static double *take_goal(const YkMachineFit *fit, const YkGoal *goal, double *const *value, double *miss, double *worst)
{
    const double *x = value[goal->channel[0]];
    double weight = sqrt(goal->weight);
    if (goal->kind == YK_GOAL_LEAST) {
        *miss++ = weight * measured(YK_MEASURE_MAX_ABS, x, fit->rows);
        return miss;
    }
    for (size_t k = 0; goal->kind == YK_GOAL_THROUGH && k < goal->count; k++) {
        YkVec off = nearest_to(x, value[goal->channel[1]], fit->rows, goal->point[k]).off;
        *worst = fmax(*worst, yk_norm(off));
        *miss++ = weight * off.x;
        *miss++ = weight * off.y;
    }
    for (size_t r = 0; goal->kind == YK_GOAL_EQUALS && r < fit->rows; r++) {
        double off = counts_at(fit, goal, r) ? x[r] - goal->equals : 0;
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

// Returns what a claim lacks, over the size of its limit; positive: it does not hold.
static double lack_of(const YkMachineFit *fit, const YkClaim *claim, double *const *value)
{
    double is = measured(claim->measure, value[claim->channel], fit->rows);
    double size = fabs(claim->limit) > 0 ? fabs(claim->limit) : 1;
    return (claim->is_below ? is - claim->limit : claim->limit - is) / size;
}

static double scale_of_claims(const YkMachineFit *fit)
{
    return fit->weight * yk_mechanism_size(fit->task->machine.mech);
}

static const double strict = 1e-6; // claims are met with a little to spare

void yk_machine_judge(const YkMachineFit *fit, double *const *value, double *miss, YkMachineTry *try)
{
    const YkMachineTask *machine = &fit->task->machine;
    double *end = miss;
    try->error = try->worst = try->lack = 0;
    if (!is_known(fit, value)) {
        try->error = try->cost = INFINITY;
        return;
    }
    for (size_t k = 0; k < machine->goal_count; k++) end = take_goal(fit, &machine->goal[k], value, end, &try->worst);
    for (double *m = miss; m < end; m++) try->error += *m * *m;
    try->cost = try->error;
    for (size_t k = 0; k < machine->claim_count; k++) {
        double lack = lack_of(fit, &machine->claim[k], value);
        try->lack = k == 0 ? lack : fmax(try->lack, lack);
        *end = scale_of_claims(fit) * fmax(lack + strict, 0);
        try->cost += *end * *end;
        end++;
    }
}

// --- derivatives of misses by the values

static void add_share(YkShares *shares, size_t miss, size_t row, size_t channel, double weight)
{
    if (weight != 0) shares->item[shares->count++] = (YkShare){miss, row, channel, weight};
}

// The nearest place moves with the three rows, and along the parabola so that it stays the nearest.
static void share_nearest(const YkMachineFit *fit, const YkGoal *goal, size_t k, double *const *value, size_t miss,
                          YkShares *shares)
{
    const double *x = value[goal->channel[0]], *y = value[goal->channel[1]];
    Nearest n = nearest_to(x, y, fit->rows, goal->point[k]);
    double t = n.t, scale = sqrt(goal->weight), part[3] = {(t * t - t) / 2, 1 - t * t, (t * t + t) / 2};
    double change[3] = {t - 0.5, -2 * t, t + 0.5};
    for (size_t i = 0; i < 3; i++) {
        YkVec shift = yk_add(yk_scale(part[i], n.speed), yk_scale(change[i], n.off)); // of t, by this row's place
        shift = yk_scale(n.is_inside ? -1 / n.stiff : 0, shift);
        size_t row = n.middle + i - 1;
        add_share(shares, miss, row, goal->channel[0], scale * (part[i] + n.speed.x * shift.x));
        add_share(shares, miss, row, goal->channel[1], scale * n.speed.x * shift.y);
        add_share(shares, miss + 1, row, goal->channel[0], scale * n.speed.y * shift.x);
        add_share(shares, miss + 1, row, goal->channel[1], scale * (part[i] + n.speed.y * shift.y));
    }
}

static void share_measure(const YkMachineFit *fit, YkMeasure measure, size_t channel, double *const *value,
                          double weight, size_t miss, YkShares *shares)
{
    size_t row = row_of(measure, value[channel], fit->rows);
    bool is_turned = measure == YK_MEASURE_MAX_ABS && value[channel][row] < 0;
    add_share(shares, miss, row, channel, is_turned ? -weight : weight);
}

static int by_row(const void *a, const void *b)
{
    const YkShare *x = a, *y = b;
    if (x->row != y->row) return (x->row > y->row) - (x->row < y->row);
    if (x->miss != y->miss) return (x->miss > y->miss) - (x->miss < y->miss);
    return (x->channel > y->channel) - (x->channel < y->channel);
}

void yk_machine_share(const YkMachineFit *fit, double *const *value, YkShares *shares)
{
    const YkMachineTask *machine = &fit->task->machine;
    size_t miss = 0;
    shares->count = 0;
    for (size_t k = 0; k < machine->goal_count; k++) {
        const YkGoal *goal = &machine->goal[k];
        double weight = sqrt(goal->weight);
        if (goal->kind == YK_GOAL_LEAST)
            share_measure(fit, YK_MEASURE_MAX_ABS, goal->channel[0], value, weight, miss++, shares);
        for (size_t p = 0; goal->kind == YK_GOAL_THROUGH && p < goal->count; p++, miss += 2)
            share_nearest(fit, goal, p, value, miss, shares);
        for (size_t r = 0; goal->kind == YK_GOAL_EQUALS && r < fit->rows; r++, miss++)
            if (counts_at(fit, goal, r)) add_share(shares, miss, r, goal->channel[0], weight);
    }
    for (size_t k = 0; k < machine->claim_count; k++, miss++) {
        const YkClaim *claim = &machine->claim[k];
        if (lack_of(fit, claim, value) + strict <= 0) continue;
        double size = fabs(claim->limit) > 0 ? fabs(claim->limit) : 1, weight = scale_of_claims(fit) / size;
        share_measure(fit, claim->measure, claim->channel, value, claim->is_below ? weight : -weight, miss, shares);
    }
    qsort(shares->item, shares->count, sizeof *shares->item, by_row);
}
