// yoke simulate: motion in time.
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "out/file.h"
#include "session.h"
#include "simulate.h"

enum { STEPS_MAX = 10000000, STEPS = 100, CHUNK = 16384 };

// Set by the first Ctrl-C (or a polite kill): the row in work is finished, and what there is comes out whole. A second one
// ends the program at once.
static volatile sig_atomic_t interrupted;

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = interrupt};
    action.sa_flags = (int)SA_RESETHAND;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    signal(SIGPIPE, SIG_IGN); // a closed pipe is a failed write, which is told
}

// --- the request
// ----------------------------------------------------------------------------------------------------------

static bool read_number(YkSession *session, const char *option, const char *text, YkQuantity quantity, double *value)
{
    if (!text) return true;
    if (!yk_session_value(session, option, "", text, quantity, value)) return false;
    if (*value > 0) return true;
    yk_problem(session->problems, YK_CODE_OPTION_VALUE, (YkPlace){0}, "%s must be more than 0, not %q", option, text);
    return false;
}

static bool read_method(YkSession *session, YkIntegrator *integrator)
{
    static const char *const names[] = {"dop853", "sdirk4", "rk4"};
    const char *word = session->request->method;
    if (!word) return true;
    for (size_t k = 0; k < 3; k++) {
        if (strcmp(word, names[k]) != 0) continue;
        *integrator = (YkIntegrator)k;
        return true;
    }
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--method takes dop853, sdirk4 or rk4 here, not %q", word);
}

static bool add_column(YkSimulationAnswer *answer, size_t *capacity, const char *name)
{
    if (!YK_ROOM(answer->columns, answer->column_count, *capacity))
        return yk_session_refuse(answer->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    YkColumn *column = &answer->columns[answer->column_count++];
    column->name = name;
    return yk_channel_parse(answer->session->mech, name, &column->channel, answer->session->problems) == YK_OK;
}

// --of a,b,c; without it the coordinates (those that the file names, where it names any) and the energy.
static bool read_columns(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    size_t capacity = 0;
    bool good = true, names_some = false;
    for (const char *at = session->request->of; at && *at;) {
        size_t length = strcspn(at, ",");
        const char *name = yk_arena_copy(session->request->arena, at, length);
        if (length > 0 || at[length] == ',') good &= name && add_column(answer, &capacity, name);
        at += length + (at[length] == ',');
    }
    if (session->request->of) return good;
    size_t count = yk_coordinate_count(session->mech);
    for (size_t i = 0; i < count; i++) names_some |= yk_coordinate_info(session->mech, i).is_declared;
    for (size_t i = 0; i < count; i++)
        if (!names_some || yk_coordinate_info(session->mech, i).is_declared)
            good &= add_column(answer, &capacity, yk_coordinate_info(session->mech, i).name);
    return good && add_column(answer, &capacity, "energy");
}

static bool read_times(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    double every = 0;
    if (!request->to) {
        yk_session_refuse(session, YK_CODE_OPTION_MISSING, "`yoke simulate` needs --to TIME%s", "");
        yk_problem_hint(session->problems, "as in --to 10s --every 10ms");
        return false;
    }
    if (!read_number(session, "--to", request->to, YK_QUANTITY_TIME, &answer->to)) return false;
    if (!read_number(session, "--every", request->every, YK_QUANTITY_TIME, &every)) return false;
    if (!yk_session_count(session, "--steps", request->steps, STEPS_MAX, STEPS, &answer->steps)) return false;
    if (every <= 0) return true;
    double count = answer->to / every, whole = rint(count);
    if (count > STEPS_MAX) return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--every %s gives more than 1e7 rows", request->every);
    answer->steps = (size_t)(fabs(count - whole) < 1e-9 * count ? whole : ceil(count));
    return true;
}

// Row k is at k * every, the last at the end.
static double time_of(const YkSimulationAnswer *answer, double every, size_t k)
{
    return k >= answer->steps ? answer->to : every > 0 ? every * (double)k : answer->to * (double)k / (double)answer->steps;
}

static bool read_pairs(YkSession *session, const char *option, const YkPairs *pairs, bool is_rate, YkStartValue *values, size_t *count)
{
    for (size_t k = 0; k < pairs->count; k++) {
        int c = yk_coordinate_find(session->mech, pairs->items[k].name);
        if (c < 0)
            return yk_session_refuse(session, YK_CODE_NOT_A_COORDINATE, "the machine has no coordinate %q", pairs->items[k].name);
        YkCoordinateInfo info = yk_coordinate_info(session->mech, (size_t)c);
        double value;
        if (!yk_session_value(session, option, pairs->items[k].name, pairs->items[k].value, yk_quantity_of(info.is_distance, is_rate), &value))
            return false;
        values[(*count)++] = (YkStartValue){info.name, is_rate, value};
    }
    return true;
}

static bool set_efforts(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    for (size_t k = 0; k < session->request->effort.count; k++) {
        size_t coordinate;
        double effort;
        if (!yk_session_effort(session, k, &coordinate, &effort)) return false;
        const char *name = yk_coordinate_info(session->mech, coordinate).name;
        if (yk_simulation_set_effort(answer->simulation, name, effort) < 0)
            return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "the effort along %q cannot be set", name);
    }
    return true;
}

