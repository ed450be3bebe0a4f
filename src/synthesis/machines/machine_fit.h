// A machine whose parameters vary, and how far it is from the goals of its task.
#ifndef SYNTHESIS_MACHINE_FIT_H
#define SYNTHESIS_MACHINE_FIT_H
#include "base/pace.h"
#include "batch/forces.h"
#include "compile/gradient.h"
#include "synthesis/tasks/task.h"
#include <yoke/batch.h>
#include <yoke/variant.h>

// The derivative of one miss by the value of one channel at one row.
typedef struct YkShare {
    size_t miss, row, channel;
    double weight;
} YkShare;
typedef struct YkShares {
    YkShare *item; // by rows, then by misses
    size_t count;
} YkShares;

enum { YK_FIT_LANES = 64, YK_STARTS_MAX = 256 };

typedef struct YkMachineFit {
    const YkTask *task;
    YkVariant *variant;
    YkState *state;
    YkBatch *batch;
    size_t rows, misses;
    double *at;                 // [rows] values of the swept coordinate, SI
    double **value;             // [channels][rows]
    const double **inputs;      // [3 inputs]
    signed char *status;        // [rows]
    double *miss, *next_miss;   // [misses]
    double *row, *A, *b;        // of the least squares
    YkBatch *starting;          // computes the coordinates of `start:` at the inputs of the file
    size_t *start, start_count; // their indices in the model's starts
    const double **still;       // [3 inputs]: none of them moves
    // Derivatives: poses at some rows, with all variables of the loops.
    YkGradient *gradient;
    YkBatch *placing; // computes the variables
    size_t variables;
    size_t orders;        // of derivatives by time that answers depend on, with that of order 0
    double **place;       // [orders * variables][YK_FIT_LANES]
    YkLaneForces *forces; // derivatives of the channels of forces; NULL: by differences, or there are none
    size_t *force;        // [channel]: its place among those
    double *weights, *by, *input_values;
    size_t force_count;
    double *pick_at;      // [YK_FIT_LANES]: the swept coordinate
    const double **pick;  // [3 inputs]
    double **low, **high; // [channels][YK_FIT_LANES]
    YkShares shares;
    size_t poses; // solved or linearised so far, and by differences among them
    size_t differenced;
    size_t backwards; // runs backwards through the forces of a pose
    YkPace *pace;     // counts the work; NULL: not watched
    double weight;    // of a claim's shortfall (over its limit) beside misses (over the machine's size)
} YkMachineFit;

// A set of parameters. `error`: the sum of squared, weighted misses of the goals; `cost` adds the claims' shortfall.
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
// Finds the coordinates of `start:` at these parameters, on the branches of the task's machine: value[start_count], SI.
// Returns false if the machine does not close at the inputs of the file.
bool yk_machine_start(YkMachineFit *fit, const double *parameters, double *value);
// Lists how the misses depend on the values, by rows.
void yk_machine_share(const YkMachineFit *fit, double *const *value, YkShares *shares);
// Prepares derivatives. Returns false when out of memory. machine_slopes.c
bool yk_machine_slopes_new(YkMachineFit *fit, YkArena *arena);
// Fills the derivatives of all misses, fit->row, at a try that was the last one measured: one motion, and for each miss
// transposed solutions of the loops and a run backwards through the forces, whatever the number of parameters. Misses
// without such a derivative - forces with dry friction, of redundant machines and of laws, some angles of transmission
// - take differences of two poses per parameter at each row on which they depend. Returns false if the machine comes
// apart beside the try, or an expression has no derivative.
bool yk_machine_differentiate(YkMachineFit *fit, const YkMachineTry *try);
// Improves a try by at most `steps` steps of Levenberg and Marquardt within the ranges.
bool yk_machine_improve(YkMachineFit *fit, YkMachineTry *try, size_t steps);

// machine_batch.c: draws parameters and improves the best of them, for this seed and the number of the batch; the first
// batch takes the parameters of the file. Returns false if no machine moves.
enum { YK_MACHINE_BATCHES = 200 };
bool yk_machine_batch(YkMachineFit *fit, uint64_t seed, size_t batch, YkMachineTry *best);
size_t yk_machine_batch_work(const YkTask *task); // microseconds
// Write what a batch found as numbers, and read it: numbers[yk_machine_width].
size_t yk_machine_width(const YkTask *task);
void yk_machine_pack(const YkTask *task, const YkMachineTry *try, bool is_found, double *numbers);
bool yk_machine_unpack(const YkTask *task, const double *numbers, YkMachineTry *try);

#endif
