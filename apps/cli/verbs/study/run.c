// Computes the rows of a study in this process, block by block; takes and shows what is done, wherever it was computed.
#include <stdio.h>
#include <stdlib.h>
#include "ranks.h"
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

static const double block_seconds = 0.2; // s between checks of signals, progress and the partial file
enum { BLOCK = 64, BLOCK_MAX = 1 << 20, BLOCK_BYTES = 1 << 23 };

YkRowCase yk_study_case(const YkStudyAnswer *a, const YkDesigns *designs)
{
    return (YkRowCase){designs, a->input_row, a->pose_count, a->times, a->over.name != NULL};
}

bool yk_study_take(YkStudyAnswer *a, const double *rows, size_t count)
{
    if (!yk_partial_add(a, rows, count)) return false;
    for (size_t k = 0; k < count; k++) yk_study_note(a, a->done + k, rows + k * a->width);
    a->done += count;
    return !a->session->ran_out;
}

// --- progress

static void show_left(const YkStudyAnswer *a, double passed)
{
    double rate = (double)(a->done - a->found) / passed;
    if (a->done > a->found) fprintf(stderr, ", about %.0f s left", (double)(a->design_count - a->done) / rate);
}

// mpirun collects what the ranks print, and it is not a terminal, so progress is a line at growing intervals.
static void show_lines(YkStudyAnswer *a, double passed)
{
    if (passed < a->next_line || a->session->request->quiet) return;
    a->next_line = passed < 60 ? passed + 10 : passed + 60;
    fprintf(stderr, "yoke: study: %zu of %zu designs on %d ranks, %.0f s", a->done, a->design_count, yk_ranks_count(),
            passed);
    show_left(a, passed);
    fputs("\n", stderr);
}

void yk_study_show(YkStudyAnswer *a, bool is_last)
{
    if (a->began == 0) {
        a->began = yk_stop_now();
        a->next_line = 10;
    }
    double passed = yk_stop_now() - a->began;
    if (!yk_stop_shows_progress(a->session)) {
        if (yk_ranks_count() > 1 && !is_last) show_lines(a, passed);
        return;
    }
    fprintf(stderr, "\r\033[K");
    if (is_last) return;
    fprintf(stderr, "study: %zu of %zu designs", a->done, a->design_count);
    if (passed > 1) show_left(a, passed);
}

// --- computing

static bool run_block(YkStudyAnswer *a, double *rows, size_t count)
{
    const YkDesigns designs = yk_study_designs(a);
    const YkRowCase asked = yk_study_case(a, &designs);
    YkStatus status = yk_study_rows(a->study, &asked, a->done, count, rows);
    if (status == YK_STOPPED) return true;
    if (status != YK_OK) return yk_session_refuse_for_memory(a->session);
    return yk_study_take(a, rows, count);
}

bool yk_study_compute(YkStudyAnswer *a)
{
    size_t most = BLOCK_BYTES / (a->width * sizeof(double)) + 1, size = BLOCK;
    if (most > BLOCK_MAX) most = BLOCK_MAX;
    if (most > a->design_count) most = a->design_count;
    double *room = a->rows ? NULL : calloc(most * a->width + 1, sizeof *room);
    bool good = a->rows || room || yk_session_refuse_for_memory(a->session);
    yk_study_show(a, false);
    while (good && a->done < a->design_count && !yk_stop_is_asked()) {
        size_t count = a->design_count - a->done < size ? a->design_count - a->done : size;
        if (count > most) count = most;
        double start = yk_stop_now();
        good = run_block(a, room ? room : a->rows + a->done * a->width, count);
        yk_study_show(a, false);
        if (yk_stop_now() - start < block_seconds / 2 && size < most) size *= 2;
    }
    yk_study_show(a, true);
    free(room);
    return good;
}
