// Hands designs out to threads, and lets the caller watch: workers wake the calling thread after every slice of their
// work, and it alone asks.
#include <pthread.h>
#include "study/study.h"

// --- asking

static bool ask_caller(YkJob *job)
{
    double part = (double)atomic_load(&job->done) / (double)(job->asked->design_count + 1);
    if (!atomic_load(&job->is_stopped) && !job->progress.goes_on(job->progress.context, part))
        atomic_store(&job->is_stopped, true);
    return !atomic_load(&job->is_stopped);
}

static bool go_on_as_caller(void *context, double part)
{
    (void)part; // of all designs, not of this worker's
    return ask_caller(context);
}

static bool go_on_beside(void *context, double part)
{
    YkJob *job = context;
    (void)part;
    pthread_mutex_lock(&job->lock);
    pthread_cond_signal(&job->sign);
    pthread_mutex_unlock(&job->lock);
    return !atomic_load(&job->is_stopped);
}

static void watch(YkWorker *w, YkJob *job, bool is_caller)
{
    YkProgress progress = {is_caller ? go_on_as_caller : go_on_beside, job};
    w->pace = (YkPace){.progress = job->progress.goes_on ? progress : (YkProgress){0}, .to = 1};
}

// --- working

static void work(YkWorker *w)
{
    YkJob *job = w->job;
    size_t designs = job->asked->design_count;
    while (!atomic_load(&job->is_stopped)) {
        size_t from = atomic_fetch_add(&job->next, job->chunk), to = from + job->chunk;
        if (from >= designs) return;
        for (size_t d = from; d < to && d < designs && !w->pace.is_stopped; d++) {
            w->worst = yk_worse(w->worst, yk_worker_design(w, d));
            atomic_fetch_add(&job->done, 1);
        }
    }
}

static void *work_beside(void *context)
{
    YkWorker *w = context;
    YkJob *job = w->job;
    work(w);
    pthread_mutex_lock(&job->lock);
    job->running--;
    pthread_cond_signal(&job->sign);
    pthread_mutex_unlock(&job->lock);
    return NULL;
}

// Waits for the other threads, and asks the caller meanwhile.
static void wait(YkJob *job)
{
    pthread_mutex_lock(&job->lock);
    while (job->running > 0) {
        pthread_cond_wait(&job->sign, &job->lock);
        pthread_mutex_unlock(&job->lock);
        if (job->progress.goes_on) ask_caller(job);
        pthread_mutex_lock(&job->lock);
    }
    pthread_mutex_unlock(&job->lock);
}

static size_t start_threads(YkStudy *study, YkJob *job)
{
    size_t started = 0;
    pthread_mutex_lock(&job->lock);
    while (started + 1 < study->thread_count && started + 1 < job->asked->design_count &&
           pthread_create(&study->thread[started], NULL, work_beside, &study->worker[started + 1]) == 0)
        started++;
    job->running = started;
    pthread_mutex_unlock(&job->lock);
    return started;
}

// The calling thread is the first worker; if a thread cannot be started, the others do all the work.
static YkStatus run(YkStudy *study, YkJob *job)
{
    size_t started = start_threads(study, job);
    if (!job->progress.goes_on || ask_caller(job)) work(&study->worker[0]);
    wait(job);
    YkStatus worst = study->worker[0].worst;
    for (size_t t = 0; t < started; t++) {
        pthread_join(study->thread[t], NULL);
        worst = yk_worse(worst, study->worker[t + 1].worst);
    }
    return atomic_load(&job->is_stopped) ? YK_STOPPED : worst;
}

YkStatus yk_study_go(YkStudy *study, YkJob *job)
{
    const YkStudyCase *asked = job->asked;
    bool is_fine = asked->inputs && !asked->inputs_per_design &&
                   yk_poses_are_fine(study->worker[0].mech, asked->inputs, 0, asked->pose_count);
    job->progress = study->progress;
    job->chunk = asked->design_count / (study->thread_count * 16) + 1;
    if (job->chunk > 256) job->chunk = 256;
    for (size_t t = 0; t < study->thread_count; t++) {
        YkWorker *w = &study->worker[t];
        w->job = job;
        w->worst = YK_OK;
        w->is_fine = is_fine;
        w->plans = asked->inputs && !asked->inputs_per_design && asked->pose_count <= YK_STUDY_BLOCK;
        w->planned = 0;
        watch(w, job, t == 0);
    }
    if (pthread_mutex_init(&job->lock, NULL) != 0) return YK_NO_MEMORY;
    YkStatus status = YK_NO_MEMORY;
    if (pthread_cond_init(&job->sign, NULL) == 0) {
        status = run(study, job);
        pthread_cond_destroy(&job->sign);
    }
    pthread_mutex_destroy(&job->lock);
    for (size_t t = 0; t < study->thread_count; t++) study->worker[t].plans = false; // others may ask for other poses
    return status;
}
