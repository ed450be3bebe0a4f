// yoke solve: one pose, or every one that the inputs allow.
#include <math.h>
#include "certify.h"
#include "columns.h"
#include "laws_left.h"
#include "reach.h"
#include "roll.h"
#include "stop.h"
#include "stops_passed.h"
#include "verbs/solve/solve.h"

// The writer for the format, and what it writes for a configuration.
typedef struct Writer {
    YkSession *session;
    YkJson json;
    size_t count; // configurations written
    YkDynamics *dynamics;
    YkMethod method;
    YkState *scratch;
    YkLawWatch *laws; // that a configuration has left
    YkStopWatch *stops;
    YkState *own; // --all: the machine's own pose; NULL if it does not get there
} Writer;

// Returns whether the machine has inputs whose accelerations are sought.
static bool has_free_inputs(const YkSession *session, const YkDynamics *dynamics)
{
    for (size_t i = 0; i < yk_input_count(session->mech); i++)
        if (!yk_dynamics_is_prescribed(dynamics, i)) return true;
    return false;
}

YkStatus yk_solve_forces(YkSession *session, YkDynamics *dynamics, YkMethod method, YkState *state)
{
    session->dynamics = NULL;
    session->forces_message = NULL;
    session->lacks_accelerations = false;
    if (!dynamics || !yk_state_has_rates(state)) return YK_OK;
    YkStatus status = yk_dynamics_solve(dynamics, state, method);
    if (status == YK_OK || status == YK_REDUNDANT) {
        session->dynamics = dynamics;
        return YK_OK;
    }
    session->forces_message = yk_dynamics_report(dynamics)->message;
    session->lacks_accelerations = has_free_inputs(session, dynamics);
    return status;
}

static void write_one(Writer *writer, const YkState *state)
{
    yk_law_watch_look(writer->laws, state, writer->dynamics, yk_state_time(state));
    yk_stop_watch_look(writer->stops, state, 0);
    switch (writer->session->request->format) {
    case YK_FORMAT_TEXT:
        yk_solve_text(writer->session, state, writer->count);
        break;
    case YK_FORMAT_JSON:
        yk_solve_json(writer->session, &writer->json, state);
        break;
    case YK_FORMAT_CSV:
        if (writer->session->columns) {
            yk_solve_of_csv(writer->session, state);
        } else {
            yk_solve_csv(writer->session, state, writer->count);
        }
        break;
    }
    writer->count++;
}

// Writes one of several configurations. Its forces are found in another state, since the search continues from this
// one.
static bool visit(void *context, YkState *state)
{
    Writer *writer = context;
    YkSession *session = writer->session;
    yk_state_copy(writer->scratch, state);
    session->is_start = writer->own && yk_state_is_at(writer->own, state);
    session->is_chosen = !session->is_start;
    yk_note_status(session, yk_solve_forces(session, writer->dynamics, writer->method, writer->scratch));
    write_one(writer, writer->scratch);
    return true;
}

// Writes the valid poses; a failure leaves the list empty.
static YkStatus write_all(Writer *writer, YkStatus status, YkConfigurationsReport *report)
{
    YkSession *session = writer->session;
    if (!session->request->all) {
        if (status >= 0) write_one(writer, session->state);
        return status;
    }
    if (status >= 0 && session->is_start) {
        writer->own = session->state;
        session->state = NULL;
    }
    session->keeps_what_is_done = !yk_stop_is_asked();
    YkStatus each =
        yk_reach_ask(session) < 0 ? YK_NO_MEMORY : yk_session_each(session, session->state, visit, writer, report);
    yk_note_status(session, each);
    yk_state_free(writer->own);
    return each;
}

static void begin(Writer *writer, YkStatus status, const char *message)
{
    YkSession *session = writer->session;
    if (session->request->format == YK_FORMAT_JSON) {
        yk_json_object(&writer->json, NULL, YK_JSON_LINES);
        yk_json_head(&writer->json, session, status, message);
        yk_json_list(&writer->json, "configurations", YK_JSON_LINES);
    } else if (session->request->format == YK_FORMAT_TEXT) {
        yk_solve_text_head(session, status);
    } else if (session->columns) {
        yk_solve_of_csv_head(session);
    } else {
        yk_solve_csv_head(session);
    }
}

// Writes whether there are others, and why.
static void write_report(Writer *writer, const YkConfigurationsReport *report)
{
    YkJson *json = &writer->json;
    bool is_known = report->reason != YK_INCOMPLETE;
    yk_json_bool(json, "complete", report->complete);
    yk_json_string(json, "reason", is_known ? yk_complete_reason_name(report->reason) : NULL);
    if (report->count > writer->count) yk_json_number(json, "count", (double)report->count);
    yk_json_string(json, "because", report->message);
    if (report->continua > 0) yk_json_number(json, "continua", (double)report->continua);
    if (report->block < 0 || (report->expected == 0 && report->reason == YK_COMPLETE_BY_EXCLUSION)) return;
    yk_json_object(json, "complex", YK_JSON_INLINE);
    yk_json_number(json, "proved", (double)report->proved);
    yk_json_number(json, "counted", report->expected > 0 || is_known ? (double)report->expected : (double)NAN);
    yk_json_end(json);
}

