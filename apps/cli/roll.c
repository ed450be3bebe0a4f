// Enumerates and names the configurations at the requested pose, for as long as --within allows.
#include "roll.h"
#include <stdlib.h>
#include <string.h>
#include "answer.h"
#include "reach.h"
#include "stop.h"

static bool is_within(void *context, double part)
{
    const struct YkRolls *rolls = context;
    (void)part;
    return (rolls->deadline == 0 || yk_stop_now() < rolls->deadline) && !yk_stop_is_asked();
}

bool yk_roll_within(YkSession *session, double *seconds)
{
    const char *within = session->request->within;
    *seconds = 0;
    if (!within) return true;
    if (!session->request->all)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--within %s needs --all", within);
    if (!yk_session_value(session, "--within", "", within, YK_QUANTITY_TIME, seconds)) return false;
    if (*seconds > 0) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--within %s: a time above 0 is needed", within);
}

bool yk_roll_solver(YkSession *session, YkGroupSolver *solver)
{
    const char *word = session->request->solver;
    *solver = YK_SOLVER_BOTH;
    if (!word) return true;
    if (!session->request->all)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--solver %s needs --all", word);
    if (strcmp(word, "paths") == 0) *solver = YK_SOLVER_PATHS;
    if (strcmp(word, "elimination") == 0) *solver = YK_SOLVER_ELIMINATION;
    if (*solver != YK_SOLVER_BOTH || strcmp(word, "both") == 0) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--solver takes elimination, paths or both, not %q", word);
}

static bool make_rolls(YkSession *session)
{
    if (session->rolls) return true;
    session->rolls = calloc(1, sizeof *session->rolls);
    if (session->rolls) session->rolls->configurations = yk_configurations_new(session->mech);
    if (!session->rolls || !session->rolls->configurations) {
        yk_roll_end(session);
        yk_session_run_out(session);
        return false;
    }
    double seconds;
    if (yk_roll_within(session, &seconds) && seconds > 0) session->rolls->deadline = yk_stop_now() + seconds;
    return true;
}

static YkConfigurationsOptions options_of(YkSession *session)
{
    YkConfigurationsOptions options = yk_default_configurations_options();
    options.in_search_order = options.with_names = true;
    yk_roll_solver(session, &options.solver);
    if (session->rolls->deadline > 0 || session->keeps_what_is_done)
        options.enough = (YkProgress){is_within, session->rolls};
    return options;
}

YkText yk_configuration_name(YkSession *session, const YkState *state)
{
    YkText text = {0};
    const char *name;
    if (!make_rolls(session)) return yk_label_of(state);
    YkConfigurationsOptions options = options_of(session);
    YkStatus status = yk_configurations_name(session->rolls->configurations, state, &options, &name);
    if (status == YK_NO_MEMORY) yk_session_run_out(session);
    if (status < 0) return yk_label_of(state);
    yk_text_puts(&text, name);
    return text;
}

YkStatus yk_session_each(YkSession *session, YkState *state, bool (*visit)(void *, YkState *), void *context,
                         YkConfigurationsReport *report)
{
    if (report) *report = (YkConfigurationsReport){.block = -1};
    if (!make_rolls(session)) return YK_NO_MEMORY;
    YkConfigurationsOptions options = options_of(session);
    // If what is done so far is kept, Ctrl-C ends the solving of groups, not the whole call.
    if (session->keeps_what_is_done) yk_state_set_progress(state, (YkProgress){0});
    YkStatus status = yk_configurations_each(session->rolls->configurations, state, &options, visit, context, report);
    if (session->keeps_what_is_done) yk_state_set_progress(state, yk_stop_progress(session));
    if (status == YK_NO_MEMORY) yk_session_run_out(session);
    return status;
}

const YkContinuum *yk_session_continuum(const YkSession *session)
{
    return session->rolls ? yk_configurations_continuum(session->rolls->configurations) : NULL;
}
