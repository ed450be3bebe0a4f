// Runs the motion, with a row of numbers and a pose of the drawing at each step.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "dynamics/dynamics.h"
#include "report/report.h"

enum { PEAK_STEPS = 64, STEPS_MAX = 200000 };
static const double coarse = 0.35;         // rad from row to row
static const double duration_least = 1e-3; // s

static void say(YkReportPage *report, const char *message)
{
    report->motion_message = yk_arena_copy(report->arena, message, strlen(message));
    if (!report->motion_message) report->motion_message = "";
}

static bool make_room(YkReportPage *report)
{
    size_t rows = report->motion.steps + 1;
    report->at = calloc(rows, sizeof *report->at);
    report->values = calloc(rows * report->column_count + 1, sizeof *report->values);
    report->row_capacity = rows;
    return report->at && report->values;
}

double yk_report_place(const YkReportPage *report, const YkState *state)
{
    bool is_sweep = report->motion.kind == YK_REPORT_TURN || report->motion.kind == YK_REPORT_RANGE;
    return is_sweep ? yk_state_coordinate(state, (size_t)report->motion.coordinate).position : yk_state_time(state);
}

// Adds a pose of the drawing for the present row. A simulation finds the laws that it leaves itself.
static void pose(void *context, const YkState *state)
{
    YkReportPage *report = context;
    if (!report->simulation) yk_law_watch_look(report->laws, state, report->along, yk_report_place(report, state));
    if (!report->drawing || report->posed >= report->row_capacity) return;
    YkStatus status = yk_drawing_pose(report->drawing, state);
    if (status == YK_OK) status = yk_drawing_trace(report->drawing, state);
    yk_report_note(report, status);
    if (status != YK_OK) return;
    report->posed++;
}

// --- Sweeps

// Takes the swept machine's forces as those of an imposed motion, at the start too. Sweeps have a dynamics of their
// own, since the page reports the start's forces after they have run.
static bool prescribe_all(YkReportPage *report)
{
    if (!report->dynamics) return true;
    report->along = yk_dynamics_new(report->mech, NULL);
    for (size_t i = 0; report->along && i < yk_input_count(report->mech); i++) {
        yk_dynamics_prescribe(report->dynamics, i, true);
        yk_dynamics_prescribe(report->along, i, true);
    }
    return report->along != NULL;
}

static YkSweep *sweep(YkReportPage *report, double from, double to, size_t steps, const YkChannel *channels,
                      size_t count, bool poses, YkProblems *problems)
{
    YkState *state = yk_report_new_state(report);
    YkSweep *result = NULL;
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = report->motion.kind == YK_REPORT_TIME ? -1 : report->motion.coordinate;
    options.from = from;
    options.to = to;
    options.steps = steps;
    options.dynamics = report->along;
    if (poses) {
        options.visit = pose;
        options.context = report;
    }
    if (state && poses) state->witness = report->witness;
    if (state && yk_state_copy(state, report->start) >= 0)
        result = yk_sweep_run(state, &options, channels, count, problems);
    yk_state_free(state);
    return result;
}

static void run_sweep(YkReportPage *report, YkProblems *problems)
{
    YkChannel *channels = calloc(report->column_count + 1, sizeof *channels);
    if (channels && prescribe_all(report)) {
        for (size_t c = 0; c < report->column_count; c++) channels[c] = report->columns[c].channel;
        report->sweep = sweep(report, report->motion.from, report->motion.to, report->motion.steps, channels,
                              report->column_count, true, problems);
    }
    free(channels);
    report->failed |= !report->sweep;
    if (!report->sweep) return;
    report->motion_status = yk_sweep_status(report->sweep);
    yk_report_note(report, report->motion_status);
    report->row_count = yk_sweep_row_count(report->sweep);
    for (size_t row = 0; row < report->row_count; row++) {
        bool is_singular = yk_sweep_row_status(report->sweep, row) == YK_SINGULAR;
        report->at[row] = yk_sweep_at(report->sweep, row);
        for (size_t c = 0; c < report->column_count; c++) {
            YkChannel channel = report->columns[c].channel;
            bool is_lost = is_singular && (channel.order > 0 || channel.kind >= YK_CHANNEL_POINT_SPEED) &&
                           channel.kind != YK_CHANNEL_TRANSMISSION;
            report->values[row * report->column_count + c] =
                is_lost ? (double)NAN : yk_sweep_value(report->sweep, row, c);
        }
    }
}

// --- Simulation

static void take_row(YkReportPage *report)
{
    size_t row = report->row_count++;
    report->at[row] = yk_simulation_time(report->simulation);
    for (size_t c = 0; c < report->column_count; c++)
        report->values[row * report->column_count + c] =
            yk_simulation_channel(report->simulation, report->columns[c].channel);
    pose(report, yk_simulation_state(report->simulation));
}

// After every step, of some twelve evaluations.
static bool go_on(void *context, double time)
{
    enum { STEP = 12 * 300 };
    YkReportPage *report = context;
    const YkReportMotion *motion = &report->motion;
    yk_pace_reach(&report->pace, (time - motion->from) / (motion->to - motion->from));
    return yk_pace_spend(&report->pace, STEP * report->model->body_count);
}

