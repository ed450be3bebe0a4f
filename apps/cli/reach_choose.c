// Takes configurations by name: --assembly LABEL, nearest or K; and finds which of several is the machine's own.
#include <string.h>
#include "reach.h"
#include "roll.h"
#include "stop.h"

// --- choosing

typedef struct Chooser {
    YkSession *session;
    const char *word;
    size_t number; // the one wanted, or 0: by name
    size_t seen;
    YkState *found;
    bool has_found;
    YkText list; // the names available
} Chooser;

static bool look(void *context, YkState *state)
{
    Chooser *c = context;
    YkText name = yk_configuration_name(c->session, state);
    c->seen++;
    yk_text_format(&c->list, *yk_text_get(&name) ? "%s%z: %s" : "%s%z, which has no label%s", c->seen > 1 ? "; " : "",
                   c->seen, yk_text_get(&name));
    bool is_it = c->number > 0 ? c->seen == c->number : strcmp(yk_text_get(&name), c->word) == 0;
    yk_text_free(&name);
    if (!is_it || c->has_found) return true;
    c->has_found = yk_state_copy(c->found, state) >= 0;
    return true;
}

static size_t number_of(const char *word)
{
    size_t number = 0;
    for (const char *c = word; *c; c++) {
        if (*c < '0' || *c > '9' || number > 1000000) return 0;
        number = 10 * number + (size_t)(*c - '0');
    }
    return number;
}

static YkStatus refuse(YkSession *session, const Chooser *c)
{
    yk_text_format(&session->reach_message, "no configuration %q closes at the requested pose", c->word);
    yk_problem(session->problems, YK_CODE_NO_SUCH_ASSEMBLY, (YkPlace){0}, "%s", yk_text_get(&session->reach_message));
    const char *hint = c->seen == 0 ? "nothing closes there%s" : c->seen == 1 ? "there is only %s" : "there are %s";
    yk_problem_hint(session->problems, hint, yk_text_get(&c->list));
    return YK_NO_ASSEMBLY;
}

// Returns whether the chosen configuration is the one that the machine would get to.
static bool is_own(YkSession *session, const YkState *chosen)
{
    YkState *state = yk_reach_own(session);
    session->ran_out |= yk_memory_ran_out();
    bool own = state && yk_state_is_at(state, chosen);
    yk_state_free(state);
    return own;
}

static YkStatus choose_by_name(YkSession *session, const char *word)
{
    Chooser c = {session, word, number_of(word), 0, yk_session_new_state(session, session->mech), false, {0}};
    if (!c.found) {
        yk_session_run_out(session);
        return YK_NO_MEMORY;
    }
    YkStatus status = yk_session_each(session, session->state, look, &c, NULL);
    if (status >= 0 && c.has_found) {
        status = yk_state_copy(session->state, c.found);
        yk_session_hold(session, session->state);
        if (status >= 0) status = yk_state_set_time(session->state, session->time, session->problems);
        if (status >= 0) status = yk_state_solve(session->state);
    } else {
        status = refuse(session, &c);
    }
    yk_state_free(c.found);
    yk_text_free(&c.list);
    return status;
}

YkStatus yk_reach_choose(YkSession *session)
{
    const char *word = session->request->assembly;
    session->is_chosen = true;
    YkStatus status = yk_reach_ask(session);
    if (status < 0) return status;
    status = strcmp(word, "nearest") == 0 ? yk_state_assemble(session->state) : choose_by_name(session, word);
    if (status >= 0) session->is_start = is_own(session, session->state);
    return status;
}

YkStatus yk_reach_untold(YkSession *session)
{
    YkStatus status = yk_reach_ask(session);
    if (status >= 0) status = yk_state_assemble(session->state);
    session->is_chosen = true;
    if (status >= 0)
        yk_problem(session->problems, YK_CODE_START_UNTOLD, (YkPlace){0},
                   "the file does not say where the machine was assembled; the configuration nearest to its guesses "
                   "at this pose was taken");
    return status;
}
