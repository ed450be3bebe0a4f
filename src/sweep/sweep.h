// A sweep on its way: what its parts share. walk.c goes from pose to pose, extremes.c watches the channels, rows.c
// keeps what was asked for, sweep.c runs them.
#ifndef SWEEP_SWEEP_H
#define SWEEP_SWEEP_H
#include <yoke/sweep.h>
#include "sweep/walk.h"

struct YkSweep {
    YkWalk walk;
    YkSweepOptions options;
    YkChannel *channels;
    size_t channel_count, row_count;
    double *at, *values;
    signed char *row_status;
    double *slope, *slope_at; // per channel: last nonzero derivative along the path, and where
    double *sums, *beside;    // per channel: scratch
    double *event_values;     // per event and channel
    size_t events_read, event_capacity;
    double worst_residual;
};

// Solves at a place that the sweep has passed, on the branch that it had there. along: with rates along the path,
// otherwise with the motion's own.
YkStatus yk_sweep_look_back(YkSweep *sweep, double at, bool along);
// The channels at the pose that stands; forces are NaN where they are not determined.
void yk_sweep_read_channels(const YkSweep *sweep, double *values);
// The state stands at `here`, verified: reads the channels at the events noted since the last call.
void yk_sweep_read_events(YkSweep *sweep, double here);

// The state stands at `at`, verified: looks whether a channel turned round since it was last seen moving.
void yk_sweep_watch_extremes(YkSweep *sweep, double at);

// A row at `at`; false where the machine does not close there.
bool yk_sweep_record(YkSweep *sweep, double at);
// After a row that came out singular: does the motion go on beyond with the touching blocks' other sign?
void yk_sweep_try_change_row(YkSweep *sweep);

#endif