// Simulates from the start to the end of the motion. Returns false, with the reason, if it cannot begin.
static bool simulate(YkReportPage *report)
{
    YkProblems *problems = yk_problems_new();
    YkSimulationOptions options = yk_default_simulation_options();
    options.start = report->motion.from;
    options.horizon = report->motion.to;
    options.compile = report->options.compile;
    options.pose = yk_state_has_pose(report->start) ? report->start : NULL;
    options.steps_max = STEPS_MAX;
    options.goes_on = go_on;
    options.context = report;
    report->simulation = problems ? yk_simulation_new(report->model, &options, problems) : NULL;
    yk_report_note_problems(report, problems);
    if (report->simulation) yk_simulation_set_certifier(report->simulation, (YkCertifier *)report->witness);
    if (!report->simulation) {
        report->motion_status = YK_NOT_CONVERGED;
        say(report, problems && yk_problems_count(problems) > 0 ? yk_problems_get(problems, 0)->message : "");
    }
    yk_problems_free(problems);
    for (size_t k = 0; report->simulation && k <= report->motion.steps && !report->pace.is_stopped; k++) {
        double part = (double)k / (double)report->motion.steps,
               time = report->motion.from + (report->motion.to - report->motion.from) * part;
        report->motion_status = yk_simulation_advance(report->simulation, time);
        yk_report_note(report, report->motion_status);
        if (report->motion_status < 0 || report->motion_status == YK_SINGULAR) {
            say(report, yk_simulation_report(report->simulation)->message);
            break;
        }
        take_row(report);
        report->failed |= yk_simulation_dynamics(report->simulation)->ran_out;
    }
    return report->simulation != NULL;
}

// Returns whether an angle turns so far from row to row that neither lines nor eyes can follow.
static bool is_coarse(const YkReportPage *report)
{
    for (size_t c = 0; c < report->column_count; c++) {
        const YkReportColumn *column = &report->columns[c];
        if (column->role != YK_ROLE_COORDINATE || column->channel.order > 0 ||
            column->channel.quantity != YK_QUANTITY_ANGLE)
            continue;
        for (size_t row = 1; row < report->row_count; row++)
            if (fabs(yk_report_value(report, row, c) - yk_report_value(report, row - 1, c)) > coarse) return true;
    }
    return false;
}

static void forget_rows(YkReportPage *report)
{
    yk_simulation_free(report->simulation);
    report->simulation = NULL;
    if (report->witness) report->witness->recall(report->witness, 0);
    report->row_count = report->posed = 0;
    if (report->drawing) report->drawing->pose_count = report->drawing->trace_count = 0;
}

// Halves a chosen duration while the machine turns too fast for its rows.
static void run_simulation(YkReportPage *report)
{
    if (report->witness) report->witness->keep(report->witness, 0);
    while (simulate(report) && !report->pace.is_stopped && report->options.duration == 0 && is_coarse(report) &&
           report->motion.duration > duration_least) {
        forget_rows(report);
        report->motion.duration *= 0.5;
        report->motion.to = report->motion.from + report->motion.duration;
    }
}

void yk_report_run(YkReportPage *report, YkProblems *problems)
{
    if (report->motion.kind == YK_REPORT_STILL) return;
    if (!make_room(report)) {
        report->failed = true;
        return;
    }
    if (report->motion.kind == YK_REPORT_SIMULATION)
        run_simulation(report);
    else
        run_sweep(report, problems);
}

// --- Peaks

// Returns whether a value beats the best so far: larger in magnitude, or least.
static bool beats(double value, double best, bool least)
{
    if (!isfinite(value)) return false;
    return isnan(best) || (least ? value < best : fabs(value) > fabs(best));
}

static YkPeak best_of_rows(const YkReportPage *report, size_t column, bool least, size_t *row)
{
    YkPeak best = {(double)NAN, 0};
    for (size_t k = 0; k < report->row_count; k++) {
        double value = yk_report_value(report, k, column);
        if (!beats(value, best.value, least)) continue;
        best = (YkPeak){value, report->at[k]};
        *row = k;
    }
    return best;
}

// Searches between the rows beside the best one, in finer steps, twice. Simulations are not run again.
static YkPeak best_of(YkReportPage *report, size_t column, bool least)
{
    size_t row = 0;
    YkPeak best = best_of_rows(report, column, least, &row);
    if (!report->sweep || report->row_count < 2 || isnan(best.value)) return best;
    double from = report->at[row > 0 ? row - 1 : 0],
           to = report->at[row + 1 < report->row_count ? row + 1 : report->row_count - 1];
    for (int round = 0; round < 2; round++) {
        YkSweep *fine = sweep(report, from, to, PEAK_STEPS, &report->columns[column].channel, 1, false, NULL);
        double step = (to - from) / PEAK_STEPS;
        yk_report_note(report, fine ? yk_sweep_status(fine) : YK_NO_MEMORY);
        for (size_t k = 0; fine && k < yk_sweep_row_count(fine); k++)
            if (beats(yk_sweep_value(fine, k, 0), best.value, least) && yk_sweep_row_status(fine, k) != YK_SINGULAR)
                best = (YkPeak){yk_sweep_value(fine, k, 0), yk_sweep_at(fine, k)};
        yk_sweep_free(fine);
        from = from < to ? fmax(from, best.at - step) : fmin(from, best.at - step);
        to = from < to ? fmin(to, best.at + step) : fmax(to, best.at + step);
    }
    return best;
}

YkPeak yk_report_peak(YkReportPage *report, size_t column)
{
    return best_of(report, column, false);
}

YkPeak yk_report_least(YkReportPage *report, size_t column)
{
    return best_of(report, column, true);
}
