// A study's request and answer, and its writers.
#ifndef CLI_STUDY_H
#define CLI_STUDY_H
#include "answer.h"
#include "range.h"
#include "verbs/sweep/sweep.h"

enum { YK_REDUCTIONS = 4 }; // least, largest, mean, range of a cycle

typedef enum YkStudyFormat { YK_STUDY_TEXT, YK_STUDY_JSON, YK_STUDY_CSV, YK_STUDY_NPY } YkStudyFormat;

typedef struct YkAxis { // a parameter that varies
    const char *name;
    double from, to; // of a grid
    size_t count;
    YkDistribution distribution; // of a sample
} YkAxis;

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
    double *times;  // [pose]; over a coordinate: NULL
    YkState *timed; // the session's state at the time that is asked
    YkState *start; // if other inputs gave the assembly: its pose with these; otherwise NULL
    YkStudy *study;
    double *rows; // [design][width]
    size_t width, done;
    bool is_interrupted;
    double *derivative, *difference;           // [column][axis], with --sensitivities
    YkStatus start_status, sensitivity_status; // below 0: the file itself has no valid pose, and no design has
} YkStudyAnswer;

// request.c: reads the whole command line and makes the study. Returns false with problems added.
bool yk_study_read(YkStudyAnswer *answer);
void yk_study_parameters(const YkStudyAnswer *answer, size_t design, double *values); // [axis]

// partial.c: keeps what is done beside the output. Reads the rows of an interrupted run; returns false with a problem
// added if they are of another study.
bool yk_partial_open(YkStudyAnswer *answer);
bool yk_partial_add(YkStudyAnswer *answer, size_t from, size_t to); // rows [from, to)
void yk_partial_close(bool is_finished);                            // finished: removes it
void yk_partial_tell(YkProblems *problems);                         // where it is, if it is: a hint to the last problem

// why.c: if designs make no machine, says why the first of them does not, as a hint to the last problem.
void yk_study_tell_why(const YkStudyAnswer *answer);

// Places in a row.
static inline double *yk_study_row(const YkStudyAnswer *a, size_t design)
{
    return a->rows + design * a->width;
}
static inline YkStatus yk_study_status(const YkStudyAnswer *a, size_t design)
{
    return (YkStatus)yk_study_row(a, design)[a->axis_count];
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

// Over the valid designs, at every pose.
typedef struct YkMoments {
    size_t count;
    double mean, deviation, least, largest;
} YkMoments;
YkMoments yk_study_moments(const YkStudyAnswer *answer, size_t k);
typedef struct YkTolerance { // of a column, from the derivatives: sum of |S| t, and root of the sum of (S s)^2
    double worst, root;
} YkTolerance;
double yk_study_tolerance_of(const YkStudyAnswer *answer, size_t axis);
YkTolerance yk_study_tolerance(const YkStudyAnswer *answer, size_t column);
size_t yk_study_count(const YkStudyAnswer *answer, YkStatus status); // designs with it

void yk_study_text(const YkStudyAnswer *answer);
void yk_study_json(const YkStudyAnswer *answer);
void yk_study_csv(const YkStudyAnswer *answer);
void yk_study_npy(const YkStudyAnswer *answer);

#endif