static bool set_events(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    for (size_t k = 0; k < session->request->event.count; k++) {
        const YkPair *pair = &session->request->event.items[k];
        YkChannel channel;
        double value;
        if (yk_channel_parse(session->mech, pair->name, &channel, session->problems) != YK_OK) return false;
        if (!yk_session_value(session, "--event", pair->name, pair->value, channel.quantity, &value)) return false;
        if (yk_simulation_watch(answer->simulation, pair->name, channel, value, 0) < 0) return false;
    }
    return true;
}

static bool make(YkSimulationAnswer *answer, YkSimulationOptions *options)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    size_t most = request->at.count + request->rate.count + 1, count = 0, names = 0;
    YkStartValue *values = calloc(most, sizeof *values);
    const char **inputs = calloc(most, sizeof *inputs);
    bool good = values && inputs && read_pairs(session, "--at", &request->at, false, values, &count);
    names = count;
    good = good && read_pairs(session, "--rate", &request->rate, true, values, &count);
    for (size_t k = 0; good && k < names; k++) inputs[k] = values[k].coordinate;
    YkCompileOptions compile = {inputs, names};
    if (good) {
        options->values = values;
        options->value_count = count;
        if (names > 0) options->compile = &compile;
        answer->simulation = yk_simulation_new(session->model, options, session->problems);
        good = answer->simulation && set_efforts(answer) && set_events(answer);
    }
    free((void *)inputs);
    free(values);
    return good;
}

// --- running
// --------------------------------------------------------------------------------------------------------------

static void read_row(YkSimulationAnswer *answer)
{
    double *row = answer->rows + answer->row_count * (answer->column_count + 1);
    row[0] = yk_simulation_time(answer->simulation);
    for (size_t c = 0; c < answer->column_count; c++)
        row[c + 1] = yk_simulation_channel(answer->simulation, answer->columns[c].channel);
    answer->row_count++;
}

// Only for people who look on.
static void show_progress(const YkSimulationAnswer *answer, size_t k, bool is_last)
{
    static clock_t last;
    if (answer->session->request->quiet || !isatty(STDERR_FILENO)) return;
    clock_t now = clock();
    if (is_last) {
        if (last != 0) fputs("\r                                        \r", stderr);
    } else if (now - last > CLOCKS_PER_SEC / 5) {
        last = now;
        fprintf(stderr, "\rsimulate: t = %g s, %.0f %%", yk_simulation_time(answer->simulation),
                100 * (double)k / (double)answer->steps);
    }
}

