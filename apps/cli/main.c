// yoke VERB FILE [options]: one verb, one question.
#include <signal.h>
#include <stdio.h>
#include "help.h"
#include "options.h"
#include "ranks.h"
#include "session.h"
#include "stop.h"

// Several ranks would all do the same: only some verbs share their work among them, and only rank 0 refuses the rest.
static bool shares_work(const YkRequest *request)
{
    return request->verb->run == yk_run_study || request->verb->run == yk_run_synthesize ||
           request->verb->run == yk_run_map;
}

static bool refuse_ranks(YkSession *session)
{
    yk_session_refuse(session, YK_CODE_RANKS_VERB, "mpirun started `yoke %s` on several ranks, which it cannot use",
                      session->request->verb->name);
    yk_problem_hint(
        session->problems,
        "start it without mpirun: `yoke study`, `yoke synthesize` and `yoke map` share their work among ranks");
    return false;
}

static void tell_version(YkSession *session)
{
    const char *plugin = yk_ranks_plugin();
    yk_text_format(&session->out, "yoke %s\n", yk_version());
    if (plugin) yk_text_format(&session->out, "yoke-mpi %s\n", plugin);
}

static int run(YkSession *session)
{
    const YkRequest *request = session->request;
    bool has_ranks = yk_ranks_count() > 1, is_asked = request->verb && !request->version && !request->help;
    if (yk_problems_error_count(session->problems) > 0) return YK_EXIT_WRONG;
    if (has_ranks && is_asked && !shares_work(request) && !refuse_ranks(session)) return YK_EXIT_WRONG;
    if (!is_asked && yk_ranks_rank() > 0) return YK_EXIT_DONE;
    if (request->version) {
        tell_version(session);
        return yk_session_finish(session, YK_EXIT_DONE);
    }
    if (!request->verb || request->help) {
        if (request->verb) {
            yk_help_verb(&session->out, request->verb);
        } else {
            yk_help_tour(&session->out);
        }
        return yk_session_finish(session, YK_EXIT_DONE);
    }
    int exit_code = request->verb->run(session);
    yk_stop_clear_line();
    return exit_code;
}

// A file that cannot grow any more is a failed write, which is reported, and the rest of the file is removed.
static void ignore_file_limit(void)
{
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

int main(int argc, char **argv)
{
    ignore_file_limit();
    yk_stop_catch();
    if (yk_ranks_rank() > 0) yk_ranks_hush();
    YkRequest request = {.arena = yk_arena_new()};
    YkSession session = {.request = &request, .problems = yk_problems_new()};
    int exit_code = YK_EXIT_WRONG;
    if (request.arena && session.problems) {
        yk_problems_set_teller(session.problems, "yoke");
        yk_options_read(argc, argv, &request, session.problems);
        exit_code = run(&session);
        if (!session.is_told) yk_tell_problems(&session, session.problems);
        session.ran_out |= yk_memory_ran_out();
        if (session.ran_out) exit_code = YK_EXIT_WRONG;
    }
    bool is_stopped = yk_stop_is_heeded();
    if (is_stopped) exit_code = yk_stop_exit();
    bool has_no_reason = exit_code == YK_EXIT_WRONG && !session.has_told_error;
    if (!is_stopped && (has_no_reason || (session.ran_out && !session.has_told_memory)))
        fputs("yoke: error: out of memory [E0100]\n", stderr);
    if (exit_code == YK_EXIT_WRONG && yk_ranks_rank() > 0 && !yk_ranks()) yk_ranks_linger();
    yk_session_free(&session);
    yk_problems_free(session.problems);
    yk_request_free(&request);
    return exit_code;
}
