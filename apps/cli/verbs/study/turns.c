// A study moves straight from pose to pose, and so misses that a drive which turns back just at a limit between two
// poses takes the machine through a dead point. Designs then follow their drives in time.
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

// Returns what keeps a study from following the drives from t = 0; NULL if nothing does.
static const char *hindrance(const YkSession *session)
{
    if (session->request->sensitivities) return "`--sensitivities`";
    if (session->request->assembly) return "a study with `--assembly`";
    return session->hold_count > 0 ? "a study whose inputs are set or held" : NULL;
}

static bool refuse(YkSession *session, YkEvent event)
{
    yk_problem(
        session->problems, YK_CODE_STUDY_TURNS, (YkPlace){0},
        "a drive turns back at t = %e s, just where joint %q is at its limit: the machine goes on through its dead "
        "point there, and %s cannot follow it",
        event.at, yk_block_info(session->mech, (size_t)event.block).label, hindrance(session));
    yk_problem_hint(session->problems, "`yoke sweep --over t` does, with `--param` for each design");
    return false;
}

// Follows the motion of the file's design in time, and looks for such a place. Returns false, with a problem, where the
// study cannot follow, or when out of memory.
static bool follow(YkStudyAnswer *answer, YkState *state, double from, double to)
{
    YkSession *session = answer->session;
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = -1;
    options.from = from, options.to = to, options.steps = 1;
    if (from == to) return true;
    YkProblems *quiet = yk_problems_new(); // the study reports whatever else is wrong
    YkSweep *sweep = quiet ? yk_sweep_run(state, &options, NULL, 0, quiet) : NULL;
    bool ran_out = !sweep && (!quiet || yk_problems_error_count(quiet) == 0);
    bool good = !ran_out || yk_session_refuse_for_memory(session);
    yk_problems_free(quiet);
    for (size_t k = 0; sweep && good && k < yk_sweep_event_count(sweep); k++) {
        YkEvent event = yk_sweep_event(sweep, k);
        if (!event.is_turned) continue;
        answer->follows_time = true;
        good = !hindrance(session) || refuse(session, event);
    }
    yk_sweep_free(sweep);
    return good;
}

bool yk_study_check_turns(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    bool is_over_time = answer->over.name && answer->over.coordinate < 0;
    double from = is_over_time ? answer->over.from : session->time;
    if (from == 0 && !is_over_time) return true; // where it was put together
    YkState *state = yk_session_new_state(session, session->mech);
    if (!state) return yk_session_refuse_for_memory(session);
    bool good = true, stands = yk_state_set_time(state, 0, NULL) >= 0 && yk_state_assemble(state) >= 0;
    if (stands) good = follow(answer, state, 0, from);
    if (stands && good && is_over_time) good = follow(answer, state, from, answer->over.to);
    yk_state_free(state);
    return good;
}
