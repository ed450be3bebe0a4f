// yoke solve: one pose, or every one that the inputs allow.
#include <string.h>
#include "session.h"
#include "solve.h"

// The writer that the format asks for, and what it writes of a configuration.
typedef struct Writer {
    YkSession *session;
    YkJson json;
    size_t count; // configurations written
    YkDynamics *dynamics;
    YkDynamicsMethod method;
} Writer;

// Forces at the pose; a pose without (a dead point, a freedom without inertia) says so and keeps its motion.
static void find_forces(Writer *writer, YkState *state)
{
    YkSession *session = writer->session;
    YkDynamics *dynamics = writer->dynamics;
    session->dynamics = NULL;
    if (!dynamics || !yk_state_has_rates(state)) return;
    YkStatus status = yk_dynamics_solve(dynamics, state, writer->method);
    if (status == YK_OK || status == YK_REDUNDANT) {
        session->dynamics = dynamics;
        return;
    }
    yk_tell_status(session, status, yk_dynamics_report(dynamics)->message);
}

static void write_one(Writer *writer, YkState *state)
{
    find_forces(writer, state);
    switch (writer->session->request->format) {
    case YK_FORMAT_TEXT:
        yk_solve_text(writer->session, state, writer->count);
        break;
    case YK_FORMAT_JSON:
        yk_solve_json(writer->session, &writer->json, state);
        break;
    case YK_FORMAT_CSV:
        yk_solve_csv(writer->session, state, writer->count);
        break;
    }
    writer->count++;
}

static bool visit(void *context, YkState *state)
{
    write_one(context, state);
    return true;
}

// Poses that stand get written; a failure leaves the list empty.
static YkStatus write_all(Writer *writer, YkStatus status, bool *is_complete)
{
    YkState *state = writer->session->state;
    if (status < 0) return status;
    if (!writer->session->request->all) {
        write_one(writer, state);
        return status;
    }
    YkStatus each = yk_state_each(state, visit, writer, is_complete);
    return each < 0 ? each : status;
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
    } else {
        yk_solve_csv_head(session);
    }
}

static void end(Writer *writer, bool is_complete)
{
    YkSession *session = writer->session;
    bool all = session->request->all;
    if (session->request->format == YK_FORMAT_JSON) {
        yk_json_end(&writer->json);
        if (all) yk_json_bool(&writer->json, "complete", is_complete);
        yk_json_end(&writer->json);
    } else if (session->request->format == YK_FORMAT_TEXT && all) {
        yk_text_format(&session->out, "\n%z configuration%s%s\n", writer->count, writer->count == 1 ? "" : "s",
                       is_complete ? "; there are no others"
                                   : "; there may be others: a larger group was searched, not enumerated");
    }
}

int yk_run_solve(YkSession *session)
{
    Writer writer = {.session = session, .json = {.text = &session->out}};
    if (!yk_session_method(session, &writer.method)) return YK_EXIT_WRONG;
    if (!yk_session_load(session, NULL) || !yk_session_inputs(session) || !yk_session_forces(session, false))
        return YK_EXIT_WRONG;
    writer.dynamics = session->dynamics;
    bool is_complete = true;
    YkStatus status = yk_state_assemble(session->state);
    const char *message = yk_state_report(session->state)->message;
    yk_tell_status(session, status, message);
    begin(&writer, status, message);
    status = write_all(&writer, status, &is_complete);
    end(&writer, is_complete);
    session->dynamics = writer.dynamics; // the session frees it
    return yk_session_finish(session, yk_status_exit(status));
}
