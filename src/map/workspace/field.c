// Divides the plane of two inputs into squares until each has the same number of configurations everywhere.
#include "map/workspace/field.h"
#include <stdlib.h>
#include "map/workspace/tile.h"

enum { COARSE = 64, ZOOMS = 6 };

void yk_field_end(YkField *f)
{
    yk_tiles_forget(f);
    yk_tracer_end(&f->tracer);
    free(f->count);
    free(f->state);
    yk_crossings_end(&f->crossings);
    yk_box_memory_end(&f->first);
    yk_box_memory_end(&f->memory);
    free(f->tiles);
}

// --- dividing

bool yk_field_begin(YkField *f, const double start[2])
{
    double reach = yk_tracer_reach(f->tracer.mech);
    yk_field_count_at(f, start[0] + 0.0123456789 * (f->is_angle[0] ? 1 : reach),
                      start[1] + 0.0198765432 * (f->is_angle[1] ? 1 : reach), NULL);
    if (yk_field_is_over(f)) return false;
    if (yk_box_remember(&f->tracer, &f->first)) return true;
    f->tracer.out_of_memory = true;
    return false;
}

void yk_field_set(YkField *f, const double low[2], const double high[2], size_t n, bool has_curves)
{
    f->n = n;
    f->has_curves = has_curves;
    f->proved = f->lost = 0;
    for (int k = 0; k < 2; k++) {
        f->low[k] = low[k];
        f->high[k] = high[k];
        f->step[k] = (high[k] - low[k]) / (double)n;
    }
}

// Takes a tile from the source.
static bool take_from_source(YkField *f, size_t tile)
{
    YkTilePlane plane = {{f->low[0], f->low[1]}, {f->high[0], f->high[1]}, f->n, f->has_curves};
    const uint32_t *words = NULL;
    size_t count = 0;
    f->status = f->source->get(f->source->context, &plane, tile, f->tile_count, &words, &count);
    if (f->status < 0) return false;
    if (yk_tile_take(f, tile, words, count)) return true;
    if (!f->tracer.out_of_memory) f->status = YK_BAD_ARGUMENT;
    return false;
}

static bool divide_all(YkField *f, size_t n, bool has_curves)
{
    YkTileRoom room = {0};
    yk_field_set(f, f->low, f->high, n, has_curves);
    yk_pace_reach(f->tracer.pace, 0);
    bool good = yk_tiles_plan(f);
    for (size_t k = 0; k < f->tile_count && good; k++) {
        good = f->source ? take_from_source(f, k)
                         : yk_tile_compute(f, k, &room) && yk_tile_take(f, k, room.words, room.word_count);
        if (has_curves) yk_pace_reach(f->tracer.pace, (double)(k + 1) / (double)f->tile_count);
    }
    yk_tile_room_end(&room);
    return good;
}

// Makes the counts that follow all tiles begin alike, whoever computed the tiles.
static bool settle(YkField *f)
{
    for (size_t k = 0; k < f->tracer.piece_count; k++) f->memory.expected[k] = f->most[k];
    if (!yk_box_recall(&f->tracer, &f->memory, NULL)) f->tracer.out_of_memory = true;
    return !yk_field_is_over(f);
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
    double reach = yk_tracer_reach(f->tracer.mech), period = yk_tracer_period(&f->tracer);
    while ((double)n * tolerance < 1) n *= 2;
    for (int k = 0; k < 2; k++) {
        f->low[k] = f->is_angle[k] ? aside[k] - YK_PI : -(1 + aside[k]) * reach;
        f->high[k] = f->is_angle[k] ? f->low[k] + period : (1 + 0.7 * aside[k]) * reach;
    }
    if (!make_room(f, n)) f->tracer.out_of_memory = true;
    for (int k = 0; k < ZOOMS && !(f->is_angle[0] && f->is_angle[1]) && !yk_field_is_over(f); k++)
        if (!divide_all(f, COARSE, false) || !shrink(f)) break;
    return !yk_field_is_over(f) && divide_all(f, n, true) && settle(f);
}

// --- the curves

YkCrossing yk_field_crossing(YkField *f, size_t x, size_t y, int axis)
{
    const YkCrossing *known = yk_crossings_find(&f->crossings, yk_crossing_key(y * f->n + x, axis));
    if (known) return *known;
    YkCrossing found = yk_field_find_crossing(f, x, y, axis);
    if (!yk_crossings_add(&f->crossings, found)) f->tracer.out_of_memory = true;
    return found;
}
