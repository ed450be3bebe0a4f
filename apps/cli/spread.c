// How ranks that share work begin and end together.
#include "spread.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "stop.h"

static const double shortest_pause = 2e-5, longest_pause = 1e-3, patience = 10; // s

void yk_spread_wait(double *pause)
{
    *pause = *pause == 0 ? shortest_pause : *pause < longest_pause / 2 ? *pause * 2 : longest_pause;
    const struct timespec time = {0, (long)(*pause * 1e9)};
    nanosleep(&time, NULL);
}

// --- rank 0

static bool refuse_silent(YkProblems *problems, int rank, const char *what, YkSpreadHello *hello)
{
    size_t length = strlen(hello->said);
    while (length > 0 && hello->said[length - 1] == '\n') length--;
    hello->said[length] = '\0';
    yk_problem(problems, YK_CODE_RANKS_FAILED, (YkPlace){0}, "rank %d on %s could not read the %s", rank, hello->place,
               what);
    yk_problem_hint(problems, "it said: %s", hello->said);
    return false;
}

bool yk_spread_hear_hello(YkSession *session, int rank, uint64_t signature, const char *what, const char *files)
{
    YkProblems *problems = session->problems;
    YkSpreadHello hello;
    memset(&hello, 0, sizeof hello);
    yk_ranks()->receive(rank, YK_SPREAD_HELLO, &hello, sizeof hello);
    if (strcmp(hello.version, yk_version()) != 0) {
        yk_problem(problems, YK_CODE_RANKS_DIFFER, (YkPlace){0}, "rank %d on %s is yoke %s, and rank 0 is yoke %s",
                   rank, hello.place, hello.version, yk_version());
        return false;
    }
    if (!hello.is_read) return refuse_silent(problems, rank, what, &hello);
    if (hello.signature == signature) return true;
    yk_problem(problems, YK_CODE_RANKS_DIFFER, (YkPlace){0}, "rank %d on %s has another %s or command line than rank 0",
               rank, hello.place, files);
    return false;
}

bool yk_spread_hear_lost(YkSession *session, int rank)
{
    int32_t reason = 0;
    yk_ranks()->receive(rank, YK_SPREAD_LOST, &reason, sizeof reason);
    if (reason == YK_SPREAD_STOPPED) return true; // an interruption, wherever the signal went
    yk_problem(session->problems, YK_CODE_RANKS_FAILED, (YkPlace){0}, "rank %d ran out of memory", rank);
    return false;
}

void yk_spread_dismiss(void)
{
    double start = yk_stop_now(), pause = 0;
    int gone = 1, count = yk_ranks()->count();
    for (int rank = 1; rank < count; rank++) yk_ranks()->send(rank, YK_SPREAD_STOP, NULL, 0);
    while (gone < count) {
        int rank, tag;
        size_t bytes;
        if (!yk_ranks()->poll(&rank, &tag, &bytes)) {
            if (yk_stop_now() - start > patience) yk_ranks()->abort(YK_EXIT_WRONG);
            yk_spread_wait(&pause);
            continue;
        }
        char *room = malloc(bytes + 1);
        if (!room) yk_ranks()->abort(YK_EXIT_WRONG);
        if (room) yk_ranks()->receive(rank, tag, room, bytes);
        free(room);
        gone += tag == YK_SPREAD_BYE;
        pause = 0;
    }
    yk_ranks_end();
}

// --- other ranks

void yk_spread_say_hello(YkSession *session, uint64_t signature, bool is_read)
{
    YkSpreadHello hello;
    memset(&hello, 0, sizeof hello);
    if (!is_read && !session->is_told) yk_tell_problems(session, session->problems);
    session->is_told = true;
    yk_ranks_unhush(hello.said, sizeof hello.said);
    strncpy(hello.version, yk_version(), sizeof hello.version - 1);
    strncpy(hello.place, yk_ranks()->place(), sizeof hello.place - 1);
    hello.signature = signature;
    hello.is_read = is_read;
    yk_ranks()->send(0, YK_SPREAD_HELLO, &hello, sizeof hello);
}

void yk_spread_say_lost(YkSpreadReason reason)
{
    int32_t word = (int32_t)reason;
    yk_ranks()->send(0, YK_SPREAD_LOST, &word, sizeof word);
}

// Requests are dropped once this rank has failed.
void yk_spread_serve(bool (*compute)(void *context, YkSpreadWork work), void *context)
{
    bool good = true;
    double pause = 0;
    for (;;) {
        YkSpreadWork work = {.count = 0};
        int from, tag;
        size_t bytes;
        if (good && yk_stop_is_asked()) {
            yk_spread_say_lost(YK_SPREAD_STOPPED);
            good = false;
        }
        if (!yk_ranks()->poll(&from, &tag, &bytes)) {
            yk_spread_wait(&pause);
            continue;
        }
        pause = 0;
        yk_ranks()->receive(from, tag, &work, sizeof work);
        if (tag == YK_SPREAD_STOP) break;
        if (good) good = compute(context, work);
    }
    yk_ranks()->send(0, YK_SPREAD_BYE, NULL, 0);
}
