// Dragging with several free inputs: descent by damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963) along lines
// that are walked. Ways on which a stop or a limit lies are taken out of the step, which then slides along it.
#include <string.h>
#include "loads/point.h"
#include "sweep/drag_walk.h"

enum { STEPS_MAX = 300 };
static const double STEP_MAX = 8 * YK_PI / 180, STILL = 1e-10; // rad, or sizes of the machine

// Finds the motion of the point and of the worst block for a unit rate of each input, at the present pose. Returns
// false if the rates are not known.
static bool find_rates(YkDrag *d)
{
    YkState *s = d->state;
    size_t n = s->mech->input_count;
    memcpy(d->goal, s->valid_input, 3 * n * sizeof *d->goal);
    bool ok = true;
    for (size_t a = 0; a < d->active_count && ok; a++) {
        for (size_t i = 0; i < n; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
        s->input[3 * d->active[a] + 1] = yk_drag_scale(d, a);
        ok = yk_state_solve(s) >= 0 && s->has_rates;
        YkVec v = yk_load_point(s->mech, &s->space, &d->end).velocity;
        d->jx[a] = v.x;
        d->jy[a] = v.y;
    }
    memcpy(s->input, d->goal, 3 * n * sizeof *d->goal);
    return yk_state_solve(s) >= 0 && ok;
}

static double dot(const YkDrag *d, const double *a, const double *b)
{
    double sum = 0;
    for (size_t k = 0; k < d->active_count; k++) sum += a[k] * b[k];
    return sum;
}

static void take_out(const YkDrag *d, double *v, const double *normal)
{
    double along = dot(d, v, normal);
    for (size_t k = 0; k < d->active_count; k++) v[k] -= along * normal[k];
}

// Finds the step -J' (J P J' + damping)^-1 r, where P takes out the blocked ways: what it does along them, they hold
// back.
static void find_pull(YkDrag *d, double damping)
{
    YkVec r = yk_sub(yk_load_point(d->state->mech, &d->state->space, &d->end).at, d->target);
    double xx = dot(d, d->jx, d->jx) + damping, xy = dot(d, d->jx, d->jy), yy = dot(d, d->jy, d->jy) + damping;
    for (size_t k = 0; k < d->normal_count; k++) {
        const double *normal = d->normal + k * d->active_count;
        double x = dot(d, d->jx, normal), y = dot(d, d->jy, normal);
        xx -= x * x;
        xy -= x * y;
        yy -= y * y;
    }
    double det = xx * yy - xy * xy, px = (yy * r.x - xy * r.y) / det, py = (xx * r.y - xy * r.x) / det;
    for (size_t k = 0; k < d->active_count; k++) d->way[k] = -(d->jx[k] * px + d->jy[k] * py);
}

// Takes the blocked ways out of the step and cuts it, so that its largest entry is at most STEP_MAX. Returns that.
static double cut_step(YkDrag *d)
{
    double most = 0;
    for (size_t k = 0; k < d->normal_count; k++) take_out(d, d->way, d->normal + k * d->active_count);
    for (size_t k = 0; k < d->active_count; k++) most = fmax(most, fabs(d->way[k]));
    if (!isfinite(most)) return 0;
    for (size_t k = 0; k < d->active_count && most > STEP_MAX; k++) d->way[k] *= STEP_MAX / most;
    return fmin(most, STEP_MAX);
}

// How much the linear model promises: half of what the squared distance loses by the step.
static double promised(const YkDrag *d)
{
    YkVec r = yk_sub(yk_load_point(d->state->mech, &d->state->space, &d->end).at, d->target);
    YkVec v = yk_vec(dot(d, d->jx, d->way), dot(d, d->jy, d->way));
    return -yk_dot(r, v) - 0.5 * yk_dot(v, v);
}

// Nielsen 1999: less damping the better the model was, more at once where it was wrong.
static double next_damping(double damping, double gain, double *grow)
{
    double off = 2 * gain - 1;
    *grow = gain > 0 ? 2 : 2 * *grow;
    return gain > 0 ? damping * fmax(1.0 / 3, 1 - off * off * off) : damping * *grow / 2;
}

// Sets the goal one step on, by a part of the way and a little along a normal.
static void set_goal(YkDrag *d, double part, const double *normal, double off)
{
    memcpy(d->goal, d->home, 3 * d->state->mech->input_count * sizeof *d->goal);
    for (size_t k = 0; k < d->active_count; k++)
        d->goal[3 * d->active[k]] += (part * d->way[k] + (normal ? off * normal[k] : 0)) * yk_drag_scale(d, k);
}

static void keep_home(YkDrag *d)
{
    memcpy(d->home, d->state->valid_input, 3 * d->state->mech->input_count * sizeof *d->home);
}

// Back along the line to where it began, or as near as it closes.
static void go_home(YkDrag *d)
{
    yk_path_probe(&d->walk.path, 0, true);
}

typedef struct Blocked {
    size_t stop; // SIZE_MAX: none
    int block;   // -1: none
} Blocked;

typedef struct Held { // what the motion slides along
    Blocked items[YK_DRAG_NORMALS];
    size_t count;
} Held;

// Walks to the goal, or as far as stops and limits let it. Returns the part.
static double go(YkDrag *d, Blocked *blocked, size_t *passes)
{
    YkWalk *w = &d->walk;
    *blocked = (Blocked){SIZE_MAX, -1};
    yk_drag_begin_walk(d);
    yk_path_probe(&w->path, 0, true);
    bool arrives = yk_walk_go(w, 0, 1);
    double at = w->path.last;
    *passes = w->event_count - !arrives;
    blocked->stop = yk_drag_meet_stop(d, 0, &at);
    if (blocked->stop == SIZE_MAX && !arrives) blocked->block = w->limit_block;
    return at;
}

// An obstacle, as a number that is 0 there and grows inwards: a block's margin, how far a coordinate is from its stop.
static double quantity(const YkDrag *d, const Blocked *b)
{
    if (b->stop == SIZE_MAX) return d->state->space.block_margin[b->block];
    const YkDragStop *s = &d->stops[b->stop];
    double value = yk_loads_coordinate(d->state, &d->state->space, s->coordinate).position / s->scale;
    return value - s->low / s->scale < s->high / s->scale - value ? value : -value;
}

// As a further normal. False if it has no slope, or nothing is left to move.
static bool add_normal(YkDrag *d, const Blocked *b)
{
    YkState *s = d->state;
    if (d->normal_count == d->active_count) return false;
    double *normal = d->normal + d->normal_count * d->active_count, here = quantity(d, b);
    keep_home(d);
    for (size_t k = 0; k < d->active_count; k++) {
        normal[k] = 0;
        for (double sign = 1; sign >= -1 && normal[k] == 0; sign -= 2) {
            memcpy(s->input, d->home, 3 * s->mech->input_count * sizeof *s->input);
            s->input[3 * d->active[k]] += sign * 1e-6 * yk_drag_scale(d, k);
            if (yk_state_solve(s) >= 0) normal[k] = sign * (quantity(d, b) - here);
        }
    }
    memcpy(s->input, d->home, 3 * s->mech->input_count * sizeof *s->input);
    yk_state_solve(s);
    for (size_t k = 0; k < d->normal_count; k++) take_out(d, normal, d->normal + k * d->active_count);
    double size = sqrt(dot(d, normal, normal));
    if (!(size > 1e-14)) return false;
    for (size_t k = 0; k < d->active_count; k++) normal[k] /= size;
    d->normal_count++;
    return true;
}

static void find_normals(YkDrag *d, Held *held)
{
    size_t kept = 0;
    d->normal_count = 0;
    for (size_t k = 0; k < held->count; k++)
        if (add_normal(d, &held->items[k])) held->items[kept++] = held->items[k];
    held->count = kept;
}

// Finds the step; what it leaves inwards blocks no longer. The step decides, not the slope: where there are more inputs
// than the point needs, the two may go opposite ways along one of them.
static double find_step(YkDrag *d, Held *held, double damping)
{
    find_pull(d, damping);
    for (size_t k = held->count; k-- > 0;) {
        if (!(dot(d, d->way, d->normal + k * d->active_count) > 0)) continue;
        held->items[k] = held->items[--held->count];
        find_normals(d, held);
        find_pull(d, damping);
        k = held->count; // all that is left is judged by the new step
    }
    return cut_step(d);
}

// A little back inside, where rates are known.
static bool step_inside(YkDrag *d)
{
    Blocked blocked;
    size_t passes;
    keep_home(d);
    memset(d->way, 0, d->active_count * sizeof *d->way);
    for (size_t k = 0; k < d->normal_count; k++) {
        set_goal(d, 0, d->normal + k * d->active_count, 1e-7);
        if (go(d, &blocked, &passes) == 1 && d->state->has_rates) return true;
        go_home(d);
    }
    return false;
}

static bool is_at(const YkDrag *d, const Blocked *b)
{
    if (b->stop == SIZE_MAX) return b->block >= 0 && d->state->space.block_margin[b->block] < 1e-2;
    const YkDragStop *s = &d->stops[b->stop];
    double value = yk_loads_coordinate(d->state, &d->state->space, s->coordinate).position;
    return fmin(value - s->low, s->high - value) < 1e-3 * s->scale;
}

static void tell(const YkDrag *d, const Blocked *blocked, YkDragged *e)
{
    bool is_stop = blocked->stop != SIZE_MAX;
    e->end = is_stop ? YK_DRAG_STOP : YK_DRAG_LIMIT;
    if (is_stop) e->coordinate = (int)d->stops[blocked->stop].coordinate;
    e->block = blocked->block;
}

void yk_drag_many(YkDrag *d, YkDragged *e)
{
    double size = d->state->mech->size, damping = 1e-3 * size * size, grow = 4, inwards = 0, pressed = INFINITY,
           looked = INFINITY;
    Held held = {.count = 0};
    Blocked blocked, last = {SIZE_MAX, -1};
    size_t passes;
    bool is_settled = false;
    for (int k = 0; k < STEPS_MAX; k++) {
        double before = yk_drag_distance(d);
        if (k % 40 == 0 && !(looked - before > 1e-5 * size)) break; // along a curved limit it only creeps
        if (k % 40 == 0) looked = before;
        size_t count = held.count;
        find_normals(d, &held);
        if (held.count < count) inwards = 2 * inwards + 1; // it was held already
        if (before <= 1e-10 * size || (!d->state->has_rates && !step_inside(d)) || !find_rates(d)) break;
        if (find_step(d, &held, damping) <= STILL || damping > 1e6 * size * size) {
            is_settled = held.count == 0 || !(pressed - before > 1e-6 * size);
            if (is_settled) break;
            pressed = before; // it slid a little inside: once more without what holds it
            held.count = 0;
            damping = 1e-3 * size * size;
            continue;
        }
        keep_home(d);
        double promise = promised(d), off = inwards * dot(d, d->way, d->way);
        set_goal(d, 1, held.count > 0 ? d->normal + (held.count - 1) * d->active_count : NULL, off);
        go(d, &blocked, &passes);
        double after = yk_drag_distance(d);
        bool is_nearer = after < before, is_blocked = blocked.stop != SIZE_MAX || blocked.block >= 0;
        if (is_nearer) e->pass_count += passes;
        if (!is_nearer) go_home(d);
        if (is_blocked) last = blocked;
        if (is_blocked && held.count == YK_DRAG_NORMALS) break;
        if (is_blocked) held.items[held.count++] = blocked;
        if (is_blocked && is_nearer) continue;
        double gain = is_nearer ? 0.5 * (before - after) * (before + after) / fmax(promise, 1e-300) : 0;
        damping = fmax(next_damping(damping, gain, &grow), 1e-12 * size * size);
        if (!is_blocked) inwards *= 0.5;
    }
    e->end = is_settled && held.count == 0 ? YK_DRAG_NEAREST : YK_DRAG_SPENT;
    if (held.count > 0 && is_at(d, &last)) tell(d, &last, e);
    for (size_t i = 0; i < d->state->mech->input_count; i++) // the motion's own
        memcpy(d->goal + 3 * i + 1, d->walk.path.others + 3 * i + 1, 2 * sizeof *d->goal);
    yk_path_probe(&d->walk.path, d->walk.path.last, false);
}
