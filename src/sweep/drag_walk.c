// The pose from which a drag goes on: its distance from the target, and the stops that it is beyond.
#include <math.h>
#include "loads/point.h"
#include "sweep/drag_walk.h"

double yk_drag_distance(const YkDrag *d)
{
    return yk_norm(yk_sub(yk_load_point(d->state->mech, &d->state->space, &d->end).at, d->target));
}

double yk_drag_scale(const YkDrag *d, size_t active)
{
    return yk_input_unit(d->state->mech, (size_t)d->active[active]);
}

static double value_of(const YkDrag *d, size_t stop)
{
    return yk_loads_coordinate(d->state, &d->state->space, d->stops[stop].coordinate).position;
}

// How far the coordinate is beyond its stop, over its scale.
static double beyond(const YkDrag *d, size_t stop)
{
    const YkDragStop *s = &d->stops[stop];
    double value = value_of(d, stop);
    return fmax(s->low - value, value - s->high) / s->scale;
}

// Returns whether the present pose is beyond a stop.
static bool is_beyond(const YkDrag *d, size_t stop)
{
    return beyond(d, stop) > 1e-12;
}

void yk_drag_widen_stops(YkDrag *d)
{
    for (size_t k = 0; k < d->stop_count; k++) {
        double value = value_of(d, k);
        d->stops[k].low = fmin(d->stops[k].own->low, value);
        d->stops[k].high = fmax(d->stops[k].own->high, value);
    }
}

size_t yk_drag_meet_stop(YkDrag *d, double a, double *b)
{
    size_t met = SIZE_MAX;
    YkPath *path = &d->walk.path;
    for (size_t k = 0; k < d->stop_count; k++) {
        if (!is_beyond(d, k)) continue;
        double inside = a, outside = *b;
        for (int j = 0; j < 60 && fabs(outside - inside) > 1e-13 * yk_path_scale(path); j++) {
            double middle = 0.5 * (inside + outside);
            bool is_out = yk_path_probe(path, middle, true) < 0 || beyond(d, k) > 0;
            *(is_out ? &outside : &inside) = middle;
        }
        yk_path_probe(path, *b = inside, true);
        met = k;
    }
    return met;
}

void yk_drag_begin_walk(YkDrag *d)
{
    YkWalk *w = &d->walk;
    w->event_count = w->more_events = 0;
    w->status = YK_OK;
    w->limit_block = -1;
    for (size_t k = 0; k < w->margin_count; k++) w->flipped_at[k] = NAN;
    for (size_t k = 0; k < w->path.meeting_count; k++) w->path.meetings[k].is_known = false;
    w->has_begun = false;
    YkPath *path = &w->path;
    for (size_t i = 0; i < d->state->mech->input_count; i++) path->others[3 * i] = d->state->valid_input[3 * i];
    path->last = path->is_line ? 0 : d->state->valid_input[3 * path->input];
    path->way = 0;
    w->from = path->last;
}
