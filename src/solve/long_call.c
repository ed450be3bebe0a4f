// Long calls on a state: who watches them, and the state's return to where it stood when one is stopped.
#include "solve/state.h"

YkStatus yk_state_set_progress(YkState *s, YkProgress progress)
{
    if (progress.goes_on && !s->before) s->before = yk_state_new(s->mech);
    if (progress.goes_on && !s->before) return YK_NO_MEMORY;
    s->progress = progress;
    return YK_OK;
}

void yk_state_lend(YkState *s, YkPace *pace)
{
    s->pace = s->groups.pace = pace;
}

bool yk_state_begin(YkState *s)
{
    if (s->pace || !s->progress.goes_on) return false;
    yk_state_take(s->before, s);
    yk_state_lend(s, &s->own_pace);
    yk_pace_begin(&s->own_pace, s->progress);
    return true;
}

YkStatus yk_state_end(YkState *s, bool is_own, YkStatus status)
{
    bool is_stopped = yk_state_is_stopped(s);
    if (is_own) {
        yk_state_lend(s, NULL);
        if (is_stopped) yk_state_take(s, s->before);
    }
    return is_stopped ? yk_state_refuse(s, YK_STOPPED, "stopped before it was done, as the caller asked") : status;
}
