// Loops over the library's calls that would be slow in Python, and the ways from C back into Python.
// cffi reads this file too, so it has only declarations that cffi understands.
#include <yoke/yoke.h>

// Asks Python, at most every 20 ms, whether a long call may go on: for Ctrl-C and a progress bar.
bool yk_host_goes_on(void *context, double part);
YkProgress yk_host_progress(void);

// Puts `state` where the machine was assembled (`entry`) and goes from there (yk_state_reach).
YkStatus yk_host_reach(YkState *state, const YkState *entry, const YkInputHold *holds, size_t count, double time,
                       YkMove *move, YkProblems *problems);

// Writes NaN over the rates of rows at dead points, where they are undefined.
void yk_host_blank_rates(YkSweep *sweep, const YkChannel *channels, size_t count);
// Reads channels of a state. Undefined rates are NaN; so are accelerations without has_accelerations, and forces
// without `dynamics`.
void yk_host_read(const YkState *state, const YkDynamics *dynamics, const YkChannel *channels, size_t count,
                  bool has_accelerations, double *values);

typedef struct YkHostRows {
    double from, to, every; // s; every 0: `steps` equal spans
    size_t steps;
    const YkChannel *channels;
    size_t channel_count;
    double *rows; // [steps + 1][1 + channels]: the time, then the channels
    size_t done;  // rows written
} YkHostRows;
// Advances a simulation from row to row. Returns the status of the last advance, YK_STOPPED if it was told to end.
YkStatus yk_host_simulate(YkSimulation *simulation, YkHostRows *rows);
// Asks Python as yk_host_goes_on does. context: a double[2], the span of time.
bool yk_host_goes_on_in_time(void *context, double time);

typedef struct YkHostMany {
    YkSimulation **simulations;
    const size_t *coordinates; // whose efforts are set before the step
    size_t coordinate_count;
    const double *efforts; // [simulation][coordinate]; NULL: they stay
    double span;           // s; 0: only reads
    const YkChannel *channels;
    size_t channel_count;
    double *values;      // [simulation][channel]
    signed char *status; // [simulation]: below 0, the simulation stood still
} YkHostMany;
// Acts on the simulations from `begin` to `end`, steps and reads them. Those whose status is below 0 are left out.
YkStatus yk_host_step_many(const YkHostMany *many, size_t begin, size_t end);

// Draws the values of designs 0 to count - 1 of one parameter.
void yk_host_draw(const YkDistribution *distribution, uint64_t seed, uint64_t parameter, double *values, size_t count);

// For the bench: makes `count` calls of solve, or of step, without Python's part.
void yk_host_time_solve(YkState *state, const YkState *entry, YkInputHold *holds, YkMove *move, const double *values,
                        size_t count);
void yk_host_time_steps(YkSimulation *simulation, double span, size_t count);
