// A simulation's answer, and its writers.
#ifndef CLI_SIMULATE_H
#define CLI_SIMULATE_H
#include "answer.h"
#include "sweep.h"

typedef struct YkSimulationAnswer {
    YkSession *session;
    YkSimulation *simulation;
    YkColumn *columns; // after t
    size_t column_count;
    double *rows; // [row][1 + column]: t first; SI
    size_t row_count, written;
    double to, from;
    size_t steps; // rows after the first
    YkStatus status;
    bool is_interrupted;
} YkSimulationAnswer;

void yk_simulate_text(YkSimulationAnswer *answer);
void yk_simulate_json(YkSimulationAnswer *answer);
void yk_simulate_csv_head(YkSimulationAnswer *answer);
void yk_simulate_csv_rows(YkSimulationAnswer *answer); // those not written yet
bool yk_simulate_plot(YkSimulationAnswer *answer, const char *path);
const char *yk_happening_word(YkHappeningKind kind);
// Events, works and the summary line on standard error.
void yk_simulate_tell(YkSimulationAnswer *answer);

#endif
