// yoke synthesize: from a task to machines that fulfil it.
#include "verbs/synthesize/synthesize.h"
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "base/units/units.h"
#include "session.h"
#include "spread.h"
#include "stop.h"
#include "write/folder.h"

// Reads a time span: a number with a unit of time, or in seconds.
static bool read_span(YkSession *session, const char *text, double *seconds)
{
    size_t length = strlen(text), digits = yk_number_read(text, length, seconds), bad_length;
    const char *bad;
    YkDimension dimension = {.time = 1};
    double size = 1;
    bool good = digits > 0 && *seconds > 0 && isfinite(*seconds);
    if (good && digits < length)
        good = yk_unit_read(text + digits, length - digits, &size, &dimension, &bad, &bad_length);
    good = good && dimension.time == 1 && dimension.length == 0 && dimension.mass == 0 && dimension.angle == 0;
    *seconds *= size;
    return good ||
           yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--within takes a time span as in 60s, not %q", text);
}

static bool goes_on(void *context, double part)
{
    YkSynthesisAnswer *answer = context;
    YkProgress stop = yk_stop_progress(answer->session);
    if (answer->session->request->so_far) yk_synthesis_tell_part(answer, part);
    if (answer->deadline > 0 && yk_stop_now() > answer->deadline) answer->is_late = true;
    return stop.goes_on(stop.context, part) && !answer->is_late;
}

// Reads what the request gives. Returns false with problems added.
static bool read_request(YkSynthesisAnswer *answer, YkProblems *problems)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    size_t seed = 1;
    double within = 0;
    if (request->format == YK_FORMAT_CSV)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--format takes text or json here, not %q", "csv");
    if (request->so_far && request->format != YK_FORMAT_JSON)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--so-far needs --format json, not %q", "text");
    if (!request->file) {
        yk_session_refuse(session, YK_CODE_FILE_MISSING, "`yoke %s` needs a task file", "synthesize");
        yk_problem_hint(session->problems, "`yoke new --task motion > task.yaml` writes one to begin with");
        return false;
    }
    bool writes = request->output && yk_ranks_rank() == 0;
    if (writes && !yk_folder_is_free(request->output, session->problems)) return false;
    answer->task = yk_task_load(request->file, problems);
    if (!answer->task || !yk_session_count(session, "--seed", request->seed, 1000000000, 1, &seed)) return false;
    if (request->within && !read_span(session, request->within, &within)) return false;
    if (!yk_session_threads(session, &answer->threads)) return false;
    answer->seed = seed;
    if (within > 0) answer->deadline = yk_stop_now() + within;
    return true;
}

// Searches, on all ranks where there are several.
static void search(YkSynthesisAnswer *answer, YkProblems *problems)
{
    YkSynthesisOptions options = yk_default_synthesis_options();
    YkSynthesisSpread *spread = NULL;
    YkSynthesisThreads *threads = NULL;
    options.seed = answer->seed;
    options.progress = (YkProgress){goes_on, answer};
    if (answer->session->request->so_far) options.findings = (YkFindings){yk_synthesis_tell_found, answer};
    bool has_ranks = yk_ranks() != NULL;
    if (has_ranks) spread = yk_synthesis_spread(answer, &options, problems);
    bool has_threads = !has_ranks && answer->threads > 1; // a rank is one thread
    if (has_threads) threads = yk_synthesis_threads(answer, &options, problems);
    if ((!has_ranks || spread) && (!has_threads || threads))
        answer->synthesis = yk_synthesis_run(answer->task, &options, problems);
    yk_synthesis_join(threads);
    yk_synthesis_gather(spread);
}

// Searches for machines. Returns the exit code of a run that ends without an answer.
static int find(YkSynthesisAnswer *answer)
{
    YkSession *session = answer->session;
    YkProblems *problems = yk_problems_new();
    int exit_code = YK_EXIT_WRONG;
    bool is_read = problems && read_request(answer, problems);
    if (!problems) yk_session_refuse_for_memory(session);
    if (is_read && yk_ranks_rank() == 0) search(answer, problems);
    if (problems) yk_tell_problems(session, problems);
    if (yk_ranks() && yk_ranks_rank() > 0)
        exit_code = yk_synthesis_serve(answer, is_read);
    else if (yk_ranks())
        yk_spread_dismiss();
    yk_problems_free(problems);
    return exit_code;
}

// Says on standard error why there is none: how many were left out for which reason.
static void tell_none(const YkSynthesisAnswer *answer)
{
    YkText reasons = {0};
    for (int k = 1; k < YK_DEFECT_COUNT; k++) {
        size_t count = yk_synthesis_left_out(answer->synthesis, (YkDefect)k);
        if (count > 0)
            yk_text_format(&reasons, "%s%z %s", yk_text_has_some(&reasons) ? ", " : "", count,
                           yk_defect_name((YkDefect)k));
    }
    yk_problem(answer->session->problems, YK_CODE_NO_MACHINE, (YkPlace){0},
               yk_text_has_some(&reasons) ? "no machine does what the task asks; left out: %s"
                                          : "no machine does what the task asks%s",
               yk_text_get(&reasons));
    yk_problem_hint(answer->session->problems, "`--defects` shows those that were left out");
    yk_text_free(&reasons);
}

static int finish(YkSynthesisAnswer *answer)
{
    YkSession *session = answer->session;
    const char *folder = session->request->output;
    YkRequest own = *session->request;
    bool has_some = yk_synthesis_count(answer->synthesis) > 0;
    if (folder && !yk_synthesis_files(answer, folder)) return YK_EXIT_WRONG;
    if (!has_some) tell_none(answer);
    if (session->request->format == YK_FORMAT_JSON)
        yk_synthesis_json(answer, &session->out);
    else
        yk_synthesis_text(answer);
    own.output = NULL; // it named the folder
    session->request = &own;
    return yk_session_finish(session, has_some ? YK_EXIT_DONE : YK_EXIT_NO_ANSWER);
}

int yk_run_synthesize(YkSession *session)
{
    YkSynthesisAnswer answer = {.session = session, .seed = 1};
    const YkRequest *request = session->request;
    session->keeps_what_is_done = true;
    if (yk_ranks_count() > 1 && !yk_ranks_begin(session)) {
        if (yk_ranks_is_first_here()) yk_ranks_speak(); // a computer reports once what it lacks
        return YK_EXIT_WRONG;
    }
    int exit_code = find(&answer);
    if (answer.synthesis) exit_code = finish(&answer);
    session->request = request;
    yk_synthesis_free(answer.synthesis);
    yk_task_free(answer.task);
    return exit_code;
}
