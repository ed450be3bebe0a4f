// Configurations are enumerated, and those of groups named, in yoke.wasm alone: panels.wasm leaves it what asks for
// them. The page asks it again (worker.ts).
#include "roll.h"
#include <stdio.h>
#include "answer.h"
#include "reach.h"

static bool leave(YkSession *session)
{
    if (!session->has_told_error)
        fputs("yoke: error: this module does not list configurations; yoke.wasm does\n", stderr);
    session->has_told_error = true;
    return false;
}

bool yk_roll_within(YkSession *session, double *seconds)
{
    *seconds = 0;
    return (!session->request->all && !session->request->within) || leave(session);
}

bool yk_roll_solver(YkSession *session, YkGroupSolver *solver)
{
    *solver = YK_SOLVER_BOTH;
    return !session->request->solver || leave(session);
}

YkText yk_configuration_name(YkSession *session, const YkState *state)
{
    for (size_t k = 0; k < yk_block_count(session->mech); k++)
        if (yk_block_info(session->mech, k).kind == YK_BLOCK_GROUP) leave(session);
    return yk_label_of(state);
}

YkStatus yk_session_each(YkSession *session, YkState *state, bool (*visit)(void *, YkState *), void *context,
                         YkConfigurationsReport *report)
{
    (void)state;
    (void)visit;
    (void)context;
    if (report) *report = (YkConfigurationsReport){.block = -1};
    leave(session);
    return YK_STOPPED;
}

const YkContinuum *yk_session_continuum(const YkSession *session)
{
    (void)session;
    return NULL;
}

void yk_roll_end(YkSession *session)
{
    (void)session;
}
