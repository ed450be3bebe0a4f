// The inside of YkStudy.
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H
#include <pthread.h>
#include <stdatomic.h>
#include <yoke/move.h>
#include <yoke/study.h>
#include "base/pace.h"
#include "base/worse.h"
#include "compile/mechanism.h"
#include "batch/batch.h"
#include "batch/pose_forces.h"
#include "solve/state.h"

enum { YK_STUDY_BLOCK = 192 }; // poses reduced at a time, lanes run at a time: their rows stay in the first two caches
enum { YK_STUDY_LANES = 512 }; // lanes that may stay from design to design

typedef struct YkJob { // one call, for all workers
    const YkStudyCase *asked;
    double *const *outputs;
    YkExtent *extents; // NULL: every pose is kept
    signed char *status;
    size_t *standing;
    atomic_size_t next; // design
    size_t chunk;
    YkProgress progress; // of the caller
    atomic_size_t done;  // designs
    atomic_bool is_stopped;
    // The calling thread waits here for the others, and is woken after every slice of their work: it alone may ask.
    pthread_mutex_t lock;
    pthread_cond_t sign;
    size_t running; // threads besides the caller's
} YkJob;

// The end of a design's range: recorded where a way along one input ended.
typedef struct YkBarrier {
    bool is_set;
    double at;
} YkBarrier;

typedef struct YkWay {    // a design's way from its start through its poses
    size_t lanes;         // lanes that were run and are surely on the way
    bool is_stepwise;     // the state moves pose by pose; before that, in lanes
    bool has_answered;    // a pose was already asked for
    YkStatus status;      // below 0: it has no start
    YkBarrier barrier[2]; // below, above
    size_t input;         // the input that the barriers limit
} YkWay;

typedef struct YkWorker {
    YkArena *arena; // of its arrays
    struct YkStudy *study;
    YkPace pace; // its states work for it
    YkVariant *variant;
    const YkMechanism *mech;
    YkState *home;         // the file's pose
    YkState *begun;        // the pose in which the design was assembled; valid once the design is set
    YkState *state, *kept; // the design's pose; the last one reached
    YkStatus home_status;
    YkBatch *batch; // lanes along the way; NULL: pose by pose
    // If other inputs gave the assembly: the variant of that machine, its pose in the file and its pose in the design;
    // otherwise NULL.
    YkVariant *base_variant;
    YkState *base_home, *base;
    YkPoseForces *forces; // pose by pose, without a batch
    YkMotion *goal;       // [input]
    YkWay way;
    double *last, *end;   // [3 * input + k]: of the last lane known to be on the way; of the last one filled in
    double *lane;         // [3 * input + k][YK_STUDY_LANES]: lanes on the way,
    double *lane_output;  // [channel][YK_STUDY_BLOCK]: their results,
    ptrdiff_t *lane_pose; // [YK_STUDY_LANES]: and the pose of each lane, or -1
    bool lane_is_pose[YK_STUDY_LANES];
    double lane_time[YK_STUDY_LANES];
    bool plans; // all designs of the job have the same few poses, so that their lanes stay
    size_t planned,
        first_stretch;     // lanes of the whole way (0: they are others); of these, those up to its first stretch
    double *planned_from;  // [input]: where they start
    const double **row;    // [3 * input + k]: the rows that the batch reads
    double **row_output;   // [channel]: and those that it writes
    double *value;         // [parameter]
    bool is_fine;          // the poses of the job lie close together
    const double **inputs; // [3 * input + k]
    const double *times;   // [pose], or NULL
    double **outputs;      // [channel]
    YkExtent *extent;      // [channel]
    size_t *count;         // [channel] poses in it
    double *block;         // [channel][YK_STUDY_BLOCK]
    signed char *block_status;
    YkJob *job;
    YkStatus worst;
} YkWorker;

typedef struct YkRemake YkRemake;

struct YkStudy {
    YkRemake *remake; // designs are machines of their own; NULL: variants
    YkWorker *worker;
    pthread_t *thread;
    size_t thread_count;
    YkChannel *channels;
    size_t channel_count, parameter_count;
    bool follows_time;
    double *own; // values of the file
    YkProgress progress;
};

// Returns whether a pose with this status counts for a channel: rates have no value at a dead point, nor forces at a
// change point.
bool yk_study_counts(YkChannel channel, YkStatus status);
// Does what the worker's job asks of one design (study.c); hands all designs out to threads (threads.c).
YkStatus yk_worker_design(YkWorker *worker, size_t design);
YkStatus yk_study_go(YkStudy *study, YkJob *job);
// Sets a design, at its start; then solves its poses at w->inputs, in one call or several: each call is the next part
// of the way.
YkStatus yk_worker_set(YkWorker *worker, const double *values);
YkStatus yk_worker_go(YkWorker *worker, double *const *outputs, signed char *status, size_t count);

// Creates the worker's states for assembling designs (start.c). Returns false with problems added, or out of memory.
bool yk_worker_start(YkWorker *worker, const YkState *state, const YkStudyOptions *options, YkProblems *problems);
// Carries the file's assembly to the values that the variant already has.
YkStatus yk_worker_begin(YkWorker *worker, const double *values);
// Puts worker->state in the pose in which the design was assembled.
YkStatus yk_worker_stand(YkWorker *worker);

// Returns whether poses [from, to) lie close enough together to be lanes of one way.
bool yk_poses_are_fine(const YkMechanism *mech, const double *const *inputs, size_t from, size_t to);

#endif
