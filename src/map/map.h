// The inside of YkMap: strands as branches with rows, and the circuits they make.
#ifndef MAP_MAP_H
#define MAP_MAP_H
#include <yoke/map.h>
#include "base/text.h"
#include "map/strand.h"

typedef struct YkMapRows { // of one strand, or of one branch
    double *numbers;       // [count][width]
    size_t count, capacity;
} YkMapRows;

typedef struct YkMapLine { // a branch
    size_t circuit;
    bool is_closed;
    YkMapRows rows;
} YkMapLine;

typedef struct YkMapMark { // an event
    YkMapEvent event;
    size_t circuit;
    double *row;
} YkMapMark;

typedef struct YkMapSpan {
    size_t circuit;
    YkRange range;
} YkMapSpan;

// A row: the mapped coordinate, all coordinates, the angles of all joints, the points.
struct YkMap {
    const YkMechanism *mech;
    YkTracer tracer;
    size_t coordinate;
    double *inputs; // the values of all inputs at the start
    size_t joints, points, width;
    YkMapRows *strand_rows; // [leaf strand]
    YkStrands *leaves;      // those of the last level
    size_t *circuit_of;     // [leaf strand]
    size_t *branch_of;      // [leaf strand]: in `lines`
    size_t circuit_count;
    bool has_start;
    double start_at;   // the mapped coordinate there
    size_t start_leaf; // the one that contains the machine's own configuration, or YK_NOT_FOUND
    YkMapLine *lines;
    size_t line_count, line_capacity;
    YkMapMark *marks;
    size_t mark_count, mark_capacity;
    YkMapSpan *spans;
    size_t span_count, span_capacity;
    YkMapTurn *turns; // [circuit][joint]
    bool is_complete;
    size_t lost; // dead points of another map that are not on this one
    char message[640];
    YkText picture; // the last one drawn
};

static inline double *yk_map_row_at(const YkMap *map, const YkMapRows *rows, size_t row)
{
    return rows->numbers + row * map->width;
}
static inline size_t yk_map_joint_column(const YkMap *map, size_t joint)
{
    return 1 + map->mech->coordinate_count + joint;
}
static inline size_t yk_map_point_column(const YkMap *map, size_t point)
{
    return 1 + map->mech->coordinate_count + map->joints + 2 * point;
}

// map.c
void yk_map_tell(YkMap *map); // decides whether all is proved, and writes the message

// rows.c
bool yk_map_read_rows(YkMap *map); // of all leaf strands
// Writes the row of a leaf strand's pose at an input; angles nearest to those of `before`, unless it is NULL.
bool yk_map_read_row(YkMap *map, YkStrand *strand, double at, const double *before, double *row);
double *yk_map_add_row(YkMap *map, YkMapRows *rows); // NULL when out of memory
// Returns how far two poses are apart: radians, lengths over the machine's size; whole turns do not count.
double yk_map_apart(const YkMap *map, const double *a, const double *b);

// place.c
// Returns the leaf on which a pose lies, given as a row, or YK_NOT_FOUND; row is the leaf's nearest pose.
size_t yk_map_find_leaf(YkMap *map, const double *pose, double *row);

// circuits.c
bool yk_map_find_circuits(YkMap *map);
// turns.c
bool yk_map_find_turns(YkMap *map);
// events.c
bool yk_map_find_events(YkMap *map);
bool yk_map_mark(YkMap *map, YkMapEvent event, size_t circuit, const double *row);
// Returns an input within the domain's first turn, as it is shown.
double yk_map_shown(const YkMap *map, double at);

#endif