// CSV on standard output comes as it is computed.
static bool is_streamed(const YkSession *session)
{
    const char *output = session->request->output;
    return session->request->format == YK_FORMAT_CSV && (!output || strcmp(output, "-") == 0);
}

static bool flush(YkSession *session)
{
    bool good = !session->out.failed && yk_file_write_to(STDOUT_FILENO, "standard output", yk_text_get(&session->out),
                                                         session->out.length, session->problems);
    yk_text_clear(&session->out);
    return good;
}

static bool run(YkSimulationAnswer *answer, double every)
{
    YkSession *session = answer->session;
    bool is_csv = session->request->format == YK_FORMAT_CSV, good = true;
    if (is_csv) yk_simulate_csv_head(answer);
    for (size_t k = 0; k <= answer->steps && good; k++) {
        answer->status = yk_simulation_advance(answer->simulation, time_of(answer, every, k));
        if (answer->status < 0) break;
        read_row(answer);
        if (is_csv) yk_simulate_csv_rows(answer);
        bool is_due = k == answer->steps || session->out.length > CHUNK || interrupted;
        if (is_streamed(session) && is_due) good = flush(session);
        show_progress(answer, k, k == answer->steps || interrupted);
        if (!interrupted || k == answer->steps) continue;
        answer->is_interrupted = true;
        break;
    }
    if (good && is_streamed(session)) good = flush(session);
    return good;
}

static int finish(YkSimulationAnswer *answer, bool good)
{
    YkSession *session = answer->session;
    int exit_code = !good ? YK_EXIT_WRONG : answer->status < 0 || answer->is_interrupted ? YK_EXIT_NO_ANSWER : YK_EXIT_DONE;
    if (answer->status < 0) {
        yk_tell_status(session, answer->status, yk_simulation_report(answer->simulation)->message);
        yk_problem_hint(session->problems, "rows up to t = %e s are written", yk_simulation_time(answer->simulation));
    }
    if (session->request->format == YK_FORMAT_TEXT) yk_simulate_text(answer);
    if (session->request->format == YK_FORMAT_JSON) yk_simulate_json(answer);
    if (good && !is_streamed(session)) exit_code = yk_session_finish(session, exit_code);
    const char *plot = session->request->plot;
    if (plot && good && !yk_simulate_plot(answer, plot)) exit_code = YK_EXIT_WRONG;
    yk_print_problems(session->problems, session->request->quiet);
    session->is_told = true; // the summary is the last line
    yk_simulate_tell(answer);
    return exit_code;
}

static int simulate(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    YkSimulationOptions options = yk_default_simulation_options();
    double every = 0;
    if (request->plot && yk_file_kind(request->plot) == YK_FILE_OTHER) {
        yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--plot writes .svg, .pdf or .png, not %q", request->plot);
        return YK_EXIT_WRONG;
    }
    if (!read_method(session, &options.integrator) || !yk_session_load(session, NULL)) return YK_EXIT_WRONG;
    bool good = read_times(answer) && read_number(session, "--tol", request->tolerance, YK_QUANTITY_NUMBER, &options.tolerance) &&
                read_number(session, "--step", request->step, YK_QUANTITY_TIME, &options.step) &&
                (!request->every || read_number(session, "--every", request->every, YK_QUANTITY_TIME, &every)) &&
                read_columns(answer);
    if (!good) return YK_EXIT_WRONG;
    options.horizon = answer->to;
    answer->rows = calloc((answer->steps + 1) * (answer->column_count + 1), sizeof *answer->rows);
    if (!answer->rows) {
        yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
        return YK_EXIT_WRONG;
    }
    if (!make(answer, &options)) return answer->simulation ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    catch_signals();
    return finish(answer, run(answer, every));
}

int yk_run_simulate(YkSession *session)
{
    YkSimulationAnswer answer = {.session = session};
    int exit_code = simulate(&answer);
    yk_simulation_free(answer.simulation);
    free(answer.columns);
    free(answer.rows);
    return exit_code;
}
