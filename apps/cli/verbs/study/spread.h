// What the ranks of a study say to each other: spread.c is rank 0, serve.c all others.
#ifndef CLI_SPREAD_H
#define CLI_SPREAD_H
#include <stdint.h>

// Tags of messages. To rank 0: HELLO once; ROWS, a YkSpreadRows and the rows; LOST, in place of rows; BYE, the last.
// From rank 0: WORK, a YkSpreadWork; STOP, the last.
enum { YK_SPREAD_HELLO = 1, YK_SPREAD_WORK, YK_SPREAD_ROWS, YK_SPREAD_LOST, YK_SPREAD_STOP, YK_SPREAD_BYE };
enum { YK_SPREAD_AHEAD = 2 }; // blocks that a rank has at a time: the next one waits while it computes

typedef struct YkSpreadHello {
    char version[64], place[256];
    uint64_t signature;
    int32_t is_read; // whether it could read the study
    char said[2048]; // its messages, if it could not
} YkSpreadHello;
typedef struct YkSpreadWork {
    uint64_t from, count; // designs
} YkSpreadWork;
typedef struct YkSpreadRows {
    uint64_t from, count;
    double seconds; // it took
} YkSpreadRows;
typedef enum YkSpreadReason { YK_SPREAD_STOPPED, YK_SPREAD_MEMORY } YkSpreadReason; // of LOST, an int32_t

void yk_spread_wait(double *pause); // sleeps, longer from call to call, at most a millisecond; *pause 0: anew

#endif
