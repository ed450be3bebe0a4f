// A sweep in progress, shared by its files. walk.c goes from pose to pose, extremes.c watches the channels, rows.c
// keeps the requested values, sweep.c runs them.
#ifndef SWEEP_SWEEP_H
#define SWEEP_SWEEP_H
#include <yoke/sweep.h>
#include "sweep/walk.h"

struct YkSweep {
    YkArena *arena; // of all arrays but the rows and event_values
    YkWalk walk;
    YkSweepOptions options;
    YkChannel *channels;
    size_t channel_count, row_count;
    double *rows; // [row][1 + channel]: the swept variable, then the channels
    signed char *row_status;
    double *slope, *slope_at; // per channel: last nonzero derivative along the path, and where
    double *sums, *beside;    // per channel: scratch
    double *largest;          // [channel]: about a change point
    double *event_values;     // per event and channel
    size_t events_read, event_capacity;
    double worst_residual;
};

// Returns a row: the swept variable, then the channels.
static inline double *yk_sweep_row(const YkSweep *sweep, size_t row)
{
    return sweep->rows + row * (1 + sweep->channel_count);
}

// Solves at a place that the sweep has passed, on the branch that it had there. along: with rates along the path,
// otherwise with the motion's own.
YkStatus yk_sweep_look_back(YkSweep *sweep, double at, bool along);
// Reads the channels at the present pose; forces are NaN if they are not determined.
void yk_sweep_read_channels(YkSweep *sweep, double *values);
// Reads the channels at the events noted since the last call, with the state at `here`, verified.
void yk_sweep_read_events(YkSweep *sweep, double here);

// Checks, with the state at `at`, verified, whether a channel has turned round since it was last seen moving.
void yk_sweep_watch_extremes(YkSweep *sweep, double at);

// Records a row at `at`; returns false if the machine does not close there.
bool yk_sweep_record(YkSweep *sweep, double at);
// Tries, after a row that came out singular, whether the motion continues beyond with the other sign of the touching
// blocks.
void yk_sweep_try_change_row(YkSweep *sweep);

#endif
