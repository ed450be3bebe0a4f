// A study's request and answer, and its writers.
#ifndef CLI_STUDY_H
#define CLI_STUDY_H
#include "answer.h"
#include "range.h"
#include "verbs/sweep/sweep.h"
#include "write/stream.h"

enum { YK_REDUCTIONS = 4, YK_PARTIAL_PATH = 4096, YK_STUDY_PIECE = 1 << 20 }; // least, largest, mean, range of a cycle

typedef enum YkStudyFormat { YK_STUDY_TEXT, YK_STUDY_JSON, YK_STUDY_CSV, YK_STUDY_NPY, YK_STUDY_JSONL } YkStudyFormat;

typedef YkDesignAxis YkAxis; // a parameter that varies

// Statistics of an answer over the valid designs, at every pose.
typedef struct YkMoments {
    size_t count;
    double mean, deviation, least, largest;
} YkMoments;

// Figures of all rows so far, gathered as they come, since they need not stay in memory.
typedef struct YkStudySum {
    YkMoments *moments;                              // [answer]; the deviation is a sum of squares
    size_t statuses[YK_SINGULAR - YK_NO_MEMORY + 1]; // designs with this status
    size_t without;                                  // designs without a valid pose
    size_t bad;                                      // the first that makes no machine; YK_NOT_FOUND: none
} YkStudySum;

// The table has a row per design: values of the parameters, status, number of valid poses, then the answers.
typedef struct YkStudyAnswer {
    YkSession *session;
    YkStudyFormat format;
    YkAxis *axes;
    size_t axis_count;
    YkTolerances *tolerances; // of a sample
    bool is_sample;
    uint64_t seed;
    size_t design_count, threads;
    YkOver over; // name NULL: one pose
    size_t pose_count;
    double *input;            // [3 * input + k][pose]
    const double **input_row; // NULL: the state's
    YkAnswerColumn *columns;  // --of
    size_t column_count;
    bool has_forces; // among them
    double *times;   // [pose]; over a coordinate: NULL
    YkState *timed;  // the session's state at the time that is asked
    YkState *start;  // if other inputs gave the assembly: its pose with these; otherwise NULL
    YkStudy *study;
    double *rows;     // [design][width]; NULL: they are in the blocks
    YkBlocks *blocks; // OUTPUT.partial, if the output is a file; otherwise NULL
    char partial[YK_PARTIAL_PATH];
    double *missing;  // [width]: in place of a row that cannot be read any more
    bool has_missing; // there was such a row
    YkStream stream;  // the output, while rows go to it
    YkStudySum sum;
    size_t width, done;
    double began, next_line; // s of real time: when computing began; when the next line of progress is due
    size_t found;            // designs that were done already
    bool is_interrupted;
    bool follows_time;                         // designs go along their drives, not straight from pose to pose
    double *derivative, *difference;           // [column][axis], with --sensitivities
    YkStatus start_status, sensitivity_status; // below 0: the file itself has no valid pose, and no design has
} YkStudyAnswer;

// request.c: reads the whole command line and makes the study. Returns false with problems added.
bool yk_study_read(YkStudyAnswer *answer);

// partial.c: keeps what is done beside the output. Reads the rows of an interrupted run; returns false with a problem
// added if they are of another study.
bool yk_partial_open(YkStudyAnswer *answer);
bool yk_partial_add(YkStudyAnswer *answer, const double *rows, size_t count);
void yk_partial_close(YkStudyAnswer *answer, bool is_finished); // finished: removes it
void yk_partial_tell(const YkStudyAnswer *answer);              // where it is, if it is: a hint to the last problem
bool yk_partial_is_kept(const YkRequest *request);              // whether the output is a file that can have one
// Returns a number that identifies the study: of the version, the files and all options that decide its rows.
uint64_t yk_study_signature(const YkStudyAnswer *answer);

// run.c: computes the designs that are missing, in order. Returns false with a problem added.
bool yk_study_compute(YkStudyAnswer *answer);
// Takes the rows of the next designs, wherever they were computed. Returns false with a problem added.
bool yk_study_take(YkStudyAnswer *answer, const double *rows, size_t count);
YkRowCase yk_study_case(const YkStudyAnswer *answer, const YkDesigns *designs);
YkDesigns yk_study_designs(const YkStudyAnswer *answer);
// Shows how far it is, and what time is left, if anybody watches.
void yk_study_show(YkStudyAnswer *answer, bool is_last);

// spread.c: computes them on all ranks of mpirun (ranks.h). Returns false with a problem added.
bool yk_study_spread(YkStudyAnswer *answer);
// Does the work of a rank other than 0, whether the study could be read or not. Returns the exit code.
int yk_study_serve(YkStudyAnswer *answer, bool is_read);

// why.c: if designs make no machine, says why the first of them does not, as a hint to the last problem.
void yk_study_tell_why(const YkStudyAnswer *answer);

// laws.c: moves the file's own design through the poses, and warns of the laws whose range it leaves there.
void yk_study_warn_of_laws(YkStudyAnswer *answer);

// Places in a row.
const double *yk_study_row(YkStudyAnswer *answer, size_t design); // numbers.c
static inline YkStatus yk_row_status(const YkStudyAnswer *a, const double *row)
{
    return (YkStatus)row[a->axis_count];
}
static inline size_t yk_study_first(const YkStudyAnswer *a) // answer
{
    return a->axis_count + 2;
}
static inline size_t yk_study_kinds(const YkStudyAnswer *a) // answers a column of --of
{
    return a->over.name ? YK_REDUCTIONS : 1;
}
// Writes "d5.min", or "d5" for one pose; returns the quantity of the k-th answer.
void yk_study_name(const YkStudyAnswer *answer, size_t k, YkText *name);
YkQuantity yk_study_quantity(const YkStudyAnswer *answer, size_t k);

// turns.c: finds whether a drive turns back just at a limit on the way, so that designs must follow their drives in
// time. Returns false with a problem added if they cannot.
bool yk_study_check_turns(YkStudyAnswer *answer);
// Gathers a row into the sum.
void yk_study_note(YkStudyAnswer *answer, size_t design, const double *row);
YkMoments yk_study_moments(const YkStudyAnswer *answer, size_t k);
typedef struct YkTolerance { // of a column, from the derivatives: sum of |S| t, and root of the sum of (S s)^2
    double worst, root;
} YkTolerance;
double yk_study_tolerance_of(const YkStudyAnswer *answer, size_t axis);
// Returns the derivative of a column by a parameter: by the loops where they give it, otherwise by difference.
double yk_study_slope(const YkStudyAnswer *answer, size_t column, size_t axis);
YkTolerance yk_study_tolerance(const YkStudyAnswer *answer, size_t column);
size_t yk_study_count(const YkStudyAnswer *answer, YkStatus status); // designs with it

// Hands on what the writers have made so far, if it is much and the output is a file.
void yk_study_flush(YkStudyAnswer *answer, size_t most);

void yk_study_text(YkStudyAnswer *answer);
void yk_study_json(YkStudyAnswer *answer);
void yk_study_jsonl(YkStudyAnswer *answer);
void yk_study_csv(YkStudyAnswer *answer);
void yk_study_npy(YkStudyAnswer *answer);

#endif
