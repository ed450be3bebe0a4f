// Divides the plane of two inputs into squares until each has the same number of configurations everywhere.
#include "map/field.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COARSE = 64, ZOOMS = 6, SEARCHES = 24, COUNT_MAX = 60000 };

void yk_field_end(YkField *f)
{
    yk_tracer_end(&f->tracer);
    free(f->count);
    free(f->state);
    yk_crossings_end(&f->crossings);
}

static bool is_over(const YkField *f)
{
    return f->tracer.out_of_memory || yk_pace_is_stopped(f->tracer.pace);
}

static int count_at(YkField *f, double x, double y, int *counts)
{
    double at[2] = {x, y};
    return yk_box_count(&f->tracer, at, at, counts);
}

// --- dividing

static void fill(YkField *f, size_t x, size_t y, size_t size, int count, unsigned char state)
{
    for (size_t row = y; row < y + size; row++)
        for (size_t k = row * f->n + x; k < row * f->n + x + size; k++) {
            f->count[k] = (uint16_t)(count < COUNT_MAX ? count : COUNT_MAX);
            f->state[k] = state;
        }
}

// Counts at the centre of a cell, or, where configurations meet just there, beside it.
static void sample(YkField *f, size_t x, size_t y)
{
    static const double aside[][2] = {{0, 0}, {0.231, 0.117}, {-0.173, 0.219}, {-0.127, -0.259}, {0.287, -0.191}};
    for (size_t k = 0; k < sizeof aside / sizeof *aside && !is_over(f); k++) {
        int count = count_at(f, yk_field_center(f, 0, x) + aside[k][0] * f->step[0],
                             yk_field_center(f, 1, y) + aside[k][1] * f->step[1], NULL);
        if (count < 0) continue;
        fill(f, x, y, 1, count, 0);
        return;
    }
    fill(f, x, y, 1, x > 0 ? f->count[y * f->n + x - 1] : 0, YK_CELL_LOST);
    f->lost++;
}

static void divide(YkField *f, size_t x, size_t y, size_t size)
{
    if (is_over(f)) return;
    const size_t at[2] = {x, y};
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = f->low[k] + (double)at[k] * f->step[k];
        high[k] = f->low[k] + (double)(at[k] + size) * f->step[k];
    }
    if (size == f->n) yk_pace_reach(f->tracer.pace, 0);
    int count = yk_box_count(&f->tracer, low, high, NULL);
    if (count >= 0) {
        fill(f, x, y, size, count, YK_CELL_PROVED);
        f->proved += size * size;
    } else if (size == 1) {
        sample(f, x, y);
    } else {
        size_t half = size / 2;
        for (size_t k = 0; k < 4; k++) divide(f, x + k % 2 * half, y + k / 2 * half, half);
    }
}

static void divide_all(YkField *f, size_t n)
{
    f->n = n;
    f->proved = f->lost = 0;
    for (int k = 0; k < 2; k++) f->step[k] = (f->high[k] - f->low[k]) / (double)n;
    divide(f, 0, 0, n);
}

// --- the domain

static bool make_room(YkField *f, size_t n)
{
    f->count = calloc(n * n, sizeof *f->count);
    f->state = calloc(n * n, sizeof *f->state);
    return f->count && f->state;
}

// Shrinks the range of distances to what the machine can reach, and a cell more. Returns whether that was much less.
static bool shrink(YkField *f)
{
    size_t first[2] = {f->n, f->n}, last[2] = {0, 0};
    bool is_less = false;
    for (size_t y = 0; y < f->n; y++)
        for (size_t x = 0; x < f->n; x++) {
            const size_t at[2] = {x, y}, k = y * f->n + x;
            for (int axis = 0; axis < 2 && (f->count[k] > 0 || !(f->state[k] & YK_CELL_PROVED)); axis++) {
                first[axis] = at[axis] < first[axis] ? at[axis] : first[axis];
                last[axis] = at[axis] > last[axis] ? at[axis] : last[axis];
            }
        }
    for (int axis = 0; axis < 2; axis++) {
        if (f->is_angle[axis] || first[axis] > last[axis]) continue;
        double low = f->low[axis] + ((double)first[axis] - 1) * f->step[axis];
        double high = f->low[axis] + ((double)last[axis] + 2) * f->step[axis];
        if (high - low > 0.9 * (f->high[axis] - f->low[axis])) continue;
        f->low[axis] = low;
        f->high[axis] = high;
        is_less = true;
    }
    return is_less;
}

bool yk_field_fill(YkField *f, double tolerance)
{
    const double aside[2] = {0.0123456789, 0.0198765432}; // so that no edge lies where machines are special
    size_t n = COARSE;
    double reach = yk_tracer_reach(f->tracer.mech), period = yk_tracer_period(f->tracer.mech);
    while ((double)n * tolerance < 1) n *= 2;
    for (int k = 0; k < 2; k++) {
        f->low[k] = f->is_angle[k] ? aside[k] - YK_PI : -(1 + aside[k]) * reach;
        f->high[k] = f->is_angle[k] ? f->low[k] + period : (1 + 0.7 * aside[k]) * reach;
    }
    if (!make_room(f, n)) f->tracer.out_of_memory = true;
    for (int k = 0; k < ZOOMS && !(f->is_angle[0] && f->is_angle[1]) && !is_over(f); k++) {
        divide_all(f, COARSE);
        if (is_over(f) || !shrink(f)) break;
    }
    if (!is_over(f)) divide_all(f, n);
    return !is_over(f);
}

// --- the curves

static int16_t first_difference(const YkField *f, const int *a, const int *b)
{
    for (size_t level = 1; level <= f->tracer.piece_count; level++)
        if (a[level] != b[level]) return (int16_t)(level - 1);
    return 0;
}

// Bisects the way from a cell's centre to its neighbour's.
static YkCrossing find_crossing(YkField *f, size_t x, size_t y, int axis)
{
    double at[2] = {yk_field_center(f, 0, x), yk_field_center(f, 1, y)}, from = 0, to = 1;
    int own[2][YK_BOX_LEVELS] = {{0}}, middle[YK_BOX_LEVELS] = {0};
    int first = count_at(f, at[0], at[1], own[0]);
    int second = count_at(f, at[0] + (axis == 0 ? f->step[0] : 0), at[1] + (axis == 1 ? f->step[1] : 0), own[1]);
    for (int k = 0; k < SEARCHES && first >= 0 && second >= 0 && first != second; k++) {
        double half = 0.5 * (from + to);
        int count = count_at(f, at[0] + (axis == 0 ? half * f->step[0] : 0),
                             at[1] + (axis == 1 ? half * f->step[1] : 0), middle);
        if (count < 0) break;
        bool is_before = count == first;
        memcpy(own[is_before ? 0 : 1], middle, sizeof middle);
        *(is_before ? &from : &to) = half;
        if (!is_before) second = count;
    }
    int16_t piece = first >= 0 && second >= 0 ? first_difference(f, own[0], own[1]) : 0;
    return (YkCrossing){yk_crossing_key(y * f->n + x, axis), (float)(0.5 * (from + to)), piece};
}

YkCrossing yk_field_crossing(YkField *f, size_t x, size_t y, int axis)
{
    const YkCrossing *known = yk_crossings_find(&f->crossings, yk_crossing_key(y * f->n + x, axis));
    if (known) return *known;
    YkCrossing found = find_crossing(f, x, y, axis);
    if (!yk_crossings_add(&f->crossings, found)) f->tracer.out_of_memory = true;
    return found;
}
