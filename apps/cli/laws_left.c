// Warns of laws whose range is left: what happens outside is rarely what the file means.
#include "laws_left.h"
#include "answer.h"
#include "session.h"
#include "write/law_left.h"

YkLawWatch *yk_session_watch_laws(YkSession *session)
{
    YkLawWatch *watch = yk_law_watch_new(session->model);
    if (!watch) yk_session_run_out(session);
    return watch;
}

static void warn(YkSession *session, YkProblems *problems, const YkLawLeft *left, const char *axis, YkQuantity quantity,
                 const char *whose)
{
    YkText words = {0};
    yk_law_left_write(&words, session->model, left);
    if (axis) {
        yk_text_format(&words, "; first at %s = ", axis);
        yk_add_value(session, &words, left->at, quantity, YK_DIGITS);
    }
    if (axis && left->poses > 1) yk_text_format(&words, ", in %z poses", left->poses);
    yk_problem(problems, YK_CODE_LAW_LEFT, left->place, "%s%s", yk_text_get(&words), whose);
    yk_problem_hint(problems, "give the law the whole range that the machine needs, or `period:` if it repeats");
    yk_text_free(&words);
}

void yk_warn_of_laws(YkSession *session, const YkLawWatch *watch, const char *axis, YkQuantity quantity,
                     const char *whose)
{
    size_t count = yk_law_watch_count(watch);
    if (count == 0) return;
    YkProblems *problems = yk_session_file_problems(session);
    for (size_t k = 0; problems && k < count; k++) {
        YkLawLeft left = yk_law_watch_get(watch, k);
        warn(session, problems, &left, axis, quantity, whose);
    }
    yk_tell_problems(session, problems);
    yk_problems_free(problems);
}

void yk_add_laws_json(YkJson *json, const YkLawWatch *watch, bool has_axis)
{
    size_t count = yk_law_watch_count(watch);
    if (count == 0) return;
    yk_json_list(json, "laws_left", YK_JSON_LINES);
    for (size_t k = 0; k < count; k++) {
        YkLawLeft left = yk_law_watch_get(watch, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "law", left.law);
        yk_json_string(json, "user", yk_law_user_word(left.user));
        yk_json_string(json, "of", left.name);
        yk_json_number(json, "argument", left.argument);
        yk_json_number(json, "from", left.from);
        yk_json_number(json, "to", left.to);
        yk_json_number(json, "value", left.value);
        if (has_axis) yk_json_number(json, "at", left.at);
        yk_json_integer(json, "poses", (long long)left.poses);
        yk_json_end(json);
    }
    yk_json_end(json);
}
