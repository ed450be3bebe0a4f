// Lists the events of every circuit.
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "map/map.h"

double yk_map_shown(const YkMap *map, double at)
{
    const YkTracer *t = &map->tracer;
    if (!t->is_angle) return at;
    double shown = at > YK_PI ? at - t->period : at; // the domain begins a little after -pi
    return shown <= -YK_PI ? shown + t->period : shown;
}

bool yk_map_mark(YkMap *map, YkMapEvent event, size_t circuit, const double *row)
{
    double *copy = malloc(map->width * sizeof *copy);
    if (!copy || !YK_ROOM(map->marks, map->mark_count, map->mark_capacity)) {
        free(copy);
        return false;
    }
    memcpy(copy, row, map->width * sizeof *copy);
    copy[0] = copy[1 + map->coordinate] = event.at;
    size_t place = map->mark_count++;
    for (; place > 0 && map->marks[place - 1].event.at > event.at; place--) map->marks[place] = map->marks[place - 1];
    map->marks[place] = (YkMapMark){event, circuit, copy};
    return true;
}

static bool mark_tie(YkMap *map, const YkTie *tie)
{
    YkStrand *leaf = tie->strand[0];
    const YkMapLine *line = &map->lines[map->branch_of[leaf->index]];
    YkMapEvent event = {.kind = tie->kind == YK_TIE_LIMIT ? YK_MAP_LIMIT : YK_MAP_CHANGE_POINT,
                        .at = yk_map_shown(map, tie->at),
                        .block = (int)tie->block,
                        .coordinate = YK_NOT_FOUND,
                        .branch = map->branch_of[leaf->index]};
    double nearest = INFINITY;
    const double *row = NULL;
    for (size_t r = 0; r < line->rows.count; r++) { // branches have a row at each of their events
        const double *candidate = yk_map_row_at(map, &line->rows, r);
        double off = candidate[0] - tie->at;
        if (map->tracer.is_angle) off -= map->tracer.period * rint(off / map->tracer.period);
        if (fabs(off) < nearest) {
            nearest = fabs(off);
            row = candidate;
        }
    }
    return row && yk_map_mark(map, event, line->circuit, row);
}

// Marks where the domain of a distance ends on a branch.
static bool mark_ends(YkMap *map, const YkStrand *leaf)
{
    const YkTracer *t = &map->tracer;
    const YkMapRows *rows = &map->strand_rows[leaf->index];
    for (int end = 0; end < 2 && !t->is_angle; end++) {
        double at = end == 1 ? yk_strand_to(leaf) : yk_strand_from(leaf);
        if (at != (end == 1 ? t->high : t->low)) continue;
        YkMapEvent event = {YK_MAP_END, at, -1, YK_NOT_FOUND, map->branch_of[leaf->index]};
        const double *row = yk_map_row_at(map, rows, end == 1 ? rows->count - 1 : 0);
        if (!yk_map_mark(map, event, map->circuit_of[leaf->index], row)) return false;
    }
    return true;
}

bool yk_map_find_events(YkMap *map)
{
    const YkTies *ties = &map->tracer.ties[map->tracer.piece_count];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        bool is_first = tie->kind == YK_TIE_LIMIT || tie->kind == YK_TIE_CHANGE;
        for (size_t j = 0; j < k; j++) is_first &= ties->items[j].event != tie->event;
        if (is_first && !mark_tie(map, tie)) return false;
    }
    for (size_t k = 0; k < map->leaves->count; k++)
        if (!mark_ends(map, map->leaves->items[k])) return false;
    return true;
}
