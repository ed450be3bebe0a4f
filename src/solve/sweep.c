// The sweep. Between two rows the path is probed, and probed more finely wherever a block's margin (sin^2 of its transmission angle) could
// reach zero: a simple zero is a limit position, a double zero a change point, which the motion passes with the other sign.
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
    double *margins;       // [depth][3][block]
    double *slope, *slope_at; // per channel: last nonzero derivative along the path, and where
    YkStatus status;
    double worst_residual, from;
    bool failed;
};

YkSweepOptions yk_default_sweep_options(void) { return (YkSweepOptions){-1, 0, 1, 36, 2 * YK_PI / 180}; }

static void add_event(YkSweep *w, YkEvent event)
{
    if (w->event_count >= EVENTS_MAX) return;
    if (!YK_ROOM(w->events, w->event_count, w->event_capacity)) {
        w->failed = true;
        return;
    }
    w->events[w->event_count++] = event;
}

static double *margins_of(const YkSweep *w, size_t depth, size_t which) { return w->margins + (3 * depth + which) * w->margin_count; }

static void read_margins(const YkSweep *w, double *margins)
{
    const YkSpace *space = &w->path.state->space;
    if (space->blocks == w->margin_count)
        memcpy(margins, space->block_margin, w->margin_count * sizeof *margins);
    else
        margins[0] = space->margin[0];
}

static bool has_margin(const YkSweep *w, size_t block)
{
    const YkMechanism *mech = w->path.state->mech;
    return w->margin_count != mech->block_count || mech->blocks[block].kind <= YK_BLOCK_RPR;
}

// --- extremes -----------------------------------------------------------------------------------------------------------

static bool is_smooth(YkChannel c) { return c.order == 0 && c.kind != YK_CHANNEL_TIME && c.kind < YK_CHANNEL_POINT_SPEED; }

// The derivative of a channel along the path, or 0 where it is not above rounding.
static double slope_here(const YkSweep *w, YkChannel c)
{
    if (!yk_state_has_rates(w->path.state)) return 0;
    double value = yk_state_channel(w->path.state, c);
    c.order = 1;
    double slope = yk_state_channel(w->path.state, c);
    return fabs(slope) * yk_path_scale(&w->path) > 1e-10 * (w->path.state->mech->size + fabs(value)) ? slope : 0;
}

static void bisect_extreme(YkSweep *w, size_t channel, double from, double to, double slope)
{
    YkChannel c = w->channels[channel];
    for (int k = 0; k < 60 && fabs(to - from) > 1e-13 * yk_path_scale(&w->path); k++) {
        double middle = 0.5 * (from + to);
        if (yk_path_probe(&w->path, middle, true) < 0) break;
        YkChannel rate = c;
        rate.order = 1;
        if (yk_state_channel(w->path.state, rate) * slope > 0)
            from = middle;
        else
            to = middle;
    }
    double at = 0.5 * (from + to);
    if (yk_path_probe(&w->path, at, true) < 0) return;
    double value = yk_state_channel(w->path.state, c);
    add_event(w, (YkEvent){.kind = YK_EVENT_EXTREME, .at = at, .block = -1, .channel = channel, .value = value, .is_maximum = (slope > 0) == (w->options.to > w->options.from)});
}

// The state stands at `at`, verified: looks whether a channel turned round since it was last seen moving.
static void watch_extremes(YkSweep *w, double at)
{
    bool moved = false;
    for (size_t c = 0; c < w->channel_count; c++) {
        if (!is_smooth(w->channels[c])) continue;
        double slope = slope_here(w, w->channels[c]);
        if (slope == 0) continue;
        if (w->slope[c] * slope < 0 && fabs(slope) < 1e6 * yk_path_scale(&w->path)) {
            bisect_extreme(w, c, w->slope_at[c], at, w->slope[c]);
            moved = true;
            yk_path_probe(&w->path, at, true);
        }
        w->slope[c] = slope;
        w->slope_at[c] = at;
    }
    if (moved) yk_path_probe(&w->path, at, true);
}

// --- verified progress --------------------------------------------------------------------------------------------------

static bool stop_at_limit(YkSweep *w, double good, double bad)
{
    int block = w->path.state->report.block;
    double at = yk_path_limit(&w->path, good, bad);
    add_event(w, (YkEvent){.kind = YK_EVENT_LIMIT, .at = at, .block = block});
    w->status = YK_LIMIT;
    return false;
}

static void flip(YkSweep *w, size_t block, double at)
{
    YkState *s = w->path.state;
    s->branch[block] = (signed char)-s->branch[block];
    add_event(w, (YkEvent){.kind = YK_EVENT_CHANGE_POINT, .at = at, .block = (int)block});
    if (w->row_count > 0 && w->at[w->row_count - 1] == at) w->row_status[w->row_count - 1] = YK_CHANGE_POINT;
}

