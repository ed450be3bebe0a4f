// Finds extremes of the channels: where a slope along the path changes its sign, bisected on the branch that was
// passed.
#include "sweep/sweep.h"

static bool is_smooth(YkChannel c)
{
    return c.order == 0 && c.kind != YK_CHANNEL_TIME && c.kind < YK_CHANNEL_POINT_SPEED;
}

// Returns one unit of a channel: a turn, or the machine's size.
static double unit_of(const YkSweep *w, YkChannel c)
{
    return c.quantity == YK_QUANTITY_ANGLE ? 2 * YK_PI : w->walk.path.state->mech->size;
}

// Returns the derivative of a channel along the path, or 0 if it is not above rounding, or could be another branch's.
// Near a change point the pose is known to the rounding over the sine of the transmission angle, rates to that over its
// square.
static double slope_here(const YkSweep *w, YkChannel c)
{
    const double ROUNDING = 1e-15;
    const YkState *s = w->walk.path.state;
    double margin = s->space.margin[0], noise = s->is_regular ? 0 : ROUNDING / margin;
    if (!s->has_rates || (margin < YK_BRANCH_MARGIN && !s->is_regular)) return 0;
    double value = yk_state_channel(s, c), unit = unit_of(w, c);
    c.order = 1;
    double slope = yk_state_channel(s, c), least = fmax(1e-10, noise) * (unit + fabs(value));
    return fabs(slope) * yk_path_scale(&w->walk.path) > least ? slope : 0;
}

// Changes the signs of the blocks from those after the change points passed since `at` to those before, or back. A
// change point at `at` itself is seen from the walk's position beyond it: its signs stay.
static void exchange_signs(YkSweep *w, double at)
{
    double way = w->options.to > w->options.from ? 1 : -1;
    for (size_t k = 0; k < w->walk.event_count; k++) {
        const YkEvent *e = &w->walk.events[k];
        if (e->is_passed && (e->at - at) * way > 0)
            w->walk.path.state->branch[e->block] = (signed char)-w->walk.path.state->branch[e->block];
    }
    if ((w->walk.path.passed - at) * way > 0) w->walk.path.side = -w->walk.path.side;
}

YkStatus yk_sweep_look_back(YkSweep *w, double at, bool along)
{
    double last = w->walk.path.last, way = w->options.to > w->options.from ? 1 : -1;
    exchange_signs(w, at);
    w->walk.path.last = at + way; // where two configurations meet, takes the one seen from beyond
    YkStatus status = yk_path_try(&w->walk.path, at, along);
    if (status < 0) w->walk.path.last = last;
    exchange_signs(w, at);
    return status;
}

// Handles a change point between two places that leaves no rates next to it: the motion turns round in it.
static double at_change_point(const YkSweep *w, double at, double from, double to)
{
    for (size_t k = w->walk.event_count; k-- > 0;) {
        const YkEvent *e = &w->walk.events[k];
        if (e->kind == YK_EVENT_CHANGE_POINT && (e->at - from) * (to - e->at) >= 0 &&
            yk_path_way(&w->walk.path, e->at, at) < 1e-4)
            return e->at;
    }
    return at;
}

// Notes the extreme between two places that the sweep has passed on its branch; none if a pose between them does not
// close on that branch.
static void bisect_extreme(YkSweep *w, size_t channel, double from, double to, double slope)
{
    YkChannel value = w->channels[channel], rate = value;
    double first = from, last = to;
    rate.order = 1;
    for (int k = 0; k < 60 && fabs(to - from) > 1e-13 * yk_path_scale(&w->walk.path); k++) {
        double middle = 0.5 * (from + to);
        if (yk_sweep_look_back(w, middle, true) < 0) return;
        if (yk_state_channel(w->walk.path.state, rate) * slope > 0)
            from = middle;
        else
            to = middle;
    }
    double at = 0.5 * (from + to);
    if (w->walk.path.state->space.margin[0] < 2 * YK_BLUR_MARGIN) at = at_change_point(w, at, first, last);
    if (yk_sweep_look_back(w, at, true) < 0) return;
    yk_walk_note(&w->walk, (YkEvent){.kind = YK_EVENT_EXTREME,
                                     .at = at,
                                     .block = -1,
                                     .channel = channel,
                                     .value = yk_state_channel(w->walk.path.state, value),
                                     .is_maximum = (slope > 0) == (w->options.to > w->options.from)});
}

void yk_sweep_watch_extremes(YkSweep *w, double at)
{
    const double STEEP = 1e6; // units over one of the path: so the channel goes to a limit, and does not turn round
    bool moved = false;
    for (size_t c = 0; c < w->channel_count; c++) {
        if (!is_smooth(w->channels[c])) continue;
        double slope = slope_here(w, w->channels[c]);
        if (slope == 0) continue;
        if (w->slope[c] * slope < 0 &&
            fabs(slope) * yk_path_scale(&w->walk.path) < STEEP * unit_of(w, w->channels[c])) {
            bisect_extreme(w, c, w->slope_at[c], at, w->slope[c]);
            moved = true;
            yk_path_try(&w->walk.path, at, true);
        }
        w->slope[c] = slope;
        w->slope_at[c] = at;
    }
    if (moved) yk_path_probe(&w->walk.path, at, true);
}
