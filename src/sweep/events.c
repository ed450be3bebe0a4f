// Reads the channels at the events of a sweep, as soon as the sweep has passed them.
#include "sweep/sweep.h"

static bool is_rate(YkChannel c)
{
    return c.order > 0 || c.kind == YK_CHANNEL_POINT_SPEED;
}

static void read_event(YkSweep *w, size_t event)
{
    double *values = w->event_values + event * w->channel_count;
    bool stands = yk_sweep_look_back(w, w->walk.events[event].at, false) >= 0;
    if (stands) yk_sweep_read_channels(w, values);
    for (size_t c = 0; c < w->channel_count; c++)
        if (!stands || (is_rate(w->channels[c]) && !yk_state_has_rates(w->walk.path.state))) values[c] = (double)NAN;
}

void yk_sweep_read_events(YkSweep *w, double here)
{
    if (w->events_read == w->walk.event_count) return;
    while (w->events_read < w->walk.event_count) {
        if (!YK_ROW_ROOM(w->event_values, w->channel_count, w->events_read, w->event_capacity)) {
            w->walk.failed = true;
            return;
        }
        read_event(w, w->events_read++);
    }
    yk_path_try(&w->walk.path, here, true);
    yk_path_probe(&w->walk.path, here, true);
}

double yk_sweep_event_value(const YkSweep *w, size_t event, size_t channel)
{
    bool is_known = event < w->events_read && channel < w->channel_count;
    return is_known ? w->event_values[event * w->channel_count + channel] : (double)NAN;
}
