// Forward dynamics in batches: in SIMD lanes where the machine allows, otherwise pose by pose; on several threads.
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/dynamics.h>
#include "base/problems.h"
#include "base/worse.h"
#include "solve/state.h"
#include "study/lane_motion.h"
#include "study/start.h"
#include "study/tree_batch.h"

enum { CHUNK = 1024 }; // states handed out at a time, a multiple of the lanes

typedef struct Worker {
    YkMotionBatch *batch;
    YkVariant *variant;
    YkTreeBatch *tree; // or:
    YkState *home, *state;
    YkLaneMotion *lanes; // or NULL
    bool *is_solved;     // of a chunk of states
    YkDynamics *dynamics;
    double *value, *acceleration;
    YkMotion *goal;
    YkStatus worst;
} Worker;

struct YkMotionBatch {
    Worker *worker;
    pthread_t *thread;
    size_t thread_count, parameter_count, input_count;
    double *own; // values of the file
    const YkMotionCase *asked;
    double *const *accelerations;
    signed char *status;
    atomic_size_t next;
};

// --- making

static bool start(YkMotionBatch *batch, Worker *w, const YkState *state, const char *const *parameters, size_t count,
                  YkProblems *problems)
{
    bool fits = false;
    w->batch = batch;
    w->variant = yk_variant_new(state->mech, parameters, count, problems);
    if (!w->variant) return false;
    w->tree = yk_tree_batch_new(w->variant, state, count, &fits);
    if (fits) return w->tree != NULL;
    w->home = yk_state_new(w->variant->mech);
    w->state = yk_state_new(w->variant->mech);
    w->value = calloc(count + 1, sizeof *w->value);
    w->acceleration = calloc(state->mech->input_count + 1, sizeof *w->acceleration);
    w->goal = calloc(state->mech->input_count + 1, sizeof *w->goal);
    if (!w->home || !w->state || !w->value || !w->acceleration || !w->goal) return false;
    YkStatus status = yk_study_take_home(w->home, state);
    if (status == YK_NO_MEMORY) return false;
    w->dynamics = yk_dynamics_new(w->variant->mech, NULL);
    w->is_solved = calloc(CHUNK, sizeof *w->is_solved);
    if (!w->dynamics || !w->is_solved) return false;
    if (status < 0) return true;
    w->lanes = yk_lane_motion_new(w->home, w->dynamics, CHUNK, &fits);
    return w->lanes || !fits;
}

static void end(Worker *w)
{
    yk_tree_batch_free(w->tree);
    yk_lane_motion_free(w->lanes);
    free(w->is_solved);
    yk_dynamics_free(w->dynamics);
    yk_state_free(w->home);
    yk_state_free(w->state);
    yk_variant_free(w->variant);
    free(w->value);
    free(w->acceleration);
    free(w->goal);
}

YkMotionBatch *yk_motion_batch_new(const YkState *state, const char *const *parameters, size_t parameter_count,
                                   size_t threads, YkProblems *problems)
{
    size_t errors = yk_problems_error_count(problems), count = threads > 0 ? threads : 1;
    YkMotionBatch *batch = calloc(1, sizeof *batch);
    bool good = batch != NULL;
    if (good) {
        batch->parameter_count = parameter_count;
        batch->input_count = state->mech->input_count;
        batch->worker = calloc(count, sizeof *batch->worker);
        batch->thread = calloc(count, sizeof *batch->thread);
        batch->own = calloc(parameter_count + 1, sizeof *batch->own);
        good = batch->worker && batch->thread && batch->own;
    }
    for (size_t p = 0; good && p < parameter_count; p++)
        batch->own[p] = yk_model_parameter(state->mech->model, parameters[p]);
    for (size_t t = 0; good && t < count; t++) {
        batch->thread_count++;
        good = start(batch, &batch->worker[t], state, parameters, parameter_count, t == 0 ? problems : NULL);
    }
    if (good) return batch;
    yk_motion_batch_free(batch);
    if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0},
                   "out of memory while preparing the motion of many states");
    return NULL;
}

void yk_motion_batch_free(YkMotionBatch *batch)
{
    if (!batch) return;
    for (size_t t = 0; t < batch->thread_count; t++) end(&batch->worker[t]);
    free(batch->worker);
    free(batch->thread);
    free(batch->own);
    free(batch);
}

