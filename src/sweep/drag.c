// Dragging with one free input: along its way until the distance grows, or the motion ends.
#include <stdlib.h>
#include <string.h>
#include "loads/point.h"
#include "sweep/drag_walk.h"

enum { EVENTS_KEPT = 64, STEPS_MAX = 4000 };
static const double TURN_MAX = 8 * YK_PI / 180, REACHED = 1e-9; // REACHED: of the machine's size

// --- making ---------------------------------------------------------------------------------------

static bool take_stops(YkDrag *d)
{
    const YkMechanism *mech = d->state->mech;
    d->stops = calloc(mech->model->stop_count + 1, sizeof *d->stops);
    for (size_t k = 0; d->stops && k < mech->model->stop_count; k++) {
        const YkStop *stop = &mech->model->stops[k];
        const YkCoordinate *c = &mech->model->coordinates[stop->coordinate];
        int32_t q = yk_tree_coordinate(mech, c->joint, c->is_distance);
        if (q != YK_NONE)
            d->stops[d->stop_count++] = (YkDragStop){stop, q, stop->low, stop->high, c->is_distance ? mech->size : 1};
    }
    return d->stops != NULL;
}

static bool take_inputs(YkDrag *d, const bool *is_fixed)
{
    const YkMechanism *mech = d->state->mech;
    size_t n = mech->input_count;
    d->active = calloc(n + 1, sizeof *d->active);
    d->memory = calloc((9 + YK_DRAG_NORMALS) * n + 1, sizeof(double));
    if (!d->active || !d->memory) return false;
    for (size_t i = 0; i < n; i++)
        if (!(is_fixed && is_fixed[i]) && !yk_coordinate_info(mech, (size_t)mech->inputs[i]).is_held)
            d->active[d->active_count++] = (int32_t)i;
    d->goal = d->memory;
    d->home = d->goal + 3 * n;
    d->jx = d->home + 3 * n;
    d->jy = d->jx + n;
    d->way = d->jy + n;
    d->normal = d->way + n;
    return true;
}

static bool prepare(YkDrag *d, const bool *is_fixed)
{
    YkPath path;
    if (!take_inputs(d, is_fixed) || !take_stops(d)) return false;
    bool is_single = d->active_count == 1;
    size_t input = d->active_count > 0 ? (size_t)d->active[0] : 0;
    bool ok = is_single ? yk_path_start(&path, d->state, (int)d->state->mech->inputs[input])
                        : yk_path_start_line(&path, d->state, d->goal);
    if (!ok || !yk_walk_start(&d->walk, path, TURN_MAX)) return false;
    d->walk.events = calloc(EVENTS_KEPT, sizeof *d->walk.events);
    d->walk.event_capacity = d->walk.events_max = EVENTS_KEPT; // so that noting one allocates nothing
    return d->walk.events != NULL;
}

YkDrag *yk_drag_new(YkState *state, size_t body, const double place[2], const bool *is_fixed)
{
    if (body >= state->mech->model->body_count) return NULL;
    YkDrag *d = calloc(1, sizeof *d);
    if (!d) return NULL;
    d->state = state;
    d->end = yk_load_end(state->mech, (int32_t)body, yk_vec(place[0], place[1]));
    if (prepare(d, is_fixed)) return d;
    yk_drag_free(d);
    return NULL;
}

void yk_drag_free(YkDrag *d)
{
    if (!d) return;
    yk_walk_end(&d->walk);
    free(d->stops);
    free(d->active);
    free(d->memory);
    free(d);
}

// --- along one input ------------------------------------------------------------------------------

// How the squared distance's half goes with the path.
static double slope_here(const YkDrag *d)
{
    YkLoadPoint p = yk_load_point(d->state->mech, &d->state->space, &d->end);
    return yk_dot(yk_sub(p.at, d->target), p.velocity);
}

// How far to go at once: no body turns farther than TURN_MAX.
static double stride(const YkDrag *d)
{
    const YkState *s = d->state;
    double fastest = 1, scale = yk_path_scale(&d->walk.path);
    for (size_t k = 1; s->has_rates && k < s->mech->slot_count; k++)
        fastest = fmax(fastest, scale * fabs(yk_space_turn(&s->space, (int32_t)k).w[0]));
    return TURN_MAX * scale / fmin(fastest, 1e4);
}

// The distance a little away; INFINITY where nothing closes there. The state ends where it was.
static double distance_beside(YkDrag *d, double at, double off)
{
    YkPath *path = &d->walk.path;
    double there = yk_path_try(path, at + off, true) >= 0 ? yk_drag_distance(d) : INFINITY;
    if (isinf(there)) d->block = d->state->report.block;
    yk_path_try(path, at, true);
    return there;
}

// Returns which way the distance falls: +1, -1, or 0. *is_end: on one side the machine does not close.
static double find_way(YkDrag *d, double at, bool *is_end)
{
    *is_end = false;
    double slope = d->state->has_rates ? slope_here(d) : 0;
    if (slope != 0) return slope > 0 ? -1 : 1;
    double off = (d->state->has_rates ? 1e-4 : 1e-7) * yk_path_scale(&d->walk.path), here = yk_drag_distance(d);
    double up = distance_beside(d, at, off), down = distance_beside(d, at, -off);
    *is_end = isinf(up) || isinf(down);
    return fmin(up, down) < here ? (up < down ? 1 : -1) : 0;
}

