// The functions that the plugin yoke-mpi gives the command: messages between ranks, and nothing else.
#ifndef CLI_RANKS_TABLE_H
#define CLI_RANKS_TABLE_H
#include <stdbool.h>
#include <stddef.h>

enum { YK_RANKS_INTERFACE = 1 };
#define YK_RANKS_ENTRY "yk_ranks_open"

typedef struct YkRanks {
    int interface;             // YK_RANKS_INTERFACE of the headers that it was built with
    const char *yoke;          // the version of yoke that it belongs to
    const char *(*made)(void); // of its libraries, "Open MPI v4.1.4"
    bool (*begin)(void);       // returns false if that is impossible
    int (*rank)(void);
    int (*count)(void);
    void (*send)(int to, int tag, const void *data, size_t bytes);
    // Returns whether a message has come: from which rank, with which tag, how long.
    bool (*poll)(int *from, int *tag, size_t *bytes);
    void (*receive)(int from, int tag, void *data, size_t bytes);
    void (*end)(void);
    void (*abort)(int exit_code); // ends all ranks at once; does not return
    const char *(*place)(void);   // the computer's name
} YkRanks;
typedef const YkRanks *(*YkRanksOpen)(void);

#endif
