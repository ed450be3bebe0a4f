// yoke map: what its files share.
#ifndef VERBS_MAP_MAP_H
#define VERBS_MAP_MAP_H
#include "answer.h"

typedef struct YkMapAnswer {
    YkSession *session;
    YkMap *map;
    const char *name; // of the mapped coordinate
    YkQuantity quantity;
} YkMapAnswer;

void yk_map_text(const YkMapAnswer *answer);
void yk_map_json(const YkMapAnswer *answer);
bool yk_map_plot(const YkMapAnswer *answer, const char *path);
// Returns the joint that labels the block of an event, or the coordinate that stands at a dead point; NULL if none.
const char *yk_map_event_of(const YkMapAnswer *answer, YkMapEvent event);

#endif
