// Problems on standard error.
#include <stdio.h>
#include <stdlib.h>
#include "stop.h"

// Colours are for people: on a terminal, unless the user asked for none (https://no-color.org).
static int wants_colour(void)
{
    const char *none = getenv("NO_COLOR");
    return yk_is_at_terminal() && !(none && *none);
}

const char *yk_words_of_problems(const YkSession *session, YkProblems *problems)
{
    bool has_errors = yk_problems_error_count(problems) > 0;
    if (!session->keeps_what_is_done && yk_stop_is_due()) return ""; // main reports the stop
    yk_stop_clear_line();
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
