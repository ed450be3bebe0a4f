// Finds the limits of another coordinate's map on this one: its dead points.
#include <stdlib.h>
#include <string.h>
#include "map/map.h"

// Returns whether both maps are of the same coordinates, so that rows mean the same.
static bool has_same_rows(const YkMap *map, const YkMap *other)
{
    const YkMechanism *a = map->mech, *b = other->mech;
    if (a->model != b->model || a->coordinate_count != b->coordinate_count || map->width != other->width) return false;
    for (size_t c = 0; c < a->coordinate_count; c++)
        if (strcmp(a->coordinates[c].name, b->coordinates[c].name) != 0) return false;
    return true;
}

static bool add_mark(YkMap *map, const YkMap *other, const YkMapMark *mark, double *row)
{
    double *found = row + map->width;
    memcpy(row, mark->row, map->width * sizeof *row);
    row[0] = row[1 + map->coordinate]; // an unknown of the other map
    size_t leaf = yk_map_find_leaf(map, row, found);
    if (leaf == YK_NOT_FOUND) {
        map->lost++;
        return true;
    }
    YkMapEvent event = {YK_MAP_DEAD_POINT, yk_map_shown(map, found[0]), -1, other->coordinate, map->branch_of[leaf]};
    return yk_map_mark(map, event, map->circuit_of[leaf], found);
}

YkStatus yk_map_add_dead_points(YkMap *map, const YkMap *other)
{
    if (!map || !other || map->coordinate == other->coordinate || !has_same_rows(map, other)) return YK_BAD_ARGUMENT;
    double *rows = calloc(2 * map->width, sizeof *rows);
    bool ok = rows != NULL;
    for (size_t k = 0; ok && k < other->mark_count; k++)
        if (other->marks[k].event.kind == YK_MAP_LIMIT) ok = add_mark(map, other, &other->marks[k], rows);
    free(rows);
    if (!other->is_complete) map->lost++;
    if (ok) yk_map_tell(map);
    return ok && !map->tracer.out_of_memory ? YK_OK : YK_NO_MEMORY;
}
