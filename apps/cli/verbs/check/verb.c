// yoke check: what machine the file describes.
#include <stdlib.h>
#include "reach.h"
#include "verbs/check/check.h"

// Tries to assemble the machine at the start. The answer does not depend on it, the exit code does.
static YkStatus try_assembly(YkCheckAnswer *answer)
{
    YkStatus status = yk_session_reach(answer->session, NULL);
    answer->message = yk_reach_message(answer->session);
    return status;
}

static void write_answer(const YkCheckAnswer *answer)
{
    switch (answer->session->request->format) {
    case YK_FORMAT_TEXT:
        yk_check_text(answer);
        break;
    case YK_FORMAT_JSON:
        yk_check_json(answer);
        break;
    case YK_FORMAT_CSV:
        yk_check_csv(answer);
        break;
    }
}

// Finds masses and loads, and the number of equations that they lead to. Returns false when out of memory.
static bool look_at_loads(YkCheckAnswer *answer)
{
    YkSession *session = answer->session;
    YkDynamics *dynamics = yk_dynamics_new(session->mech, session->problems);
    if (!dynamics) return false;
    answer->loads = yk_model_loads(session->model);
    answer->has_loads = yk_dynamics_has_loads(dynamics);
    if (answer->has_loads) answer->equations = yk_dynamics_count(dynamics);
    yk_dynamics_free(dynamics);
    if (answer->equations.ran_out) yk_session_run_out(session);
    return !answer->equations.ran_out;
}

static int answer_check(YkCheckAnswer *answer)
{
    YkSession *session = answer->session;
    size_t found = yk_four_bars(session->mech, answer->four_bars, YK_FOUR_BARS_MAX);
    if (found == YK_NOT_FOUND) yk_session_run_out(session);
    if (found == YK_NOT_FOUND) return YK_EXIT_WRONG;
    answer->four_bar_count = found < YK_FOUR_BARS_MAX ? found : YK_FOUR_BARS_MAX;
    if (!look_at_loads(answer)) return YK_EXIT_WRONG;
    answer->status = try_assembly(answer);
    yk_tell_status(session, answer->status, answer->message);
    write_answer(answer);
    return yk_session_finish(session, yk_status_exit(answer->status));
}

int yk_run_check(YkSession *session)
{
    if (session->request->sketch) return yk_check_sketch(session);
    if (!yk_session_load(session, NULL) || !yk_session_inputs(session)) return YK_EXIT_WRONG;
    YkCheckAnswer *answer = calloc(1, sizeof *answer);
    size_t *bodies = yk_session_alloc(session, yk_model_body_count(session->model) + 1, sizeof *bodies);
    int exit_code = YK_EXIT_WRONG;
    if (answer && bodies) {
        answer->session = session;
        answer->bodies = bodies;
        exit_code = answer_check(answer);
    } else {
        yk_session_refuse_for_memory(session);
    }
    free(answer);
    return exit_code;
}
