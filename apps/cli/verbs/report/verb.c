// yoke report: everything about a machine on one page.
#include <string.h>
#include "answer.h"
#include "certify.h"
#include "range.h"
#include "reach.h"
#include "write/pdf.h"

enum { STEPS_MAX = 2000 };

typedef struct Reporter {
    YkSession *session;
    YkReportOptions options;
    YkCompileOptions compile;
    const char **inputs; // of --over and --at
    YkOver over;
    size_t *points; // of --trace
    bool as_pdf;
} Reporter;

static bool refuse(Reporter *reporter, YkCode code, const char *format, const char *word)
{
    return yk_session_refuse(reporter->session, code, format, word);
}

static bool ends_with(const char *path, const char *ending)
{
    size_t n = strlen(path), m = strlen(ending);
    return n >= m && strcmp(path + n - m, ending) == 0;
}

// Reads --format html|pdf, or the file's ending.
static bool read_format(Reporter *reporter)
{
    const YkRequest *request = reporter->session->request;
    const char *word = request->format_word, *path = request->output;
    if (word && strcmp(word, "html") != 0 && strcmp(word, "pdf") != 0)
        return refuse(reporter, YK_CODE_OPTION_VALUE, "--format takes html or pdf here, not %q", word);
    reporter->as_pdf = word ? strcmp(word, "pdf") == 0 : path && ends_with(path, ".pdf");
    return true;
}

static bool find_points(Reporter *reporter)
{
    YkSession *session = reporter->session;
    const YkWords *trace = &session->request->trace;
    reporter->points = yk_session_alloc(reporter->session, trace->count + 1, sizeof *reporter->points);
    if (!reporter->points) return yk_session_refuse_for_memory(reporter->session);
    return yk_session_points(session, trace, reporter->points);
}

// Keeps the options with which the machine was compiled, so that a simulation compiles it alike.
static bool keep_inputs(Reporter *reporter, const char *swept)
{
    const YkAssignments *at = &reporter->session->request->at;
    reporter->inputs = yk_session_alloc(reporter->session, at->count + 1, sizeof *reporter->inputs);
    if (!reporter->inputs) return yk_session_refuse_for_memory(reporter->session);
    reporter->compile = yk_default_compile_options();
    if (swept) reporter->inputs[reporter->compile.input_count++] = swept;
    for (size_t i = 0; i < at->count; i++)
        if (!swept || strcmp(swept, at->items[i].name) != 0)
            reporter->inputs[reporter->compile.input_count++] = at->items[i].name;
    reporter->compile.inputs = reporter->inputs;
    reporter->options.compile = &reporter->compile;
    return true;
}

static bool read_times(Reporter *reporter)
{
    YkSession *session = reporter->session;
    const YkRequest *request = session->request;
    double *duration = &reporter->options.duration;
    if (!yk_session_count(session, "--steps", request->steps, STEPS_MAX, 0, &reporter->options.steps)) return false;
    if (!request->to) return true;
    if (!yk_session_value(session, "--to", "", request->to, YK_QUANTITY_TIME, duration)) return false;
    return *duration > 0 || refuse(reporter, YK_CODE_OPTION_VALUE, "--to %s must be later than the start", request->to);
}

static bool prepare(Reporter *reporter)
{
    YkSession *session = reporter->session;
    const char *over = session->request->over;
    reporter->options = yk_default_report_options();
    if (!read_format(reporter)) return false;
    if (over && !yk_over_split(session, over, &reporter->over)) return false;
    const char *swept = over && strcmp(reporter->over.name, "t") != 0 ? reporter->over.name : NULL;
    if (!yk_session_load(session, swept) || !yk_session_inputs(session) || !yk_certify_begin(session)) return false;
    if (over && !yk_over_read(session, &reporter->over)) return false;
    reporter->options.has_range = over != NULL;
    reporter->options.coordinate = over ? reporter->over.coordinate : -1;
    reporter->options.from = reporter->over.from;
    reporter->options.to = reporter->over.to;
    if (!keep_inputs(reporter, swept) || !read_times(reporter) || !find_points(reporter)) return false;
    reporter->options.traced_points = reporter->points;
    reporter->options.traced_count = session->request->trace.count;
    reporter->options.is_plain = session->request->plain;
    return true;
}

static int write_report(Reporter *reporter, YkReportPage *report)
{
    YkSession *session = reporter->session;
    YkStatus status = yk_report_status(report);
    const char *html = yk_report_html(report, session->problems);
    if (!html) return YK_EXIT_WRONG;
    yk_tell_status(session, status, yk_report_message(report));
    yk_certify_warn(session);
    if (reporter->as_pdf) {
        if (!yk_print_pdf(html, &session->out, session->problems)) return YK_EXIT_WRONG;
    } else {
        yk_text_puts(&session->out, html);
    }
    return yk_session_finish(session, yk_status_exit(status));
}

int yk_run_report(YkSession *session)
{
    Reporter reporter = {.session = session};
    int exit_code = YK_EXIT_WRONG;
    YkStatus reached = YK_BAD_ARGUMENT;
    bool good = prepare(&reporter);
    if (good) reached = yk_session_reach(session, NULL);
    if (good && reached < 0 && reached != YK_NO_ASSEMBLY) { // a machine that cannot be assembled has a page
        yk_reach_tell(session, reached);
        exit_code = yk_status_exit(reached);
    } else if (good) {
        YkReportPage *report = yk_report_new(session->state, &reporter.options, session->problems);
        if (report) exit_code = write_report(&reporter, report);
        yk_report_free(report);
    }
    return exit_code;
}
