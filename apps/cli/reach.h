// The requested pose, and how the machine gets there: from where `start:` says that it was assembled, or by --assembly.
#ifndef CLI_REACH_H
#define CLI_REACH_H
#include "range.h"
#include "session.h"

// Brings session->state to the requested pose: drives at --time, --at; for a range (over, or NULL) at its FROM. Notes
// change points and detours. If the status is below 0, yk_reach_message says why and yk_reach_hint gives a hint.
YkStatus yk_session_reach(YkSession *session, const YkOver *over);
// Only puts session->state where the machine was assembled, for a study whose designs move from there; *start (the
// caller frees it) is its pose with the file's own inputs. If the file does not say where that is, or with --assembly,
// session->state is at the requested pose instead, and *start is NULL.
YkStatus yk_session_stand(YkSession *session, const YkOver *over, YkState **start);
// Returns why the pose was not reached, or what its state reports.
const char *yk_reach_message(const YkSession *session);
// Counts the configurations that close at the requested pose.
size_t yk_reach_count(YkSession *session);
// Adds a status other than YK_OK to the problems, with its message and, if the pose was not reached, a hint at what
// closes there.
void yk_reach_tell(YkSession *session, YkStatus status);
// Returns the machine where the file assembles it: the state of session->base (or mech) at t = 0, assembled; NULL when
// out of memory. The file's own configuration is carried over if --param gives other parameters.
YkState *yk_reach_start(YkSession *session, YkStatus *status);

// Returns a configuration's name among those that close at the pose: its label, with a number (`J+.2`) if several have
// the same label, counted in their order at the start. The caller frees it.
YkText yk_configuration_name(YkSession *session, const YkState *state);

// Parts of yk_session_reach. Takes the configuration that --assembly names at the requested pose;
YkStatus yk_reach_choose(YkSession *session);
// takes the one nearest to the guesses there, if the file does not say where the machine was assembled;
YkStatus yk_reach_untold(YkSession *session);
// says where the way stopped, at the pose of session->state;
void yk_reach_word_stop(YkSession *session);
// the machine's own pose at the asked inputs, or NULL if it does not come there; the caller frees it.
YkState *yk_reach_own(YkSession *session);
// Sets session->state to the requested inputs, without a pose.
YkStatus yk_reach_ask(YkSession *session);

#endif
