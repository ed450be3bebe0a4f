// Says where a pose leaves the range of a law.
#ifndef CLI_LAWS_LEFT_H
#define CLI_LAWS_LEFT_H
#include "cli.h"
#include "write/json.h"

// Makes a watch over the session's model; NULL when out of memory, which is remembered.
YkLawWatch *yk_session_watch_laws(YkSession *session);
// Warns of every law that was left, at its line of the file. axis: what `at` of the watch is ("t", "theta1"); NULL:
// there was one pose. whose: ends the sentence, if only some of the poses were looked at; or "".
void yk_warn_of_laws(YkSession *session, const YkLawWatch *watch, const char *axis, YkQuantity quantity,
                     const char *whose);
// Adds "laws_left", if there are any, in SI. has_axis: `at` has a meaning.
void yk_add_laws_json(YkJson *json, const YkLawWatch *watch, bool has_axis);

#endif
