// yoke simulate: motion in time.
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/number.h"
#include "base/problems.h"
#include "certify.h"
#include "laws_left.h"
#include "reach.h"
#include "stop.h"
#include "verbs/simulate/simulate.h"

enum { CHUNK = 16384 };
static const double flush_after = 0.1, progress_after = 0.2; // s of real time

static void ignore_closed_pipes(void)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL); // a closed pipe is a failed write, which is reported
}

// --- after every step: whether to go on, and progress for people who watch

typedef struct Watch {
    double from, to; // s
    bool shows_progress, has_shown;
    double last_flush, last_progress;
    size_t steps;
    YkSession *session;
} Watch;

// Warns once, after the first steps, if there would be very many at their pace.
static void foretell(const Watch *watch, double time)
{
    const double many = 1e7;
    double steps = (double)watch->steps * (watch->to - watch->from) / (time - watch->from);
    YkProblems *problems = steps > many ? yk_problems_new() : NULL;
    char number[YK_NUMBER_SIZE];
    if (!problems) return;
    yk_number_write_digits(steps, 1, number);
    yk_problem(problems, YK_CODE_MOTION_LONG, (YkPlace){0}, "at the pace of its first steps the motion takes %s steps",
               number);
    yk_problem_hint(problems, "Ctrl-C stops it, with complete rows so far; an earlier --to costs less");
    yk_tell_problems(watch->session, problems);
    yk_problems_free(problems);
}

// Shows no progress if the rows go to the same terminal.
static bool wants_progress(const YkSession *session)
{
    const char *output = session->request->output;
    bool rows_are_seen = isatty(STDOUT_FILENO) && (!output || strcmp(output, "-") == 0);
    return yk_stop_shows_progress(session) && !rows_are_seen;
}

static bool look(void *context, double time)
{
    enum { FIRST_STEPS = 1000 };
    Watch *watch = context;
    if (++watch->steps == FIRST_STEPS && time > watch->from) foretell(watch, time);
    if (watch->shows_progress && yk_stop_now() - watch->last_progress > progress_after) {
        fprintf(stderr, "\rsimulate: t = %.6g s, %.0f %%   ", time,
                100 * (time - watch->from) / (watch->to - watch->from));
        watch->has_shown = true;
        watch->last_progress = yk_stop_now();
    }
    return !yk_stop_is_asked();
}

static void clear_progress(const Watch *watch)
{
    if (watch->has_shown) fputs("\r                                              \r", stderr);
}

// --- running

// Flushes rows when there are many of them, or when a reader may be waiting.
static bool flush_if_due(YkSimulationAnswer *answer, Watch *watch)
{
    if (answer->session->out.length < CHUNK && yk_stop_now() - watch->last_flush < flush_after) return true;
    watch->last_flush = yk_stop_now();
    return yk_simulate_flush(answer);
}

// Returns false when memory or the output is exhausted; reported.
static bool run_rows(YkSimulationAnswer *answer, Watch *watch)
{
    bool streams = answer->session->request->format != YK_FORMAT_JSON;
    for (size_t k = 0; k <= answer->steps; k++) {
        double time = yk_simulate_time_of(answer, k);
        answer->status = yk_simulation_advance(answer->simulation, time);
        bool has_row = answer->status == YK_OK && yk_simulation_time(answer->simulation) >= time;
        answer->is_interrupted = yk_stop_is_asked() && (!has_row || k < answer->steps);
        if (has_row && !yk_simulate_row(answer)) return false;
        if (streams && has_row && !flush_if_due(answer, watch)) return false;
        if (!has_row || answer->is_interrupted) break;
    }
    return !streams || yk_simulate_flush(answer);
}

static bool run(YkSimulationAnswer *answer, Watch *watch)
{
    YkSession *session = answer->session;
    if (session->request->format != YK_FORMAT_JSON &&
        !yk_stream_open(&answer->stream, session->request->output, session->problems))
        return false;
    ignore_closed_pipes();
    session->keeps_what_is_done = true; // what is done comes out whole
    yk_simulate_head(answer);
    bool good = run_rows(answer, watch);
    clear_progress(watch);
    return good;
}

// --- the end of it

// Adds what stopped it, as a problem. Returns the message, or NULL if it came to its end.
static const char *explain_stop(YkSimulationAnswer *answer, YkText *message)
{
    YkSession *session = answer->session;
    if (!answer->is_interrupted && answer->status == YK_OK) return NULL;
    const char *why = answer->is_interrupted ? "" : yk_simulation_report(answer->simulation)->message;
    yk_text_puts(message, answer->is_interrupted ? "interrupted at t = " : "the motion ends at t = ");
    yk_add_value(session, message, yk_simulation_time(answer->simulation), YK_QUANTITY_TIME, 10);
    if (*why) yk_text_format(message, ": %s", why);
    yk_problem(session->problems, answer->is_interrupted ? YK_CODE_INTERRUPTED : YK_CODE_MOTION_ENDS, (YkPlace){0},
               "%s", yk_text_get(message));
    return yk_text_get(message);
}

