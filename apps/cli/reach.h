// The pose that was asked for, and how the machine gets there: from where `start:` says that it was put together, or by
// --assembly.
#ifndef CLI_REACH_H
#define CLI_REACH_H
#include "range.h"
#include "session.h"

// Brings session->state to the asked pose: drives at --time, --at; of a range (over, or NULL) at its FROM. Notes change
// points and ways round. Where the status is below 0, yk_reach_message says why and yk_reach_hint gives a hint.
YkStatus yk_session_reach(YkSession *session, const YkOver *over);
// Only puts session->state where the machine was put together, for a study whose designs move from there; *start (the
// caller frees it) is its pose with the file's own inputs. Where that is not told, or by --assembly, session->state is
// at the asked pose instead, and *start is NULL.
YkStatus yk_session_stand(YkSession *session, const YkOver *over, YkState **start);
// Why the pose was not reached, or what its state has to say.
const char *yk_reach_message(const YkSession *session);
// How many configurations close at the asked pose.
size_t yk_reach_count(YkSession *session);
// Adds a status other than YK_OK to the problems, with its message and, where the pose was not reached, a hint at what
// closes there.
void yk_reach_tell(YkSession *session, YkStatus status);
// The machine where the file puts it together: session->base's (or mech's) state at t = 0, assembled; NULL when out of
// memory. The file's own configuration is carried over where --param gives other parameters.
YkState *yk_reach_start(YkSession *session, YkStatus *status);

// Are these the same configuration, whole turns apart?
bool yk_same_configuration(const YkState *a, const YkState *b);
// A configuration's name among those that close at the pose: its label, with a number behind it (`J+.2`) where several
// have the same, counted as they come at the start. The caller frees it.
YkText yk_configuration_name(YkSession *session, const YkState *state);

// What yk_session_reach is made of. Takes the configuration that --assembly names at the asked pose:
YkStatus yk_reach_choose(YkSession *session);
// the one nearest to the guesses there, for a file that does not say where the machine was put together:
YkStatus yk_reach_untold(YkSession *session);
// puts into words where the way stopped: session->state stands there.
void yk_reach_word_stop(YkSession *session);
// the machine's own pose at the asked inputs, or NULL if it does not come there; the caller frees it.
YkState *yk_reach_own(YkSession *session);
// Sets session->state to the asked inputs, without a pose.
YkStatus yk_reach_ask(YkSession *session);

#endif
