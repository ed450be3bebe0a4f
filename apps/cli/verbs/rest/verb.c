// yoke rest: where the machine stands still under its loads, and how it vibrates there.
#include "reach.h"
#include "stop.h"
#include "verbs/rest/rest.h"

enum { STARTS_MAX = 100000 };

// Returns whether the search failed because the machine cannot be assembled: that is an answer, not an error in the
// file.
static bool has_no_assembly(const YkProblems *problems)
{
    for (size_t i = 0; i < yk_problems_count(problems); i++) {
        int code = yk_problems_get(problems, i)->code;
        if (code == YK_CODE_POSE_NO_ASSEMBLY || code == YK_CODE_POSE_LIMIT || code == YK_CODE_NO_SUCH_ASSEMBLY)
            return true;
    }
    return false;
}

static bool find(YkRestAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    YkRestOptions options = yk_default_rest_options();
    options.progress = yk_stop_progress(session);
    if (!yk_session_count(session, "--starts", request->starts, STARTS_MAX, options.starts, &options.starts))
        return false;
    if (request->time && !yk_session_value(session, "--time", "", request->time, YK_QUANTITY_TIME, &options.time))
        return false;
    if (request->assembly || request->time) { // another assembly, or the machine where its drives have brought it
        if (!yk_session_inputs(session)) return false;
        YkStatus status = yk_session_reach(session, NULL);
        if (status < 0) {
            yk_reach_tell(session, status);
            return false;
        }
        options.pose = session->state;
    }
    answer->rest = yk_rest_find(session->model, &options, session->problems);
    if (answer->rest) answer->mech = yk_rest_mechanism(answer->rest);
    if (answer->rest && yk_rest_reach(answer->rest) < 0) {
        yk_rest_free(answer->rest);
        answer->rest = NULL;
    }
    if (!answer->rest && yk_problems_error_count(session->problems) == 0) yk_session_refuse_for_memory(session);
    return answer->rest != NULL;
}

static void tell_none(YkSession *session)
{
    yk_problem(session->problems, YK_CODE_NO_REST, (YkPlace){0}, "no equilibrium was found");
    yk_problem_hint(session->problems, "`yoke simulate` shows where the loads take the machine");
}

static void write_answer(const YkRestAnswer *answer)
{
    switch (answer->session->request->format) {
    case YK_FORMAT_TEXT:
        yk_rest_text(answer);
        break;
    case YK_FORMAT_JSON:
        yk_rest_json(answer);
        break;
    case YK_FORMAT_CSV:
        yk_rest_csv(answer);
        break;
    }
}

int yk_run_rest(YkSession *session)
{
    YkRestAnswer answer = {.session = session};
    if (!yk_session_load(session, NULL)) return YK_EXIT_WRONG;
    if (!find(&answer)) return has_no_assembly(session->problems) ? YK_EXIT_NO_ANSWER : YK_EXIT_WRONG;
    bool has_some = yk_rest_count(answer.rest) > 0;
    if (!has_some) tell_none(session);
    int exit_code = YK_EXIT_WRONG;
    if (yk_rest_watch_laws(&answer)) {
        yk_warn_of_laws(session, answer.laws, "equilibrium", YK_QUANTITY_NUMBER, "");
        write_answer(&answer);
        exit_code = yk_session_finish(session, has_some ? YK_EXIT_DONE : YK_EXIT_NO_ANSWER);
    } else {
        yk_session_refuse_for_memory(session);
    }
    yk_law_watch_free(answer.laws);
    yk_rest_free(answer.rest);
    return exit_code;
}
