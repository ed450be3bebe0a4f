// Finds where the file's own design leaves the range of a law: other designs pass nearly the same poses.
#include "laws_left.h"
#include "model/model.h"
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

// Moves to a pose; returns whether it is there.
static bool go_to(const YkStudyAnswer *a, YkState *state, YkMotion *goal, size_t pose)
{
    if (a->times && yk_state_set_time(state, a->times[pose], NULL) < 0) return false;
    for (size_t i = 0; i < yk_input_count(a->session->mech); i++)
        goal[i] = (YkMotion){a->input_row[3 * i][pose], a->input_row[3 * i + 1][pose], a->input_row[3 * i + 2][pose]};
    return yk_state_move_to(state, goal, NULL, NULL) >= 0;
}

static double place_of(const YkStudyAnswer *a, const YkState *state)
{
    bool is_swept = a->over.name && !a->times;
    return is_swept ? yk_state_coordinate(state, (size_t)a->over.coordinate).position : yk_state_time(state);
}

void yk_study_warn_of_laws(YkStudyAnswer *a)
{
    YkSession *session = a->session;
    if (session->model->law_count == 0) return;
    YkLawWatch *watch = yk_session_watch_laws(session);
    YkState *state = yk_session_new_state(session, session->mech);
    YkMotion *goal = yk_session_alloc(session, yk_input_count(session->mech) + 1, sizeof *goal);
    bool good = watch && state && goal && yk_state_copy(state, a->timed) >= 0;
    if (good) yk_session_hold(session, state);
    for (size_t k = 0; good && k < a->pose_count && !yk_stop_is_asked(); k++)
        if (go_to(a, state, goal, k)) yk_law_watch_look(watch, state, session->dynamics, place_of(a, state));
    if (good) yk_warn_of_laws(session, watch, a->over.name, a->over.quantity, ", with the file's own values");
    yk_law_watch_free(watch);
    yk_state_free(state);
}
