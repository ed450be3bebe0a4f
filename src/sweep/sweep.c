// The sweep as a whole: memory, the way from row to row, results.
#include "sweep/meeting.h"
#include "sweep/sweep.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"

YkSweepOptions yk_default_sweep_options(void)
{
    return (YkSweepOptions){
        .coordinate = -1, .from = 0, .to = 1, .steps = 36, .turn_max = 2 * YK_PI / 180, .method = YK_METHOD_REDUCED};
}

static bool watch(void *context, double at)
{
    yk_sweep_watch_extremes(context, at);
    yk_sweep_read_events(context, at);
    return true;
}

// Goes from the pose of the state to the start of the sweep, on the same branch; events on that way are not recorded.
// If the sweep goes on in the same direction, a change point at its start is passed as anywhere else; if it turns back
// there, the signs hold that it came with.
static bool approach(YkSweep *w)
{
    YkWalk *walk = &w->walk;
    YkState *s = walk->path.state;
    double here = walk->path.input < 0 ? s->time : s->valid_input[3 * walk->path.input], from = w->options.from;
    walk->from = here;
    yk_path_probe(&walk->path, here, true);
    yk_walk_begin_at(walk, here, (here == from ? w->options.to : from) > here ? 1 : -1);
    if (yk_walk_refuses(walk, from, w->options.to)) return false;
    bool is_chain = s->mech->block_count == 0; // without loops nothing can fail to close on the way
    bool ok = here == from || (is_chain && yk_path_probe(&walk->path, from, true) >= 0) ||
              (!yk_walk_refuses(walk, here, from) && yk_walk_go(walk, here, from));
    if (ok) walk->event_count = walk->more_events = 0;
    walk->from = from;
    // The sweep may pass it again immediately.
    for (size_t k = 0; k < walk->margin_count; k++) walk->flipped_at[k] = NAN;
    return ok;
}

static void run_rows(YkSweep *w)
{
    const YkSweepOptions *o = &w->options;
    YkWalk *walk = &w->walk;
    double last = o->from;
    if (!approach(w) || !yk_sweep_record(w, o->from)) return;
    yk_path_probe(&walk->path, o->from, true);
    yk_sweep_try_change_row(w);
    yk_sweep_watch_extremes(w, o->from);
    walk->arrived = watch;
    walk->context = w;
    for (size_t k = 1; k <= o->steps; k++) {
        double next = k == o->steps ? o->to : o->from + (o->to - o->from) * (double)k / (double)o->steps;
        if (!yk_walk_go(walk, last, next) || !yk_sweep_record(w, next)) return;
        yk_pace_reach(walk->path.state->pace, (double)k / (double)o->steps);
        yk_path_probe(&walk->path, next, true);
        yk_sweep_try_change_row(w);
        last = next;
    }
}

// Runs the sweep. The state ends at the last pose, with the motion's own rates.
static void run(YkSweep *w)
{
    run_rows(w);
    if (w->row_count > 0) yk_sweep_read_events(w, w->walk.path.last);
    if (w->walk.status != YK_STOPPED) yk_path_settle(&w->walk.path);
    if (w->walk.status == YK_OK) yk_walk_arrive(&w->walk, w->options.to > w->options.from ? 1 : -1);
}

static bool allocate(YkSweep *w)
{
    size_t rows = w->options.steps + 1;
    YkArena *a = w->arena = yk_arena_new();
    w->rows = calloc(rows * (1 + w->channel_count), sizeof *w->rows); // rows beyond a limit then cost no memory
    w->row_status = calloc(rows, 1);
    w->slope = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->slope);
    w->slope_at = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->slope_at);
    w->sums = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->sums);
    w->beside = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->beside);
    w->largest = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->largest);
    w->channels = yk_arena_alloc(a, w->channel_count + 1, sizeof *w->channels);
    return !yk_arena_failed(a) && w->rows && w->row_status;
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

static YkSweep *sweep(YkState *state, const YkSweepOptions *options, const YkChannel *channels, size_t channel_count,
                      YkProblems *problems)
{
    if (!are_good(state, options, problems)) return NULL;
    YkSweep *w = calloc(1, sizeof *w);
    if (!w) return NULL;
    w->options = *options;
    w->channel_count = channel_count;
    YkPath path;
    yk_path_start(&path, state, options->coordinate);
    if (!yk_walk_start(&w->walk, path, options->turn_max) || !allocate(w)) {
        yk_sweep_free(w);
        return NULL;
    }
    w->walk.problems = problems;
    if (channel_count > 0) memcpy(w->channels, channels, channel_count * sizeof *channels);
    run(w);
    if (w->walk.failed) {
        yk_sweep_free(w);
        return NULL;
    }
    return w;
}

YkSweep *yk_sweep_run(YkState *state, const YkSweepOptions *options, const YkChannel *channels, size_t channel_count,
                      YkProblems *problems)
{
    bool is_own = yk_state_begin(state);
    YkSweep *w = sweep(state, options, channels, channel_count, problems);
    if (yk_state_end(state, is_own, YK_OK) != YK_STOPPED) return w;
    yk_sweep_free(w);
    yk_problem_stopped(problems);
    return NULL;
}

void yk_sweep_free(YkSweep *w)
{
    if (!w) return;
    yk_walk_end(&w->walk);
    yk_arena_free(w->arena);
    free(w->rows);
    free(w->row_status);
    free(w->event_values);
    free(w);
}

YkStatus yk_sweep_status(const YkSweep *w)
{
    return w->walk.status;
}
size_t yk_sweep_row_count(const YkSweep *w)
{
    return w->row_count;
}
double yk_sweep_at(const YkSweep *w, size_t row)
{
    return row < w->row_count ? *yk_sweep_row(w, row) : (double)NAN;
}
double yk_sweep_value(const YkSweep *w, size_t row, size_t channel)
{
    return row < w->row_count && channel < w->channel_count ? yk_sweep_row(w, row)[1 + channel] : (double)NAN;
}
const double *yk_sweep_rows(const YkSweep *w)
{
    return w->rows;
}
YkStatus yk_sweep_row_status(const YkSweep *w, size_t row)
{
    return row < w->row_count ? (YkStatus)w->row_status[row] : YK_BAD_ARGUMENT;
}
size_t yk_sweep_event_total(const YkSweep *w)
{
    return w->walk.event_count + w->walk.more_events;
}
size_t yk_sweep_event_count(const YkSweep *w)
{
    return w->walk.event_count;
}
YkEvent yk_sweep_event(const YkSweep *w, size_t index)
{
    if (index >= w->walk.event_count)
        return (YkEvent){.at = (double)NAN, .block = -1, .channel = YK_NOT_FOUND, .value = (double)NAN};
    return w->walk.events[index];
}
double yk_sweep_worst_residual(const YkSweep *w)
{
    return w->worst_residual;
}
