// A simulation's request and answer, and its writers.
#ifndef CLI_SIMULATE_H
#define CLI_SIMULATE_H
#include "answer.h"
#include "verbs/sweep/sweep.h"
#include "write/stream.h"

typedef struct YkSimulationAnswer {
    YkSession *session;
    // the request
    double from, to, every;  // s; every: 0 if --steps gives it
    size_t steps;            // rows after the first
    YkAnswerColumn *columns; // after t
    size_t column_count;
    YkSimulationOptions options;
    YkStartValue *values; // --at, --rate
    const char **inputs;  // --at
    YkCompileOptions compile;
    // the answer
    YkSimulation *simulation;
    YkStream stream; // where rows of text and CSV go
    double *row;     // [1 + column], t first; SI
    double *rows;    // all of them, if JSON or a plot needs them
    size_t row_count, row_capacity;
    YkStatus status;
    size_t told_count;           // events that were looked at for cams that lose their followers, and laws
    YkLawWatch *laws;            // that the motion has left
    bool is_interrupted, is_cut; // by a signal; by an output that accepts no more
} YkSimulationAnswer;

// request.c. Each returns false with a problem added.
bool yk_simulate_read(YkSimulationAnswer *answer);    // reads the whole command line; the machine is compiled
bool yk_simulate_prepare(YkSimulationAnswer *answer); // --effort and --event
double yk_simulate_time_of(const YkSimulationAnswer *answer, size_t row); // s

// rows.c: rows as they are computed.
void yk_simulate_head(YkSimulationAnswer *answer);
bool yk_simulate_row(YkSimulationAnswer *answer); // reads and writes the present one; false: out of memory, reported
bool yk_simulate_flush(YkSimulationAnswer *answer);

void yk_simulate_json(const YkSimulationAnswer *answer, const char *message, const char *code);
bool yk_simulate_plot(const YkSimulationAnswer *answer, const char *path);
const char *yk_happening_word(YkHappeningKind kind);
// Writes events, works and the summary line, for standard error.
void yk_simulate_tell(const YkSimulationAnswer *answer, YkText *text);

#endif
