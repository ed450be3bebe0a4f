// The limits of the rates at a change point where a walk stands. J is singular there, but the motion is smooth through
// it, so what has no value at the pose is interpolated from four poses on each side (Lagrange, error O(h^8)).
#include <stdlib.h>
#include "sweep/walk.h"

// The poses beside a change point.
typedef struct Beside {
    YkWalk *walk;
    double at, side, step; // the signs hold on that side of the path; the nearest pose, in units of the path
    int32_t moving;        // over time: the only input that moves, and its way on that side; YK_NONE: along the path
    double way;
    bool is_back; // over time: both sides of the path lie on the same side of the change point
} Beside;

static double input_unit(const YkMechanism *mech, size_t input)
{
    return mech->coordinates[mech->inputs[input]].is_distance ? mech->size : 1;
}

// Finds which input moves, if it is only one: its drive may rest or turn back at the change point, so that time does
// not lead to both sides of it, but its way does. The rates are those at the change point.
static void find_moving(Beside *b)
{
    const YkPath *path = &b->walk->path;
    const YkState *s = path->state;
    size_t count = 0;
    b->moving = YK_NONE;
    if (path->is_line || path->input >= 0) return;
    b->is_back = yk_path_turns_back(path, b->at);
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double here = yk_path_heads(path, i, b->at, b->side), there = yk_path_heads(path, i, b->at, -b->side);
        if (here == 0 && there == 0 && s->input[3 * i + 1] == 0 && s->input[3 * i + 2] == 0) continue;
        count++;
        b->moving = (int32_t)i;
        b->way = here != 0 ? copysign(1, here) : 0;
    }
    if (count != 1 || b->way == 0) b->moving = YK_NONE;
}

// Solves the pose that many steps from the change point, on the side of the signs if positive.
static bool stand_beside(const Beside *b, double steps)
{
    YkPath *path = &b->walk->path;
    YkState *s = path->state;
    if (b->moving == YK_NONE) {
        double off = b->side * steps * b->step * yk_path_scale(path);
        return yk_path_probe(path, b->at + off, false) >= 0;
    }
    double off = b->way * steps * b->step * input_unit(s->mech, (size_t)b->moving);
    if (yk_path_set(path, b->at, false) < 0) return false;
    s->input[3 * b->moving] += off;
    if (yk_state_solve(s) < 0) return false;
    yk_path_refer(path);
    return true;
}

static void exchange_signs(const Beside *b, const double *margins)
{
    YkState *s = b->walk->path.state;
    if (b->moving == YK_NONE && b->is_back) return;
    for (size_t k = 0; k < b->walk->margin_count; k++)
        if (yk_walk_has_margin(b->walk, k) && margins[k] <= YK_SINGULAR_MARGIN)
            s->branch[k] = (signed char)-s->branch[k];
}

bool yk_walk_visit_beside(YkWalk *w, double at, double side, const double *margins, YkVisitBeside visit, void *context)
{
    enum { SIDE = 4 };
    Beside b = {.walk = w, .at = at, .side = side, .step = 0.01};
    bool ok = true;
    find_moving(&b);
    for (int way = 1; way >= -1; way -= 2) {
        for (int k = 1; k <= SIDE; k++) {
            double weight = 0.5;
            for (int j = 1; j <= SIDE; j++)
                if (j != k) weight *= (double)(j * j) / (double)(j * j - k * k);
            ok = ok && stand_beside(&b, way * k);
            if (ok) visit(context, weight);
        }
        exchange_signs(&b, margins);
    }
    if (ok && stand_beside(&b, 0.125)) visit(context, 0);
    yk_path_probe(&w->path, at + side * b.step * yk_path_scale(&w->path), true); // from the side of its signs
    yk_path_probe(&w->path, at, true);
    return ok;
}

// --- the state's own rates

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
    if (weight == 0) return;
    sum->is_known = sum->is_known && sum->state->has_rates;
    for (size_t k = 0; k < count; k++) sum->numbers[k] += weight * space->data[k];
}

// Takes the rates from the sum; the positions stay.
static void take_rates(YkState *s, const double *numbers)
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

// Returns whether the rates at the end of the path are along it: elsewhere the limits depend on the way there.
static bool moves_along(const YkPath *path)
{
    const YkMechanism *mech = path->state->mech;
    double ratio[3] = {0}, size = 0;
    if (!path->is_line) return true;
    for (size_t i = 0; i < mech->input_count; i++) {
        double way = (path->goal[3 * i] - path->others[3 * i]) / input_unit(mech, i);
        if (fabs(way) <= size) continue;
        size = fabs(way);
        for (size_t k = 1; k < 3; k++) ratio[k] = path->goal[3 * i + k] / input_unit(mech, i) / way;
    }
    for (size_t i = 0; i < mech->input_count; i++)
        for (size_t k = 1; k < 3; k++) {
            double along = ratio[k] * (path->goal[3 * i] - path->others[3 * i]);
            double off = fabs(path->goal[3 * i + k] - along) / input_unit(mech, i);
            if (off > 1e-12 * fabs(ratio[k]) * size) return false;
        }
    return true;
}

YkStatus yk_walk_take_limits(YkWalk *w, double at, double way)
{
    YkState *s = w->path.state;
    double *margins = yk_walk_margins(w, 0, 0);
    if (s->space.margin[0] > YK_SINGULAR_MARGIN || s->mech->has_groups || w->margin_count != s->mech->block_count ||
        !moves_along(&w->path))
        return YK_SINGULAR;
    Sum sum = {s, calloc(yk_space_number_count(&s->space), sizeof *sum.numbers), true};
    if (!sum.numbers) return YK_NO_MEMORY;
    yk_walk_read_margins(w, margins);
    int block = yk_walk_touching_block(w, margins);
    bool ok = block >= 0 &&
              yk_walk_visit_beside(w, at, yk_walk_has_passed(w) ? way : -way, margins, add_pose, &sum) && sum.is_known;
    YkStatus status = yk_path_probe(&w->path, at, false);
    if (ok && status == YK_SINGULAR) {
        take_rates(s, sum.numbers);
        s->has_rates = true;
        status = yk_state_refuse(s, YK_CHANGE_POINT,
                                 "two configurations meet here; the rates are the limits of the motion that led here, "
                                 "and forces need a sweep past this pose");
        s->report.block = block;
    }
    free(sum.numbers);
    return status;
}
