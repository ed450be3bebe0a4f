// yoke derive: the machine's equations in symbols, and verdicts on equations of others.
#include <string.h>
#include "base/names.h"
#include "reach.h"
#include "stop.h"
#include "verbs/derive/derive.h"
#include "write/stream.h"

enum { SECTIONS_MAX = 32 };

// YK_NOT_FOUND if there is none of this name.
static size_t find_section(const char *name, size_t length)
{
    for (size_t k = 0; k < yk_derivation_section_count(); k++) {
        const char *own = yk_derivation_section_name(k);
        if (strlen(own) == length && strncmp(own, name, length) == 0) return k;
    }
    return YK_NOT_FOUND;
}

static bool refuse_section(YkSession *session, const char *word, size_t length)
{
    YkText text = {0};
    const char *names[SECTIONS_MAX];
    size_t count = yk_derivation_section_count();
    yk_text_add(&text, word, length);
    yk_problem(session->problems, YK_CODE_OPTION_VALUE, (YkPlace){0}, "--what has no part %q", yk_text_get(&text));
    for (size_t k = 0; k < count; k++) names[k] = yk_derivation_section_name(k);
    const char *near = yk_nearest(yk_text_get(&text), names, count);
    yk_text_clear(&text);
    for (size_t k = 0; k < count; k++) yk_text_format(&text, "%s, ", names[k]);
    if (near)
        yk_problem_hint(session->problems, "did you mean `%s`?", near);
    else
        yk_problem_hint(session->problems, "%sall", yk_text_get(&text));
    yk_text_free(&text);
    return false;
}

// Reads "loops,jacobian" or "all" into wanted[section]. Without the option: all that the machine has.
static bool read_what(YkSession *session, const YkDerivation *derivation, bool *wanted)
{
    const char *word = session->request->what;
    if (!word || strcmp(word, "all") == 0) {
        for (size_t k = 0; k < yk_derivation_section_count(); k++) wanted[k] = yk_derivation_has_section(derivation, k);
        return true;
    }
    while (*word) {
        size_t length = strcspn(word, ","), k = find_section(word, length);
        if (k == YK_NOT_FOUND) return refuse_section(session, word, length);
        wanted[k] = true;
        word += length + (word[length] == ',');
    }
    return true;
}

static bool read_format(YkSession *session, YkPageFormat *format)
{
    const char *word = session->request->format_word;
    *format = word ? yk_page_format_find(word) : YK_PAGE_TEXT;
    if (*format < YK_PAGE_FORMATS) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE,
                             "--format takes text, latex, mathml, json or c here, not %q", word);
}

// Assembles at the inputs and solves the forces too: verdicts and values need both, pictures only the pose. Returns an
// exit code; what went wrong is reported.
static int find_pose(YkSession *session, bool *has_forces)
{
    const YkRequest *request = session->request;
    if (!yk_session_inputs(session) || !yk_session_forces(session, false)) return YK_EXIT_WRONG;
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return yk_status_exit(status);
    }
    const char *message = yk_state_report(session->state)->message;
    if (session->dynamics) {
        status = yk_dynamics_solve(session->dynamics, session->state, YK_METHOD_REDUCED);
        if (status < 0) message = yk_dynamics_report(session->dynamics)->message;
    }
    *has_forces = session->dynamics && (status == YK_OK || status == YK_REDUNDANT);
    bool only_draws = !request->numbers && request->checks.count == 0;
    if (only_draws && status < 0 && status != YK_NO_MEMORY) return YK_EXIT_DONE;
    yk_tell_status(session, status, message);
    return yk_status_exit(status);
}

// The page as it comes. A short one stays in session->out; the contents of a longer one are passed on at once, so that
// a large machine needs no memory for the whole. A file appears whole or not at all.
typedef struct Output {
    YkSession *session;
    YkStream stream;
} Output;

static bool flush(Output *output)
{
    YkText *out = &output->session->out;
    bool good = !out->failed || yk_session_refuse_for_memory(output->session);
    if (good && !output->stream.is_open)
        good = yk_stream_open(&output->stream, output->session->request->output, output->session->problems);
    good = good && yk_stream_write(&output->stream, yk_text_get(out), out->length, output->session->problems);
    yk_text_clear(out);
    return good;
}

static bool take(void *context, const char *text, size_t length)
{
    Output *output = context;
    bool good = output->session->out.length == 0 || flush(output);
    yk_text_add(&output->session->out, text, length);
    return good;
}

static int finish_page(Output *output, YkStatus status)
{
    YkSession *session = output->session;
    if (status < 0) {
        yk_stream_drop(&output->stream);
        session->ran_out |= status == YK_NO_MEMORY;
        return status == YK_BAD_MODEL ? YK_EXIT_NO_ANSWER : YK_EXIT_WRONG;
    }
    if (!output->stream.is_open) return yk_session_finish(session, YK_EXIT_DONE);
    if (!flush(output)) {
        yk_stream_drop(&output->stream);
        return YK_EXIT_WRONG;
    }
    return yk_stream_close(&output->stream, session->problems) ? YK_EXIT_DONE : YK_EXIT_WRONG;
}

static int write_page(YkSession *session, YkDerivation *derivation, YkPageFormat format, const bool *wanted)
{
    Output output = {.session = session};
    YkPageOptions options = yk_default_page_options();
    options.format = format;
    options.sections = wanted;
    options.write = take;
    options.context = &output;
    if (session->request->numbers) {
        options.state = session->state;
        options.dynamics = session->dynamics;
    }
    return finish_page(&output, yk_derivation_page(derivation, &options, session->problems));
}

static int derive(YkSession *session, YkDerivation *derivation, YkPageFormat format)
{
    const YkRequest *request = session->request;
    bool wanted[SECTIONS_MAX] = {false}, checks = request->checks.count > 0, has_forces = false;
    if (!checks && !read_what(session, derivation, wanted)) return YK_EXIT_WRONG;
    int exit_code = YK_EXIT_DONE;
    if (checks || request->svg || request->numbers) exit_code = find_pose(session, &has_forces);
    if (exit_code == YK_EXIT_DONE && checks) return yk_derive_checks(session, derivation, format == YK_PAGE_JSON);
    if (exit_code == YK_EXIT_DONE && request->svg) exit_code = yk_derive_drawings(session, derivation, has_forces);
    return exit_code == YK_EXIT_DONE ? write_page(session, derivation, format, wanted) : exit_code;
}

int yk_run_derive(YkSession *session)
{
    YkPageFormat format;
    if (!read_format(session, &format) || !yk_session_load(session, NULL)) return YK_EXIT_WRONG;
    YkDerivation *derivation = yk_derivation_new(session->model, session->mech, session->problems);
    if (derivation) yk_derivation_set_progress(derivation, yk_stop_progress(session));
    int exit_code = derivation ? derive(session, derivation, format) : YK_EXIT_NO_ANSWER;
    yk_derivation_free(derivation);
    return exit_code;
}
