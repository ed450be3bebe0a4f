// Shared by the writers of a sweep.
#include <math.h>
#include "verbs/sweep/sweep.h"

double yk_sweep_cell(const YkSweepAnswer *answer, size_t row, size_t column)
{
    YkChannel channel = answer->columns[column].channel;
    bool is_rate = channel.order > 0 || channel.kind == YK_CHANNEL_POINT_SPEED;
    if (is_rate && yk_sweep_row_status(answer->sweep, row) == YK_SINGULAR) return NAN;
    return yk_sweep_value(answer->sweep, row, column);
}

const char *yk_event_word(YkEvent event)
{
    switch (event.kind) {
    case YK_EVENT_LIMIT:
        return "limit";
    case YK_EVENT_CHANGE_POINT:
        return "change-point";
    case YK_EVENT_SINGULAR:
        return "dead-point";
    case YK_EVENT_EXTREME:
        return event.is_maximum ? "maximum" : "minimum";
    }
    return "event";
}

void yk_sweep_add_ranges(const YkSweepAnswer *answer, YkText *text)
{
    for (size_t i = 0; i < answer->range_count; i++) {
        yk_text_format(text, "%s%s from ", i > 0 ? ", and " : "", answer->ranges_of);
        yk_add_value(answer->session, text, answer->ranges[i].from, answer->ranges_quantity, 12);
        yk_text_puts(text, " to ");
        yk_add_value(answer->session, text, answer->ranges[i].to, answer->ranges_quantity, 12);
    }
}
