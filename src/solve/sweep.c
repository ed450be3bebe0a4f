// The sweep. Between two rows the path is probed, and probed more finely wherever a block's margin (sin^2 of its
// transmission angle) could reach zero: a simple zero is a limit position, a double zero a change point, which the
// motion passes with the other sign.
#include <yoke/sweep.h>
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "solve/path.h"

enum { DEPTH_MAX = 44, MARGINS_MAX = 2000, EVENTS_MAX = 10000 };

struct YkSweep {
    YkPath path;
    YkSweepOptions options;
    YkChannel *channels;
    size_t channel_count, row_count, margin_count;
    double *at, *values;
    signed char *row_status;
    YkEvent *events;
    size_t event_count, event_capacity;
    double *margins;          // [depth][3][block]
    double *slope, *slope_at; // per channel: last nonzero derivative along the path, and where
    double *sums;             // per channel: scratch
    double *flipped_at;       // per block: its last change point (NaN: none yet)
    YkStatus status;
    YkProblems *problems;
    double worst_residual, from;
    bool failed;
    int limit_block;
};

YkSweepOptions yk_default_sweep_options(void)
{
    return (YkSweepOptions){-1, 0, 1, 36, 2 * YK_PI / 180, NULL, YK_METHOD_REDUCED};
}

static void add_event(YkSweep *w, YkEvent event)
{
    if (w->event_count >= EVENTS_MAX) return;
    if (!YK_ROOM(w->events, w->event_count, w->event_capacity)) {
        w->failed = true;
        return;
    }
    w->events[w->event_count++] = event;
}

static double *margins_of(const YkSweep *w, size_t depth, size_t which)
{
    return w->margins + (3 * depth + which) * w->margin_count;
}

static void read_margins(const YkSweep *w, double *margins)
{
    const YkState *s = w->path.state;
    if (s->mech->block_count != w->margin_count) margins[0] = s->space.margin[0];
    for (size_t k = 0; s->mech->block_count == w->margin_count && k < w->margin_count; k++)
        margins[k] = yk_path_margin(s, &s->space, k);
}

static bool has_margin(const YkSweep *w, size_t block)
{
    const YkMechanism *mech = w->path.state->mech;
    return w->margin_count != mech->block_count || mech->blocks[block].kind <= YK_BLOCK_RPR;
}

// --- extremes
// -----------------------------------------------------------------------------------------------------------

static bool is_smooth(YkChannel c)
{
    return c.order == 0 && c.kind != YK_CHANNEL_TIME && c.kind < YK_CHANNEL_POINT_SPEED;
}

// The derivative of a channel along the path, or 0 where it is not above rounding.
static double slope_here(const YkSweep *w, YkChannel c)
{
    if (!yk_state_has_rates(w->path.state)) return 0;
    double value = yk_state_channel(w->path.state, c);
    c.order = 1;
    double slope = yk_state_channel(w->path.state, c);
    return fabs(slope) * yk_path_scale(&w->path) > 1e-10 * (w->path.state->mech->size + fabs(value)) ? slope : 0;
}

// Takes the signs of the blocks from before the change points between `at` and `here` to after them, or back.
static void exchange_signs(YkSweep *w, double at, double here)
{
    for (size_t k = 0; k < w->event_count; k++) {
        const YkEvent *e = &w->events[k];
        bool between = (e->at - at) * (here - e->at) >= 0;
        if (e->kind == YK_EVENT_CHANGE_POINT && between)
            w->path.state->branch[e->block] = (signed char)-w->path.state->branch[e->block];
    }
}

// Solves at a place that the sweep has passed, on the branch that it had there.
static YkStatus look_back(YkSweep *w, double at, double here)
{
    exchange_signs(w, at, here);
    YkStatus status = yk_path_try(&w->path, at, true);
    exchange_signs(w, at, here);
    return status;
}

// Where a change point leaves no rates in the last digits of `at`, the motion turns round in it.
static double at_change_point(const YkSweep *w, double at)
{
    for (size_t k = w->event_count; k-- > 0;)
        if (w->events[k].kind == YK_EVENT_CHANGE_POINT && fabs(w->events[k].at - at) < 1e-5 * yk_path_scale(&w->path))
            return w->events[k].at;
    return at;
}

