// The messages of ranks that share work, and how they begin and end together. Rank 0 conducts, all others serve.
#ifndef CLI_SPREAD_H
#define CLI_SPREAD_H
#include <stdint.h>
#include "ranks.h"

// Tags of messages. To rank 0: HELLO once; ROWS, a YkSpreadRows and the numbers; LOST, in place of rows; BYE, the last.
// From rank 0: WORK, a YkSpreadWork; STOP, the last.
enum { YK_SPREAD_HELLO = 1, YK_SPREAD_WORK, YK_SPREAD_ROWS, YK_SPREAD_LOST, YK_SPREAD_STOP, YK_SPREAD_BYE };
enum { YK_SPREAD_AHEAD = 2 }; // blocks that a rank has at a time: the next one waits while it computes

typedef struct YkSpreadHello {
    char version[64], place[256];
    uint64_t signature;
    int32_t is_read; // whether it could read its files
    char said[2048]; // its messages, if it could not
} YkSpreadHello;
typedef struct YkSpreadWork {
    uint64_t from, count; // designs, pieces of a search, or tiles
    YkTilePlane plane;    // of a map
} YkSpreadWork;
typedef struct YkSpreadRows {
    uint64_t from, count;
    double seconds; // it took
} YkSpreadRows;
typedef enum YkSpreadReason { YK_SPREAD_STOPPED, YK_SPREAD_MEMORY } YkSpreadReason; // of LOST, an int32_t

// Rank 0: receives the greeting of a rank and refuses one of another make with a problem. `what` is "study", and
// `files` the files that it reads.
bool yk_spread_hear_hello(YkSession *session, int rank, uint64_t signature, const char *what, const char *files);
// Takes LOST: returns whether the rank was told to stop; otherwise it ran out of memory, which becomes a problem.
bool yk_spread_hear_lost(YkSession *session, int rank);
// Tells all ranks to stop, and hears them out. Ends them all if one does not answer in time.
void yk_spread_dismiss(void);

// Other ranks: greets, with what was said on standard error if the files could not be read.
void yk_spread_say_hello(YkSession *session, uint64_t signature, bool is_read);
void yk_spread_say_lost(YkSpreadReason reason);
// Computes what is asked until rank 0 dismisses this rank. `compute` returns false after it has said LOST.
void yk_spread_serve(bool (*compute)(void *context, YkSpreadWork work), void *context);

void yk_spread_wait(double *pause); // sleeps, longer from call to call, at most a millisecond; *pause 0: anew

#endif
