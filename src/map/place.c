// Finds poses on a map.
#include "map/map.h"

size_t yk_map_find_leaf(YkMap *map, const double *pose, double *row)
{
    YkTracer *t = &map->tracer;
    double nearest = 1e-5, at = pose[0], best = 0;
    size_t found = YK_NOT_FOUND;
    if (t->is_angle) at -= t->period * floor((at - t->low) / t->period);
    for (size_t k = 0; k < map->leaves->count; k++) {
        YkStrand *leaf = map->leaves->items[k];
        double from = yk_strand_from(leaf), to = yk_strand_to(leaf), slack = YK_TRACE_ZONE * t->scale;
        if (at < from - slack || at > to + slack) continue;
        if (!yk_map_read_row(map, leaf, fmin(fmax(at, from), to), NULL, row)) continue;
        double apart = yk_map_apart(map, pose, row);
        // At an event poses change as the square root of the input.
        if (at < from + slack || at > to - slack) apart *= 1e-2;
        if (apart < nearest) {
            nearest = apart;
            found = k;
            best = fmin(fmax(at, from), to);
        }
    }
    if (found != YK_NOT_FOUND && !yk_map_read_row(map, map->leaves->items[found], best, pose, row)) return YK_NOT_FOUND;
    return found;
}
