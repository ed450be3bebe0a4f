// A search on all ranks of mpirun. Rank 0 gives out its pieces by demand, computes some itself and takes them in their order:
// what follows from a piece - which machine is kept, when the search ends - is decided as it is alone.
#include <stdlib.h>
#include <string.h>
#include "session.h"
#include "spread.h"
#include "stop.h"
#include "verbs/synthesize/synthesize.h"

enum { AHEAD = 3 }; // pieces that a rank has at a time

typedef struct Slot { // of piece number k: slot k modulo their number
    size_t piece;
    bool is_here;
    double *numbers;
} Slot;

struct YkSynthesisSpread {
    YkSynthesisAnswer *a;
    YkPieces *own;
    YkProgress progress;
    Slot *slots;
    size_t slot_count, width, base, next; // base: the piece that is asked for; next: the first that is not given out
    int count, ready;
    int *wants; // [rank] pieces that it can take
    char *message;
    bool is_stopped;
};

// --- rank 0

static Slot *slot_of(YkSynthesisSpread *s, size_t piece)
{
    return &s->slots[piece % s->slot_count];
}

// Pieces are given out only as far ahead as there is room for what comes back.
static bool may_give(const YkSynthesisSpread *s)
{
    return s->next < s->base + s->slot_count && s->next < yk_pieces_count(s->own);
}

static void give(YkSynthesisSpread *s)
{
    for (int round = 0; round < AHEAD; round++) // every rank gets one before any gets the next
        for (int rank = 1; rank < s->count && may_give(s); rank++) {
            if (s->wants[rank] < AHEAD - round) continue;
            YkSpreadWork work = {s->next++, 1};
            yk_ranks()->send(rank, YK_SPREAD_WORK, &work, sizeof work);
            s->wants[rank]--;
        }
}

// Keeps a piece until it is asked for. One that the search has passed by is dropped.
static void take_piece(YkSynthesisSpread *s, int rank, size_t bytes)
{
    YkSpreadRows head;
    if (bytes != sizeof head + s->width * sizeof(double)) yk_ranks()->abort(YK_EXIT_WRONG);
    yk_ranks()->receive(rank, YK_SPREAD_ROWS, s->message, bytes);
    memcpy(&head, s->message, sizeof head);
    s->wants[rank]++;
    if (head.from < s->base) return;
    Slot *slot = slot_of(s, (size_t)head.from);
    memcpy(slot->numbers, s->message + sizeof head, s->width * sizeof(double));
    slot->piece = (size_t)head.from;
    slot->is_here = true;
}

// Takes all messages that have come. Returns false if the search cannot go on; with a problem, unless it was stopped.
static bool hear(YkSynthesisSpread *s)
{
    int rank, tag;
    size_t bytes;
    while (yk_ranks()->poll(&rank, &tag, &bytes)) {
        if (tag == YK_SPREAD_ROWS) {
            take_piece(s, rank, bytes);
        } else if (tag == YK_SPREAD_LOST) {
            s->is_stopped |= yk_spread_hear_lost(s->a->session, rank);
            return false;
        } else {
            s->ready++;
            s->wants[rank] = AHEAD;
            if (!yk_spread_hear_hello(s->a->session, rank, yk_pieces_signature(s->own), "task", "task, model file"))
                return false;
        }
    }
    return true;
}

// Computes the next piece that no rank has started. Returns YK_SINGULAR if all pieces near the next one wanted are taken.
static YkStatus compute_own(YkSynthesisSpread *s)
{
    if (!may_give(s)) return YK_SINGULAR;
    Slot *slot = slot_of(s, s->next);
    YkStatus status = yk_pieces_compute(s->own, s->next, slot->numbers);
    slot->piece = s->next++;
    slot->is_here = status == YK_OK;
    return status;
}

