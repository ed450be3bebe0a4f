// A rank other than 0: computes the blocks that it is given, and prints nothing itself.
#include <stdlib.h>
#include <string.h>
#include "spread.h"
#include "stop.h"
#include "verbs/study/study.h"

// Computes a block and sends it. Returns false if it could not, after telling rank 0.
static bool compute(void *context, YkSpreadWork work)
{
    YkStudyAnswer *a = context;
    const YkDesigns designs = yk_study_designs(a);
    const YkRowCase asked = yk_study_case(a, &designs);
    size_t count = (size_t)work.count, bytes = count * a->width * sizeof(double);
    char *message = malloc(sizeof(YkSpreadRows) + bytes);
    YkSpreadRows head = {work.from, work.count, yk_stop_now()};
    YkStatus status = YK_NO_MEMORY;
    if (message) status = yk_study_rows(a->study, &asked, work.from, count, (double *)(void *)(message + sizeof head));
    head.seconds = yk_stop_now() - head.seconds;
    if (status == YK_OK) {
        memcpy(message, &head, sizeof head);
        yk_ranks()->send(0, YK_SPREAD_ROWS, message, sizeof head + bytes);
    } else {
        yk_spread_say_lost(status == YK_STOPPED ? YK_SPREAD_STOPPED : YK_SPREAD_MEMORY);
    }
    free(message);
    return status == YK_OK;
}

int yk_study_serve(YkStudyAnswer *a, bool is_read)
{
    a->session->keeps_what_is_done = true;
    a->width = yk_study_first(a) + a->column_count * yk_study_kinds(a);
    yk_spread_say_hello(a->session, is_read ? yk_study_signature(a) : 0, is_read);
    yk_spread_serve(compute, a);
    yk_ranks_end();
    return YK_EXIT_DONE; // rank 0 gives the exit code of the run
}
