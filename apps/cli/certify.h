// The certificate of a motion: whether a machine with groups is proved to stay on its configuration between poses.
#ifndef CLI_CERTIFY_H
#define CLI_CERTIFY_H
#include "session.h"
#include "write/json.h"

// Makes session->certifier unless --trust is given. Returns false when out of memory. Call it once, with session->mech.
bool yk_certify_begin(YkSession *session);
void yk_certify_end(YkSession *session);
// Lets it watch session->state from here on.
void yk_certify_watch(YkSession *session);
// Lets it watch another state of the same mechanism, or a simulation, which goes on where session->state is.
void yk_certify_state(YkSession *session, YkState *state);
void yk_certify_simulation(YkSession *session, YkSimulation *simulation);
// Warns of what is not proved.
void yk_certify_warn(YkSession *session);
// Writes "certified: true, false, or null with --trust"; if it is false, also not_certified, which says where and why.
void yk_certify_json(const YkSession *session, YkJson *json);
// Writes a line behind `before`, if the machine has groups and moved.
void yk_certify_text(const YkSession *session, const char *before, YkText *text);

#endif