static YkStatus get(void *context, size_t piece, double *numbers)
{
    YkSynthesisSpread *s = context;
    Slot *slot = slot_of(s, piece);
    double pause = 0, part = (double)piece / (double)yk_pieces_count(s->own);
    s->base = piece;
    if (s->next < piece) s->next = piece;
    for (;;) {
        if (!hear(s)) return s->is_stopped ? YK_STOPPED : YK_NO_MEMORY;
        if (!s->progress.goes_on(s->progress.context, part)) return YK_STOPPED;
        give(s);
        if (slot->is_here && slot->piece == piece) break;
        YkStatus status = compute_own(s);
        if (status < 0) return status;
        if (status == YK_SINGULAR) yk_spread_wait(&pause);
    }
    slot->is_here = false;
    memcpy(numbers, slot->numbers, s->width * sizeof *numbers);
    return YK_OK;
}

static bool make_room(YkSynthesisSpread *s)
{
    s->slot_count = (size_t)s->count * (AHEAD + 1) + 1;
    s->width = yk_pieces_width(s->own);
    s->slots = calloc(s->slot_count, sizeof *s->slots);
    s->wants = calloc((size_t)s->count, sizeof *s->wants);
    s->message = malloc(sizeof(YkSpreadRows) + s->width * sizeof(double));
    bool good = s->slots && s->wants && s->message;
    for (size_t k = 0; good && k < s->slot_count; k++)
        good = (s->slots[k].numbers = calloc(s->width + 1, sizeof(double))) != NULL;
    return good || yk_session_refuse(s->a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
}

// Waits until all ranks are known to be of one make: nothing is computed before.
static bool meet(YkSynthesisSpread *s)
{
    double pause = 0;
    while (s->ready < s->count - 1) {
        if (yk_stop_is_asked()) s->is_stopped = true;
        if (s->is_stopped || !hear(s)) return false;
        yk_spread_wait(&pause);
    }
    return true;
}

YkSynthesisSpread *yk_synthesis_spread(YkSynthesisAnswer *a, YkSynthesisOptions *options, YkProblems *problems)
{
    YkSynthesisSpread *s = calloc(1, sizeof *s);
    if (!s) {
        yk_session_refuse(a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
        return NULL;
    }
    *s = (YkSynthesisSpread){.a = a, .count = yk_ranks()->count(), .progress = options->progress};
    s->own = yk_pieces_new(a->task, options, problems);
    if (s->own && make_room(s) && meet(s)) {
        if (s->width > 0) options->pieces = (YkPieceSource){get, s};
        return s;
    }
    yk_synthesis_gather(s);
    return NULL;
}

void yk_synthesis_gather(YkSynthesisSpread *s)
{
    if (!s) return;
    for (size_t k = 0; s->slots && k < s->slot_count; k++) free(s->slots[k].numbers);
    free(s->slots);
    free(s->wants);
    free(s->message);
    yk_pieces_free(s->own);
    free(s);
}

// --- other ranks

typedef struct Server {
    YkPieces *pieces;
    char *message; // the head and the numbers
} Server;

static bool compute(void *context, YkSpreadWork work)
{
    const Server *server = context;
    size_t bytes = yk_pieces_width(server->pieces) * sizeof(double);
    YkSpreadRows head = {work.from, work.count, 0};
    memcpy(server->message, &head, sizeof head);
    double *numbers = (double *)(void *)(server->message + sizeof head);
    bool good = yk_pieces_compute(server->pieces, (size_t)work.from, numbers) == YK_OK;
    if (good)
        yk_ranks()->send(0, YK_SPREAD_ROWS, server->message, sizeof head + bytes);
    else
        yk_spread_say_lost(YK_SPREAD_STOPPED);
    return good;
}

int yk_synthesis_serve(YkSynthesisAnswer *a, bool is_read)
{
    YkSynthesisOptions options = yk_default_synthesis_options();
    Server server = {NULL, NULL};
    options.seed = a->seed;
    options.progress = yk_stop_progress(a->session);
    if (is_read) server.pieces = yk_pieces_new(a->task, &options, a->session->problems);
    server.message = malloc(sizeof(YkSpreadRows) + yk_pieces_width(server.pieces) * sizeof(double));
    is_read = server.pieces && server.message;
    yk_spread_say_hello(a->session, yk_pieces_signature(server.pieces), is_read);
    yk_spread_serve(compute, &server);
    yk_ranks_end();
    yk_pieces_free(server.pieces);
    free(server.message);
    return YK_EXIT_DONE; // rank 0 gives the exit code of the run
}
