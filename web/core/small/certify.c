// Motions of groups are proved in yoke.wasm alone: panels.wasm answers for machines of dyads, which need no proof, and
// leaves it the others. The page asks it again (worker.ts).
#include "certify.h"
#include <stdio.h>

bool yk_certify_begin(YkSession *session)
{
    bool has_groups = false;
    for (size_t k = 0; k < yk_block_count(session->mech); k++)
        has_groups |= yk_block_info(session->mech, k).kind == YK_BLOCK_GROUP;
    if (!has_groups || session->request->trust) return true;
    fputs("yoke: error: this module does not prove motions; yoke.wasm does\n", stderr);
    session->has_told_error = true;
    return false;
}

void yk_certify_end(YkSession *session)
{
    (void)session;
}

void yk_certify_watch(YkSession *session)
{
    (void)session;
}

void yk_certify_state(YkSession *session, YkState *state)
{
    (void)session;
    (void)state;
}

void yk_certify_simulation(YkSession *session, YkSimulation *simulation)
{
    (void)session;
    (void)simulation;
}

void yk_certify_warn(YkSession *session)
{
    (void)session;
}

void yk_certify_json(const YkSession *session, YkJson *json)
{
    if (session->request->trust)
        yk_json_null(json, "certified");
    else
        yk_json_bool(json, "certified", true);
}

void yk_certify_text(const YkSession *session, const char *before, YkText *text)
{
    (void)session;
    (void)before;
    (void)text;
}
