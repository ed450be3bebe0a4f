// Tiles for whoever distributes a map: the public functions.
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"
#include "map/workspace/regions.h"
#include "map/workspace/tile.h"
#include "solve/state.h"

struct YkTiles {
    YkRegions *regions; // whose field has no cells
    YkState *start;
    bool has_begun;
    YkTilePlane plane; // the one that is planned
    YkTileRoom room;
};

YkTiles *yk_tiles_new(YkState *start, size_t first, size_t second, YkProblems *problems)
{
    YkTiles *t = calloc(1, sizeof *t);
    if (!t) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
        return NULL;
    }
    t->start = start;
    t->regions = yk_regions_begin(start, first, second, yk_default_regions_options().tolerance, problems);
    if (t->regions) return t;
    yk_tiles_free(t);
    return NULL;
}

void yk_tiles_free(YkTiles *t)
{
    if (!t) return;
    yk_regions_free(t->regions);
    yk_tile_room_end(&t->room);
    free(t);
}

static bool is_same(const YkTilePlane *a, const YkTilePlane *b)
{
    bool same = a->squares == b->squares && a->has_curves == b->has_curves;
    for (int k = 0; k < 2; k++) same &= a->low[k] == b->low[k] && a->high[k] == b->high[k];
    return same;
}

static bool is_plane(const YkTilePlane *p)
{
    bool is_power = p->squares >= 8 && p->squares <= 16384 && (p->squares & (p->squares - 1)) == 0;
    for (int k = 0; k < 2; k++)
        is_power = is_power && isfinite(p->low[k]) && isfinite(p->high[k]) && p->low[k] < p->high[k];
    return is_power;
}

static bool plan(YkTiles *t, const YkTilePlane *plane)
{
    if (is_same(plane, &t->plane)) return true;
    t->plane = (YkTilePlane){.squares = 0};
    if (!t->has_begun && !yk_field_begin(&t->regions->field, t->regions->start)) return false;
    t->has_begun = true;
    yk_field_set(&t->regions->field, plane->low, plane->high, plane->squares, plane->has_curves);
    if (!yk_tiles_plan(&t->regions->field)) return false;
    t->plane = *plane;
    return true;
}

YkStatus yk_tiles_compute(YkTiles *t, const YkTilePlane *plane, size_t tile, const uint32_t **words, size_t *word_count)
{
    *words = NULL;
    *word_count = 0;
    if (!t || !is_plane(plane)) return YK_BAD_ARGUMENT;
    YkField *f = &t->regions->field;
    bool is_own = yk_state_begin(t->start);
    YkStatus status = YK_OK;
    f->tracer.pace = t->start->pace;
    if (!plan(t, plane))
        status = YK_NO_MEMORY;
    else if (tile >= f->tile_count)
        status = YK_BAD_ARGUMENT;
    else if (!yk_tile_compute(f, tile, &t->room))
        status = YK_NO_MEMORY;
    f->tracer.pace = NULL;
    status = yk_state_end(t->start, is_own, status);
    if (status != YK_OK) return status;
    *words = t->room.words;
    *word_count = t->room.word_count;
    return YK_OK;
}
