// yoke code: C for this machine.
#include <string.h>
#include "answer.h"
#include "reach.h"
#include "stop.h"
#include "write/json.h"

// Returns whether the text can begin a C name and is not a word of C.
static bool is_prefix(const char *text)
{
    size_t length = strlen(text);
    if (length == 0 || length > 60) return false;
    for (const char *c = text; *c; c++) {
        bool is_letter = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || *c == '_';
        if (!is_letter && (c == text || *c < '0' || *c > '9')) return false;
    }
    return text[0] != '_';
}

static void write_json(YkSession *session, const YkCSource *code)
{
    YkJson json = {.text = &session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(session->model));
    yk_json_string(&json, "status", "ok");
    yk_json_string(&json, "language", "C11");
    yk_json_string(&json, "prefix", yk_c_source_prefix(code));
    yk_json_string(&json, "code", yk_c_source_text(code));
    yk_json_end(&json);
}

// With other parameters the machine keeps the configuration that the file has at its own.
static bool find_start(YkSession *session, YkState **start)
{
    YkStatus status = YK_NO_MEMORY;
    *start = yk_reach_start(session, &status);
    if (*start && status >= 0) return true;
    yk_tell_status(session, status, *start ? yk_state_report(*start)->message : "");
    yk_state_free(*start);
    return false;
}

int yk_run_code(YkSession *session)
{
    const YkRequest *request = session->request;
    YkCSourceOptions options = yk_default_c_source_options();
    options.progress = yk_stop_progress(session);
    options.prefix = request->prefix;
    options.single = request->single;
    options.kinematics = request->kinematics;
    if (request->prefix && !is_prefix(request->prefix)) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--prefix takes a C name that begins with a letter, not %q",
                          request->prefix);
        return YK_EXIT_WRONG;
    }
    if (request->format == YK_FORMAT_CSV) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--format takes text or json here, not %q", "csv");
        return YK_EXIT_WRONG;
    }
    if (!yk_session_load(session, NULL)) return YK_EXIT_WRONG; // problems of the machine are reported as usual
    YkState *start = NULL;
    if (request->param.count > 0 && !find_start(session, &start)) return YK_EXIT_NO_ANSWER;
    options.pose = start;
    YkCSource *code = yk_c_source_new(session->model, &options, session->problems);
    yk_state_free(start);
    if (!code) return YK_EXIT_NO_ANSWER;
    if (request->format == YK_FORMAT_JSON)
        write_json(session, code);
    else
        yk_text_puts(&session->out, yk_c_source_text(code));
    yk_c_source_free(code);
    return yk_session_finish(session, YK_EXIT_DONE);
}
