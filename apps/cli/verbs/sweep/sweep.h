// The answer of `yoke sweep`, and its writers.
#ifndef CLI_SWEEP_H
#define CLI_SWEEP_H
#include "answer.h"
#include "columns.h"
#include "range.h"
#include "stops_passed.h"

enum { YK_RANGES_MAX = 32 };

typedef struct YkHeldColumn { // an effort that dry friction leaves open in some rows
    size_t rows;
    double at;           // the first of them,
    YkEffortRange range; // and there
} YkHeldColumn;

typedef struct YkNoise { // of a cell
    float usual;         // beside the largest values of its row
    float measured;      // by poses a hair off; infinite if there are none
} YkNoise;

typedef struct YkSweepAnswer {
    YkSession *session;
    YkOver over;
    YkMethod method;
    YkAnswerColumn *columns; // as --of names them, without the swept variable
    size_t column_count;
    bool has_forces; // among them
    YkSweep *sweep;
    YkStatus status;
    YkText message;                // one sentence, if the status is not ok
    YkText label;                  // of the configuration
    YkRange ranges[YK_RANGES_MAX]; // where it closes, at a limit
    size_t range_count;
    const char *ranges_of; // the coordinate they are of, or NULL
    YkQuantity ranges_quantity;
    YkStroke *strokes;            // of each column; ratio 0 if there is none
    YkNoise *noise;               // of each row's cells, for text
    float *sines;                 // per row, for text: the least sine of a transmission angle, which spoils digits
    YkState *beside;              // the pose a hair off
    double *values;               // [4 * column_count]: of a row, and of the poses beside it
    size_t row_capacity, visited; // of both
    YkLawWatch *laws;             // that the rows have left
    YkStopWatch *stops;           // that they have passed
    YkHeldColumn *held;           // [column]
    size_t forceless;             // rows in which a load has no finite value,
    double forceless_at;          // the first of them,
    YkReport why;                 // and the reason there
} YkSweepAnswer;

// Returns a value of the table; NaN if it is undefined (rates at a dead point).
double yk_sweep_cell(const YkSweepAnswer *answer, size_t row, size_t column);
const char *yk_event_word(YkEvent event); // "limit", "dead-point", "change-point", "maximum", "minimum"
// Writes "theta1 from ... to ..." for every range.
void yk_sweep_add_ranges(const YkSweepAnswer *answer, YkText *text);
// For yk_sweep_options.visit, at every row's pose: looks for efforts among the columns that are not unique there.
void yk_sweep_look_at_friction(void *answer, const YkState *state);
void yk_sweep_warn_of_friction(const YkSweepAnswer *answer);
// Returns what is swept at a state: the coordinate, or the time.
double yk_sweep_place(const YkSweepAnswer *answer, const YkState *state);
// Measures the noise of a row, with session->dynamics and session->scale as scratch.
void yk_sweep_measure_noise(YkSweepAnswer *answer, const YkState *state, size_t row);
void yk_sweep_text(const YkSweepAnswer *answer);
void yk_sweep_json(const YkSweepAnswer *answer);
void yk_sweep_csv(const YkSweepAnswer *answer);
// Draws the columns into --plot's file. Returns false with a problem added.
bool yk_sweep_plot(const YkSweepAnswer *answer, const char *path);

#endif
