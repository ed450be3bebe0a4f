// yoke VERB FILE [options]: one verb, one question.
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "help.h"
#include "options.h"
#include "session.h"

// Colours are for people: on a terminal, unless the user asked for none (https://no-color.org).
static int wants_colour(void)
{
    const char *none = getenv("NO_COLOR"), *terminal = getenv("TERM");
    return isatty(STDERR_FILENO) && !(none && *none) && !(terminal && strcmp(terminal, "dumb") == 0);
}

const char *yk_words_of_problems(const YkSession *session, YkProblems *problems)
{
    bool has_errors = yk_problems_error_count(problems) > 0;
    if (yk_problems_count(problems) == 0 || (session->request->quiet && !has_errors)) return "";
    return yk_problems_text(problems, wants_colour());
}

void yk_tell_problems(YkSession *session, YkProblems *problems)
{
    fputs(yk_words_of_problems(session, problems), stderr);
    bool ran_out = yk_problems_ran_out(problems);
    session->ran_out |= ran_out || !problems;
    session->has_told_memory |= ran_out;
    session->has_told_error |= ran_out || yk_problems_error_count(problems) > 0;
}

static int run(YkSession *session)
{
    const YkRequest *request = session->request;
    if (yk_problems_error_count(session->problems) > 0) return YK_EXIT_WRONG;
    if (request->version) {
        yk_text_format(&session->out, "yoke %s\n", yk_version());
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
    return request->verb->run(session);
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
    YkRequest request = {.arena = yk_arena_new()};
    YkSession session = {.request = &request, .problems = yk_problems_new()};
    int exit_code = YK_EXIT_WRONG;
    if (request.arena && session.problems) {
        yk_problems_set_source(session.problems, "yoke", NULL, 0);
        yk_options_read(argc, argv, &request, session.problems);
        exit_code = run(&session);
        if (!session.is_told) yk_tell_problems(&session, session.problems);
        session.ran_out |= yk_memory_ran_out();
        if (session.ran_out) exit_code = YK_EXIT_WRONG;
    }
    bool has_no_reason = exit_code == YK_EXIT_WRONG && !session.has_told_error;
    if (has_no_reason || (session.ran_out && !session.has_told_memory))
        fputs("yoke: error: out of memory [E0100]\n", stderr);
    yk_session_free(&session);
    yk_problems_free(session.problems);
    yk_request_free(&request);
    return exit_code;
}
