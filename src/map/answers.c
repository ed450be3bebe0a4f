// Answers questions about a map.
#include "map/map.h"

bool yk_map_is_complete(const YkMap *map)
{
    return map && map->is_complete;
}

const char *yk_map_message(const YkMap *map)
{
    return map ? map->message : "";
}

size_t yk_map_coordinate(const YkMap *map)
{
    return map ? map->coordinate : YK_NOT_FOUND;
}

YkRange yk_map_domain(const YkMap *map)
{
    return map ? (YkRange){map->tracer.low, map->tracer.high} : (YkRange){NAN, NAN};
}

size_t yk_map_circuit_count(const YkMap *map)
{
    return map ? map->circuit_count : 0;
}

YkMapCircuit yk_map_circuit(const YkMap *map, size_t circuit)
{
    YkMapCircuit c = {false, 0, 0, 0};
    if (!map || circuit >= map->circuit_count) return c;
    c.contains_start = map->has_start && circuit == 0;
    for (size_t k = 0; k < map->span_count; k++) c.ranges += map->spans[k].circuit == circuit;
    for (size_t k = 0; k < map->line_count; k++) c.branches += map->lines[k].circuit == circuit;
    for (size_t k = 0; k < map->mark_count; k++) c.events += map->marks[k].circuit == circuit;
    return c;
}

YkRange yk_map_range(const YkMap *map, size_t circuit, size_t range)
{
    for (size_t k = 0; map && k < map->span_count; k++)
        if (map->spans[k].circuit == circuit && range-- == 0) return map->spans[k].range;
    return (YkRange){NAN, NAN};
}

const char *yk_map_event_kind_name(YkMapEventKind kind)
{
    static const char *const names[] = {"limit", "change-point", "dead-point", "end"};
    return (unsigned)kind < sizeof names / sizeof *names ? names[kind] : "?";
}

static const YkMapMark *find_mark(const YkMap *map, size_t circuit, size_t event)
{
    for (size_t k = 0; map && k < map->mark_count; k++)
        if (map->marks[k].circuit == circuit && event-- == 0) return &map->marks[k];
    return NULL;
}

static size_t line_in_circuit(const YkMap *map, size_t line)
{
    size_t place = 0;
    for (size_t k = 0; k < line; k++) place += map->lines[k].circuit == map->lines[line].circuit;
    return place;
}

YkMapEvent yk_map_event(const YkMap *map, size_t circuit, size_t event)
{
    const YkMapMark *mark = find_mark(map, circuit, event);
    if (!mark) return (YkMapEvent){YK_MAP_LIMIT, NAN, -1, YK_NOT_FOUND, YK_NOT_FOUND};
    YkMapEvent e = mark->event;
    e.branch = line_in_circuit(map, e.branch);
    return e;
}

double yk_map_event_value(const YkMap *map, size_t circuit, size_t event, size_t coordinate)
{
    const YkMapMark *mark = find_mark(map, circuit, event);
    return mark && coordinate < map->mech->coordinate_count ? mark->row[1 + coordinate] : NAN;
}

YkMapTurn yk_map_turn(const YkMap *map, size_t circuit, size_t joint)
{
    if (!map || circuit >= map->circuit_count || joint >= map->joints) return (YkMapTurn){false, {0, 0}};
    return map->turns[circuit * (map->joints + 1) + joint];
}

static const YkMapLine *find_line(const YkMap *map, size_t circuit, size_t branch)
{
    for (size_t k = 0; map && k < map->line_count; k++)
        if (map->lines[k].circuit == circuit && branch-- == 0) return &map->lines[k];
    return NULL;
}

YkMapBranch yk_map_branch(const YkMap *map, size_t circuit, size_t branch)
{
    const YkMapLine *line = find_line(map, circuit, branch);
    if (!line || line->rows.count == 0) return (YkMapBranch){NAN, NAN, false, 0};
    double from = yk_map_row_at(map, &line->rows, 0)[0], to = yk_map_row_at(map, &line->rows, line->rows.count - 1)[0];
    return (YkMapBranch){from, to, line->is_closed, line->rows.count};
}

const double *yk_map_row(const YkMap *map, size_t circuit, size_t branch, size_t row)
{
    const YkMapLine *line = find_line(map, circuit, branch);
    return line && row < line->rows.count ? yk_map_row_at(map, &line->rows, row) + 1 : NULL;
}

const double *yk_map_points(const YkMap *map, size_t circuit, size_t branch, size_t row)
{
    const YkMapLine *line = find_line(map, circuit, branch);
    if (!line || row >= line->rows.count) return NULL;
    return yk_map_row_at(map, &line->rows, row) + yk_map_point_column(map, 0);
}
