// The inside of YkStudy.
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H
#include <pthread.h>
#include <stdatomic.h>
#include <yoke/dynamics.h>
#include <yoke/move.h>
#include <yoke/study.h>
#include "compile/mechanism.h"
#include "solve/batch.h"
#include "solve/state.h"

enum { YK_STUDY_BLOCK = 96 }; // poses reduced at a time: their rows stay in the first cache

typedef struct YkJob { // a call of all workers
    const YkStudyCase *asked;
    double *const *outputs;
    YkExtent *extents; // NULL: every pose is kept
    signed char *status;
    size_t *standing;
    atomic_size_t next; // design
    size_t chunk;
} YkJob;

// Beyond it a design does not come: noted where a way along one input ended.
typedef struct YkBarrier {
    bool is_set;
    double at;
} YkBarrier;

typedef struct YkWay {    // of a design, from its start through its poses
    size_t lanes;         // that were run, and are the way's for sure
    bool is_stepwise;     // the state moves pose by pose; before that, lanes
    bool has_answered;    // a pose was asked already
    YkStatus status;      // below 0: it has no start
    YkBarrier barrier[2]; // below, above
    size_t input;         // of which the barriers are
} YkWay;

typedef struct YkWorker {
    struct YkStudy *study;
    YkVariant *variant;
    const YkMechanism *mech;
    YkState *home;         // the file's pose
    YkState *begun;        // where the design was put together; its pose only where is_placed
    YkState *state, *kept; // the design's pose; the last one that was reached
    YkStatus home_status;
    YkBatch *batch; // of lanes along the way; NULL: it goes pose by pose
    // Where other inputs say where the machine was put together: that one's variant, its pose in the file and in the
    // design; otherwise NULL.
    YkVariant *base_variant;
    YkState *base_home, *base;
    YkDynamics *dynamics;
    YkMotion *goal; // [input]
    YkWay way;
    double *last, *end;    // [3 * input + k]: of the last lane that is clear; of the last one that was put
    double *lane;          // [3 * input + k][YK_STUDY_BLOCK]: a block of lanes on the way,
    double *lane_output;   // [channel][YK_STUDY_BLOCK]: what they come to,
    ptrdiff_t *lane_pose;  // [YK_STUDY_BLOCK]: and which pose a lane is, or -1
    const double **row;    // [3 * input + k]: what the batch reads,
    double **row_output;   // [channel]: and writes
    double *value;         // [parameter]
    bool is_fine;          // the poses of the job lie close together
    const double **inputs; // [3 * input + k]
    double **outputs;      // [channel]
    YkExtent *extent;      // [channel]
    size_t *count;         // [channel] poses in it
    double *block;         // [channel][YK_STUDY_BLOCK]
    signed char *block_status;
    YkJob *job;
    YkStatus worst;
} YkWorker;

struct YkStudy {
    YkWorker *worker;
    pthread_t *thread;
    size_t thread_count;
    YkChannel *channels;
    size_t channel_count, parameter_count;
    double *own; // the file's values
    bool needs_forces;
};

// Sets a design, at its start; then its poses at w->inputs, which may come in several calls: each is the next part of
// the way.
YkStatus yk_worker_set(YkWorker *worker, const double *values);
YkStatus yk_worker_go(YkWorker *worker, double *const *outputs, signed char *status, size_t count);

// start.c: where a design is put together. The worker's states for it; false with problems added, or out of memory.
bool yk_worker_start(YkWorker *worker, const YkState *state, const YkStudyOptions *options, YkProblems *problems);
// Carries the file's assembly to the values, which the variant has already.
YkStatus yk_worker_begin(YkWorker *worker, const double *values);
// Puts worker->state there.
YkStatus yk_worker_stand(YkWorker *worker);

// Do poses [from, to) lie close enough together to be lanes of one way?
bool yk_poses_are_fine(const YkMechanism *mech, const double *const *inputs, size_t from, size_t to);
static inline YkStatus yk_worse(YkStatus a, YkStatus b)
{
    return a < 0 || b < 0 ? (a < b ? a : b) : (a > b ? a : b);
}

#endif