static void bisect_extreme(YkSweep *w, size_t channel, double from, double to, double slope)
{
    YkChannel value = w->channels[channel], rate = value;
    double here = to;
    rate.order = 1;
    for (int k = 0; k < 60 && fabs(to - from) > 1e-13 * yk_path_scale(&w->path); k++) {
        double middle = 0.5 * (from + to);
        if (look_back(w, middle, here) < 0) break;
        if (yk_state_channel(w->path.state, rate) * slope > 0)
            from = middle;
        else
            to = middle;
    }
    double at = 0.5 * (from + to);
    if (w->path.state->space.margin[0] < 1e-9) at = at_change_point(w, at);
    if (look_back(w, at, here) < 0) return;
    add_event(w, (YkEvent){.kind = YK_EVENT_EXTREME,
                           .at = at,
                           .block = -1,
                           .channel = channel,
                           .value = yk_state_channel(w->path.state, value),
                           .is_maximum = (slope > 0) == (w->options.to > w->options.from)});
}

// The state stands at `at`, verified: looks whether a channel turned round since it was last seen moving.
static void watch_extremes(YkSweep *w, double at)
{
    bool moved = false;
    for (size_t c = 0; c < w->channel_count; c++) {
        if (!is_smooth(w->channels[c])) continue;
        double slope = slope_here(w, w->channels[c]);
        if (slope == 0) continue;
        if (w->slope[c] * slope < 0 && fabs(slope) * yk_path_scale(&w->path) < 1e6) {
            bisect_extreme(w, c, w->slope_at[c], at, w->slope[c]);
            moved = true;
            yk_path_try(&w->path, at, true);
        }
        w->slope[c] = slope;
        w->slope_at[c] = at;
    }
    if (moved) yk_path_probe(&w->path, at, true);
}

// --- verified progress
// --------------------------------------------------------------------------------------------------

// Where a double zero lies between a and b: the root of the margin runs through it as a straight line.
static double touch(double a, double ma, double b, double mb)
{
    double ra = sqrt(fmax(ma, 0)), rb = sqrt(fmax(mb, 0));
    return ra + rb > 0 ? a + (b - a) * ra / (ra + rb) : 0.5 * (a + b);
}

// The sweep ends at `at`, since the machine does not close at `bad` - or no drive says where it is to be then.
static void mark_limit(YkSweep *w, double at, double bad)
{
    w->status = yk_path_set(&w->path, bad, true) < 0 ? YK_BAD_MODEL : YK_LIMIT;
    if (w->status == YK_BAD_MODEL) yk_state_set_time(w->path.state, bad, w->problems);
    add_event(w, (YkEvent){.kind = YK_EVENT_LIMIT, .at = at, .block = w->status == YK_LIMIT ? w->limit_block : -1});
    yk_path_probe(&w->path, at, true);
}

static bool was_flipped_near(const YkSweep *w, size_t block, double at)
{
    return fabs(w->flipped_at[block] - at) < 1e-4 * yk_path_scale(&w->path); // false for NaN
}

static double sine_at(YkSweep *w, size_t block, double at)
{
    const YkState *s = w->path.state; // no reference: on one side of the change point this is the other branch
    const YkSpace *space =
        yk_path_try(&w->path, at, true) >= 0 ? &s->space : &s->spare; // the block itself closes on both sides
    return sqrt(fmax(0, yk_path_margin(s, space, block)));
}

// Near a double zero of the margin its root is a straight line through zero: the secant from both sides finds it.
static double refine_touch(YkSweep *w, size_t block, double at)
{
    double d = 2e-4 * yk_path_scale(&w->path);
    for (int k = 0; k < 2; k++) {
        double before = sine_at(w, block, at - d), after = sine_at(w, block, at + d);
        if (!(before + after > 0)) return at;
        double moved = d * (before - after) / (before + after);
        if (fabs(moved) > 1e-3 * d + 1e-6 * yk_path_scale(&w->path)) return at;
        at += moved;
    }
    return at;
}

