// A rank other than 0: computes the blocks that it is given, and tells nothing itself.
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "ranks.h"
#include "session.h"
#include "stop.h"
#include "verbs/study/spread.h"
#include "verbs/study/study.h"

static const double shortest_pause = 2e-5, longest_pause = 1e-3; // s

void yk_spread_wait(double *pause)
{
    *pause = *pause == 0 ? shortest_pause : *pause < longest_pause / 2 ? *pause * 2 : longest_pause;
    const struct timespec time = {0, (long)(*pause * 1e9)};
    nanosleep(&time, NULL);
}

static void say_hello(YkStudyAnswer *a, bool is_read)
{
    YkSpreadHello hello;
    memset(&hello, 0, sizeof hello);
    YkSession *session = a->session;
    if (!is_read && !session->is_told) yk_tell_problems(session, session->problems);
    session->is_told = true;
    yk_ranks_unhush(hello.said, sizeof hello.said);
    a->width = yk_study_first(a) + a->column_count * yk_study_kinds(a);
    strncpy(hello.version, yk_version(), sizeof hello.version - 1);
    strncpy(hello.place, yk_ranks()->place(), sizeof hello.place - 1);
    hello.signature = is_read ? yk_study_signature(a) : 0;
    hello.is_read = is_read;
    yk_ranks()->send(0, YK_SPREAD_HELLO, &hello, sizeof hello);
}

static void say_lost(YkSpreadReason reason)
{
    int32_t word = (int32_t)reason;
    yk_ranks()->send(0, YK_SPREAD_LOST, &word, sizeof word);
}

// Computes a block and sends it. Returns false if it could not, which it has told rank 0.
static bool compute(YkStudyAnswer *a, YkSpreadWork work)
{
    const YkDesigns designs = yk_study_designs(a);
    const YkRowCase asked = yk_study_case(a, &designs);
    size_t count = (size_t)work.count, bytes = count * a->width * sizeof(double);
    char *message = calloc(1, sizeof(YkSpreadRows) + bytes);
    YkSpreadRows head = {work.from, work.count, yk_stop_now()};
    YkStatus status = YK_NO_MEMORY;
    if (message) status = yk_study_rows(a->study, &asked, work.from, count, (double *)(void *)(message + sizeof head));
    head.seconds = yk_stop_now() - head.seconds;
    if (status == YK_OK) {
        memcpy(message, &head, sizeof head);
        yk_ranks()->send(0, YK_SPREAD_ROWS, message, sizeof head + bytes);
    } else {
        say_lost(status == YK_STOPPED ? YK_SPREAD_STOPPED : YK_SPREAD_MEMORY);
    }
    free(message);
    return status == YK_OK;
}

// Waits for the next message. What was asked is dropped once this rank has failed.
static void serve(YkStudyAnswer *a)
{
    bool good = true;
    double pause = 0;
    for (;;) {
        YkSpreadWork work = {0, 0};
        int from, tag;
        size_t bytes;
        if (good && yk_stop_is_asked()) {
            say_lost(YK_SPREAD_STOPPED);
            good = false;
        }
        if (!yk_ranks()->poll(&from, &tag, &bytes)) {
            yk_spread_wait(&pause);
            continue;
        }
        pause = 0;
        yk_ranks()->receive(from, tag, &work, sizeof work);
        if (tag == YK_SPREAD_STOP) break;
        if (good) good = compute(a, work);
    }
    yk_ranks()->send(0, YK_SPREAD_BYE, NULL, 0);
}

int yk_study_serve(YkStudyAnswer *a, bool is_read)
{
    a->session->keeps_what_is_done = true;
    say_hello(a, is_read);
    serve(a);
    yk_ranks_end();
    return YK_EXIT_DONE; // rank 0 gives the exit code of the run
}
