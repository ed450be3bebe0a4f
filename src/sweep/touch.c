// Finds a change point, where a block's margin touches zero, from the poses on both sides of it.
#include "sweep/walk.h"

// Returns where a double zero lies between a and b: the square root of the margin passes through it as a straight line.
double yk_walk_touch(double a, double ma, double b, double mb)
{
    double ra = sqrt(fmax(ma, 0)), rb = sqrt(fmax(mb, 0));
    return ra + rb > 0 ? a + (b - a) * ra / (ra + rb) : 0.5 * (a + b);
}

static double margin_at(YkWalk *w, size_t block, double at)
{
    const YkState *s = w->path.state; // not a reference: on one side of the change point this is the other branch
    const YkSpace *space =
        yk_path_try(&w->path, at, true) >= 0 ? &s->space : &s->spare; // the block itself closes on both sides
    return space->block_margin[block];
}

static double sine_at(YkWalk *w, size_t block, double at)
{
    return sqrt(fmax(0, margin_at(w, block, at)));
}

bool yk_walk_closes_beyond(YkWalk *w, size_t block, double at, double way)
{
    double beyond = yk_path_off(&w->path, at, way, 2e-5);
    return !isfinite(beyond) || margin_at(w, block, beyond) > 0;
}

// Refines a double zero of the margin by secants from both sides: near it the root is a straight line through zero.
double yk_walk_refine_touch(YkWalk *w, size_t block, double at, double reach)
{
    static const double sides[] = {2e-4, 2e-4, 1e-5};
    for (int k = 0; k < 3; k++) {
        double a = yk_path_off(&w->path, at, -1, sides[k]), b = yk_path_off(&w->path, at, 1, sides[k]);
        if (!isfinite(a) || !isfinite(b)) return at;
        double before = sine_at(w, block, a), after = sine_at(w, block, b);
        if (!(before + after > 0)) return at;
        double moved = yk_path_between(&w->path, a, b, before / (before + after));
        if (yk_path_way(&w->path, at, moved) > fmin(reach, 0.2 * sides[k])) return at;
        at = moved;
    }
    return at;
}

// Returns whether a pose lies so little beyond a change point that its margin is still nearly zero: it has the signs
// beyond.
bool yk_walk_has_just_passed(YkWalk *w, size_t block, double b, double way, double *at)
{
    *at = yk_walk_refine_touch(w, block, b, 4e-5);
    return (b - *at) * way > 0 && sine_at(w, block, *at) < 3e-7 && yk_walk_closes_beyond(w, block, b, way);
}

// Returns whether the square root of the margin is a straight line: at twice the distance from zero the margin is 4
// times as large, where at a fourfold zero it is 16 times.
static bool is_straight(double nearer, double farther)
{
    return nearer > 0 && farther > 2 * nearer && farther < 8 * nearer;
}

bool yk_walk_turns_at_limit(YkWalk *w, size_t block, double *at)
{
    if (!yk_path_is_time(&w->path)) return false;
    double middle = *at, span = fabs(yk_path_off(&w->path, middle, 1, 1e-5) - middle);
    if (!isfinite(span)) return false;
    for (int k = 0; k < 3; k++, span *= 0.2) {
        double before = sine_at(w, block, middle - span), after = sine_at(w, block, middle + span);
        if (!(before + after > 0)) return false;
        middle += span * (before - after) / (before + after);
    }
    if (margin_at(w, block, middle) > YK_SINGULAR_MARGIN) return false;
    for (int side = -1; side <= 1; side += 2) {
        double half = margin_at(w, block, middle + 0.5 * side * span);
        if (!is_straight(half, margin_at(w, block, middle + side * span))) return false;
    }
    *at = middle;
    return true;
}

bool yk_walk_turns_at_a_limit(YkWalk *w, const double *margins, double at)
{
    for (size_t k = 0; k < w->margin_count; k++)
        if (yk_walk_has_margin(w, k) && margins[k] <= YK_SINGULAR_MARGIN && yk_walk_turns_at_limit(w, k, &at))
            return true;
    return false;
}