static void flip(YkSweep *w, size_t block, double at)
{
    YkState *s = w->path.state;
    at = refine_touch(w, block, at);
    s->branch[block] = (signed char)-s->branch[block];
    w->flipped_at[block] = at;
    add_event(w, (YkEvent){.kind = YK_EVENT_CHANGE_POINT, .at = at, .block = (int)block});
}

static bool advance(YkSweep *w, double a, double b, size_t depth);
static bool go_on(YkSweep *w, double from, double to, size_t depth);

// The machine closes at `good` and not at `bad`. Where it stops, a block may have come to a change point beyond which
// only its other sign fits the rest (a redundant link, a later dyad): then the motion goes on. Otherwise this is a
// limit.
static bool stop_or_pass(YkSweep *w, double good, double bad, size_t depth)
{
    YkState *s = w->path.state;
    w->limit_block = s->report.block;
    double at = yk_path_limit(&w->path, good, bad), beyond = at + copysign(2e-5 * yk_path_scale(&w->path), bad - at);
    bool fits = fabs(beyond - at) < fabs(bad - at) && w->margin_count == s->mech->block_count && depth + 1 < DEPTH_MAX;
    double *margins = margins_of(w, depth, 0);
    read_margins(w, margins);
    for (size_t k = 0; fits && k < w->margin_count; k++) {
        if (!has_margin(w, k) || margins[k] > 1e-8 || was_flipped_near(w, k, at)) continue;
        s->branch[k] = (signed char)-s->branch[k];
        bool passes = yk_path_probe(&w->path, beyond, true) >= 0;
        s->branch[k] = (signed char)-s->branch[k];
        if (!passes) continue;
        flip(w, k, touch(at, margins[k], beyond, yk_path_margin(s, &s->space, k)));
        yk_path_probe(&w->path, beyond, true);
        read_margins(w, margins_of(w, depth + 1, 0));
        return advance(w, beyond, bad, depth + 1);
    }
    mark_limit(w, at, bad);
    return false;
}

// Could the margin reach zero between its three samples? Not if it stays well above its own variation; nor where it is
// zero at an end and rises from there as a parabola or a line does.
static bool may_vanish(double a, double m, double b)
{
    double least = fmin(a, fmin(m, b)), most = fmax(a, fmax(m, b));
    if (a <= YK_SINGULAR_MARGIN || b <= YK_SINGULAR_MARGIN) return m < 0.1 * most;
    return least < 0.2 * (most - least);
}

typedef enum Verdict { CLEAR, FINER, TOUCHED } Verdict;

// Judges [a, b] from the margins at both ends and in the middle; in the narrowest intervals a touch is a change point.
static Verdict look(YkSweep *w, double a, double b, size_t depth)
{
    const double *ma = margins_of(w, depth, 0), *mm = margins_of(w, depth, 1), *mb = margins_of(w, depth, 2);
    bool narrow = fabs(b - a) < 4e-7 * yk_path_scale(&w->path) || depth + 1 >= DEPTH_MAX, touched = false;
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!has_margin(w, k) || !may_vanish(ma[k], mm[k], mb[k])) continue;
        if (!narrow) return FINER;
        if (fmin(ma[k], fmin(mm[k], mb[k])) > 1e-11 || w->margin_count != w->path.state->mech->block_count) continue;
        if (was_flipped_near(w, k, b)) continue;
        flip(w, k, touch(a, ma[k], b, mb[k]));
        touched = true;
    }
    return touched ? TOUCHED : CLEAR;
}

// Blocks that are singular at `a`, where the motion has come to and goes on: double zeros, passed with the other sign.
static void flip_at(YkSweep *w, double a, const double *margins)
{
    if (a == w->from || w->margin_count != w->path.state->mech->block_count) return;
    for (size_t k = 0; k < w->margin_count; k++)
        if (has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN && !was_flipped_near(w, k, a)) flip(w, k, a);
}

// Over time: do the drives go farther between a and b than the path may be left unseen?
static bool is_coarse(YkSweep *w, double a, double b)
{
    if (w->path.input >= 0 || yk_path_set(&w->path, 0.5 * (a + b), true) < 0) return false;
    double scale = yk_path_scale(&w->path);
    if (yk_path_set(&w->path, b, true) < 0) return false;
    return fabs(b - a) > 1.001 * w->options.turn_max * fmin(scale, yk_path_scale(&w->path));
}

