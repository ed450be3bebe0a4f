// Things that a run keeps in memory, and whether memory ran out.
#include "session.h"

void yk_session_run_out(YkSession *session)
{
    session->ran_out = true;
}

void *yk_session_alloc(const YkSession *session, size_t count, size_t size)
{
    return yk_arena_alloc(session->request->arena, count, size);
}

const YkMotion *yk_session_bodies(YkSession *session, const YkState *state)
{
    if (!session->bodies)
        session->bodies = yk_session_alloc(session, yk_model_body_count(session->model), sizeof *session->bodies);
    if (session->bodies)
        yk_state_bodies(state, session->bodies);
    else
        yk_session_run_out(session);
    return session->bodies;
}

bool yk_ran_out(const YkProblems *problems)
{
    return !problems || yk_problems_count(problems) == 0 || yk_problems_ran_out(problems);
}