// Could the margin reach zero between its three samples? Not if it stays well above its own variation; nor where it is
// zero at an end and rises from there as a parabola or a line does.
static bool may_vanish(double a, double m, double b)
{
    double least = fmin(a, fmin(m, b)), most = fmax(a, fmax(m, b));
    if (a <= YK_SINGULAR_MARGIN || b <= YK_SINGULAR_MARGIN) return m < 0.1 * most;
    return least < 0.2 * (most - least);
}

// Where a double zero lies between a and b: the root of the margin runs through it as a straight line.
static double touch(double a, double ma, double b, double mb)
{
    double ra = sqrt(fmax(ma, 0)), rb = sqrt(fmax(mb, 0));
    return ra + rb > 0 ? a + (b - a) * ra / (ra + rb) : 0.5 * (a + b);
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
        if (has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN) flip(w, k, a);
}

// From the valid pose at a (margins known at this depth) to b. False when stopped.
static bool advance(YkSweep *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b);
    if (yk_path_probe(&w->path, middle, true) < 0) return stop_at_limit(w, a, middle);
    read_margins(w, margins_of(w, depth, 1));
    if (yk_path_probe(&w->path, b, true) < 0) return stop_at_limit(w, middle, b);
    read_margins(w, margins_of(w, depth, 2));
    if (w->path.state->mech->has_groups) return true; // tracked: checked on the way
    Verdict verdict = look(w, a, b, depth);
    if (verdict == FINER) {
        double *next = margins_of(w, depth + 1, 0);
        memcpy(next, margins_of(w, depth, 0), w->margin_count * sizeof *next);
        if (!advance(w, a, middle, depth + 1)) return false;
        read_margins(w, next);
        flip_at(w, middle, next);
        if (!advance(w, middle, b, depth + 1)) return false;
    }
    if (verdict == TOUCHED && yk_path_probe(&w->path, b, true) < 0) return stop_at_limit(w, a, b);
    return true;
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

// --- rows ---------------------------------------------------------------------------------------------------------------

static bool record(YkSweep *w, double at)
{
    YkState *s = w->path.state;
    YkStatus status = yk_path_probe(&w->path, at, false);
    if (status < 0) return stop_at_limit(w, w->row_count > 0 ? w->at[w->row_count - 1] : at, at);
    size_t row = w->row_count++;
    w->at[row] = at;
    w->row_status[row] = (signed char)status;
    for (size_t c = 0; c < w->channel_count; c++) w->values[row * w->channel_count + c] = yk_state_channel(s, w->channels[c]);
    YkResiduals r = yk_state_residuals(s);
    w->worst_residual = fmax(w->worst_residual, r.position);
    if (status == YK_SINGULAR) add_event(w, (YkEvent){.kind = YK_EVENT_SINGULAR, .at = at, .block = s->report.block});
    return true;
}

static void run(YkSweep *w)
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
        last = next;
    }
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
    w->channels = calloc(w->channel_count + 1, sizeof *w->channels);
    return w->at && w->values && w->row_status && w->margins && w->slope && w->slope_at && w->channels;
}

static bool are_good(const YkState *state, const YkSweepOptions *o, YkProblems *problems)
{
    bool is_input = o->coordinate < 0 || ((size_t)o->coordinate < state->mech->coordinate_count &&
                                          state->mech->coordinates[o->coordinate].input != YK_NONE);
    bool ok = is_input && isfinite(o->from) && isfinite(o->to) && o->steps > 0 && o->steps < 100000000 && o->turn_max > 0 && state->has_pose;
    if (!ok) yk_problem(problems, YK_CODE_SWEEP_RANGE, (YkPlace){0}, "this range cannot be swept: it needs finite ends, 1 to 1e8 steps and an input of the machine");
    return ok;
}

YkSweep *yk_sweep_run(YkState *state, const YkSweepOptions *options, const YkChannel *channels, size_t channel_count, YkProblems *problems)
{
    if (!are_good(state, options, problems)) return NULL;
    YkSweep *w = calloc(1, sizeof *w);
    if (!w) return NULL;
    w->options = *options;
    w->channel_count = channel_count;
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
    free(w->channels);
    free(w);
}

YkStatus yk_sweep_status(const YkSweep *w) { return w->status; }
size_t yk_sweep_row_count(const YkSweep *w) { return w->row_count; }
double yk_sweep_at(const YkSweep *w, size_t row) { return w->at[row]; }
double yk_sweep_value(const YkSweep *w, size_t row, size_t channel) { return w->values[row * w->channel_count + channel]; }
YkStatus yk_sweep_row_status(const YkSweep *w, size_t row) { return (YkStatus)w->row_status[row]; }
size_t yk_sweep_event_count(const YkSweep *w) { return w->event_count; }
YkEvent yk_sweep_event(const YkSweep *w, size_t index) { return w->events[index]; }
double yk_sweep_worst_residual(const YkSweep *w) { return w->worst_residual; }
