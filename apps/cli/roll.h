// The roll of configurations at a pose: which there are, what they are called, and whether there are others.
#ifndef CLI_ROLL_H
#define CLI_ROLL_H
#include <yoke/configurations.h>
#include "session.h"

// Kept of them by a session.
struct YkRolls {
    YkConfigurations *configurations;
    double deadline; // --within; 0: none
};

// Visits every configuration at the inputs of `state`, a state of session->mech, as yk_configurations_each does in the
// order of yk_state_each; report may be NULL. Names (yk_configuration_name) may be asked for while it visits.
YkStatus yk_session_each(YkSession *session, YkState *state, bool (*visit)(void *context, YkState *state),
                         void *context, YkConfigurationsReport *report);
// Returns the continuum that the configuration being visited stands for, or NULL.
const YkContinuum *yk_session_continuum(const YkSession *session);
// Reads --within, s; 0 without it. Returns false, with a problem, for a bad value or without --all.
bool yk_roll_within(YkSession *session, double *seconds);
// Reads --solver. Returns false, with a problem, for another word or without --all.
bool yk_roll_solver(YkSession *session, YkGroupSolver *solver);
// Frees what the session keeps of configurations.
void yk_roll_end(YkSession *session);

#endif