static bool halve(YkSweep *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b), *next = margins_of(w, depth + 1, 0);
    memcpy(next, margins_of(w, depth, 0), w->margin_count * sizeof *next);
    return advance(w, a, middle, depth + 1) && go_on(w, middle, b, depth);
}

// From the valid pose at a (margins known at this depth) to b. False when stopped.
static bool advance(YkSweep *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b);
    if (depth + 1 < DEPTH_MAX && is_coarse(w, a, b)) return halve(w, a, b, depth);
    if (yk_path_try(&w->path, middle, true) < 0) return stop_or_pass(w, a, middle, depth) && go_on(w, middle, b, depth);
    read_margins(w, margins_of(w, depth, 1));
    if (yk_path_try(&w->path, b, true) < 0) return stop_or_pass(w, middle, b, depth);
    read_margins(w, margins_of(w, depth, 2));
    bool is_tracked =
        w->path.state->mech->has_groups && w->margin_count != w->path.state->mech->block_count; // checked on the way
    Verdict verdict = is_tracked ? CLEAR : look(w, a, b, depth);
    if (verdict == TOUCHED && yk_path_try(&w->path, b, true) < 0) return stop_or_pass(w, middle, b, depth);
    if (verdict != FINER) yk_path_refer(&w->path); // only poses on the branch are references
    return verdict == FINER ? halve(w, a, b, depth) : true;
}

// The state stands at `from`, reached a moment ago: on to `to`, one level down.
static bool go_on(YkSweep *w, double from, double to, size_t depth)
{
    if (depth + 1 >= DEPTH_MAX) return yk_path_probe(&w->path, to, true) >= 0 || stop_or_pass(w, from, to, depth);
    double *margins = margins_of(w, depth + 1, 0);
    read_margins(w, margins);
    flip_at(w, from, margins);
    return advance(w, from, to, depth + 1);
}

// In verified sub-steps from a to b.
static bool progress(YkSweep *w, double a, double b)
{
    double stride = w->options.turn_max * yk_path_scale(&w->path);
    size_t parts = (size_t)fmin(1e7, ceil(fabs(b - a) / stride));
    double last = a;
    for (size_t k = 1; k <= parts; k++) {
        double next = k == parts ? b : a + (b - a) * (double)k / (double)parts;
        double *margins = margins_of(w, 0, 0);
        read_margins(w, margins);
        flip_at(w, last, margins);
        if (!advance(w, last, next, 0)) return false;
        watch_extremes(w, next);
        last = next;
    }
    return true;
}

// --- rows
// ---------------------------------------------------------------------------------------------------------------

static bool wants_forces(const YkSweep *w)
{
    for (size_t c = 0; w->options.dynamics && c < w->channel_count; c++)
        if (yk_channel_needs_forces(w->channels[c])) return true;
    return false;
}

// The channels at the pose that stands; forces are NaN where they are not determined.
static void read_channels(const YkSweep *w, double *values)
{
    YkState *s = w->path.state;
    YkStatus status =
        wants_forces(w) && s->has_rates ? yk_dynamics_solve(w->options.dynamics, s, w->options.method) : YK_SINGULAR;
    bool has_forces = status == YK_OK || status == YK_REDUNDANT;
    for (size_t c = 0; c < w->channel_count; c++) {
        if (!yk_channel_needs_forces(w->channels[c]))
            values[c] = yk_state_channel(s, w->channels[c]);
        else
            values[c] = has_forces ? yk_dynamics_channel(w->options.dynamics, s, w->channels[c]) : (double)NAN;
    }
}

static bool record(YkSweep *w, double at)
{
    YkState *s = w->path.state;
    YkStatus status = yk_path_probe(&w->path, at, false);
    if (status < 0) {
        w->limit_block = s->report.block;
        mark_limit(w, w->row_count > 0 ? w->at[w->row_count - 1] : at, at);
        return false;
    }
    size_t row = w->row_count++;
    w->at[row] = at;
    w->row_status[row] = (signed char)status;
    read_channels(w, w->values + row * w->channel_count);
    w->worst_residual = fmax(w->worst_residual, yk_state_residuals(s).position);
    if (status == YK_SINGULAR) add_event(w, (YkEvent){.kind = YK_EVENT_SINGULAR, .at = at, .block = s->report.block});
    return true;
}

