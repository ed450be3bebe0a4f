// Rank 0 of a study: gives blocks of designs to whoever asks, computes some itself, and writes the rows in order.
//
// The size of a block follows the speed of the rank that gets it, and shrinks towards the end, so that all finish
// together (guided self-scheduling: Polychronopoulos & Kuck 1987). Few blocks are out at a time: rows that came too
// early wait in memory, and a slow rank holds up the others before they are many.
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "session.h"
#include "spread.h"
#include "stop.h"
#include "verbs/study/study.h"

static const double block_seconds = 0.2, seconds_per_rank = 5e-4; // s
static const double shortest_pause = 2e-5, longest_pause = 1e-2;  // s
enum { FIRST_BLOCK = 64, BLOCK_BYTES = 1 << 23, SMALLEST_BYTES = 1 << 16, HELD_BYTES = 1 << 28 };

typedef struct Early { // rows that have come, in the order of their designs
    uint64_t from, count;
    const double *rows;
    void *memory; // in which they are
    struct Early *next;
} Early;

typedef struct Peer {
    bool is_ready;
    int wants;      // blocks that it can take
    double seconds; // a design, by its last block; 0: not known
} Peer;

typedef struct Own { // rank 0's own block, computed beside
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t sign, news; // to the thread; from it
    bool is_running, is_due, is_done, ends;
    YkSpreadWork work;
    double *rows, seconds;
    YkStatus status;
    YkStudyAnswer *answer;
} Own;

typedef struct Spread {
    YkStudyAnswer *a;
    Peer *peers; // [rank]; 0 is this one
    int count;
    uint64_t next; // the first design that has not been handed out
    size_t out, most_out,
        most_rows; // blocks that are given and not yet written; their largest number; rows of the largest
    Early *early;
    Own own;
    bool is_stopped;
} Spread;

// --- messages of failures

static bool run_out(Spread *s)
{
    return yk_session_refuse_for_memory(s->a->session);
}

static bool hear_lost(Spread *s, int rank)
{
    s->is_stopped = yk_spread_hear_lost(s->a->session, rank);
    if (!s->is_stopped) yk_partial_tell(s->a);
    return s->is_stopped;
}

static bool hear_hello(Spread *s, int rank)
{
    s->peers[rank].is_ready = true;
    s->peers[rank].wants = YK_SPREAD_AHEAD;
    return yk_spread_hear_hello(s->a->session, rank, yk_study_signature(s->a), "study",
                                "model file, file of tolerances");
}

// --- rows

// Keeps rows until their turn. Takes their memory over.
static bool keep(Spread *s, uint64_t from, uint64_t count, const double *rows, void *memory)
{
    Early *early = malloc(sizeof *early), **at = &s->early;
    if (!early) {
        free(memory);
        return run_out(s);
    }
    while (*at && (*at)->from < from) at = &(*at)->next;
    *early = (Early){from, count, rows, memory, *at};
    *at = early;
    return true;
}

// Writes all rows whose turn it is.
static bool write_rows(Spread *s)
{
    bool good = true;
    while (good && s->early && s->early->from == s->a->done) {
        Early *early = s->early;
        s->early = early->next;
        s->out--;
        good = yk_study_take(s->a, early->rows, (size_t)early->count);
        free(early->memory);
        free(early);
    }
    return good;
}

// --- work

// Returns the next block for a rank; count 0: there is none now.
static YkSpreadWork next_work(Spread *s, int rank)
{
    uint64_t left = s->a->design_count - s->next, count = FIRST_BLOCK, fair = left / (2 * (uint64_t)s->count) + 1;
    double target = block_seconds + seconds_per_rank * s->count, seconds = s->peers[rank].seconds;
    if (left == 0 || s->out >= s->most_out) return (YkSpreadWork){.count = 0};
    if (seconds > 0) count = target / seconds < (double)s->most_rows ? (uint64_t)(target / seconds) + 1 : s->most_rows;
    if (count > fair) count = fair;
    if (count > s->most_rows) count = s->most_rows;
    YkSpreadWork work = {.from = s->next, .count = count};
    s->next += count;
    s->out++;
    return work;
}

static void give_work(Spread *s)
{
    for (int rank = 1; rank < s->count; rank++) {
        Peer *peer = &s->peers[rank];
        while (peer->is_ready && peer->wants > 0) {
            YkSpreadWork work = next_work(s, rank);
            if (work.count == 0) return;
            yk_ranks()->send(rank, YK_SPREAD_WORK, &work, sizeof work);
            peer->wants--;
        }
    }
}

static bool take_rows(Spread *s, int rank, size_t bytes)
{
    YkSpreadRows head;
    char *message = malloc(bytes + 1);
    if (!message) return run_out(s);
    if (bytes < sizeof head) yk_ranks()->abort(YK_EXIT_WRONG);
    yk_ranks()->receive(rank, YK_SPREAD_ROWS, message, bytes);
    memcpy(&head, message, sizeof head);
    s->peers[rank].wants++;
    if (head.count > 0) s->peers[rank].seconds = (head.seconds + 1e-7) / (double)head.count;
    return keep(s, head.from, head.count, (const double *)(const void *)(message + sizeof head), message);
}

// Takes one message. Returns false with a problem added, or stopped.
static bool hear(Spread *s, int rank, int tag, size_t bytes)
{
    if (tag == YK_SPREAD_ROWS) return take_rows(s, rank, bytes);
    if (tag == YK_SPREAD_HELLO) return hear_hello(s, rank);
    if (tag == YK_SPREAD_LOST) return hear_lost(s, rank);
    yk_ranks()->receive(rank, tag, NULL, 0);
    return true;
}

// --- rank 0's own blocks

