// A machine whose parameters vary, and how far it is from the goals of its task.
#ifndef SYNTHESIS_MACHINE_FIT_H
#define SYNTHESIS_MACHINE_FIT_H
#include "base/pace.h"
#include "synthesis/task.h"
#include <yoke/batch.h>
#include <yoke/variant.h>

typedef struct YkMachineFit {
    const YkTask *task;
    YkVariant *variant;
    YkState *state;
    YkBatch *batch;
    size_t rows, misses;
    double *at;                          // [rows] values of the swept coordinate, SI
    double **value;                      // [channels][rows]
    const double **inputs;               // [3 inputs]
    signed char *status;                 // [rows]
    double *miss, *low_miss, *high_miss; // [misses]
    double *row, *A, *b;                 // of the least squares
    YkPace *pace;                        // counts the work; NULL: not watched
    double weight;                       // of what a claim lacks, over its limit, against the machine's size
} YkMachineFit;

// A set of parameters. `error` is the sum of squared, weighted misses of the goals; `cost` also has what the claims lack.
typedef struct YkMachineTry {
    double value[YK_FREE_MAX]; // SI
    double error, cost, worst;
    double lack; // the largest excess over a claim's limit, over the limit's size
} YkMachineTry;

// Prepares a fit in an arena; everything but what the arena holds is freed by yk_machine_fit_free. Returns false with a
// problem if the machine cannot be assembled or its parameters cannot vary.
bool yk_machine_fit_new(const YkTask *task, YkArena *arena, YkMachineFit *fit, YkProblems *problems);
void yk_machine_fit_free(YkMachineFit *fit);
// Judges values [channels][rows] at the rows of the swept coordinate, and fills miss[misses].
void yk_machine_judge(const YkMachineFit *fit, double *const *value, double *miss, YkMachineTry *try);
// Moves the machine with these parameters. Returns false if it does not go through its range.
bool yk_machine_measure(YkMachineFit *fit, double *miss, YkMachineTry *try);
// Improves a try by at most `steps` steps of Levenberg and Marquardt within the ranges. A gradient takes two motions a
// parameter: central differences.
bool yk_machine_improve(YkMachineFit *fit, YkMachineTry *try, size_t steps);

#endif
