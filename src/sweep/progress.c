// Verified progress. Between two rows the path is probed, and probed more finely wherever a block's margin (sin^2 of
// its transmission angle) could reach zero: a simple zero is a limit position, a double zero a change point, which the
// motion passes with the other sign.
#include <string.h>
#include "sweep/sweep.h"

double *yk_sweep_margins(const YkSweep *w, size_t depth, size_t which)
{
    return w->margins + (3 * depth + which) * w->margin_count;
}

void yk_sweep_read_margins(const YkSweep *w, double *margins)
{
    const YkState *s = w->path.state;
    if (s->mech->block_count != w->margin_count) margins[0] = s->space.margin[0];
    for (size_t k = 0; s->mech->block_count == w->margin_count && k < w->margin_count; k++)
        margins[k] = yk_path_margin(s, &s->space, k);
}

bool yk_sweep_has_margin(const YkSweep *w, size_t block)
{
    const YkMechanism *mech = w->path.state->mech;
    return w->margin_count != mech->block_count || mech->blocks[block].kind <= YK_BLOCK_RPR;
}

// Where a double zero lies between a and b: the root of the margin runs through it as a straight line.
static double touch(double a, double ma, double b, double mb)
{
    double ra = sqrt(fmax(ma, 0)), rb = sqrt(fmax(mb, 0));
    return ra + rb > 0 ? a + (b - a) * ra / (ra + rb) : 0.5 * (a + b);
}

void yk_sweep_end_at(YkSweep *w, double at, double bad)
{
    w->status = yk_path_set(&w->path, bad, true) < 0 ? YK_BAD_MODEL : YK_LIMIT;
    if (w->status == YK_BAD_MODEL) yk_state_set_time(w->path.state, bad, w->problems);
    yk_sweep_note(w, (YkEvent){.kind = YK_EVENT_LIMIT, .at = at, .block = w->status == YK_LIMIT ? w->limit_block : -1});
    yk_path_probe(&w->path, at, true);
}

bool yk_sweep_was_flipped_near(const YkSweep *w, size_t block, double at)
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
    yk_sweep_note(w, (YkEvent){.kind = YK_EVENT_CHANGE_POINT, .at = at, .block = (int)block});
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
    bool fits =
        fabs(beyond - at) < fabs(bad - at) && w->margin_count == s->mech->block_count && depth + 1 < SWEEP_DEPTH_MAX;
    double *margins = yk_sweep_margins(w, depth, 0);
    yk_sweep_read_margins(w, margins);
    for (size_t k = 0; fits && k < w->margin_count; k++) {
        if (!yk_sweep_has_margin(w, k) || margins[k] > 1e-8 || yk_sweep_was_flipped_near(w, k, at)) continue;
        s->branch[k] = (signed char)-s->branch[k];
        bool passes = yk_path_probe(&w->path, beyond, true) >= 0;
        s->branch[k] = (signed char)-s->branch[k];
        if (!passes) continue;
        flip(w, k, touch(at, margins[k], beyond, yk_path_margin(s, &s->space, k)));
        yk_path_probe(&w->path, beyond, true);
        yk_sweep_read_margins(w, yk_sweep_margins(w, depth + 1, 0));
        return advance(w, beyond, bad, depth + 1);
    }
    yk_sweep_end_at(w, at, bad);
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
    const double *ma = yk_sweep_margins(w, depth, 0), *mm = yk_sweep_margins(w, depth, 1),
                 *mb = yk_sweep_margins(w, depth, 2);
    bool narrow = fabs(b - a) < 4e-7 * yk_path_scale(&w->path) || depth + 1 >= SWEEP_DEPTH_MAX, touched = false;
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!yk_sweep_has_margin(w, k) || !may_vanish(ma[k], mm[k], mb[k])) continue;
        if (!narrow) return FINER;
        if (fmin(ma[k], fmin(mm[k], mb[k])) > 1e-11 || w->margin_count != w->path.state->mech->block_count) continue;
        if (yk_sweep_was_flipped_near(w, k, b)) continue;
        flip(w, k, touch(a, ma[k], b, mb[k]));
        touched = true;
    }
    return touched ? TOUCHED : CLEAR;
}

void yk_sweep_flip_at(YkSweep *w, double a, const double *margins)
{
    if (a == w->from || w->margin_count != w->path.state->mech->block_count) return;
    for (size_t k = 0; k < w->margin_count; k++)
        if (yk_sweep_has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN && !yk_sweep_was_flipped_near(w, k, a))
            flip(w, k, a);
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
    double middle = 0.5 * (a + b), *next = yk_sweep_margins(w, depth + 1, 0);
    memcpy(next, yk_sweep_margins(w, depth, 0), w->margin_count * sizeof *next);
    return advance(w, a, middle, depth + 1) && go_on(w, middle, b, depth);
}

// From the valid pose at a (margins known at this depth) to b. False when stopped.
static bool advance(YkSweep *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b);
    if (depth + 1 < SWEEP_DEPTH_MAX && is_coarse(w, a, b)) return halve(w, a, b, depth);
    if (yk_path_try(&w->path, middle, true) < 0) return stop_or_pass(w, a, middle, depth) && go_on(w, middle, b, depth);
    yk_sweep_read_margins(w, yk_sweep_margins(w, depth, 1));
    if (yk_path_try(&w->path, b, true) < 0) return stop_or_pass(w, middle, b, depth);
    yk_sweep_read_margins(w, yk_sweep_margins(w, depth, 2));
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
    if (depth + 1 >= SWEEP_DEPTH_MAX) return yk_path_probe(&w->path, to, true) >= 0 || stop_or_pass(w, from, to, depth);
    double *margins = yk_sweep_margins(w, depth + 1, 0);
    yk_sweep_read_margins(w, margins);
    yk_sweep_flip_at(w, from, margins);
    return advance(w, from, to, depth + 1);
}

bool yk_sweep_progress(YkSweep *w, double a, double b)
{
    double stride = w->options.turn_max * yk_path_scale(&w->path);
    size_t parts = (size_t)fmin(1e7, ceil(fabs(b - a) / stride));
    double last = a;
    for (size_t k = 1; k <= parts; k++) {
        double next = k == parts ? b : a + (b - a) * (double)k / (double)parts;
        double *margins = yk_sweep_margins(w, 0, 0);
        yk_sweep_read_margins(w, margins);
        yk_sweep_flip_at(w, last, margins);
        if (!advance(w, last, next, 0)) return false;
        yk_sweep_watch_extremes(w, next);
        last = next;
    }
    return true;
}
