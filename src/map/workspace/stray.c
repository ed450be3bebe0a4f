// Finds what is not proved and lies neither along the curves nor at places where a dyad turns freely or two of its
// solutions touch.
#include <math.h>
#include "elementary/elementary.h"
#include "map/workspace/field.h"

enum { REACH = 12, STEPS = 40, DEEPEST = 8, BOXES = 8000 };

static void mark_near(YkField *f, size_t x, size_t y)
{
    size_t left = x > REACH ? x - REACH : 0, low = y > REACH ? y - REACH : 0;
    for (size_t row = low; row <= y + REACH && row < f->n; row++)
        for (size_t k = left; k <= x + REACH && k < f->n; k++) f->state[row * f->n + k] |= YK_CELL_NEAR;
}

// Takes a step towards the place where the ends of a dyad meet. Returns its length in cells; infinity if there is none,
// or if the ends meet along a curve.
static double approach(YkField *f, double at[2], const YkFold *here)
{
    YkFold there;
    YkVec slope[2];
    for (int k = 0; k < 2; k++) {
        double aside[2] = {at[0], at[1]}, h = 1e-4 * f->step[k];
        aside[k] += h;
        if (!yk_box_fold(&f->tracer, aside, &there) || there.level != here->level) return INFINITY;
        slope[k] = yk_scale(f->step[k] / h, yk_sub(there.apart, here->apart));
    }
    double area = yk_cross(slope[0], slope[1]);
    if (!(fabs(area) > 1e-4 * yk_norm(slope[0]) * yk_norm(slope[1]))) return INFINITY;
    double change[2] = {-yk_cross(here->apart, slope[1]) / area, yk_cross(here->apart, slope[0]) / area};
    for (int k = 0; k < 2; k++) at[k] += change[k] * f->step[k];
    return yk_hypot(change[0], change[1]);
}

// Finds the place near a cell where the ends of a dyad with equal links meet, by Newton's method.
static bool find_fold(YkField *f, size_t cell, YkFoldPlace *place)
{
    const double met = 1e-13;
    YkFold fold;
    const double from[2] = {yk_field_center(f, 0, cell % f->n), yk_field_center(f, 1, cell / f->n)};
    double length = INFINITY;
    *place = (YkFoldPlace){{from[0], from[1]}, 0, false};
    for (int k = 0; k < STEPS && yk_box_fold(&f->tracer, place->at, &fold); k++) {
        place->level = fold.level;
        if (yk_norm(fold.apart) < met && length < REACH) return true;
        length = approach(f, place->at, &fold);
        for (int axis = 0; axis < 2; axis++)
            if (!(fabs(place->at[axis] - from[axis]) < REACH * f->step[axis])) return false;
    }
    return false;
}

// --- solutions that touch

// The gap of one dyad about a place, in cells: its value, slopes and curvatures.
typedef struct Hill {
    double value, slope[2], curvature[3];
} Hill;

static bool read_hill(YkField *f, const double at[2], size_t level, Hill *hill)
{
    const double h = 0.1;
    double g[3][3];
    YkGap gap;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            double aside[2] = {at[0] + h * (j - 1) * f->step[0], at[1] + h * (k - 1) * f->step[1]};
            if (!yk_box_gap(&f->tracer, aside, &gap) || gap.level != level) return false;
            g[j][k] = gap.value;
        }
    hill->value = g[1][1];
    hill->slope[0] = (g[2][1] - g[0][1]) / (2 * h);
    hill->slope[1] = (g[1][2] - g[1][0]) / (2 * h);
    hill->curvature[0] = (g[2][1] - 2 * g[1][1] + g[0][1]) / (h * h);
    hill->curvature[1] = (g[2][2] - g[2][0] - g[0][2] + g[0][0]) / (4 * h * h);
    hill->curvature[2] = (g[1][2] - 2 * g[1][1] + g[1][0]) / (h * h);
    return true;
}

