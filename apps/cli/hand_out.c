// Gives out pieces on demand and takes them in order, so that the consequences of a piece are decided as in one
// process.
#include "hand_out.h"
#include <stdlib.h>
#include <string.h>
#include "session.h"
#include "stop.h"

enum { AHEAD = 3 }; // pieces that a rank has at a time

typedef struct Slot { // of piece number k: slot k modulo their number
    size_t piece, size;
    bool is_here;
    char *bytes;
} Slot;

struct YkHandOut {
    YkHandOutOptions options;
    YkSpreadWork work;
    Slot *slots;
    size_t slot_count, pieces, base, next; // base: the piece that is asked for; next: the first that is not given out
    int count, ready;
    int *wants; // [rank] pieces that it can take
    bool is_stopped;
};

static bool run_out(YkHandOut *h)
{
    return yk_session_refuse_for_memory(h->options.session);
}

// --- rank 0

static Slot *slot_of(YkHandOut *h, size_t piece)
{
    return &h->slots[piece % h->slot_count];
}

// Pieces are given out only as far ahead as there is room for what comes back.
static bool may_give(const YkHandOut *h)
{
    return h->next < h->base + h->slot_count && h->next < h->pieces;
}

static YkSpreadWork next_work(YkHandOut *h)
{
    YkSpreadWork work = h->work;
    work.from = h->next++;
    work.count = 1;
    return work;
}

static void give(YkHandOut *h)
{
    for (int round = 0; round < AHEAD; round++) // every rank gets one before any gets the next
        for (int rank = 1; rank < h->count && may_give(h); rank++) {
            if (h->wants[rank] < AHEAD - round) continue;
            YkSpreadWork work = next_work(h);
            yk_ranks()->send(rank, YK_SPREAD_WORK, &work, sizeof work);
            h->wants[rank]--;
        }
}

// Keeps a piece until it is asked for. Takes the bytes over.
static void keep(YkHandOut *h, size_t piece, char *bytes, size_t size)
{
    Slot *slot = slot_of(h, piece);
    free(slot->bytes);
    *slot = (Slot){piece, size, true, bytes};
}

// Takes a message with a piece. One that is no longer wanted is dropped.
static bool take_piece(YkHandOut *h, int rank, size_t bytes)
{
    YkSpreadRows head;
    if (bytes < sizeof head) yk_ranks()->abort(YK_EXIT_WRONG);
    char *message = malloc(bytes);
    if (!message) return run_out(h);
    yk_ranks()->receive(rank, YK_SPREAD_ROWS, message, bytes);
    memcpy(&head, message, sizeof head);
    h->wants[rank]++;
    if (head.from < h->base || head.from >= h->pieces) {
        free(message);
        return true;
    }
    memmove(message, message + sizeof head, bytes - sizeof head);
    keep(h, (size_t)head.from, message, bytes - sizeof head);
    return true;
}

static bool hear_hello(YkHandOut *h, int rank)
{
    h->ready++;
    h->wants[rank] = AHEAD;
    return yk_spread_hear_hello(h->options.session, rank, h->options.signature, h->options.what, h->options.files);
}

// Takes all messages that have come. Returns false if it cannot go on; with a problem, unless it was stopped.
static bool hear(YkHandOut *h)
{
    int rank, tag;
    size_t bytes;
    bool good = true;
    while (good && yk_ranks()->poll(&rank, &tag, &bytes)) {
        if (tag == YK_SPREAD_ROWS) {
            good = take_piece(h, rank, bytes);
        } else if (tag == YK_SPREAD_LOST) {
            h->is_stopped |= yk_spread_hear_lost(h->options.session, rank);
            good = false;
        } else {
            good = hear_hello(h, rank);
        }
    }
    return good;
}

