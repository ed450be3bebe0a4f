// yoke study: many designs of one machine.
#include <math.h>
#include <stdlib.h>
#include "spread.h"
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

static bool find_sensitivities(YkStudyAnswer *a)
{
    size_t count = a->column_count * a->axis_count + 1;
    if (!a->session->request->sensitivities) return true;
    a->derivative = yk_session_alloc(a->session, count, sizeof *a->derivative);
    a->difference = yk_session_alloc(a->session, count, sizeof *a->difference);
    if (!a->derivative || !a->difference) return yk_session_refuse_for_memory(a->session);
    a->sensitivity_status = yk_study_sensitivities(a->study, a->input_row, a->derivative, a->difference);
    yk_note_status(a->session, a->sensitivity_status);
    if (a->sensitivity_status < 0 && !yk_stop_is_asked())
        yk_tell_status(a->session, a->sensitivity_status,
                       "no sensitivities: a design next to the file's own has no valid pose");
    return true;
}

// --- the answer

static void tell_failed(YkStudyAnswer *a)
{
    size_t failed = 0;
    for (int status = YK_NO_MEMORY; status < YK_OK; status++) failed += yk_study_count(a, (YkStatus)status);
    if (failed == 0) return;
    yk_problem(a->session->problems, YK_CODE_STUDY_FAILED_DESIGNS, (YkPlace){0}, "%z of %z designs are not valid%s",
               failed, a->done, a->over.name ? " at every pose" : "");
    yk_study_tell_why(a);
}

// Ends the output. Returns the exit code.
static int finish(YkStudyAnswer *a, int exit_code)
{
    YkSession *session = a->session;
    bool good = !a->has_missing;
    session->ran_out |= yk_blocks_ran_out(a->blocks);
    if (!good && !session->ran_out)
        yk_problem(session->problems, YK_CODE_OUTPUT_FAILED, (YkPlace){0},
                   "cannot read %q back: another program or the disk has changed it", a->partial);
    if (!a->blocks && good) return yk_session_finish(session, exit_code);
    if (!yk_session_has_memory(session)) {
        yk_stream_drop(&a->stream);
        yk_session_refuse_for_memory(session);
        return YK_EXIT_WRONG;
    }
    yk_study_flush(a, 0);
    if (!good) yk_stream_drop(&a->stream);
    if (!a->stream.is_open) return YK_EXIT_WRONG; // a piece did not fit
    return yk_stream_close(&a->stream, session->problems) ? exit_code : YK_EXIT_WRONG;
}

static int write_answer(YkStudyAnswer *a)
{
    static void (*const writers[])(YkStudyAnswer *) = {yk_study_text, yk_study_json, yk_study_csv, yk_study_npy,
                                                       yk_study_jsonl};
    int exit_code = a->sum.without == a->design_count || a->sensitivity_status < 0 ? YK_EXIT_NO_ANSWER : YK_EXIT_DONE;
    tell_failed(a);
    yk_study_warn_of_laws(a);
    if (a->blocks && !yk_stream_open(&a->stream, a->session->request->output, a->session->problems)) {
        exit_code = YK_EXIT_WRONG;
    } else {
        writers[a->format](a);
        exit_code = finish(a, exit_code);
    }
    yk_partial_close(a, exit_code != YK_EXIT_WRONG);
    if (exit_code == YK_EXIT_WRONG) yk_partial_tell(a);
    return exit_code;
}

// Makes room for rows, or finds those that an earlier run has left.
static bool begin(YkStudyAnswer *a)
{
    a->width = yk_study_first(a) + a->column_count * yk_study_kinds(a);
    a->sum.moments = yk_session_alloc(a->session, a->width + 1, sizeof *a->sum.moments);
    a->missing = yk_session_alloc(a->session, a->width + 1, sizeof *a->missing);
    a->sum.bad = YK_NOT_FOUND;
    if (!yk_partial_is_kept(a->session->request)) a->rows = calloc(a->design_count * a->width + 1, sizeof *a->rows);
    if (!a->sum.moments || !a->missing || (!a->rows && !yk_partial_is_kept(a->session->request)))
        return yk_session_refuse_for_memory(a->session);
    for (size_t k = 0; k < a->width; k++) a->sum.moments[k] = (YkMoments){0, 0, 0, INFINITY, -INFINITY};
    a->session->keeps_what_is_done = true;
    if (!yk_partial_open(a)) return false;
    for (size_t d = 0; d < a->done; d++) yk_study_note(a, d, yk_study_row(a, d));
    a->found = a->done;
    return true;
}

static int answer_study(YkStudyAnswer *a)
{
    bool good = begin(a) && find_sensitivities(a);
    if (!good && yk_ranks_count() > 1) yk_spread_dismiss();
    if (good) good = yk_ranks_count() > 1 ? yk_study_spread(a) : yk_study_compute(a);
    if (!good) return YK_EXIT_WRONG;
    a->is_interrupted = a->done < a->design_count;
    if (!a->is_interrupted) return write_answer(a);
    yk_partial_close(a, false);
    yk_problem(a->session->problems, YK_CODE_INTERRUPTED, (YkPlace){0}, "interrupted after %z of %z designs", a->done,
               a->design_count);
    yk_partial_tell(a);
    return YK_EXIT_NO_ANSWER;
}

// Ends what is open; with the file closed, another run may go on.
static void end(YkStudyAnswer *a)
{
    yk_stream_drop(&a->stream);
    yk_partial_close(a, false);
}

static int answer_on_ranks(YkStudyAnswer *a)
{
    if (!yk_ranks_begin(a->session)) {
        if (yk_ranks_is_first_here()) yk_ranks_speak(); // a computer reports once what it lacks
        return YK_EXIT_WRONG;
    }
    bool is_read = yk_study_read(a);
    if (yk_ranks_rank() > 0) return yk_study_serve(a, is_read);
    if (is_read) return answer_study(a);
    yk_spread_dismiss();
    return a->start_status < 0 ? yk_status_exit(a->start_status) : YK_EXIT_WRONG;
}

int yk_run_study(YkSession *session)
{
    YkStudyAnswer *a = calloc(1, sizeof *a);
    int exit_code = YK_EXIT_WRONG;
    if (!a) {
        yk_session_refuse_for_memory(session);
        return exit_code;
    }
    a->session = session;
    if (yk_ranks_count() > 1)
        exit_code = answer_on_ranks(a);
    else if (yk_study_read(a))
        exit_code = answer_study(a);
    else if (a->start_status < 0)
        exit_code = yk_status_exit(a->start_status);
    end(a);
    yk_study_free(a->study);
    yk_state_free(a->start);
    yk_state_free(a->timed);
    yk_tolerances_free(a->tolerances);
    free(a->rows);
    free(a->columns);
    free(a);
    return exit_code;
}
