// yoke sweep: moves a coordinate, or time, through a range.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "certify.h"
#include "laws_left.h"
#include "reach.h"
#include "stop.h"
#include "verbs/sweep/sweep.h"
#include "write/file.h"

enum { STEPS_MAX = 10000000, STEPS = 36 };
static const double full_turn = 6.28318530717958647692;

// Reads --of a,b,c; without it takes all coordinates but the swept one. Reports all bad names.
static bool read_columns(YkSweepAnswer *answer)
{
    YkSession *session = answer->session;
    YkAnswerColumns columns = {0};
    bool good = yk_columns_read(session, &columns);
    for (size_t i = 0; !session->request->of && i < yk_coordinate_count(session->mech); i++)
        if ((int)i != answer->over.coordinate)
            good &= yk_columns_add(session, &columns, yk_coordinate_info(session->mech, i).name);
    answer->columns = columns.items;
    answer->column_count = columns.count;
    answer->has_forces = yk_columns_need_forces(&columns);
    return good;
}

// Returns the coordinate whose closing ranges matter: the swept one, or the one that time drives; -1 if there are
// several.
static int ranged_coordinate(const YkSweepAnswer *answer)
{
    if (answer->over.coordinate >= 0) return answer->over.coordinate;
    const YkMechanism *mech = answer->session->mech;
    return yk_input_count(mech) == 1 ? (int)yk_input_coordinate(mech, 0) : -1;
}

static void find_ranges(YkSweepAnswer *answer, YkState *start)
{
    int coordinate = ranged_coordinate(answer);
    if (coordinate < 0) return;
    YkCoordinateInfo info = yk_coordinate_info(answer->session->mech, (size_t)coordinate);
    size_t count = yk_closing_ranges(start, (size_t)coordinate, answer->ranges, YK_RANGES_MAX);
    if (count == YK_NOT_FOUND) yk_text_fail(&answer->session->out);
    if (count == YK_NOT_FOUND) return;
    answer->range_count = count < YK_RANGES_MAX ? count : YK_RANGES_MAX;
    answer->ranges_of = info.name;
    answer->ranges_quantity = yk_quantity_of(info.is_distance, 0);
}

// Returns whether all extremes of a column are those of the stroke of one turn.
static bool repeats(const YkSweepAnswer *answer, size_t column, const YkStroke *stroke)
{
    double most = 1e-7 * (stroke->high - stroke->low); // by which the places of extremes change them
    for (size_t k = 0; k < yk_sweep_event_count(answer->sweep); k++) {
        YkEvent e = yk_sweep_event(answer->sweep, k);
        bool is_its = e.kind == YK_EVENT_EXTREME && e.channel == column;
        if (is_its && fabs(e.value - (e.is_maximum ? stroke->high : stroke->low)) > most) return false;
    }
    return true;
}

// Finds time ratios of quick-returns, if the sweep is whole turns of an input that repeat one another.
static void find_strokes(YkSweepAnswer *answer, YkState *start)
{
    double turns = fabs(answer->over.to - answer->over.from) / full_turn;
    if (answer->over.quantity != YK_QUANTITY_ANGLE || turns < 0.5 ||
        fabs(turns - floor(turns + 0.5)) * full_turn > 1e-9)
        return;
    size_t input = (size_t)yk_coordinate_info(answer->session->mech, (size_t)answer->over.coordinate).input;
    for (size_t c = 0; answer->strokes && c < answer->column_count; c++) {
        YkChannel channel = answer->columns[c].channel;
        YkStroke *stroke = &answer->strokes[c];
        YkStatus status = channel.order > 0 ? YK_BAD_ARGUMENT : yk_stroke(start, input, channel, stroke);
        yk_note_status(answer->session, status);
        if (status != YK_OK || !repeats(answer, c, stroke)) stroke->ratio = 0;
    }
}

// Writes "limit at theta1 = 190.09 deg: dyad C (RRP) closes no further".
static void word_limit(YkSweepAnswer *answer)
{
    YkText *text = &answer->message;
    for (size_t i = yk_sweep_event_count(answer->sweep); i-- > 0;) {
        YkEvent event = yk_sweep_event(answer->sweep, i);
        if (event.kind != YK_EVENT_LIMIT) continue;
        yk_text_format(text, "%s goes no further than ", answer->over.name);
        yk_add_value(answer->session, text, event.at, answer->over.quantity, 12);
        if (answer->status == YK_BAD_MODEL) yk_text_puts(text, ": beyond, a drive has no value, rate or acceleration");
        if (event.block < 0) return;
        YkBlockInfo block = yk_block_info(answer->session->mech, (size_t)event.block);
        yk_text_format(text, ": beyond, joint %q (%s) does not close", block.label, yk_block_kind_name(block.kind));
        return;
    }
    yk_text_puts(text, yk_state_report(answer->session->state)->message);
}