// Finds the place near a cell where a dyad's gap is 0 but for rounding and has its least or largest value, by Newton's
// method on the slopes.
static bool find_touch(YkField *f, size_t cell, YkFoldPlace *place)
{
    const double met = 1e-13;
    const double from[2] = {yk_field_center(f, 0, cell % f->n), yk_field_center(f, 1, cell / f->n)};
    YkGap gap;
    Hill hill;
    if (!yk_box_gap(&f->tracer, from, &gap)) return false;
    *place = (YkFoldPlace){{from[0], from[1]}, gap.level, true};
    for (int k = 0; k < STEPS && read_hill(f, place->at, gap.level, &hill); k++) {
        const double *c = hill.curvature;
        double area = c[0] * c[2] - c[1] * c[1];
        if (!(area > 1e-3 * (c[0] * c[0] + c[2] * c[2]))) return false; // a ridge, or a pass
        double change[2] = {(c[1] * hill.slope[1] - c[2] * hill.slope[0]) / area,
                            (c[1] * hill.slope[0] - c[0] * hill.slope[1]) / area};
        for (int axis = 0; axis < 2; axis++) {
            place->at[axis] += change[axis] * f->step[axis];
            if (!(fabs(place->at[axis] - from[axis]) < REACH * f->step[axis])) return false;
        }
        if (fabs(change[0]) + fabs(change[1]) < 1e-4)
            return yk_box_gap(&f->tracer, place->at, &gap) && gap.level == place->level && fabs(gap.value) < met;
    }
    return false;
}

// Divides a square finer than cells, to prove its number all over it but within a few of the finest squares from a
// place, if there is one.
static bool prove_finer(YkField *f, const double low[2], const double high[2], int count, const YkFoldPlace *but)
{
    if (f->boxes_left == 0) return false;
    f->boxes_left--;
    int here = yk_box_count(&f->tracer, low, high, NULL);
    if (here >= 0) return here == count;
    double middle[2] = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    bool is_finest = true, is_near = but != NULL;
    for (int k = 0; k < 2; k++) {
        double finest = f->step[k] / (1 << DEEPEST);
        is_finest &= high[k] - low[k] < 1.5 * finest;
        is_near = is_near && fabs(middle[k] - but->at[k]) < REACH * finest;
    }
    if (is_finest) return is_near;
    for (int part = 0; part < 4; part++) {
        double from[2], to[2];
        for (int k = 0; k < 2; k++) {
            bool is_high = part >> k & 1;
            from[k] = is_high ? middle[k] : low[k];
            to[k] = is_high ? high[k] : middle[k];
        }
        if (!prove_finer(f, from, to, count, but)) return false;
    }
    return true;
}

// Returns whether a cell is proved once it is divided, but for a place where solutions touch.
static bool explain(YkField *f, size_t cell, YkFoldPlace *touch, bool *has_touch)
{
    const size_t at[2] = {cell % f->n, cell / f->n};
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = f->low[k] + (double)at[k] * f->step[k];
        high[k] = f->low[k] + (double)(at[k] + 1) * f->step[k];
    }
    *has_touch = find_touch(f, cell, touch);
    return prove_finer(f, low, high, f->count[cell], *has_touch ? touch : NULL);
}

static size_t cell_of(const YkField *f, const YkFoldPlace *place, int axis)
{
    double cell = floor((place->at[axis] - f->low[axis]) / f->step[axis]);
    return cell < 0 ? 0 : cell < (double)f->n ? (size_t)cell : f->n - 1;
}

// Keeps a place, an angle within the domain, unless it is known from the domain's other edge.
static void keep(YkField *f, YkFoldPlace place)
{
    bool is_known = false;
    for (int k = 0; k < 2; k++) {
        double length = f->high[k] - f->low[k];
        if (f->is_angle[k]) place.at[k] -= length * floor((place.at[k] - f->low[k]) / length);
    }
    for (size_t k = 0; k < f->fold_count; k++)
        is_known |=
            fabs(f->folds[k].at[0] - place.at[0]) < f->step[0] && fabs(f->folds[k].at[1] - place.at[1]) < f->step[1];
    if (!is_known) f->folds[f->fold_count++] = place;
}

size_t yk_field_stray(YkField *f)
{
    YkFoldPlace place;
    for (size_t k = 0; k < f->crossings.capacity; k++) {
        const YkCrossing *c = &f->crossings.items[k];
        if (c->key != 0) mark_near(f, yk_crossing_cell(c) % f->n, yk_crossing_cell(c) / f->n);
    }
    f->boxes_left = BOXES;
    for (size_t k = 0; k < f->n * f->n; k++) {
        bool has_touch = false;
        if (f->state[k] & (YK_CELL_PROVED | YK_CELL_NEAR)) continue;
        if (f->fold_count == YK_FOLD_PLACES) return k;
        if (find_fold(f, k, &place)) {
            mark_near(f, cell_of(f, &place, 0), cell_of(f, &place, 1));
            keep(f, place);
            if (!(f->state[k] & YK_CELL_NEAR)) return k;
        } else if (explain(f, k, &place, &has_touch)) {
            f->state[k] |= has_touch ? YK_CELL_NEAR : YK_CELL_PROVED;
            f->proved += !has_touch;
            if (has_touch) keep(f, place);
        } else {
            return k;
        }
    }
    return f->n * f->n;
}