// The singular event of a row that proved to be a change point says nothing more.
static size_t drop_singular(YkSweep *w, double at)
{
    size_t kept = 0;
    for (size_t k = 0; k < w->event_count; k++)
        if (w->events[k].kind != YK_EVENT_SINGULAR || w->events[k].at != at) w->events[kept++] = w->events[k];
    return kept;
}

// A row on a change point itself: J is singular there, but the motion is smooth through it, so its rates are the limits
// from both sides: interpolated from four poses on each (Lagrange, error O(h^8)). The blocks that touch have the other
// sign on the near side.
static void fill_change_row(YkSweep *w, size_t row, const double *margins, double way)
{
    enum { SIDE = 4 };
    YkState *s = w->path.state;
    double at = w->at[row], h = 0.01 * yk_path_scale(&w->path) * way, *sums = w->sums;
    bool ok = true;
    for (size_t c = 0; c < w->channel_count; c++) sums[c] = 0;
    for (int side = 1; side >= -1; side -= 2) {
        for (int k = 1; k <= SIDE; k++) {
            double weight = 0.5;
            for (int j = 1; j <= SIDE; j++)
                if (j != k) weight *= (double)(j * j) / (double)(j * j - k * k);
            ok = ok && yk_path_probe(&w->path, at + side * k * h, false) >= 0;
            if (ok) read_channels(w, w->slope); // scratch here: extremes are looked for between rows
            for (size_t c = 0; ok && c < w->channel_count; c++) sums[c] += weight * w->slope[c];
        }
        for (size_t k = 0; k < w->margin_count; k++) // to the near side, and back
            if (has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN) s->branch[k] = (signed char)-s->branch[k];
    }
    yk_path_probe(&w->path, at + h, true); // from where its signs are now
    yk_path_probe(&w->path, at, true);
    if (!ok) return;
    w->row_status[row] = YK_CHANGE_POINT;
    for (size_t c = 0; c < w->channel_count; c++)
        if (w->channels[c].order > 0 || w->channels[c].kind >= YK_CHANNEL_POINT_SPEED)
            w->values[row * w->channel_count + c] = sums[c];
}

// After a row that came out singular: does the motion go on beyond with the touching blocks' other sign?
static void try_change_row(YkSweep *w)
{
    size_t row = w->row_count - 1;
    double way = w->options.to > w->options.from ? 1 : -1, *margins = margins_of(w, 0, 0);
    YkState *s = w->path.state;
    if (w->row_status[row] != YK_SINGULAR || w->margin_count != s->mech->block_count || s->mech->has_groups || row == 0)
        return;
    read_margins(w, margins);
    flip_at(w, w->at[row], margins);
    fill_change_row(w, row, margins, way);
    if (w->row_status[row] == YK_CHANGE_POINT) {
        w->event_count = drop_singular(w, w->at[row]);
        return;
    }
    for (size_t k = 0; k < w->margin_count; k++) // a limit after all: take the signs back
        if (was_flipped_near(w, k, w->at[row])) {
            s->branch[k] = (signed char)-s->branch[k];
            w->flipped_at[k] = NAN;
            w->event_count--;
        }
}

static void run_rows(YkSweep *w)
{
    const YkSweepOptions *o = &w->options;
    double last = o->from;
    // from the pose of the state to the start of the sweep, on the same branch
    YkState *s = w->path.state;
    double here = w->path.input < 0 ? s->time : s->valid_input[3 * w->path.input];
    w->from = here;
    yk_path_probe(&w->path, here, true);
    size_t channels = w->channel_count;
    w->channel_count = 0;
    bool ok = here == o->from || progress(w, here, o->from);
    w->channel_count = channels;
    w->event_count = ok ? 0 : w->event_count;
    w->from = o->from;
    if (!ok || !record(w, o->from)) return;
    yk_path_probe(&w->path, o->from, true);
    watch_extremes(w, o->from);
    for (size_t k = 1; k <= o->steps; k++) {
        double next = k == o->steps ? o->to : o->from + (o->to - o->from) * (double)k / (double)o->steps;
        if (!progress(w, last, next) || !record(w, next)) return;
        yk_path_probe(&w->path, next, true);
        try_change_row(w);
        last = next;
    }
}

