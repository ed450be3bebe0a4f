// The map of a machine with one freedom: its whole motion, on all circuits, with proof that nothing is missing.
//
// All configurations are followed along one coordinate, the mapped one: real ones, and also complex ones, out of which
// real ones could arise. Between events their number is proved constant. Branches meet at limits, where the mapped
// coordinate turns back, and at change points; branches that the machine can join without being taken apart are a
// circuit. docs/configurations.md has the mathematics.
#ifndef YOKE_MAP_H
#define YOKE_MAP_H

#include <yoke/state.h>
#include <yoke/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkMap YkMap;

// Maps the motion over a coordinate that is an input of the state's mechanism; other inputs keep the state's values.
// `start` is assembled in the machine's own configuration. An angle is mapped over the whole turns after which
// everything repeats, a distance over all values for which the machine could close. Progress of the state watches it.
// Returns NULL with a problem if the machine has a part that cannot be mapped (the message names it), or when out of
// memory or stopped.
// Cost: the paths of all complex solutions of each block on each branch of those before it, over the whole range.
YK_API YkMap *yk_map_new(YkState *start, size_t coordinate, YkProblems *problems);
YK_API void yk_map_free(YkMap *map);

// Returns whether everything was proved: no configuration and no event is missing.
YK_API bool yk_map_is_complete(const YkMap *map);
YK_API const char *yk_map_message(const YkMap *map); // why it is complete, or what was not proved, in one sentence
YK_API size_t yk_map_coordinate(const YkMap *map);   // the mapped one
YK_API YkRange yk_map_domain(const YkMap *map);      // rad or m; of an angle a whole number of turns long

// --- circuits: the one that contains the start first

YK_API size_t yk_map_circuit_count(const YkMap *map);
typedef struct YkMapCircuit {
    bool contains_start;
    size_t ranges, branches, events; // how many it has
} YkMapCircuit;
YK_API YkMapCircuit yk_map_circuit(const YkMap *map, size_t circuit); // all 0 beyond the last
// Returns a range of the mapped coordinate in which the circuit has configurations. Its ends are exact to 1e-10. An
// angle starts in (-pi, pi]; a range as long as the domain closes on itself.
YK_API YkRange yk_map_range(const YkMap *map, size_t circuit, size_t range);

typedef enum YkMapEventKind {
    YK_MAP_LIMIT,        // the mapped coordinate turns back: two branches join
    YK_MAP_CHANGE_POINT, // two branches cross
    YK_MAP_DEAD_POINT,   // another coordinate that was asked for turns back (yk_map_add_dead_points)
    YK_MAP_END           // the end of the domain: nothing is known beyond it
} YkMapEventKind;
YK_API const char *yk_map_event_kind_name(YkMapEventKind kind); // "limit", "change-point", "dead-point", "end"
typedef struct YkMapEvent {
    YkMapEventKind kind;
    double at;         // value of the mapped coordinate, to 1e-10; an angle in (-pi, pi], or within the domain
    int block;         // LIMIT, CHANGE_POINT: the block whose configurations meet; otherwise -1
    size_t coordinate; // DEAD_POINT: the one that turns back; otherwise YK_NOT_FOUND
    size_t branch;     // a branch of the circuit on which it lies
} YkMapEvent;
YK_API YkMapEvent yk_map_event(const YkMap *map, size_t circuit, size_t event); // ascending in `at`
// Returns the value of a coordinate at an event, or NaN if the circuit has no event of that number.
YK_API double yk_map_event_value(const YkMap *map, size_t circuit, size_t event, size_t coordinate);

// Returns the motion of a joint's angle on a circuit: its range, and whether it turns fully: the joint can go on
// turning the same way for ever. is_full is false and the range 0 for a joint whose bodies never turn to each other.
typedef struct YkMapTurn {
    bool is_full;
    YkRange range; // rad, as wide as the angle moves
} YkMapTurn;
YK_API YkMapTurn yk_map_turn(const YkMap *map, size_t circuit, size_t joint);

