// A search on several threads: they compute its pieces ahead, and the search takes them in their order. The
// consequences of a piece - which machine is kept, when the search ends - are decided as on one thread, so the answer
// has the same bits.
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "session.h"
#include "verbs/synthesize/synthesize.h"

enum { AHEAD = 4, NONE = -1 }; // pieces ahead for each thread

typedef struct Slot {
    long long piece; // whose numbers are here, or NONE
    double *numbers;
} Slot;

typedef struct Worker {
    YkSynthesisThreads *all;
    YkPieces *pieces;
    double *numbers;
    pthread_t thread;
} Worker;

struct YkSynthesisThreads {
    YkProgress progress; // of the calling thread, which alone asks
    Worker *worker;
    Slot *slot; // piece k is put in slot[k % slots]
    size_t count, started, slots, width, pieces;
    pthread_mutex_t lock;
    pthread_cond_t sign; // a piece is there, or there is room for others
    size_t base, next;   // the piece that the search waits for; the next that no thread has begun
    YkStatus status;     // a worker's failure
    atomic_bool is_stopped;
};

static bool goes_on_beside(void *context, double part)
{
    const YkSynthesisThreads *t = context;
    (void)part; // of this worker's pieces
    return !atomic_load(&t->is_stopped);
}

// --- workers

// Waits until there is a piece to begin. Returns false when the search has ended. The lock is held.
static bool wait_for_work(YkSynthesisThreads *t)
{
    while (!atomic_load(&t->is_stopped) && (t->next >= t->pieces || t->next >= t->base + t->slots))
        pthread_cond_wait(&t->sign, &t->lock);
    return !atomic_load(&t->is_stopped);
}

static void *work(void *context)
{
    Worker *w = context;
    YkSynthesisThreads *t = w->all;
    pthread_mutex_lock(&t->lock);
    while (wait_for_work(t)) {
        size_t piece = t->next++;
        pthread_mutex_unlock(&t->lock);
        YkStatus status = yk_pieces_compute(w->pieces, piece, w->numbers);
        pthread_mutex_lock(&t->lock);
        Slot *slot = &t->slot[piece % t->slots];
        if (status < 0 && t->status >= 0) t->status = status;
        if (piece >= t->base) { // otherwise the search has passed it by
            memcpy(slot->numbers, w->numbers, t->width * sizeof *w->numbers);
            slot->piece = (long long)piece;
        }
        pthread_cond_broadcast(&t->sign);
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

// --- the search

// Waits some time for a sign. The lock is held.
static void wait_a_little(YkSynthesisThreads *t)
{
    enum { NANOSECONDS = 20000000, SECOND = 1000000000 };
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += NANOSECONDS;
    until.tv_sec += until.tv_nsec / SECOND;
    until.tv_nsec %= SECOND;
    pthread_cond_timedwait(&t->sign, &t->lock, &until);
}

static YkStatus get(void *context, size_t piece, double *numbers)
{
    YkSynthesisThreads *t = context;
    Slot *slot = &t->slot[piece % t->slots];
    double part = (double)piece / (double)t->pieces;
    bool goes_on = true;
    pthread_mutex_lock(&t->lock);
    t->base = piece;
    if (t->next < piece) t->next = piece;
    pthread_cond_broadcast(&t->sign);
    while (goes_on && slot->piece != (long long)piece && t->status >= 0) {
        wait_a_little(t);
        pthread_mutex_unlock(&t->lock);
        goes_on = t->progress.goes_on(t->progress.context, part);
        pthread_mutex_lock(&t->lock);
    }
    YkStatus status = !goes_on ? YK_STOPPED : slot->piece == (long long)piece ? YK_OK : t->status;
    if (status >= 0) memcpy(numbers, slot->numbers, t->width * sizeof *numbers);
    pthread_mutex_unlock(&t->lock);
    return status;
}

// --- beginning and end

static bool make_workers(YkSynthesisThreads *t, YkSynthesisAnswer *a, const YkSynthesisOptions *options,
                         YkProblems *problems)
{
    YkSynthesisOptions own = *options;
    own.progress = (YkProgress){goes_on_beside, t};
    t->worker = calloc(t->count, sizeof *t->worker);
    for (size_t k = 0; t->worker && k < t->count; k++) {
        Worker *w = &t->worker[k];
        w->all = t;
        w->pieces = yk_pieces_new(a->task, &own, problems);
        t->width = yk_pieces_width(w->pieces);
        t->pieces = yk_pieces_count(w->pieces);
        w->numbers = w->pieces ? calloc(t->width + 1, sizeof *w->numbers) : NULL;
        if (!w->numbers) return false;
        if (t->width == 0) return true; // not sought in pieces
    }
    t->slots = t->count * AHEAD;
    t->slot = t->worker ? calloc(t->slots, sizeof *t->slot) : NULL;
    for (size_t k = 0; t->slot && k < t->slots; k++) {
        t->slot[k].piece = NONE;
        if (!(t->slot[k].numbers = calloc(t->width, sizeof(double)))) return false;
    }
    return t->slot != NULL;
}

YkSynthesisThreads *yk_synthesis_threads(YkSynthesisAnswer *a, YkSynthesisOptions *options, YkProblems *problems)
{
    YkSynthesisThreads *t = calloc(1, sizeof *t);
    size_t before = yk_problems_count(problems);
    if (t) {
        *t = (YkSynthesisThreads){.progress = options->progress, .count = a->threads};
        pthread_mutex_init(&t->lock, NULL);
        pthread_cond_init(&t->sign, NULL);
    }
    if (!t || !make_workers(t, a, options, problems)) {
        if (yk_problems_count(problems) == before) yk_session_refuse_for_memory(a->session);
        yk_synthesis_join(t);
        return NULL;
    }
    while (t->width > 0 && t->started < t->count &&
           pthread_create(&t->worker[t->started].thread, NULL, work, &t->worker[t->started]) == 0)
        t->started++;
    if (t->started > 0) options->pieces = (YkPieceSource){get, t};
    return t;
}

void yk_synthesis_join(YkSynthesisThreads *t)
{
    if (!t) return;
    pthread_mutex_lock(&t->lock);
    atomic_store(&t->is_stopped, true);
    pthread_cond_broadcast(&t->sign);
    pthread_mutex_unlock(&t->lock);
    for (size_t k = 0; k < t->started; k++) pthread_join(t->worker[k].thread, NULL);
    for (size_t k = 0; t->worker && k < t->count; k++) {
        yk_pieces_free(t->worker[k].pieces);
        free(t->worker[k].numbers);
    }
    for (size_t k = 0; t->slot && k < t->slots; k++) free(t->slot[k].numbers);
    free(t->slot);
    free(t->worker);
    pthread_cond_destroy(&t->sign);
    pthread_mutex_destroy(&t->lock);
    free(t);
}
