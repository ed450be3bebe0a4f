// The sweep: a motion through many poses along a path of the inputs, verified between the poses too. No limit is
// jumped, and no branch changes unreported.
#ifndef YOKE_SWEEP_H
#define YOKE_SWEEP_H

#include <yoke/dynamics.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkSweepOptions {
    int coordinate;  // the coordinate swept, an input; -1, the default, sweeps time (all drives)
    double from, to; // its range (rad, m or s); default 0 to 1
    size_t steps;    // n steps give n + 1 poses; default 36
    double turn_max; // largest turn of any body between verified poses, rad (or this times the machine's size / 1 s):
                     // default 2 deg
    YkDynamics *dynamics; // computes the channels that need forces (inverse and forward dynamics at every row); NULL if
                          // there are none
    YkMethod method;
    void (*visit)(void *context, const YkState *state); // called at the pose of every row, in order; may be NULL
    void *context;
} YkSweepOptions;
YK_API YkSweepOptions yk_default_sweep_options(void);

typedef enum YkEventKind { YK_EVENT_LIMIT, YK_EVENT_CHANGE_POINT, YK_EVENT_SINGULAR, YK_EVENT_EXTREME } YkEventKind;
typedef struct YkEvent {
    YkEventKind kind;
    double at;      // value of the swept variable, to 1e-8 or better
    int block;      // LIMIT, CHANGE_POINT, SINGULAR
    size_t channel; // EXTREME: index into the channels
    double value;   // EXTREME: the channel's value there
    bool is_maximum;
    bool is_passed; // CHANGE_POINT: the machine goes on beyond it; otherwise its drive turns back or rests there
    bool is_turned; // CHANGE_POINT: a drive turns back just at a limit there; the machine goes on to the other side
} YkEvent;

typedef struct YkSweep YkSweep;
// Sweeps from the configuration of `state`, which is assembled: it first moves to `from`,
// and it is left where the sweep ends. Its other inputs keep their values, and the swept coordinate keeps the state's
// rate and acceleration. Channels are recorded row by row. At a limit the rows before it remain, and the status is
// YK_LIMIT. Returns NULL only when out of memory, if the options are wrong, or, with a problem, if it was stopped
// (yk_state_set_progress).
YK_API YkSweep *yk_sweep_run(YkState *state, const YkSweepOptions *options, const YkChannel *channels,
                             size_t channel_count, YkProblems *problems);
YK_API void yk_sweep_free(YkSweep *sweep);
YK_API YkStatus yk_sweep_status(const YkSweep *sweep);
YK_API size_t yk_sweep_row_count(const YkSweep *sweep);
YK_API double yk_sweep_at(const YkSweep *sweep, size_t row); // the swept variable
YK_API double yk_sweep_value(const YkSweep *sweep, size_t row, size_t channel);
// Returns all rows at once, which belong to the sweep: rows[row * (1 + channels)] is the swept variable, and the
// channels follow it.
YK_API const double *yk_sweep_rows(const YkSweep *sweep);
YK_API YkStatus yk_sweep_row_status(const YkSweep *sweep,
                                    size_t row); // OK, SINGULAR (rates are 0 and must not be shown), CHANGE_POINT
YK_API size_t yk_sweep_event_count(const YkSweep *sweep);
// Returns the number of all events; only the first 10,000 are kept.
YK_API size_t yk_sweep_event_total(const YkSweep *sweep);
YK_API YkEvent yk_sweep_event(const YkSweep *sweep, size_t index);
// Returns a channel's value at an event; NaN if it is undetermined there (rates at dead points and change points).
YK_API double yk_sweep_event_value(const YkSweep *sweep, size_t event, size_t channel);
YK_API double yk_sweep_worst_residual(const YkSweep *sweep);

// Finds every range of a coordinate in which the configuration of `state`, given by its labels, closes: for an angle
// within a turn that starts at the state's value minus pi, for a distance within +-(sum of lengths). Ends are exact to
// 1e-10, or to 1e-9 for groups, whose iteration also converges a little beyond a limit; a full turn is one range of
// 2 pi. The range in which the state stands goes on through change points, as its
// motion does. Returns the count, YK_NOT_FOUND when out of memory or stopped (the state's report then says YK_STOPPED).
typedef struct YkRange {
    double from, to;
} YkRange;
YK_API size_t yk_closing_ranges(YkState *state, size_t coordinate, YkRange *ranges, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
