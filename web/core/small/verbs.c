// The verbs that panels.wasm leaves to yoke.wasm. The page asks the right module (worker.ts), so that nobody reads
// this.
#include <stdio.h>
#include "cli.h"
#include "session.h"

static int leave(YkSession *session)
{
    fputs("yoke: error: this module does not have the verb; yoke.wasm has\n", stderr);
    session->has_told_error = true;
    return YK_EXIT_WRONG;
}

int yk_run_new(YkSession *session)
{
    return leave(session);
}

int yk_run_study(YkSession *session)
{
    return leave(session);
}

int yk_run_report(YkSession *session)
{
    return leave(session);
}

int yk_run_code(YkSession *session)
{
    return leave(session);
}

int yk_run_studio(YkSession *session)
{
    return leave(session);
}

int yk_run_synthesize(YkSession *session)
{
    return leave(session);
}

int yk_run_map(YkSession *session)
{
    return leave(session);
}

int yk_run_cognates(YkSession *session)
{
    return leave(session);
}

int yk_run_balance(YkSession *session)
{
    return leave(session);
}

int yk_run_explain(YkSession *session)
{
    return leave(session);
}

int yk_run_rest(YkSession *session)
{
    return leave(session);
}