// Has the distance begun to grow at the present pose, on the way `way`?
static bool is_uphill(YkDrag *d, double at, double way)
{
    if (d->state->has_rates) return way * slope_here(d) > 0;
    double off = 1e-7 * yk_path_scale(&d->walk.path);
    return yk_drag_distance(d) > distance_beside(d, at, -way * off);
}

// Between a, from where the distance falls, and b, where it grows: the root of its slope, by halves and secants.
static void stand_nearest(YkDrag *d, double a, double b, double way)
{
    YkPath *path = &d->walk.path;
    double fa = -1, fb = 1, scale = yk_path_scale(path);
    bool known_a = false, known_b = false;
    for (int k = 0; k < 120 && fabs(b - a) > 1e-15 * fmax(scale, fabs(b)); k++) {
        double x = k % 3 < 2 && known_a && known_b ? b - fb * (b - a) / (fb - fa) : a;
        if (!((x - a) * (b - x) > 0)) x = 0.5 * (a + b);
        if (x == a || x == b) break;
        bool closes = yk_path_probe(path, x, true) >= 0, is_known = closes && d->state->has_rates;
        double f = is_known ? way * slope_here(d) : !closes || is_uphill(d, x, way) ? 1 : -1;
        if (f == 0) return;
        if (f > 0) {
            b = x;
            fb = f;
            known_b = is_known;
        } else {
            a = x;
            fa = f;
            known_a = is_known;
        }
    }
    yk_path_probe(path, a, true);
}

// As above, in a step that has passed change points: on the side of the last one on which the nearest pose lies.
static void stand_nearest_beside(YkDrag *d, double a, double b, double way)
{
    YkWalk *w = &d->walk;
    double pass = w->events[w->event_count - 1].at, off = way * 1e-6 * yk_path_scale(&w->path);
    yk_path_probe(&w->path, pass + off, true);
    if (!is_uphill(d, pass + off, way)) {
        stand_nearest(d, pass + off, b, way);
        return;
    }
    yk_drag_begin_walk(d);
    if (yk_walk_go(w, pass + off, a)) stand_nearest(d, a, pass - off, way);
}

static void drag_single(YkDrag *d, YkDragged *e)
{
    YkWalk *w = &d->walk;
    yk_drag_begin_walk(d);
    double a = w->path.last;
    bool is_end;
    yk_path_probe(&w->path, a, true);
    double way = find_way(d, a, &is_end);
    e->end = is_end ? YK_DRAG_LIMIT : YK_DRAG_NEAREST;
    e->block = d->block; // if it is
    for (int k = 0; k < STEPS_MAX && way != 0 && !yk_state_is_stopped(d->state); k++) {
        yk_drag_begin_walk(d);
        bool arrives = yk_walk_go(w, a, a + way * stride(d));
        double b = w->path.last;
        e->pass_count += w->event_count - !arrives;
        size_t stop = yk_drag_meet_stop(d, a, &b);
        e->end = YK_DRAG_NEAREST;
        if (is_uphill(d, b, way)) {
            size_t passes = w->event_count - !arrives;
            w->event_count = passes;
            (passes > 0 ? stand_nearest_beside : stand_nearest)(d, a, b, way);
            break;
        }
        e->end = stop != SIZE_MAX ? YK_DRAG_STOP : !arrives ? YK_DRAG_LIMIT : YK_DRAG_SPENT;
        if (stop != SIZE_MAX) e->coordinate = d->stops[stop].coordinate;
        e->block = w->limit_block;
        if (e->end != YK_DRAG_SPENT) break;
        a = b;
    }
    yk_path_probe(&w->path, w->path.last, false);
}

YkStatus yk_state_drag(YkDrag *d, const double target[2], YkDragged *dragged)
{
    YkDragged unseen, *e = dragged ? dragged : &unseen;
    *e = (YkDragged){.end = YK_DRAG_NEAREST, .block = -1, .coordinate = -1};
    if (!d->state->has_pose || !isfinite(target[0]) || !isfinite(target[1])) return YK_BAD_ARGUMENT;
    d->target = yk_vec(target[0], target[1]);
    yk_drag_widen_stops(d);
    memcpy(d->walk.path.others, d->state->valid_input, 3 * d->state->mech->input_count * sizeof *d->goal); // its rates
    bool is_own = yk_state_begin(d->state);
    if (d->active_count == 1) drag_single(d, e);
    if (d->active_count > 1) yk_drag_many(d, e);
    YkStatus status = yk_state_end(d->state, is_own, YK_OK);
    e->distance = yk_drag_distance(d);
    if (status == YK_STOPPED) e->end = YK_DRAG_SPENT;
    if (e->distance <= REACHED * d->state->mech->size) e->end = YK_DRAG_REACHED;
    if (e->end != YK_DRAG_STOP) e->coordinate = -1;
    if (e->end != YK_DRAG_LIMIT) e->block = -1;
    return status;
}
