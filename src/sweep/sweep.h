// A sweep on its way: what its parts share. progress.c goes from pose to pose and never leaves the branch unseen,
// extremes.c watches the channels, rows.c keeps what was asked for, sweep.c runs them.
#ifndef SWEEP_SWEEP_H
#define SWEEP_SWEEP_H
#include <yoke/sweep.h>
#include "sweep/path.h"

enum { SWEEP_DEPTH_MAX = 44 }; // levels of halving

struct YkSweep {
    YkPath path;
    YkSweepOptions options;
    YkChannel *channels;
    size_t channel_count, row_count, margin_count;
    double *at, *values;
    signed char *row_status;
    YkEvent *events;
    size_t event_count, event_capacity;
    double *margins;          // [depth][3][block]
    double *slope, *slope_at; // per channel: last nonzero derivative along the path, and where
    double *sums;             // per channel: scratch
    double *flipped_at;       // per block: its last change point (NaN: none yet)
    YkStatus status;
    YkProblems *problems;
    double worst_residual, from;
    bool failed;
    int limit_block;
};

// Keeps an event; the first 10,000 of them.
void yk_sweep_note(YkSweep *sweep, YkEvent event);

// The blocks' margins at the three samples of an interval (0 start, 1 middle, 2 end), one set a level of halving.
double *yk_sweep_margins(const YkSweep *sweep, size_t depth, size_t which);
void yk_sweep_read_margins(const YkSweep *sweep, double *margins);
// Groups that Newton's method solves have none of their own.
bool yk_sweep_has_margin(const YkSweep *sweep, size_t block);

// In verified sub-steps from a to b; false where the motion ends on the way, with its limit noted.
bool yk_sweep_progress(YkSweep *sweep, double a, double b);
// The sweep ends at `at`, since the machine does not close at `bad` - or no drive says where it is to be then.
void yk_sweep_end_at(YkSweep *sweep, double at, double bad);
// Blocks that are singular at `a`, where the motion has come to and goes on: double zeros, passed with the other sign.
void yk_sweep_flip_at(YkSweep *sweep, double a, const double *margins);
bool yk_sweep_was_flipped_near(const YkSweep *sweep, size_t block, double at);

// The state stands at `at`, verified: looks whether a channel turned round since it was last seen moving.
void yk_sweep_watch_extremes(YkSweep *sweep, double at);

// A row at `at`; false where the machine does not close there.
bool yk_sweep_record(YkSweep *sweep, double at);
// After a row that came out singular: does the motion go on beyond with the touching blocks' other sign?
void yk_sweep_try_change_row(YkSweep *sweep);

#endif
