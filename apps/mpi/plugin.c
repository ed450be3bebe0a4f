// The plugin yoke-mpi: messages between the ranks of Open MPI, for the command (apps/cli/ranks_table.h).
#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/version.h>
#include "ranks_table.h"

static const char *made(void)
{
    static char text[MPI_MAX_LIBRARY_VERSION_STRING];
    int length = 0;
    MPI_Get_library_version(text, &length);
    text[strcspn(text, ",")] = '\0'; // "Open MPI v4.1.4, package: ..."
    return text;
}

// Begins MPI, whose calls all come from one thread. Returns false if it has already begun or ended in this process.
static bool begin(void)
{
    int has_begun = 0, given = 0;
    return MPI_Initialized(&has_begun) == MPI_SUCCESS && !has_begun &&
           MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &given) == MPI_SUCCESS && given >= MPI_THREAD_FUNNELED;
}

static int rank(void)
{
    int k = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &k);
    return k;
}

static int count(void)
{
    int k = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &k);
    return k;
}

// A message is at most INT_MAX bytes: blocks are some megabytes. More is a fault of the command, and ends the run.
static int length_of(size_t bytes)
{
    if (bytes > INT_MAX) MPI_Abort(MPI_COMM_WORLD, 2);
    return (int)bytes;
}

// --- messages on their way: MPI_Send would wait for the receiver, and keep a processor busy meanwhile

enum { SMALL = 1024, PENDING_MOST = 8 };

static struct {
    MPI_Request request;
    void *data;
} pending[PENDING_MOST];
static int pending_count;

static void forget(int index)
{
    free(pending[index].data);
    pending[index] = pending[--pending_count];
}

// Frees the messages that have arrived.
static void tidy_up(void)
{
    for (int k = pending_count - 1; k >= 0; k--) {
        int is_done = 0;
        MPI_Test(&pending[k].request, &is_done, MPI_STATUS_IGNORE);
        if (is_done) forget(k);
    }
}

static void wait_for_one(void)
{
    MPI_Wait(&pending[0].request, MPI_STATUS_IGNORE);
    forget(0);
}

static void send(int to, int tag, const void *data, size_t bytes)
{
    int length = length_of(bytes);
    tidy_up();
    if (pending_count == PENDING_MOST) wait_for_one();
    void *copy = bytes > SMALL ? malloc(bytes) : NULL;
    if (!copy) {
        MPI_Send(data, length, MPI_BYTE, to, tag, MPI_COMM_WORLD);
        return;
    }
    memcpy(copy, data, bytes);
    pending[pending_count].data = copy;
    MPI_Isend(copy, length, MPI_BYTE, to, tag, MPI_COMM_WORLD, &pending[pending_count++].request);
}

static bool poll(int *from, int *tag, size_t *bytes)
{
    int is_there = 0, length = 0;
    MPI_Status status;
    tidy_up();
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
    if (!is_there) return false;
    MPI_Get_count(&status, MPI_BYTE, &length);
    *from = status.MPI_SOURCE;
    *tag = status.MPI_TAG;
    *bytes = (size_t)length;
    return true;
}

static void receive(int from, int tag, void *data, size_t bytes)
{
    MPI_Recv(data, length_of(bytes), MPI_BYTE, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

static void end(void)
{
    while (pending_count > 0) wait_for_one();
    MPI_Finalize();
}

static void abort_all(int exit_code)
{
    MPI_Abort(MPI_COMM_WORLD, exit_code);
}

static const char *place(void)
{
    static char name[MPI_MAX_PROCESSOR_NAME];
    int length = 0;
    MPI_Get_processor_name(name, &length);
    return name;
}

__attribute__((visibility("default"))) const YkRanks *yk_ranks_open(void);
const YkRanks *yk_ranks_open(void)
{
    static const YkRanks table = {
        YK_RANKS_INTERFACE, YOKE_VERSION_STRING, made, begin, rank, count, send, poll, receive, end, abort_all, place};
    return &table;
}
