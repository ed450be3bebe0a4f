// The limits of the rates at a change point where a walk stands. J is singular there, but the motion is smooth through
// it, so values that do not exist at the pose are interpolated from four poses on each side (Lagrange, error O(h^8)).
#include <stdlib.h>
#include <string.h>
#include "sweep/meeting.h"

// --- poses beside a change point

// Finds which input moves, if it is only one: its drive may rest or turn back at the change point, so that time does
// not lead to both sides of it, but its way does. The rates are those at the change point. Returns false if one input
// stops there and another starts: the rates of the two motions have nothing in common.
static bool find_moving(YkBeside *b)
{
    const YkPath *path = &b->walk->path;
    const YkState *s = path->state;
    size_t count = 0;
    bool starts = false, stops = false;
    b->moving = YK_NONE;
    if (!yk_path_is_time(path)) return true;
    b->is_back = yk_path_turns_back(path, b->at);
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double here = yk_path_heads(path, i, b->at, b->side), there = yk_path_heads(path, i, b->at, -b->side);
        starts |= here != 0 && there == 0;
        stops |= here == 0 && there != 0;
        if (here == 0 && there == 0 && s->input[3 * i + 1] == 0 && s->input[3 * i + 2] == 0) continue;
        count++;
        b->moving = (int32_t)i;
        b->way = here != 0 ? copysign(1, here) : 0;
    }
    if (count != 1 || b->way == 0) b->moving = YK_NONE;
    if (starts && stops) return false;
    if (!yk_walk_turns_at_a_limit(b->walk, b->margins, b->at)) return true; // only time leads to both sides
    b->moving = YK_NONE;
    b->is_back = false;
    return true;
}

// Solves the pose that many steps from the change point, on the side of the signs if positive. Angles are counted from
// the change point: a first, coarse step may turn a link too far for the next pose to show how often it has turned.
static bool stand_beside(const YkBeside *b, double steps)
{
    YkPath *path = &b->walk->path;
    YkState *s = path->state;
    if (b->moving == YK_NONE) {
        double off = b->side * steps * b->step * yk_path_scale(path);
        return yk_path_try(path, b->at + off, false) >= 0;
    }
    double off = b->way * steps * b->step * yk_input_unit(s->mech, (size_t)b->moving);
    if (yk_path_set(path, b->at, false) < 0) return false;
    s->input[3 * b->moving] += off;
    yk_path_place_signs(path, b->at);
    return yk_state_solve(s) >= 0;
}

static void exchange_signs(const YkBeside *b)
{
    YkState *s = b->walk->path.state;
    if (b->moving == YK_NONE && b->is_back) return;
    for (size_t k = 0; k < b->walk->margin_count; k++)
        if (yk_walk_has_margin(b->walk, k) && b->margins[k] <= YK_SINGULAR_MARGIN &&
            !yk_walk_knows_meeting(b->walk, k, b->at))
            s->branch[k] = (signed char)-s->branch[k];
}

// Lets the signs of blocks that touch here, but not at the change point known of them, be exchanged.
static void free_signs(const YkBeside *b, bool is_free)
{
    YkPath *path = &b->walk->path;
    for (size_t k = 0; k < path->meeting_count; k++)
        path->meetings[k].is_off =
            is_free && b->margins[k] <= YK_SINGULAR_MARGIN && !yk_walk_knows_meeting(b->walk, k, b->at);
}

bool yk_beside_visit(const YkBeside *b, YkVisitBeside visit, void *context)
{
    enum { SIDE = 4 };
    bool ok = true;
    free_signs(b, true);
    for (int way = 1; way >= -1; way -= 2) {
        for (int k = 1; k <= SIDE; k++) {
            double weight = 0.5;
            for (int j = 1; j <= SIDE; j++)
                if (j != k) weight *= (double)(j * j) / (double)(j * j - k * k);
            ok = ok && stand_beside(b, way * k);
            if (ok) visit(context, weight);
        }
        exchange_signs(b);
    }
    if (ok && b->wants_nearer && stand_beside(b, 0.125)) visit(context, 0);
    yk_path_probe(&b->walk->path, b->at + b->side * b->step * yk_path_scale(&b->walk->path), true); // from that side
    yk_path_probe(&b->walk->path, b->at, true);
    free_signs(b, false);
    return ok;
}

// --- the step

typedef struct Sum {
    const YkState *state;
    double *numbers; // as the data of its space
    bool is_known;
} Sum;

static void add_pose(void *context, double weight)
{
    Sum *sum = context;
    const YkSpace *space = &sum->state->space;
    size_t count = yk_space_number_count(space);
    sum->is_known = sum->is_known && sum->state->has_rates;
    for (size_t k = 0; k < count; k++) sum->numbers[k] += weight * space->data[k];
}

static bool sum_poses(const YkBeside *b, double *numbers)
{
    YkState *s = b->walk->path.state;
    Sum sum = {s, numbers, true};
    memset(numbers, 0, yk_space_number_count(&s->space) * sizeof *numbers);
    return yk_beside_visit(b, add_pose, &sum) && sum.is_known;
}

// The largest rate of a kind in a sum, and how far another sum is off.
typedef struct Off {
    double most, off;
} Off;

static void compare(Off *o, double one, double other)
{
    o->most = fmax(o->most, fabs(other));
    o->off = one - other == one - other ? fmax(o->off, fabs(one - other)) : INFINITY;
}