// --- state by state

static YkStatus set_values(Worker *w, const YkMotionCase *asked, size_t k)
{
    const YkMotionBatch *batch = w->batch;
    if (batch->parameter_count == 0) return YK_OK;
    for (size_t p = 0; p < batch->parameter_count; p++)
        w->value[p] = asked->parameters && asked->parameters[p] ? asked->parameters[p][k] : batch->own[p];
    return yk_variant_set(w->variant, w->value);
}

// The values are set.
static YkStatus accelerate(Worker *w, const YkMotionCase *asked, size_t k)
{
    YkStatus status =
        yk_study_carry(w->variant, w->home, w->state, w->batch->own, w->value, w->batch->parameter_count, w->goal);
    for (size_t i = 0; status >= 0 && i < w->batch->input_count; i++) {
        if (asked->positions && asked->positions[i]) w->state->input[3 * i] = asked->positions[i][k];
        if (asked->rates && asked->rates[i]) w->state->input[3 * i + 1] = asked->rates[i][k];
    }
    if (status >= 0) status = yk_dynamics_accelerate(w->dynamics, w->state, w->acceleration);
    for (size_t i = 0; status >= 0 && i < w->batch->input_count; i++)
        if (!(w->acceleration[i] - w->acceleration[i] == 0)) status = YK_SINGULAR;
    return status == YK_REDUNDANT ? YK_OK : status;
}

static void tell(Worker *w, size_t k, YkStatus status)
{
    YkMotionBatch *batch = w->batch;
    if (batch->status) batch->status[k] = (signed char)status;
    w->worst = yk_worse(w->worst, status);
}

// Solves the states [from, to), which have the same values of the parameters: in lanes, where that settles them.
static void run_design(Worker *w, size_t from, size_t to)
{
    YkMotionBatch *batch = w->batch;
    YkStatus design = set_values(w, batch->asked, from);
    memset(w->is_solved, 0, (to - from) * sizeof *w->is_solved);
    if (design >= 0 && w->lanes &&
        !yk_lane_motion_run(w->lanes, batch->asked, from, to - from, batch->accelerations, w->is_solved))
        design = YK_NO_MEMORY;
    for (size_t k = from; k < to; k++) {
        bool is_done = design >= 0 && w->is_solved[k - from];
        YkStatus status = design < 0 ? design : is_done ? YK_OK : accelerate(w, batch->asked, k);
        for (size_t i = 0; !is_done && i < batch->input_count; i++)
            batch->accelerations[i][k] = status == YK_OK ? w->acceleration[i] : 0;
        tell(w, k, status);
    }
}

static void run_loops(Worker *w, size_t from, size_t to)
{
    bool is_one = w->batch->parameter_count == 0;
    for (size_t k = from; k < to; k = is_one ? to : k + 1) run_design(w, k, is_one ? to : k + 1);
}

// --- threads

static void *work(void *context)
{
    Worker *w = context;
    YkMotionBatch *batch = w->batch;
    w->worst = YK_OK;
    for (;;) {
        size_t from = atomic_fetch_add(&batch->next, CHUNK), count = batch->asked->count;
        if (from >= count) return NULL;
        size_t to = count - from < CHUNK ? count : from + CHUNK;
        if (w->tree)
            w->worst = yk_worse(
                w->worst, yk_tree_batch_run(w->tree, batch->asked, from, to, batch->accelerations, batch->status));
        else
            run_loops(w, from, to);
    }
}

YkStatus yk_motion_batch_run(YkMotionBatch *batch, const YkMotionCase *asked, double *const *accelerations,
                             signed char *status)
{
    size_t started = 0;
    if (asked->efforts && !batch->worker[0].tree) return YK_BAD_ARGUMENT;
    batch->asked = asked;
    batch->accelerations = accelerations;
    batch->status = status;
    atomic_init(&batch->next, 0);
    while (started + 1 < batch->thread_count && (started + 1) * CHUNK < asked->count &&
           pthread_create(&batch->thread[started], NULL, work, &batch->worker[started + 1]) == 0)
        started++;
    work(&batch->worker[0]);
    YkStatus worst = batch->worker[0].worst;
    for (size_t t = 0; t < started; t++) {
        pthread_join(batch->thread[t], NULL);
        worst = yk_worse(worst, batch->worker[t + 1].worst);
    }
    return worst;
}