static void tell(YkSweepAnswer *answer)
{
    YkText ranges = {0};
    yk_tell_status(answer->session, answer->status, yk_text_get(&answer->message));
    yk_sweep_add_ranges(answer, &ranges);
    if (answer->range_count > 0 && answer->status < 0)
        yk_problem_hint(answer->session->problems, "this configuration (%s) closes for %s", yk_text_get(&answer->label),
                        yk_text_get(&ranges));
    yk_text_free(&ranges);
}

// Notes where a load has no finite value.
static void look_at_loads(YkSweepAnswer *answer, const YkState *state)
{
    const YkDynamics *dynamics = answer->session->dynamics;
    if (!dynamics || !yk_state_has_rates(state)) return;
    const YkReport *report = yk_dynamics_report(dynamics);
    if (report->status != YK_NOT_CONVERGED || answer->forceless++ > 0) return;
    answer->forceless_at = yk_sweep_place(answer, state);
    answer->why = *report;
}

static void warn_of_loads(const YkSweepAnswer *answer)
{
    YkSession *session = answer->session;
    YkText at = {0};
    if (answer->forceless == 0) return;
    yk_add_value(session, &at, answer->forceless_at, answer->over.quantity, YK_DIGITS);
    yk_problem(session->problems, YK_CODE_LOAD_INFINITE, (YkPlace){0}, "no forces at %s = %s%s: %s", answer->over.name,
               yk_text_get(&at), answer->forceless > 1 ? " and at later poses" : "", answer->why.message);
    session->out.failed |= at.failed;
    yk_text_free(&at);
}

// At the pose of every row.
static void look(void *context, const YkState *state)
{
    YkSweepAnswer *answer = context;
    size_t row = answer->visited++;
    yk_sweep_look_at_friction(answer, state);
    look_at_loads(answer, state);
    yk_law_watch_look(answer->laws, state, answer->session->dynamics, yk_sweep_place(answer, state));
    yk_stop_watch_look(answer->stops, state, yk_sweep_place(answer, state));
    if (row < answer->row_capacity) yk_sweep_measure_noise(answer, state, row);
}

static bool run(YkSweepAnswer *answer, size_t steps)
{
    YkSession *session = answer->session;
    YkState *start = yk_session_new_state(session, session->mech);
    YkChannel *channels = yk_session_alloc(session, answer->column_count + 1, sizeof *channels);
    answer->strokes = yk_session_alloc(session, answer->column_count + 1, sizeof *answer->strokes);
    answer->held = yk_session_alloc(session, answer->column_count + 1, sizeof *answer->held);
    answer->laws = yk_session_watch_laws(session);
    answer->stops = yk_session_watch_stops(session);
    answer->row_capacity = session->request->format == YK_FORMAT_TEXT ? steps + 1 : 0;
    answer->noise = yk_session_alloc(session, answer->row_capacity * answer->column_count + 1, sizeof *answer->noise);
    answer->sines = yk_session_alloc(session, answer->row_capacity + 1, sizeof *answer->sines);
    answer->values = yk_session_alloc(session, answer->column_count + 1, 4 * sizeof *answer->values);
    answer->beside = yk_state_new(session->mech);
    if (start && channels && answer->strokes && answer->held && answer->noise && answer->sines && answer->values &&
        answer->beside && answer->laws && answer->stops) {
        YkSweepOptions options = yk_default_sweep_options();
        options.coordinate = answer->over.coordinate;
        options.from = answer->over.from;
        options.to = answer->over.to;
        options.steps = steps;
        options.dynamics = session->dynamics;
        options.method = answer->method;
        options.visit = look;
        options.context = answer;
        for (size_t i = 0; i < answer->column_count; i++) channels[i] = answer->columns[i].channel;
        yk_state_copy(start, session->state);
        answer->label = yk_label_of(start);
        yk_certify_watch(session);
        answer->sweep = yk_sweep_run(session->state, &options, channels, answer->column_count, session->problems);
        if (answer->sweep) {
            answer->status = yk_sweep_status(answer->sweep);
            if (answer->status == YK_LIMIT) find_ranges(answer, start);
            if (answer->status >= 0) find_strokes(answer, start);
        }
    }
    yk_state_free(start);
    if (!answer->sweep && yk_problems_error_count(session->problems) == 0) yk_session_refuse_for_memory(session);
    return answer->sweep != NULL;
}

