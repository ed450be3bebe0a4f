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

// Answers --reach. Returns the exit code: 0 if there is a way, 1 if there is none.
int yk_map_reach(YkMapAnswer *answer);

#endif
