// yoke study: many designs of one machine.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

static const double chunk_seconds = 0.2; // s between checks of signals, progress and the partial file
enum { CHUNK = 64, CHUNK_MAX = 1 << 20 };

// --- running

typedef struct Chunk { // room for one call of the library
    double *values;    // [axis][design]
    const double **rows;
    double **outputs;
    YkExtent *extents;
    signed char *status;
    size_t *standing;
} Chunk;

static void end_chunk(Chunk *chunk)
{
    free(chunk->values);
    free((void *)chunk->rows);
    free((void *)chunk->outputs);
    free(chunk->extents);
    free(chunk->status);
    free(chunk->standing);
}

static bool start_chunk(const YkStudyAnswer *a, Chunk *chunk, size_t most)
{
    *chunk = (Chunk){.values = calloc((a->axis_count + a->column_count) * most + 1, sizeof(double)),
                     .rows = calloc(a->axis_count + 1, sizeof(double *)),
                     .outputs = calloc(a->column_count + 1, sizeof(double *)),
                     .extents = calloc(a->column_count * most + 1, sizeof(YkExtent)),
                     .status = calloc(most + 1, 1),
                     .standing = calloc(most + 1, sizeof(size_t))};
    if (!chunk->values || !chunk->rows || !chunk->outputs || !chunk->extents || !chunk->status || !chunk->standing)
        return false;
    for (size_t k = 0; k < a->axis_count; k++) chunk->rows[k] = chunk->values + k * most;
    for (size_t c = 0; c < a->column_count; c++) chunk->outputs[c] = chunk->values + (a->axis_count + c) * most;
    return true;
}

// Invalid answers are NaN in the row, beside its status: empty fields, null.
static void fill_row(YkStudyAnswer *a, const Chunk *chunk, size_t k, size_t count, double *row)
{
    YkStatus status = (YkStatus)chunk->status[k];
    size_t first = yk_study_first(a), standing = a->over.name ? chunk->standing[k] : status >= 0;
    row[a->axis_count] = status;
    row[a->axis_count + 1] = (double)standing;
    for (size_t c = 0; c < a->column_count; c++) {
        YkChannel channel = a->columns[c].channel;
        bool is_lost = // at a dead point
            channel.order > 0 || channel.kind == YK_CHANNEL_POINT_SPEED || yk_channel_needs_forces(channel);
        bool stands = standing > 0 && !(status == YK_SINGULAR && is_lost && !a->over.name);
        YkExtent e = chunk->extents[c * count + k];
        if (a->over.name) {
            const double value[YK_REDUCTIONS] = {e.least, e.largest, e.mean, e.largest - e.least};
            for (size_t r = 0; r < YK_REDUCTIONS; r++) row[first + c * YK_REDUCTIONS + r] = stands ? value[r] : NAN;
        } else {
            row[first + c] = stands ? chunk->outputs[c][k] : NAN;
        }
    }
}

// Returns YK_OK; YK_STOPPED or YK_NO_MEMORY, and then these rows are invalid.
static YkStatus run_chunk(YkStudyAnswer *a, Chunk *chunk, size_t from, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        double *row = yk_study_row(a, from + k);
        yk_study_parameters(a, from + k, row);
        for (size_t p = 0; p < a->axis_count; p++) ((double *)(uintptr_t)chunk->rows[p])[k] = row[p];
    }
    YkStudyCase asked = {chunk->rows, count, a->input_row, a->pose_count, false, a->times};
    YkStatus worst = a->over.name ? yk_study_reduce(a->study, &asked, chunk->extents, chunk->status, chunk->standing)
                                  : yk_study_run(a->study, &asked, chunk->outputs, chunk->status);
    if (worst == YK_STOPPED) return worst;
    for (size_t k = 0; k < count; k++) {
        if (chunk->status[k] == YK_NO_MEMORY) return YK_NO_MEMORY;
        fill_row(a, chunk, k, count, yk_study_row(a, from + k));
    }
    return YK_OK;
}

static void show_progress(const YkStudyAnswer *a, bool is_last)
{
    if (!yk_stop_shows_progress(a->session)) return;
    if (is_last)
        fputs("\r                                                \r", stderr);
    else
        fprintf(stderr, "\rstudy: %zu of %zu designs   ", a->done, a->design_count);
}