// The state ends at the last pose, with the motion's own rates.
static void run(YkSweep *w)
{
    run_rows(w);
    yk_path_probe(&w->path, w->path.last, false);
}

static bool allocate(YkSweep *w)
{
    size_t rows = w->options.steps + 1, blocks = w->path.state->mech->block_count;
    w->margin_count = blocks == 0 || blocks > MARGINS_MAX ? 1 : blocks;
    w->at = calloc(rows, sizeof *w->at);
    w->values = calloc(rows * w->channel_count + 1, sizeof *w->values);
    w->row_status = calloc(rows, 1);
    w->margins = calloc(3 * (DEPTH_MAX + 1) * w->margin_count, sizeof *w->margins);
    w->slope = calloc(w->channel_count + 1, sizeof *w->slope);
    w->slope_at = calloc(w->channel_count + 1, sizeof *w->slope_at);
    w->sums = calloc(w->channel_count + 1, sizeof *w->sums);
    w->flipped_at = calloc(w->margin_count, sizeof *w->flipped_at);
    for (size_t k = 0; w->flipped_at && k < w->margin_count; k++) w->flipped_at[k] = NAN;
    w->channels = calloc(w->channel_count + 1, sizeof *w->channels);
    return w->at && w->values && w->row_status && w->margins && w->slope && w->slope_at && w->sums && w->flipped_at &&
           w->channels;
}

static bool are_good(const YkState *state, const YkSweepOptions *o, YkProblems *problems)
{
    bool is_input = o->coordinate < 0 || ((size_t)o->coordinate < state->mech->coordinate_count &&
                                          state->mech->coordinates[o->coordinate].input != YK_NONE);
    bool ok = is_input && isfinite(o->from) && isfinite(o->to) && o->steps > 0 && o->steps < 100000000 &&
              o->turn_max > 0 && state->has_pose;
    if (!ok)
        yk_problem(problems, YK_CODE_SWEEP_RANGE, (YkPlace){0},
                   "this range cannot be swept: it needs finite ends, 1 to 1e8 steps and an input of the machine");
    return ok;
}

YkSweep *yk_sweep_run(YkState *state, const YkSweepOptions *options, const YkChannel *channels, size_t channel_count,
                      YkProblems *problems)
{
    if (!are_good(state, options, problems)) return NULL;
    YkSweep *w = calloc(1, sizeof *w);
    if (!w) return NULL;
    w->options = *options;
    w->channel_count = channel_count;
    w->problems = problems;
    if (!yk_path_start(&w->path, state, options->coordinate) || !allocate(w)) {
        yk_sweep_free(w);
        return NULL;
    }
    if (channel_count > 0) memcpy(w->channels, channels, channel_count * sizeof *channels);
    run(w);
    if (w->failed) {
        yk_sweep_free(w);
        return NULL;
    }
    return w;
}

void yk_sweep_free(YkSweep *w)
{
    if (!w) return;
    yk_path_end(&w->path);
    free(w->at);
    free(w->values);
    free(w->row_status);
    free(w->events);
    free(w->margins);
    free(w->slope);
    free(w->slope_at);
    free(w->sums);
    free(w->flipped_at);
    free(w->channels);
    free(w);
}

YkStatus yk_sweep_status(const YkSweep *w)
{
    return w->status;
}
size_t yk_sweep_row_count(const YkSweep *w)
{
    return w->row_count;
}
double yk_sweep_at(const YkSweep *w, size_t row)
{
    return w->at[row];
}
double yk_sweep_value(const YkSweep *w, size_t row, size_t channel)
{
    return w->values[row * w->channel_count + channel];
}
YkStatus yk_sweep_row_status(const YkSweep *w, size_t row)
{
    return (YkStatus)w->row_status[row];
}
size_t yk_sweep_event_count(const YkSweep *w)
{
    return w->event_count;
}
YkEvent yk_sweep_event(const YkSweep *w, size_t index)
{
    return w->events[index];
}
double yk_sweep_worst_residual(const YkSweep *w)
{
    return w->worst_residual;
}
