// Pieces of an answer that ranks compute by demand, and rank 0 takes in their order. A piece is bytes that depend on
// its number alone. Rank 0 computes pieces too.
#ifndef CLI_HAND_OUT_H
#define CLI_HAND_OUT_H
#include "spread.h"

typedef struct YkHandOutOptions {
    YkSession *session;
    YkProgress progress;      // asked for every piece
    uint64_t signature;       // the same on all ranks
    const char *what, *files; // as for yk_spread_hear_hello
    // Computes a piece on this rank: bytes that stay until the next call. Returns a status.
    YkStatus (*compute)(void *context, YkSpreadWork work, const void **bytes, size_t *size);
    void *context;
} YkHandOutOptions;

typedef struct YkHandOut YkHandOut;
// Rank 0: waits until all ranks are known to be of one make. Returns NULL with a problem, or stopped.
YkHandOut *yk_hand_out_new(const YkHandOutOptions *options);
void yk_hand_out_free(YkHandOut *hand_out);
// Begins a series of `count` pieces, after the one before is over. Each has `work` with its own number in `from`.
// ahead: how many pieces may be out or waiting beyond the one wanted; 0: a few for each rank. Returns false when out of
// memory.
bool yk_hand_out_begin(YkHandOut *hand_out, YkSpreadWork work, size_t count, size_t ahead);
// Takes a piece, in ascending order: bytes that stay until the next call. Returns YK_OK, YK_STOPPED, or YK_NO_MEMORY,
// with a problem if a rank has failed.
YkStatus yk_hand_out_get(YkHandOut *hand_out, size_t piece, const void **bytes, size_t *size);

// Other ranks: greets, and computes what is asked until rank 0 dismisses this rank. is_read: false if this rank could
// not read its files.
void yk_hand_out_serve(const YkHandOutOptions *options, bool is_read);

#endif
