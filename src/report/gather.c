// Gathers everything on the page, from a state whose inputs are set.
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "report/report.h"
#include "solve/state.h"

static const double page_width = 800;          // px, of the drawing
static const double CHOSEN = 0.1, MOVED = 0.8; // shares of the work: the motion is chosen, and run

YkReportOptions yk_default_report_options(void)
{
    return (YkReportOptions){.coordinate = -1};
}

static void assemble(YkReportPage *report)
{
    // Keeps the pose of the caller's state if it has one; otherwise assembles at its inputs.
    report->status =
        yk_state_has_pose(report->start) ? yk_state_solve(report->start) : yk_state_assemble(report->start);
    const char *said = yk_state_report(report->start)->message;
    report->message = yk_arena_copy(report->arena, said, strlen(said));
    if (!report->message) report->message = "";
    yk_report_note(report, report->status);
}

static void make_dynamics(YkReportPage *report, YkProblems *problems)
{
    report->dynamics = yk_dynamics_new(report->mech, problems);
    report->failed |= !report->dynamics;
    if (!report->dynamics || yk_dynamics_has_loads(report->dynamics)) return;
    yk_dynamics_free(report->dynamics);
    report->dynamics = NULL;
}

// Solves the pose at the start with its forces: those of the imposed motion if one is shown, otherwise those of the
// motion that begins there.
static void solve_start(YkReportPage *report)
{
    if (!report->dynamics || report->status < 0) return;
    YkStatus status = yk_dynamics_solve(report->dynamics, report->start, YK_METHOD_REDUCED);
    yk_report_note(report, status);
    yk_law_watch_look(report->laws, report->start, report->dynamics, yk_report_place(report, report->start));
    report->has_forces = status == YK_OK || status == YK_REDUNDANT;
    if (!report->has_forces) report->forces_message = yk_dynamics_report(report->dynamics)->message;
}

// Begins a drawing of all rows, and of the start as the pose at which the page opens.
static void begin_drawing(YkReportPage *report)
{
    YkDrawOptions options = yk_default_draw_options();
    options.width = page_width;
    options.moving = true;
    options.labels = !report->options.no_labels;
    options.traced_points = report->traced;
    options.traced_count = report->traced_count;
    options.traced_hidden = report->traced_count - report->traced_shown;
    report->drawing = yk_drawing_new(report->mech, &options);
    report->failed |= !report->drawing;
}

static void end_drawing(YkReportPage *report)
{
    if (!report->drawing) return;
    YkStatus status = yk_drawing_pose(report->drawing, report->start);
    yk_report_note(report, status);
    if (status == YK_OK) return;
    yk_drawing_free(report->drawing); // a pose that cannot be drawn: the page has no drawing
    report->drawing = NULL;
}

// Gathers only the motion and its drawing, with the paths that were asked for.
static void gather_movie(YkReportPage *report, YkProblems *problems)
{
    assemble(report);
    make_dynamics(report, problems);
    if (report->status < 0) return;
    yk_report_choose_motion(report);
    yk_report_choose_traces(report);
    report->traced_count = report->traced_shown = report->options.traced_count;
    begin_drawing(report);
    if (!report->failed) yk_report_run(report, problems);
    if (report->drawing && report->posed == 0) end_drawing(report); // nothing moves: the pose at the start
}

static void gather(YkReportPage *report, YkProblems *problems)
{
    yk_pace_stage(&report->pace, 0, CHOSEN);
    assemble(report);
    make_dynamics(report, problems);
    if (report->status >= 0) {
        yk_report_choose_motion(report);
        yk_report_choose_traces(report);
        yk_report_choose_columns(report);
        begin_drawing(report);
    }
    if (report->failed) return;
    yk_pace_stage(&report->pace, CHOSEN, MOVED);
    yk_report_run(report, problems);
    yk_pace_stage(&report->pace, MOVED, 1);
    if (report->pace.is_stopped) return;
    solve_start(report);
    end_drawing(report);
    yk_report_findings(report);
}

YkReportPage *yk_report_new(YkState *state, const YkReportOptions *options, YkProblems *problems)
{
    YkReportPage *report = calloc(1, sizeof *report);
    bool good = report && (report->arena = yk_arena_new());
    if (good) {
        report->options = options ? *options : yk_default_report_options();
        report->mech = yk_state_mechanism(state);
        report->model = yk_mechanism_model(report->mech);
        report->motion.coordinate = -1;
        report->motion_message = report->message = "";
        report->progress = state->progress;
        report->witness = state->witness;
        yk_pace_begin(&report->pace, report->progress);
        report->start = yk_report_new_state(report);
        report->laws = yk_law_watch_new(report->model);
        good = report->laws && report->start && yk_state_copy(report->start, state) >= 0;
    }
    bool is_movie = good && report->options.pose_rate > 0;
    if (good) (is_movie ? gather_movie : gather)(report, problems);
    bool is_stopped = good && report->pace.is_stopped;
    if (good) report->pace.progress = (YkProgress){0};
    if (good && !is_stopped && !report->failed && !yk_arena_failed(report->arena)) return report;
    if (is_stopped)
        yk_problem_stopped(problems);
    else if (yk_problems_error_count(problems) == 0)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    yk_report_free(report);
    return NULL;
}

void yk_report_free(YkReportPage *report)
{
    if (!report) return;
    yk_drawing_free(report->drawing);
    yk_sweep_free(report->sweep);
    yk_simulation_free(report->simulation);
    yk_dynamics_free(report->dynamics);
    yk_dynamics_free(report->along);
    yk_state_free(report->start);
    yk_law_watch_free(report->laws);
    free(report->columns);
    free(report->at);
    free(report->values);
    free(report->findings);
    yk_text_free(&report->html);
    yk_arena_free(report->arena);
    free(report);
}

YkDrawing *yk_report_drawing(YkReportPage *report)
{
    return report->options.pose_rate > 0 ? report->drawing : NULL;
}

YkStatus yk_report_status(const YkReportPage *report)
{
    return report->status;
}

const char *yk_report_message(const YkReportPage *report)
{
    return report->message;
}

size_t yk_report_finding_count(const YkReportPage *report)
{
    return report->finding_count;
}

const char *yk_report_finding(const YkReportPage *report, size_t index)
{
    return index < report->finding_count ? report->findings[index].text : NULL;
}
