// yoke map: what its files share.
#ifndef VERBS_MAP_MAP_H
#define VERBS_MAP_MAP_H
#include "answer.h"

typedef struct YkMapAnswer {
    YkSession *session;
    YkMap *map;
    const char *name; // of the mapped coordinate
    YkQuantity quantity;
    size_t vertical, *points; // of --plot
} YkMapAnswer;

// Reads what --plot needs, before anything is written. points: of --trace.
bool yk_map_plan(YkMapAnswer *answer);
void yk_map_text(const YkMapAnswer *answer);
void yk_map_json(const YkMapAnswer *answer);
bool yk_map_plot(const YkMapAnswer *answer, const char *path);
// Returns the joint that labels the block of an event, or the coordinate that stands at a dead point; NULL if none.
const char *yk_map_event_of(const YkMapAnswer *answer, YkMapEvent event);

// Returns how many inputs --at leaves free.
size_t yk_map_free_inputs(const YkSession *session);
// Returns whether --at leaves the machine the freedoms that are mapped; refuses it otherwise.
bool yk_map_has_freedoms(YkSession *session, size_t wanted);

#define YK_MAP_CARRIAGE "map_carriage_" // begins the names of what carries a point

// A map over two coordinates, or over a point's x and y.
typedef struct YkRegionsAnswer {
    YkSession *session;
    YkRegions *regions;
    YkModel *model; // in which a point is carried, or NULL
    YkMechanism *own_mech;
    YkState *own_state;
    const YkMechanism *mech; // what is mapped
    YkState *state;
    size_t coordinate[2];
    const char *names[2];
    YkQuantity quantity[2];
} YkRegionsAnswer;
// Answers `map` over two coordinates (NULL: the free inputs of a session that is loaded), or over a point's x and y
// (regions.c). Returns the exit code.
int yk_map_regions(YkSession *session, const char *first, const char *second);
void yk_map_regions_text(const YkRegionsAnswer *answer);
void yk_map_regions_json(const YkRegionsAnswer *answer);

// spread.c: lets all ranks of mpirun compute tiles of the map. Returns NULL with problems added, or stopped.
typedef struct YkMapSpread YkMapSpread;
YkMapSpread *yk_map_spread(const YkRegionsAnswer *answer, YkRegionsOptions *options);
void yk_map_gather(YkMapSpread *spread);          // ends it
void yk_map_serve(const YkRegionsAnswer *answer); // what ranks other than 0 do, until rank 0 dismisses them

// Answers --reach. Returns the exit code: 0 if there is a way, 1 if there is none.
int yk_map_reach(YkMapAnswer *answer);
// Hints at a coordinate that distinguishes configurations, with its values in them. given: [yk_coordinate_count], NaN
// for those that they were not sought by.
void yk_map_hint_apart(const YkMapAnswer *answer, const double *given, const YkMapPlace *places, size_t count);

#endif