static bool run(YkStudyAnswer *a)
{
    Chunk chunk;
    size_t most = a->design_count < CHUNK_MAX ? a->design_count : CHUNK_MAX, size = CHUNK;
    bool good = start_chunk(a, &chunk, most);
    if (!good) yk_session_refuse(a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    while (good && a->done < a->design_count && !yk_stop_is_asked()) {
        size_t count = a->design_count - a->done < size ? a->design_count - a->done : size;
        if (count > most) count = most;
        double start = yk_stop_now();
        YkStatus status = run_chunk(a, &chunk, a->done, count);
        if (status == YK_STOPPED) break;
        good = status == YK_OK || yk_session_refuse(a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
        for (size_t k = 0; k < count; k++) yk_note_status(a->session, yk_study_status(a, a->done + k));
        good = good && !a->session->ran_out && yk_partial_add(a, a->done, a->done + count);
        a->done += count;
        show_progress(a, false);
        if (yk_stop_now() - start < chunk_seconds / 2 && size < most) size *= 2;
    }
    show_progress(a, true);
    end_chunk(&chunk);
    a->is_interrupted = a->done < a->design_count;
    return good;
}

static bool find_sensitivities(YkStudyAnswer *a)
{
    size_t count = a->column_count * a->axis_count + 1;
    if (!a->session->request->sensitivities) return true;
    a->derivative = calloc(count, sizeof *a->derivative);
    a->difference = calloc(count, sizeof *a->difference);
    if (!a->derivative || !a->difference)
        return yk_session_refuse(a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    a->sensitivity_status = yk_study_sensitivities(a->study, a->input_row, a->derivative, a->difference);
    yk_note_status(a->session, a->sensitivity_status);
    if (a->sensitivity_status < 0 && !yk_stop_is_asked())
        yk_tell_status(a->session, a->sensitivity_status,
                       "no sensitivities: a design next to the file's own has no valid pose");
    return true;
}

// --- the answer

static size_t tell_failed(YkStudyAnswer *a)
{
    size_t failed = 0, none = 0;
    for (size_t d = 0; d < a->done; d++) {
        failed += yk_study_status(a, d) < 0;
        none += yk_study_row(a, d)[a->axis_count + 1] == 0;
    }
    if (failed > 0) {
        yk_problem(a->session->problems, YK_CODE_STUDY_FAILED_DESIGNS, (YkPlace){0}, "%z of %z designs are not valid%s",
                   failed, a->done, a->over.name ? " at every pose" : "");
        yk_study_tell_why(a);
    }
    return none;
}

static int write_answer(YkStudyAnswer *a)
{
    static void (*const writers[])(const YkStudyAnswer *) = {yk_study_text, yk_study_json, yk_study_csv, yk_study_npy};
    size_t none = tell_failed(a);
    writers[a->format](a);
    int exit_code = none == a->design_count || a->sensitivity_status < 0 ? YK_EXIT_NO_ANSWER : YK_EXIT_DONE;
    exit_code = yk_session_finish(a->session, exit_code);
    yk_partial_close(exit_code != YK_EXIT_WRONG);
    if (exit_code == YK_EXIT_WRONG) yk_partial_tell(a->session->problems);
    return exit_code;
}

static int answer_study(YkStudyAnswer *a)
{
    a->width = yk_study_first(a) + a->column_count * yk_study_kinds(a);
    a->rows = calloc(a->design_count * a->width + 1, sizeof *a->rows);
    if (!a->rows) {
        yk_session_refuse(a->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
        return YK_EXIT_WRONG;
    }
    a->session->keeps_what_is_done = true;
    if (!yk_partial_open(a) || !find_sensitivities(a) || !run(a)) return YK_EXIT_WRONG;
    if (!a->is_interrupted) return write_answer(a);
    yk_partial_close(false);
    yk_problem(a->session->problems, YK_CODE_INTERRUPTED, (YkPlace){0}, "interrupted after %z of %z designs", a->done,
               a->design_count);
    yk_partial_tell(a->session->problems);
    return YK_EXIT_NO_ANSWER;
}

int yk_run_study(YkSession *session)
{
    YkStudyAnswer *a = calloc(1, sizeof *a);
    int exit_code = YK_EXIT_WRONG;
    if (!a) {
        yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
        return exit_code;
    }
    a->session = session;
    if (yk_study_read(a))
        exit_code = answer_study(a);
    else if (a->start_status < 0)
        exit_code = yk_status_exit(a->start_status);
    yk_study_free(a->study);
    yk_state_free(a->start);
    yk_state_free(a->timed);
    free(a->times);
    yk_tolerances_free(a->tolerances);
    free(a->axes);
    free(a->columns);
    free(a->input);
    free((void *)a->input_row);
    free(a->rows);
    free(a->derivative);
    free(a->difference);
    free(a);
    return exit_code;
}
