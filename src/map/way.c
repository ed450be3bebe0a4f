// Finds configurations on a map, and the way from one to another.
#include <stdlib.h>
#include <string.h>
#include "map/map.h"
#include "solve/gap.h"

// Returns an input within the domain of the strands.
static double into_domain(const YkMap *map, double at)
{
    const YkTracer *t = &map->tracer;
    return t->is_angle ? at - t->period * floor((at - t->low) / t->period) : at;
}

size_t yk_map_places(const YkMap *map, double at, YkMapPlace *places, size_t capacity)
{
    size_t count = 0;
    if (!map || !isfinite(at)) return 0;
    double inside = into_domain(map, at);
    for (size_t k = 0; k < map->leaves->count; k++) {
        YkStrand *leaf = map->leaves->items[k];
        if (inside < yk_strand_from(leaf) || inside > yk_strand_to(leaf)) continue;
        if (count < capacity && places) places[count] = (YkMapPlace){map->circuit_of[k], k, inside};
        count++;
    }
    return count;
}

YkMapPlace yk_map_start(const YkMap *map)
{
    YkMapPlace place = {YK_NOT_FOUND, YK_NOT_FOUND, NAN};
    if (!map || !map->has_start) return place;
    YkStrand *leaf = map->leaves->items[map->start_leaf];
    double at = into_domain(map, map->start_at);
    at = fmin(fmax(at, yk_strand_from(leaf)), yk_strand_to(leaf));
    return (YkMapPlace){map->circuit_of[map->start_leaf], map->start_leaf, at};
}

static bool is_place(const YkMap *map, YkMapPlace place)
{
    if (!map || place.strand >= map->leaves->count) return false;
    const YkStrand *leaf = map->leaves->items[place.strand];
    return place.at >= yk_strand_from(leaf) && place.at <= yk_strand_to(leaf);
}

bool yk_map_coordinates_at(YkMap *map, YkMapPlace place, double *coordinates)
{
    if (!is_place(map, place)) return false;
    double *row = calloc(map->width, sizeof *row);
    bool ok = row && yk_map_read_row(map, map->leaves->items[place.strand], place.at, NULL, row);
    if (ok) memcpy(coordinates, row + 1, map->mech->coordinate_count * sizeof *row);
    free(row);
    return ok;
}

// Returns how far a configuration is from values that are given: rad, or lengths over the machine's size.
static double off_from(const YkMap *map, const double *wanted, const double *coordinates)
{
    double most = 0;
    for (size_t c = 0; c < map->mech->coordinate_count; c++) {
        if (isnan(wanted[c]) || c == map->coordinate) continue;
        most = fmax(most, yk_gap(map->mech, yk_coordinate_info(map->mech, c).is_distance, coordinates[c] - wanted[c]));
    }
    return most;
}

size_t yk_map_find(YkMap *map, const double *coordinates, YkMapPlace *places, size_t capacity)
{
    const double near = 0.02;
    if (!map || !coordinates || isnan(coordinates[map->coordinate])) return 0;
    double at = coordinates[map->coordinate];
    size_t all = yk_map_places(map, at, NULL, 0), count = 0;
    YkMapPlace *found = calloc(all + 1, sizeof *found);
    double *row = calloc(map->mech->coordinate_count + 1, sizeof *row);
    if (found && row) yk_map_places(map, at, found, all);
    bool ok = found && row;
    for (size_t k = 0; ok && k < all; k++) {
        ok = yk_map_coordinates_at(map, found[k], row);
        if (!ok || !(off_from(map, coordinates, row) < near)) continue;
        if (places && count < capacity) places[count] = found[k];
        count++;
    }
    if (!ok) count = YK_NOT_FOUND;
    free(found);
    free(row);
    return count;
}

// --- the way

typedef struct Search {
    const YkMap *map;
    const YkTie **into; // [leaf]: the tie by which it was reached
    size_t *before;     // [leaf]: from which leaf; itself at the first
    size_t *queue;
} Search;

// Goes out from a leaf, nearest ties first, until another is reached.
static bool go_out(Search *s, size_t from, size_t to)
{
    const YkTies *ties = &s->map->tracer.ties[s->map->tracer.piece_count];
    size_t head = 0, tail = 0;
    for (size_t k = 0; k < s->map->leaves->count; k++) s->before[k] = YK_NOT_FOUND;
    s->before[from] = from;
    s->queue[tail++] = from;
    for (; head < tail && s->before[to] == YK_NOT_FOUND; head++)
        for (size_t k = 0; k < ties->count; k++) {
            const YkTie *tie = &ties->items[k];
            for (int side = 0; side < 2; side++) {
                size_t here = tie->strand[side]->index, next = tie->strand[1 - side]->index;
                if (here != s->queue[head] || s->before[next] != YK_NOT_FOUND) continue;
                s->before[next] = here;
                s->into[next] = tie;
                s->queue[tail++] = next;
            }
        }
    return s->before[to] != YK_NOT_FOUND;
}

// Writes the poses of the way backwards, from its end: the target, then every event on it, then the start.
static size_t list_poses(const Search *s, YkMapPlace from, YkMapPlace to, YkMapPlace *poses, size_t capacity)
{
    size_t count = 0;
    if (count < capacity) poses[count] = to;
    count++;
    for (size_t leaf = to.strand; leaf != from.strand; leaf = s->before[leaf]) {
        const YkTie *tie = s->into[leaf];
        if (tie->kind == YK_TIE_ROUND || tie->kind == YK_TIE_PASS) continue;
        const YkStrand *strand = s->map->leaves->items[leaf];
        int end = tie->strand[0] == strand ? tie->end[0] : tie->end[1];
        double at = end == 1 ? yk_strand_to(strand) : yk_strand_from(strand);
        if (count < capacity) poses[count] = (YkMapPlace){s->map->circuit_of[leaf], leaf, at};
        count++;
    }
    if (count < capacity) poses[count] = from;
    return count + 1;
}

size_t yk_map_way(const YkMap *map, YkMapPlace from, YkMapPlace to, YkMapPlace *way, size_t capacity)
{
    if (!is_place(map, from) || !is_place(map, to)) return 0;
    size_t n = map->leaves->count + 1, count = 0;
    Search s = {map, calloc(n, sizeof *s.into), calloc(n, sizeof *s.before), calloc(n, sizeof *s.queue)};
    if (!s.into || !s.before || !s.queue) {
        count = YK_NOT_FOUND;
    } else if (go_out(&s, from.strand, to.strand)) {
        count = list_poses(&s, from, to, way, way ? capacity : 0);
        for (size_t a = 0, b = count; way && count <= capacity && a + 1 < b; a++, b--) {
            YkMapPlace swapped = way[a];
            way[a] = way[b - 1];
            way[b - 1] = swapped;
        }
    }
    free(s.into);
    free(s.before);
    free(s.queue);
    return count;
}
