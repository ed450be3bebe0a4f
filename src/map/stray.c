// Finds what is not proved and lies neither along the curves nor at places where a dyad turns freely.
#include <math.h>
#include "elementary/elementary.h"
#include "map/field.h"

enum { REACH = 12, STEPS = 40 };

static void mark_near(YkField *f, size_t x, size_t y)
{
    size_t left = x > REACH ? x - REACH : 0, low = y > REACH ? y - REACH : 0;
    for (size_t row = low; row <= y + REACH && row < f->n; row++)
        for (size_t k = left; k <= x + REACH && k < f->n; k++) f->state[row * f->n + k] |= YK_CELL_NEAR;
}

// Takes a step towards the place where the ends of a dyad meet. Returns its length in cells; infinity if there is none, or
// if the ends meet along a curve.
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
    *place = (YkFoldPlace){{from[0], from[1]}, 0};
    for (int k = 0; k < STEPS && yk_box_fold(&f->tracer, place->at, &fold); k++) {
        place->level = fold.level;
        if (yk_norm(fold.apart) < met && length < REACH) return true;
        length = approach(f, place->at, &fold);
        for (int axis = 0; axis < 2; axis++)
            if (!(fabs(place->at[axis] - from[axis]) < REACH * f->step[axis])) return false;
    }
    return false;
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
    for (size_t k = 0; k < f->n * f->n; k++) {
        if (f->state[k] & (YK_CELL_PROVED | YK_CELL_NEAR)) continue;
        if (f->fold_count == YK_FOLD_PLACES || !find_fold(f, k, &place)) return k;
        mark_near(f, cell_of(f, &place, 0), cell_of(f, &place, 1));
        keep(f, place);
        if (!(f->state[k] & YK_CELL_NEAR)) return k;
    }
    return f->n * f->n;
}