// --- branches: rows of poses, close enough to draw

// A branch goes from one limit to the next, or round. Rows are ascending in the mapped coordinate, which goes on beyond
// a turn if the branch does; bodies turn by less than 0.05 rad from row to row, roughly.
typedef struct YkMapBranch {
    double from, to;
    bool is_closed; // its last row is its first pose again
    size_t rows;
} YkMapBranch;
YK_API YkMapBranch yk_map_branch(const YkMap *map, size_t circuit, size_t branch);
// Returns the coordinates of a row: [yk_coordinate_count]. Angles are continuous along the branch.
YK_API const double *yk_map_row(const YkMap *map, size_t circuit, size_t branch, size_t row);
// Returns the places of the model's points at a row: [yk_model_point_count][2], m.
YK_API const double *yk_map_points(const YkMap *map, size_t circuit, size_t branch, size_t row);

// Adds the dead points of another coordinate: its own map, made from `start` of a mechanism of the same model whose
// input it is, has them as limits. Each is found on this map by its pose. If one is not, or that map is not complete,
// this one is not complete either. Returns YK_OK, YK_BAD_ARGUMENT or YK_NO_MEMORY.
YK_API YkStatus yk_map_add_dead_points(YkMap *map, const YkMap *other);
// Adds the dead points of every drive whose coordinate is not an input, by maps of their own. `start` as for
// yk_map_new. Returns YK_OK, or an error with a problem added: a drive's map cannot be made, or out of memory.
YK_API YkStatus yk_map_add_drives(YkMap *map, const YkState *start, YkProblems *problems);

// --- places and ways

// A configuration on the map.
typedef struct YkMapPlace {
    size_t circuit, strand; // strand: a part of a branch, by a number that only this map understands
    double at;              // the mapped coordinate, within the domain
} YkMapPlace;
// Writes all configurations at a value of the mapped coordinate, `capacity` at most. Returns how many there are.
YK_API size_t yk_map_places(const YkMap *map, double at, YkMapPlace *places, size_t capacity);
// Writes the configurations that have these coordinates to about two digits, `capacity` at most: [yk_coordinate_count],
// NaN for those that are not given; the mapped one must be. Returns how many there are; YK_NOT_FOUND when out of
// memory.
YK_API size_t yk_map_find(YkMap *map, const double *coordinates, YkMapPlace *places, size_t capacity);
// Returns the machine's own configuration; strand is YK_NOT_FOUND if it was not found on the map.
YK_API YkMapPlace yk_map_start(const YkMap *map);
// Writes the coordinates of a configuration: [yk_coordinate_count]. Returns false for a wrong place, or out of memory.
YK_API bool yk_map_coordinates_at(YkMap *map, YkMapPlace place, double *coordinates);
// Finds a way from one configuration to another that passes the fewest limits and change points: writes the first, one
// beside each event on the way (as near as the map is proved), and the last. Returns how many; 0 if no way exists,
// which is proved if the map is complete; YK_NOT_FOUND when out of memory.
YK_API size_t yk_map_way(const YkMap *map, YkMapPlace from, YkMapPlace to, YkMapPlace *way, size_t capacity);

// A drawing of the map: a coordinate over the mapped one, one colour for each circuit, that of the start thick, events
// marked; and beside it the curves of points, on all circuits, to scale.
typedef struct YkMapPicture {
    size_t coordinate; // drawn upwards
    const size_t *points;
    size_t point_count;
    const char *angle_unit, *length_unit; // for the axes
    double angle, length;                 // what 1 rad and 1 m are in these units
} YkMapPicture;
// Returns the drawing as SVG, valid until the next call; NULL when out of memory or for a wrong index.
YK_API const char *yk_map_picture(YkMap *map, const YkMapPicture *options);

#ifdef __cplusplus
}
#endif

#endif