static void end(Writer *writer, const YkConfigurationsReport *report)
{
    YkSession *session = writer->session;
    bool all = session->request->all;
    if (session->request->format == YK_FORMAT_JSON) {
        yk_json_end(&writer->json);
        if (all) write_report(writer, report);
        yk_certify_json(session, &writer->json);
        yk_add_laws_json(&writer->json, writer->laws, false);
        yk_add_stops_json(&writer->json, writer->stops, false);
        yk_json_end(&writer->json);
    } else if (session->request->format == YK_FORMAT_TEXT && all) {
        bool is_told = report->reason != YK_COMPLETE_BY_CLOSED_FORM;
        yk_text_format(&session->out, "\n%z configuration%s; ", report->count, report->count == 1 ? "" : "s");
        if (report->count > writer->count) yk_text_format(&session->out, "the first %z are shown; ", writer->count);
        yk_text_format(&session->out, "there %s%s%s\n",
                       report->complete       ? "are no others"
                       : report->continua > 0 ? "are others"
                                              : "may be others",
                       is_told ? ": " : "", is_told ? report->message : "");
    }
    if (session->request->format == YK_FORMAT_TEXT) yk_certify_text(session, "\n", &session->out);
}

static int solve(Writer *writer)
{
    YkSession *session = writer->session;
    YkConfigurationsReport all = {.block = -1};
    YkStatus pose = yk_session_reach(session, NULL);
    YkReport report = *yk_state_report(session->state);
    YkStatus forces = pose < 0 ? YK_OK : yk_solve_forces(session, writer->dynamics, writer->method, session->state);
    YkStatus status = forces == YK_OK ? pose : forces; // of the machine's own configuration
    yk_note_status(session, pose);
    yk_note_status(session, forces);
    const char *message = pose < 0          ? yk_reach_message(session)
                          : forces == YK_OK ? report.message
                                            : session->forces_message;
    if (pose < 0 && session->request->all && yk_reach_count(session) > 0) {
        yk_problem(session->problems, YK_CODE_NONE_IS_OWN, (YkPlace){0},
                   "none of these is the machine's own configuration, which cannot get here: %s", message);
        status = YK_OK;
        message = "";
    } else if (pose < 0) {
        yk_reach_tell(session, pose);
    } else {
        yk_tell_status(session, status, message);
        yk_certify_warn(session);
    }
    begin(writer, status, message);
    if (session->dynamics) yk_warn_of_pulling_cams(session, session->dynamics);
    yk_solve_of_warn(session);
    YkStatus written = write_all(writer, pose, &all);
    end(writer, &all);
    yk_warn_of_laws(session, writer->laws, NULL, YK_QUANTITY_TIME, "");
    yk_warn_of_stops(writer->stops, NULL, YK_QUANTITY_TIME);
    int exit_code = yk_status_exit(status < 0 ? status : written);
    if (exit_code == YK_EXIT_DONE && yk_lacks_construction(session)) exit_code = YK_EXIT_NO_ANSWER;
    exit_code = yk_session_finish(session, exit_code);
    if (session->request->all) yk_stop_is_due(); // what was found is written, and main says that it was stopped
    return exit_code;
}

// Reads --of; forces among the columns need a machine that has some.
static bool read_columns(YkSession *session, YkAnswerColumns *columns)
{
    if (!session->request->of) return true;
    if (!yk_columns_read(session, columns)) return false;
    session->columns = columns;
    return !yk_columns_need_forces(columns) || yk_session_has_forces(session);
}

int yk_run_solve(YkSession *session)
{
    YkAnswerColumns columns = {0};
    Writer writer = {.session = session, .json = {.text = &session->out}};
    if (!yk_session_method(session, &writer.method)) return YK_EXIT_WRONG;
    if (!yk_session_load(session, NULL) || !yk_session_inputs(session) || !yk_certify_begin(session) ||
        !yk_session_forces(session, false))
        return YK_EXIT_WRONG;
    double seconds;
    YkGroupSolver solver;
    bool good =
        yk_roll_within(session, &seconds) && yk_roll_solver(session, &solver) && read_columns(session, &columns);
    if (session->request->centers && session->request->format == YK_FORMAT_CSV)
        good = yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--centers are written as text or json, not %q", "csv");
    YkPolygonKind kind;
    good = good && yk_polygon_read(session, &kind);
    good = good && (!yk_wants_force_polygons(session) || yk_session_has_forces(session));
    if (good && session->request->polygon && session->request->format == YK_FORMAT_CSV)
        good = yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--polygon is written as text or json, not %q", "csv");
    writer.dynamics = session->dynamics;
    writer.scratch = yk_session_new_state(session, session->mech);
    writer.laws = yk_session_watch_laws(session);
    writer.stops = yk_session_watch_stops(session);
    int exit_code = YK_EXIT_WRONG;
    if (good && writer.scratch && writer.laws && writer.stops) {
        exit_code = solve(&writer);
    } else if (good) {
        yk_session_refuse_for_memory(session);
    }
    yk_state_free(writer.scratch);
    yk_law_watch_free(writer.laws);
    yk_stop_watch_free(writer.stops);
    session->columns = NULL;
    yk_columns_free(&columns);
    session->dynamics = writer.dynamics; // the session frees it
    return exit_code;
}