static int write_answer(YkSweepAnswer *answer)
{
    YkSession *session = answer->session;
    switch (session->request->format) {
    case YK_FORMAT_TEXT:
        yk_sweep_text(answer);
        break;
    case YK_FORMAT_JSON:
        yk_sweep_json(answer);
        break;
    case YK_FORMAT_CSV:
        yk_sweep_csv(answer);
        break;
    }
    int exit_code = yk_session_finish(session, yk_status_exit(answer->status));
    const char *plot = session->request->plot;
    if (plot && exit_code != YK_EXIT_WRONG && !yk_sweep_plot(answer, plot)) exit_code = YK_EXIT_WRONG;
    return exit_code;
}

// Answers a valid request; if nothing can be assembled, an empty sweep says so.
static int answer_sweep(YkSweepAnswer *answer, size_t steps)
{
    YkSession *session = answer->session;
    answer->status = yk_session_reach(session, &answer->over);
    if (answer->status < 0) {
        yk_text_puts(&answer->message, yk_reach_message(session));
        yk_reach_tell(session, answer->status);
        return write_answer(answer);
    } else if (!run(answer, steps)) {
        return YK_EXIT_WRONG;
    } else if (answer->status == YK_LIMIT || answer->status == YK_BAD_MODEL) {
        word_limit(answer);
    } else if (answer->status != YK_OK) {
        yk_text_puts(&answer->message, yk_state_report(session->state)->message);
    }
    tell(answer);
    yk_certify_warn(session);
    yk_sweep_warn_of_friction(answer);
    warn_of_loads(answer);
    yk_warn_of_laws(answer->session, answer->laws, answer->over.name, answer->over.quantity, "");
    yk_warn_of_stops(answer->stops, answer->over.name, answer->over.quantity);
    return write_answer(answer);
}

static bool check_request(YkSession *session)
{
    const YkRequest *request = session->request;
    if (!request->over) {
        yk_session_refuse(session, YK_CODE_OPTION_MISSING, "`yoke sweep` needs --over NAME=FROM:TO%s", "");
        yk_problem_hint(session->problems,
                        "as in --over theta1=0:360deg, or --over t=0:2s; `yoke check` lists the coordinates");
        return false;
    }
    if (!request->plot || yk_file_kind(request->plot) != YK_FILE_OTHER) return true;
    return yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--plot writes .svg, .pdf or .png, not %q", request->plot);
}

int yk_run_sweep(YkSession *session)
{
    YkSweepAnswer *answer = calloc(1, sizeof *answer);
    size_t steps = STEPS;
    int exit_code = YK_EXIT_WRONG;
    if (!answer) {
        yk_session_refuse_for_memory(session);
        return exit_code;
    }
    answer->session = session;
    bool good = yk_session_method(session, &answer->method);
    good = good && (!session->request->file || check_request(session)); // without a file, that is the error to report
    good = good && (!session->request->over || yk_over_split(session, session->request->over, &answer->over));
    good = good && yk_session_count(session, "--steps", session->request->steps, STEPS_MAX, STEPS, &steps);
    const char *swept = answer->over.name && strcmp(answer->over.name, "t") != 0 ? answer->over.name : NULL;
    good =
        good && yk_session_load(session, swept) && yk_session_inputs(session) && yk_over_read(session, &answer->over);
    good = good && yk_certify_begin(session) && read_columns(answer) &&
           (!answer->has_forces || (yk_session_forces(session, true) && yk_session_has_forces(session)));
    if (good) exit_code = answer_sweep(answer, steps);
    yk_sweep_free(answer->sweep);
    yk_law_watch_free(answer->laws);
    yk_stop_watch_free(answer->stops);
    yk_text_free(&answer->message);
    yk_text_free(&answer->label);
    free(answer->columns);
    yk_state_free(answer->beside);
    free(answer);
    return exit_code;
}