// Returns whether two sums have the same rates of all orientations and distances.
static bool agree(const YkState *state, const double *one, const double *other)
{
    const double SAME = 1e-7;
    const YkSpace *space = &state->space;
    const double *base = space->data;
    Off w = {0}, a = {0}, v = {0}, b = {0};
    for (size_t k = 1; k < space->slots; k++) {
        ptrdiff_t rate = space->turn[k].w - base, accel = space->turn[k].a - base;
        compare(&w, one[rate], other[rate]);
        compare(&a, one[accel], other[accel]);
    }
    for (size_t k = 0; k < space->distances; k++) {
        ptrdiff_t rate = space->slide[k].v - base, accel = space->slide[k].a - base;
        compare(&v, one[rate], other[rate]);
        compare(&b, one[accel], other[accel]);
    }
    double speed = fmax(v.most, w.most * state->mech->size); // a slide may come to rest there
    return w.off <= SAME * w.most && a.off <= SAME * fmax(a.most, w.most * w.most) && v.off <= SAME * speed &&
           b.off <= SAME * fmax(b.most, w.most * speed);
}

// Limits and other change points may be near, and a gear may turn a link much farther than its input: halves the step
// until the limits no longer depend on it.
bool yk_beside_begin(YkBeside *b, double *limits)
{
    enum { HALVINGS = 10 };
    const YkSpace *space = &b->walk->path.state->space;
    size_t count = yk_space_number_count(space);
    double *sums = malloc((2 * count + 1) * sizeof *sums), *now = sums, *finer = sums + count;
    b->walk->failed |= !sums;
    if (!sums) return false;
    b->step = 0.01;
    bool has_limits = find_moving(b), is_known = has_limits && sum_poses(b, now), is_same = false;
    for (int k = 0; has_limits && k < HALVINGS && !is_same; k++) {
        b->step *= 0.5;
        bool is_finer_known = sum_poses(b, finer);
        is_same = is_known && is_finer_known && agree(b->walk->path.state, now, finer);
        if (is_same && limits) memcpy(limits, now, count * sizeof *limits);
        double *spare = now;
        now = finer, finer = spare, is_known = is_finer_known;
    }
    b->step *= 2;
    free(sums);
    return is_same;
}

// --- the state's own rates

void yk_state_take_rates(YkState *s, const double *numbers)
{
    YkSpace *space = &s->space;
    const double *base = space->data;
    for (size_t k = 1; k < space->slots; k++) {
        YkTurn t = space->turn[k];
        *t.w = numbers[t.w - base], *t.a = numbers[t.a - base];
    }
    for (size_t k = 0; k < space->distances; k++) {
        YkSlide d = space->slide[k];
        *d.v = numbers[d.v - base], *d.a = numbers[d.a - base];
    }
    for (size_t k = 1; k <= space->nodes; k++) {
        YkPlane p = space->plane[k];
        *p.vx = numbers[p.vx - base], *p.vy = numbers[p.vy - base];
        *p.ax = numbers[p.ax - base], *p.ay = numbers[p.ay - base];
    }
}

// Returns the first block that touches, or -1.
int yk_walk_touching_block(const YkWalk *w, const double *margins)
{
    for (size_t k = 0; k < w->margin_count; k++)
        if (yk_walk_has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN) return (int)k;
    return -1;
}

bool yk_path_moves_along(const YkPath *path)
{
    const YkMechanism *mech = path->state->mech;
    double ratio[3] = {0}, size = 0;
    if (!path->is_line) return true;
    for (size_t i = 0; i < mech->input_count; i++) {
        double way = (path->goal[3 * i] - path->others[3 * i]) / yk_input_unit(mech, i);
        if (fabs(way) <= size) continue;
        size = fabs(way);
        for (size_t k = 1; k < 3; k++) ratio[k] = path->goal[3 * i + k] / yk_input_unit(mech, i) / way;
    }
    for (size_t i = 0; i < mech->input_count; i++)
        for (size_t k = 1; k < 3; k++) {
            double along = ratio[k] * (path->goal[3 * i] - path->others[3 * i]);
            double off = fabs(path->goal[3 * i + k] - along) / yk_input_unit(mech, i);
            if (off > 1e-12 * fabs(ratio[k]) * size) return false;
        }
    return true;
}

YkStatus yk_walk_take_limits(YkWalk *w, double at, double way)
{
    YkState *s = w->path.state;
    double *margins = yk_walk_margins(w, 0, 0);
    if (s->space.margin[0] > YK_SINGULAR_MARGIN || s->mech->has_groups || w->margin_count != s->mech->block_count ||
        !yk_path_moves_along(&w->path))
        return YK_SINGULAR;
    double *limits = malloc((yk_space_number_count(&s->space) + 1) * sizeof *limits);
    if (!limits) return YK_NO_MEMORY;
    yk_walk_read_margins(w, margins);
    int block = yk_walk_touching_block(w, margins);
    YkBeside beside = {.walk = w, .at = at, .side = yk_walk_has_passed(w) ? way : -way, .margins = margins};
    bool ok = block >= 0 && yk_beside_begin(&beside, limits);
    YkStatus status = yk_path_probe(&w->path, at, false);
    if (w->failed) status = YK_NO_MEMORY;
    if (ok && status == YK_SINGULAR) {
        yk_state_take_rates(s, limits);
        s->has_rates = true;
        status = yk_state_refuse(s, YK_CHANGE_POINT,
                                 "two configurations meet here; the rates are the limits of the motion that led here, "
                                 "and forces need a sweep past this pose");
        s->report.block = block;
    }
    free(limits);
    return status;
}