// Computes the next piece that no rank has begun. Returns YK_SINGULAR if all pieces near the next one wanted are taken.
static YkStatus compute_own(YkHandOut *h)
{
    const void *bytes = NULL;
    size_t size = 0;
    if (!may_give(h)) return YK_SINGULAR;
    YkSpreadWork work = next_work(h);
    YkStatus status = h->options.compute(h->options.context, work, &bytes, &size);
    if (status < 0) return status;
    char *own = malloc(size + 1);
    if (!own) return YK_NO_MEMORY;
    memcpy(own, bytes, size);
    keep(h, (size_t)work.from, own, size);
    return YK_OK;
}

YkStatus yk_hand_out_get(YkHandOut *h, size_t piece, const void **bytes, size_t *size)
{
    Slot *slot = slot_of(h, piece);
    double pause = 0, part = (double)piece / (double)h->pieces;
    h->base = piece;
    if (h->next < piece) h->next = piece;
    for (;;) {
        if (!hear(h)) return h->is_stopped ? YK_STOPPED : YK_NO_MEMORY;
        if (!h->options.progress.goes_on(h->options.progress.context, part)) return YK_STOPPED;
        give(h);
        if (slot->is_here && slot->piece == piece) break;
        YkStatus status = compute_own(h);
        if (status < 0) return status;
        if (status == YK_SINGULAR) yk_spread_wait(&pause);
    }
    slot->is_here = false;
    *bytes = slot->bytes;
    *size = slot->size;
    return YK_OK;
}

// Waits until all ranks are known to be of one make: nothing is computed before.
static bool meet(YkHandOut *h)
{
    double pause = 0;
    while (h->ready < h->count - 1) {
        if (yk_stop_is_asked()) h->is_stopped = true;
        if (h->is_stopped || !hear(h)) return false;
        yk_spread_wait(&pause);
    }
    return true;
}

YkHandOut *yk_hand_out_new(const YkHandOutOptions *options)
{
    YkHandOut *h = calloc(1, sizeof *h);
    if (!h) {
        yk_session_refuse_for_memory(options->session);
        return NULL;
    }
    *h = (YkHandOut){.options = *options, .count = yk_ranks()->count()};
    h->wants = calloc((size_t)h->count, sizeof *h->wants);
    if (!h->wants) run_out(h);
    if (h->wants && meet(h)) return h;
    yk_hand_out_free(h);
    return NULL;
}

static void drop_slots(YkHandOut *h)
{
    for (size_t k = 0; k < h->slot_count; k++) free(h->slots[k].bytes);
    free(h->slots);
    h->slots = NULL;
    h->slot_count = 0;
}

bool yk_hand_out_begin(YkHandOut *h, YkSpreadWork work, size_t count, size_t ahead)
{
    drop_slots(h);
    h->work = work;
    h->pieces = count;
    h->base = h->next = 0;
    h->slot_count = ahead > 0 ? ahead : (size_t)h->count * (AHEAD + 1) + 1;
    h->slots = calloc(h->slot_count, sizeof *h->slots);
    if (!h->slots) h->slot_count = 0;
    return h->slots || run_out(h);
}

void yk_hand_out_free(YkHandOut *h)
{
    if (!h) return;
    drop_slots(h);
    free(h->wants);
    free(h);
}

// --- other ranks

static bool compute(void *context, YkSpreadWork work)
{
    const YkHandOutOptions *options = context;
    YkSpreadRows head = {work.from, work.count, 0};
    const void *bytes = NULL;
    size_t size = 0;
    YkStatus status = options->compute(options->context, work, &bytes, &size);
    char *message = status < 0 ? NULL : malloc(sizeof head + size);
    if (message) {
        memcpy(message, &head, sizeof head);
        if (size > 0) memcpy(message + sizeof head, bytes, size);
        yk_ranks()->send(0, YK_SPREAD_ROWS, message, sizeof head + size);
        free(message);
        return true;
    }
    yk_spread_say_lost(status == YK_STOPPED ? YK_SPREAD_STOPPED : YK_SPREAD_MEMORY);
    return false;
}

void yk_hand_out_serve(const YkHandOutOptions *options, bool is_read)
{
    YkHandOutOptions own = *options;
    yk_spread_say_hello(own.session, own.signature, is_read);
    yk_spread_serve(compute, &own);
    yk_ranks_end();
}