// Puts everything into words before a file appears, since no file may appear along with E0100.
static bool close_rows(YkSimulationAnswer *answer, const YkText *summary)
{
    YkSession *session = answer->session;
    session->out.failed |= summary->failed;
    if (yk_session_has_memory(session)) return yk_stream_close(&answer->stream, session->problems);
    yk_stream_drop(&answer->stream);
    return false;
}

static int finish(YkSimulationAnswer *answer, bool good)
{
    YkSession *session = answer->session;
    YkText words = {0}, summary = {0};
    const char *plot = session->request->plot, *message = explain_stop(answer, &words);
    yk_simulate_tell(answer, &summary);
    yk_certify_warn(session);
    yk_note_status(session, answer->status);
    good = close_rows(answer, &summary) && good && !session->out.failed;
    int exit_code = !good ? YK_EXIT_WRONG : message ? YK_EXIT_NO_ANSWER : YK_EXIT_DONE;
    if (session->request->format == YK_FORMAT_JSON && good) {
        char code[YK_CODE_SIZE];
        YkCode why = answer->is_interrupted ? YK_CODE_INTERRUPTED : YK_CODE_MOTION_ENDS;
        yk_simulate_json(answer, message, message ? yk_code_word(why, code) : NULL);
        exit_code = yk_session_finish(session, exit_code);
    }
    if (plot && good && !yk_simulate_plot(answer, plot)) exit_code = YK_EXIT_WRONG;
    yk_warn_of_laws(session, answer->laws, "t", YK_QUANTITY_TIME, "");
    yk_tell_problems(session, session->problems);
    session->is_told = true; // the summary is the last line
    if (!session->ran_out) fputs(yk_text_get(&summary), stderr);
    yk_text_free(&words);
    yk_text_free(&summary);
    return exit_code;
}

// A machine that cannot be assembled has no motion: that is an answer. Everything else is an error in the file.
static int refuse(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkProblem *first = NULL;
    for (size_t i = 0; i < yk_problems_count(session->file_problems); i++) {
        const YkProblem *problem = yk_problems_get(session->file_problems, i);
        bool is_answer = problem->code == YK_CODE_POSE_NO_ASSEMBLY || problem->code == YK_CODE_POSE_LIMIT;
        if (!first && is_answer) first = problem;
    }
    if (!first) return YK_EXIT_WRONG;
    answer->status = first->code == YK_CODE_POSE_LIMIT ? YK_LIMIT : YK_NO_ASSEMBLY;
    if (session->request->format != YK_FORMAT_JSON) return YK_EXIT_NO_ANSWER;
    yk_simulate_json(answer, first->message, answer->status == YK_LIMIT ? "E0602" : "E0601");
    return yk_session_finish(session, YK_EXIT_NO_ANSWER);
}

// Finds the pose at --from, on the machine's own assembly or that of --assembly. If it is not reached there is no
// motion, which is an answer.
static int refuse_pose(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    char code[YK_CODE_SIZE];
    yk_tell_problems(session, session->file_problems);
    yk_reach_tell(session, answer->status);
    if (session->request->format != YK_FORMAT_JSON) return yk_status_exit(answer->status);
    yk_simulate_json(answer, yk_reach_message(session), yk_code_word(yk_status_code(answer->status), code));
    return yk_session_finish(session, yk_status_exit(answer->status));
}

static YkStatus reach(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    if (!yk_session_inputs(session) || !yk_certify_begin(session)) return YK_BAD_ARGUMENT;
    session->time = answer->from;
    answer->status = yk_session_reach(session, NULL);
    answer->options.pose = session->state;
    return answer->status;
}

static int simulate(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    session->is_simulation = true;
    bool good = yk_simulate_read(answer);
    Watch watch = {.from = answer->from, .to = answer->to, .shows_progress = wants_progress(session)};
    watch.session = session;
    watch.last_flush = watch.last_progress = yk_stop_now();
    answer->options.goes_on = look;
    answer->options.context = &watch;
    if (good && reach(answer) < 0)
        return yk_problems_error_count(session->problems) > 0 ? YK_EXIT_WRONG : refuse_pose(answer);
    if (good) answer->simulation = yk_simulation_new(session->model, &answer->options, session->file_problems);
    if (session->file_problems) yk_tell_problems(session, session->file_problems);
    if (!good) return YK_EXIT_WRONG;
    if (!answer->simulation) return refuse(answer);
    yk_certify_simulation(session, answer->simulation);
    answer->laws = yk_session_watch_laws(session);
    if (!answer->laws || !yk_simulate_prepare(answer)) return YK_EXIT_WRONG;
    return finish(answer, run(answer, &watch));
}

int yk_run_simulate(YkSession *session)
{
    YkSimulationAnswer answer = {.session = session};
    int exit_code = simulate(&answer);
    yk_simulation_free(answer.simulation);
    yk_law_watch_free(answer.laws);
    free(answer.columns);
    free(answer.rows);
    return exit_code;
}