static void *work_beside(void *context)
{
    Own *own = context;
    const YkDesigns designs = yk_study_designs(own->answer);
    const YkRowCase asked = yk_study_case(own->answer, &designs);
    pthread_mutex_lock(&own->lock);
    while (!own->ends) {
        if (!own->is_due) {
            pthread_cond_wait(&own->sign, &own->lock);
            continue;
        }
        own->is_due = false;
        pthread_mutex_unlock(&own->lock);
        double start = yk_stop_now();
        YkStatus status = yk_study_rows(own->answer->study, &asked, own->work.from, (size_t)own->work.count, own->rows);
        pthread_mutex_lock(&own->lock);
        own->status = status;
        own->seconds = yk_stop_now() - start;
        own->is_done = true;
        pthread_cond_signal(&own->news);
    }
    pthread_mutex_unlock(&own->lock);
    return NULL;
}

// Begins the thread; without it rank 0 only writes.
static void begin_own(Spread *s)
{
    Own *own = &s->own;
    own->answer = s->a;
    pthread_mutex_init(&own->lock, NULL);
    pthread_cond_init(&own->sign, NULL);
    pthread_cond_init(&own->news, NULL);
    own->is_running = pthread_create(&own->thread, NULL, work_beside, own) == 0;
    s->peers[0].wants = own->is_running ? 1 : 0;
}

static void end_own(Spread *s)
{
    Own *own = &s->own;
    pthread_mutex_lock(&own->lock);
    own->ends = true;
    pthread_cond_signal(&own->sign);
    pthread_mutex_unlock(&own->lock);
    if (own->is_running) pthread_join(own->thread, NULL);
    pthread_cond_destroy(&own->sign);
    pthread_cond_destroy(&own->news);
    pthread_mutex_destroy(&own->lock);
    free(own->rows);
}

// Waits for rank 0's own block or for a while, longer from call to call: messages of others can wait, since each rank
// has a block ahead.
static void wait_for_news(Spread *s, double *pause)
{
    struct timespec until;
    *pause = *pause == 0 ? shortest_pause : *pause < longest_pause / 2 ? *pause * 2 : longest_pause;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += (long)(*pause * 1e9);
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    pthread_mutex_lock(&s->own.lock);
    if (!s->own.is_done) pthread_cond_timedwait(&s->own.news, &s->own.lock, &until);
    pthread_mutex_unlock(&s->own.lock);
}

static bool take_own(Spread *s)
{
    Own *own = &s->own;
    pthread_mutex_lock(&own->lock);
    bool is_done = own->is_done;
    own->is_done = false;
    pthread_mutex_unlock(&own->lock);
    if (!is_done) return true;
    s->is_stopped |= own->status == YK_STOPPED;
    if (own->status == YK_STOPPED) return true;
    if (own->status != YK_OK) return run_out(s);
    s->peers[0].wants = 1;
    s->peers[0].seconds = (own->seconds + 1e-7) / (double)own->work.count;
    double *rows = own->rows;
    own->rows = NULL;
    return keep(s, own->work.from, own->work.count, rows, rows);
}

static bool give_own(Spread *s)
{
    Own *own = &s->own;
    if (s->peers[0].wants == 0) return true;
    YkSpreadWork work = next_work(s, 0);
    if (work.count == 0) return true;
    double *rows = calloc((size_t)work.count * s->a->width + 1, sizeof *rows);
    if (!rows) return run_out(s);
    s->peers[0].wants = 0;
    pthread_mutex_lock(&own->lock);
    own->work = work;
    own->rows = rows;
    own->is_due = true;
    pthread_cond_signal(&own->sign);
    pthread_mutex_unlock(&own->lock);
    return true;
}

// --- the whole

static bool are_all_ready(const Spread *s)
{
    for (int rank = 1; rank < s->count; rank++)
        if (!s->peers[rank].is_ready) return false;
    return true;
}

static bool conduct(Spread *s)
{
    YkStudyAnswer *a = s->a;
    double pause = 0;
    bool good = true, are_ready = false;
    yk_study_show(a, false);
    while (good && !s->is_stopped && (a->done < a->design_count || !are_ready)) {
        int rank, tag;
        size_t bytes;
        bool has_news = yk_ranks()->poll(&rank, &tag, &bytes);
        if (has_news) good = hear(s, rank, tag, bytes);
        are_ready = are_ready || are_all_ready(s);
        good = good && take_own(s) && write_rows(s);
        if (good && are_ready) { // nothing is computed before all are known to be of one make
            good = give_own(s);
            give_work(s);
        }
        s->is_stopped |= yk_stop_is_asked();
        yk_study_show(a, false);
        if (has_news)
            pause = 0;
        else
            wait_for_news(s, &pause);
    }
    yk_study_show(a, true);
    return good;
}

static size_t most_rows(const YkStudyAnswer *a, size_t most_out)
{
    size_t bytes = HELD_BYTES / most_out;
    if (bytes > BLOCK_BYTES) bytes = BLOCK_BYTES;
    if (bytes < SMALLEST_BYTES) bytes = SMALLEST_BYTES;
    return bytes / (a->width * sizeof(double)) + 1;
}

bool yk_study_spread(YkStudyAnswer *a)
{
    int count = yk_ranks()->count();
    Spread s = {.a = a, .count = count, .next = a->done, .most_out = (size_t)count * 4 + 4};
    s.peers = calloc((size_t)count, sizeof *s.peers);
    s.most_rows = most_rows(a, s.most_out);
    bool good = s.peers || run_out(&s);
    if (good) {
        begin_own(&s);
        good = conduct(&s);
        end_own(&s);
    }
    yk_spread_dismiss();
    while (s.early) {
        Early *next = s.early->next;
        free(s.early->memory);
        free(s.early);
        s.early = next;
    }
    free(s.peers);
    return good;
}
