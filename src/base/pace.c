// Asks the caller of a long call whether to go on.
#include "base/pace.h"

bool yk_pace_begin(YkPace *pace, YkProgress progress)
{
    *pace = (YkPace){.progress = progress, .to = 1};
    return yk_pace_ask(pace);
}

void yk_pace_stage(YkPace *pace, double from, double to)
{
    if (!pace) return;
    pace->from = from;
    pace->to = to;
    yk_pace_reach(pace, 0);
}

void yk_pace_reach(YkPace *pace, double part)
{
    if (!pace) return;
    double whole = pace->from + (pace->to - pace->from) * part;
    if (whole > pace->part) pace->part = whole < 1 ? whole : 1;
}

bool yk_pace_ask(YkPace *pace)
{
    pace->work = 0;
    if (!pace->is_stopped && pace->progress.goes_on)
        pace->is_stopped = !pace->progress.goes_on(pace->progress.context, pace->part);
    return !pace->is_stopped;
}

static bool go_on_within(void *context, double part)
{
    YkPace *pace = context;
    yk_pace_reach(pace, part);
    return yk_pace_ask(pace);
}

YkProgress yk_pace_within(YkPace *pace)
{
    return pace ? (YkProgress){go_on_within, pace} : (YkProgress){0};
}
