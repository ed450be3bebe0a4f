// Ctrl-C: the verbs' long calls end soon and leave nothing behind; and one line of progress for people who watch.
#ifndef CLI_STOP_H
#define CLI_STOP_H
#include "cli.h"

// From now on Ctrl-C, or SIGTERM, asks to stop; a second one ends the program at once.
void yk_stop_catch(void);
bool yk_stop_is_asked(void);
// Returns whether it is asked, and remembers that the verb heeds it: it goes no further, and main says so.
bool yk_stop_is_due(void);
bool yk_stop_is_heeded(void);
// Gives signals their usual meaning, the program's end at once, until yk_stop_catch: for what may wait for ever and has
// nothing to tidy up.
void yk_stop_release(void);
// Returns the exit code of a verb that heeded a signal: 128 + its number, 130 for Ctrl-C. Says it on standard error.
int yk_stop_exit(void);

// Returns what the library's long calls are given. After a second it shows how far they are, if standard error is a
// terminal and --quiet is not given.
YkProgress yk_stop_progress(const YkSession *session);
// Removes the line of progress.
void yk_stop_clear_line(void);
// Return whether standard error is a terminal that can move its cursor; whether progress may be shown; and the
// clock for it, s.
bool yk_is_at_terminal(void);
bool yk_stop_shows_progress(const YkSession *session);
double yk_stop_now(void);

// Returns a new state whose long calls are watched; NULL when out of memory.
YkState *yk_session_new_state(const YkSession *session, const YkMechanism *mech);

#endif
