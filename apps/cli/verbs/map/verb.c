// yoke map: all circuits of the motion of a machine with one freedom.
#include "verbs/map/map.h"
#include <string.h>
#include "hand_out.h"
#include "reach.h"
#include "session.h"

// Refuses to map what --at holds. Both have made their coordinates inputs.
static bool is_left_free(YkSession *session, size_t mapped)
{
    for (size_t k = 0; k < session->hold_count; k++)
        if (session->holds[k].order == 0 && yk_input_coordinate(session->mech, session->holds[k].input) == mapped)
            return yk_session_refuse(session, YK_CODE_OPTION_REPEATED, "%q is mapped, so --at cannot hold it",
                                     yk_coordinate_info(session->mech, mapped).name);
    return true;
}

// --- the verb

static int write_answer(YkMapAnswer *answer)
{
    YkSession *session = answer->session;
    if (session->request->format == YK_FORMAT_JSON)
        yk_map_json(answer);
    else
        yk_map_text(answer);
    int exit_code = yk_session_finish(session, YK_EXIT_DONE);
    const char *plot = session->request->plot;
    if (plot && exit_code != YK_EXIT_WRONG && !yk_map_plot(answer, plot)) exit_code = YK_EXIT_WRONG;
    return exit_code;
}

static int answer_map(YkMapAnswer *answer, size_t coordinate)
{
    YkSession *session = answer->session;
    answer->map = yk_map_new(session->state, coordinate, session->problems);
    if (!answer->map) return yk_ran_out(session->problems) ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    if (yk_map_add_drives(answer->map, session->state, session->problems) < 0)
        return yk_ran_out(session->problems) ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    if (session->request->reach.count > 0) return yk_map_reach(answer);
    return yk_map_plan(answer) ? write_answer(answer) : YK_EXIT_WRONG;
}

static bool is_asked_well(YkSession *session)
{
    const YkRequest *request = session->request;
    if (request->format == YK_FORMAT_CSV)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--format takes text or json here, not %q", "csv");
    if (request->over && strchr(request->over, '='))
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE,
                                 "--over takes the name of a coordinate here, without a range: %q", request->over);
    if (!request->plot && request->trace.count > 0)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--trace draws %q, so it needs --plot FILE",
                                 request->trace.items[0]);
    if (!request->plot && request->of)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--of says what --plot FILE draws: %q", request->of);
    if (request->pose.count > 0 && request->reach.count == 0)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--pose %s needs --reach NAME=VALUE as well",
                                 request->pose.items[0].name);
    if (request->plot && request->reach.count > 0)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED, "--reach answers in words, without --plot %q",
                                 request->plot);
    return true;
}

// Maps two coordinates, "A,B".
static int run_over_two(YkSession *session, const char *over)
{
    YkText names[2] = {{0}, {0}};
    const char *comma = strchr(over, ',');
    yk_text_add(&names[0], over, (size_t)(comma - over));
    yk_text_puts(&names[1], comma + 1);
    int exit_code = names[0].failed || names[1].failed
                        ? YK_EXIT_WRONG
                        : yk_map_regions(session, yk_text_get(&names[0]), yk_text_get(&names[1]));
    if (names[0].failed || names[1].failed) yk_session_run_out(session);
    yk_text_free(&names[0]);
    yk_text_free(&names[1]);
    return exit_code;
}

static int refuse_ranks(YkSession *session)
{
    yk_session_refuse(session, YK_CODE_RANKS_VERB,
                      "mpirun started `yoke %s` over one freedom on several ranks, which it cannot use", "map");
    yk_problem_hint(session->problems, "start it without mpirun: only a map over two freedoms is shared among ranks");
    return YK_EXIT_WRONG;
}

static int answer(YkSession *session)
{
    const YkRequest *request = session->request;
    const char *over = request->over ? request->over : request->reach.count > 0 ? request->reach.items[0].name : NULL;
    size_t coordinate;
    if (!is_asked_well(session)) return YK_EXIT_WRONG;
    if (over && strchr(over, ',')) return run_over_two(session, over);
    if (!yk_session_load(session, over)) return YK_EXIT_WRONG;
    if (over && !yk_session_coordinate(session, over, &coordinate)) return YK_EXIT_WRONG;
    if (!yk_session_inputs(session)) return YK_EXIT_WRONG;
    if (!over && yk_map_free_inputs(session) == 2) return yk_map_regions(session, NULL, NULL);
    if (request->tolerance) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--tol %s is for a map over two coordinates",
                          request->tolerance);
        return YK_EXIT_WRONG;
    }
    if (!over) coordinate = yk_input_count(session->mech) > 0 ? yk_input_coordinate(session->mech, 0) : 0;
    for (size_t k = 0; !over && k < yk_input_count(session->mech); k++) { // the first that nothing holds
        bool is_held = false;
        for (size_t h = 0; h < session->hold_count; h++) is_held |= session->holds[h].input == k;
        if (is_held) continue;
        coordinate = yk_input_coordinate(session->mech, k);
        break;
    }
    if (!is_left_free(session, coordinate)) return YK_EXIT_WRONG;
    if (!yk_map_has_freedoms(session, 1)) return YK_EXIT_NO_ANSWER;
    if (yk_ranks()) return refuse_ranks(session);
    YkCoordinateInfo info = yk_coordinate_info(session->mech, coordinate);
    if (info.input < 0) {
        yk_session_refuse(session, YK_CODE_NOT_AN_INPUT, "no freedom is left to move %q", info.name);
        return YK_EXIT_WRONG;
    }
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return yk_status_exit(status);
    }
    YkMapAnswer answer = {.session = session, .name = info.name, .quantity = yk_quantity_of(info.is_distance, 0)};
    int exit_code = answer_map(&answer, coordinate);
    yk_map_free(answer.map);
    return exit_code;
}

// Answers on all ranks: those other than 0 serve, as soon as they have read the machine.
static int answer_on_ranks(YkSession *session)
{
    const YkHandOutOptions nothing = {.session = session};
    if (!yk_ranks_begin(session)) {
        if (yk_ranks_is_first_here()) yk_ranks_speak(); // a computer reports once what it lacks
        return YK_EXIT_WRONG;
    }
    int exit_code = answer(session);
    if (yk_ranks_rank() == 0)
        yk_spread_dismiss();
    else if (yk_ranks()) // it did not get so far
        yk_hand_out_serve(&nothing, false);
    return yk_ranks_rank() == 0 ? exit_code : YK_EXIT_DONE;
}

int yk_run_map(YkSession *session)
{
    return yk_ranks_count() > 1 ? answer_on_ranks(session) : answer(session);
}
