// The inside of YkStudy.
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H
#include <pthread.h>
#include <stdatomic.h>
#include <yoke/dynamics.h>
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

typedef struct YkWorker {
    struct YkStudy *study;
    YkVariant *variant;
    const YkMechanism *mech;
    YkState *home, *state; // the file's pose; the one in work
    YkBatch *batch;        // NULL: forces are asked for
    YkDynamics *dynamics;
    double *value;         // [parameter]
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

// Sets a design; then its poses at w->inputs.
YkStatus yk_worker_set(YkWorker *worker, const double *values);
YkStatus yk_worker_poses(YkWorker *worker, double *const *outputs, signed char *status, size_t count);

#endif
