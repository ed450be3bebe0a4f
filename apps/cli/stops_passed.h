// A warning for poses beyond a stop of the file (`stops:`): only `simulate` lets stops act.
#ifndef CLI_STOPS_PASSED_H
#define CLI_STOPS_PASSED_H
#include "cli.h"
#include "write/json.h"

typedef struct YkStopWatch YkStopWatch;

// Makes a watch over the stops of the session's model, for the caller to free; NULL, remembered, when out of memory.
YkStopWatch *yk_session_watch_stops(YkSession *session);
void yk_stop_watch_free(YkStopWatch *watch);
// Looks at a pose of the session's mechanism. at: its place along what is swept.
void yk_stop_watch_look(YkStopWatch *watch, const YkState *state, double at);
// Warns of every stop that was passed, at its line of the file. axis: what `at` is ("t", "theta1"), or NULL.
void yk_warn_of_stops(const YkStopWatch *watch, const char *axis, YkQuantity quantity);
// Adds "stops_passed", if there are any, in SI. has_axis: `at` has a meaning.
void yk_add_stops_json(YkJson *json, const YkStopWatch *watch, bool has_axis);

#endif
