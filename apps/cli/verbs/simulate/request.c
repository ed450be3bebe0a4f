// Reads the request for a simulation.
#include <math.h>
#include <string.h>
#include "columns.h"
#include "session.h"
#include "verbs/simulate/simulate.h"
#include "write/file.h"

enum { STEPS_MAX = 10000000, STEPS = 100 };
static const double tolerance_least = 1e-15, tolerance_most = 0.1;

// Reads a value greater than 0; leaves it as it is without the option.
static bool read_positive(YkSession *session, const char *option, const char *text, YkQuantity quantity, double *value)
{
    if (!text) return true;
    if (!yk_session_value(session, option, "", text, quantity, value)) return false;
    if (*value > 0) return true;
    yk_problem(session->problems, YK_CODE_OPTION_VALUE, (YkPlace){0}, "%s must be greater than 0, not %q", option,
               text);
    return false;
}

static bool read_method(YkSession *session, YkIntegrator *integrator)
{
    static const char *const names[] = {"dop853", "sdirk4", "rk4"};
    const char *word = session->request->method;
    if (!word) return true;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (strcmp(word, names[k]) != 0) continue;
        *integrator = (YkIntegrator)k;
        return true;
    }
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--method takes dop853, sdirk4 or rk4 here, not %q", word);
}

static bool read_options(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    YkSimulationOptions *options = &answer->options;
    bool is_fixed = options->integrator == YK_INTEGRATOR_RK4;
    if (request->step && !is_fixed)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--step %s: only --method rk4 has a fixed step",
                                 request->step);
    if (request->tolerance && is_fixed)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE,
                                 "--tol %s: --method rk4 has a fixed step (--step) and no tolerance",
                                 request->tolerance);
    if (!read_positive(session, "--tol", request->tolerance, YK_QUANTITY_NUMBER, &options->tolerance) ||
        !read_positive(session, "--step", request->step, YK_QUANTITY_TIME, &options->step))
        return false;
    if (options->tolerance >= tolerance_least && options->tolerance <= tolerance_most) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--tol takes a number from 1e-15 to 0.1, not %q",
                             request->tolerance);
}

// Reads --to, --from, and --every or --steps for the rows.
static bool read_times(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    if (request->from && !yk_session_value(session, "--from", "", request->from, YK_QUANTITY_TIME, &answer->from))
        return false;
    if (!yk_session_value(session, "--to", "", request->to, YK_QUANTITY_TIME, &answer->to)) return false;
    double span = answer->to - answer->from;
    if (!(span > 0) || !isfinite(span))
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--to %s must be later than the start", request->to);
    if (!read_positive(session, "--every", request->every, YK_QUANTITY_TIME, &answer->every)) return false;
    if (!yk_session_count(session, "--steps", request->steps, STEPS_MAX, STEPS, &answer->steps)) return false;
    if (answer->every <= 0) return true;
    double count = span / answer->every, whole = rint(count);
    if (!(count <= STEPS_MAX))
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--every %s gives more than 1e7 rows", request->every);
    answer->steps = (size_t)(fabs(count - whole) < 1e-9 * count ? whole : ceil(count));
    if (answer->steps == 0) answer->steps = 1;
    return true;
}

double yk_simulate_time_of(const YkSimulationAnswer *answer, size_t row)
{
    if (row >= answer->steps) return answer->to;
    if (answer->every > 0) return answer->from + answer->every * (double)row;
    return answer->from + (answer->to - answer->from) * (double)row / (double)answer->steps;
}

// Takes the coordinates (those that the file names, if any) and the energy.
static bool take_usual_columns(YkSession *session, YkAnswerColumns *columns)
{
    const YkMechanism *mech = session->mech;
    size_t count = yk_coordinate_count(mech);
    bool good = true, names_some = false;
    for (size_t i = 0; i < count; i++) names_some |= yk_coordinate_info(mech, i).is_declared;
    for (size_t i = 0; i < count; i++)
        if (!names_some || yk_coordinate_info(mech, i).is_declared)
            good &= yk_columns_add(session, columns, yk_coordinate_info(mech, i).name);
    return good && yk_columns_add(session, columns, "energy");
}

// Reads --of a,b,c; reports all bad names.
static bool read_columns(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    YkAnswerColumns columns = {0};
    bool good = session->request->of ? yk_columns_read(session, &columns) : take_usual_columns(session, &columns);
    answer->columns = columns.items;
    answer->column_count = columns.count;
    return good;
}

// Reads a start value that replaces the file's; a drive's values cannot be replaced.
static bool read_pair(YkSimulationAnswer *answer, const char *option, YkAssignment pair, bool is_rate)
{
    YkSession *session = answer->session;
    size_t coordinate;
    if (!yk_session_coordinate(session, pair.name, &coordinate)) return false;
    YkCoordinateInfo info = yk_coordinate_info(session->mech, coordinate);
    if (info.has_drive)
        return yk_session_refuse(session, YK_CODE_START_DRIVEN, "%q is driven: its drive says where it starts",
                                 info.name);
    YkStartValue *value = &answer->values[answer->options.value_count++];
    *value = (YkStartValue){.coordinate = info.name, .is_rate = is_rate};
    return yk_session_value(session, option, pair.name, pair.value, yk_quantity_of(info.is_distance, is_rate),
                            &value->value);
}

// Makes a coordinate set by --at one of the independent ones.
static bool read_start(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    const YkAssignments *at = &session->request->at, *rate = &session->request->rate;
    answer->values = yk_session_alloc(answer->session, at->count + rate->count + 1, sizeof *answer->values);
    answer->inputs = yk_session_alloc(answer->session, at->count + 1, sizeof *answer->inputs);
    if (!answer->values || !answer->inputs) return yk_session_refuse_for_memory(session);
    for (size_t k = 0; k < at->count; k++) {
        if (!read_pair(answer, "--at", at->items[k], false)) return false;
        answer->inputs[k] = answer->values[k].coordinate;
    }
    for (size_t k = 0; k < rate->count; k++)
        if (!read_pair(answer, "--rate", rate->items[k], true)) return false;
    answer->compile = (YkCompileOptions){.inputs = answer->inputs, .input_count = at->count};
    answer->options.values = answer->values;
    answer->options.compile = at->count > 0 ? &answer->compile : NULL;
    return true;
}

static bool check_request(YkSession *session)
{
    const YkRequest *request = session->request;
    if (!request->to) {
        yk_session_refuse(session, YK_CODE_OPTION_MISSING, "`yoke simulate` needs --to TIME%s", "");
        yk_problem_hint(session->problems, "as in --to 10s --every 10ms");
        return false;
    }
    if (request->every && request->steps)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED,
                                 "--every and --steps %s both say how many rows; give one", request->steps);
    if (request->plot && yk_file_kind(request->plot) == YK_FILE_OTHER)
        return yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--plot writes .svg, .pdf or .png, not %q",
                                 request->plot);
    return true;
}

bool yk_simulate_read(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    answer->options = yk_default_simulation_options();
    if (session->request->file && !check_request(session)) return false; // without a file, that is the error to report
    if (!read_method(session, &answer->options.integrator) || !yk_session_load(session, NULL)) return false;
    if (!read_times(answer) || !read_options(answer) || !read_columns(answer) || !read_start(answer)) return false;
    answer->options.start = answer->from;
    answer->options.horizon = answer->to;
    answer->row = yk_session_alloc(answer->session, answer->column_count + 1, sizeof *answer->row);
    return answer->row || yk_session_refuse_for_memory(session);
}

static bool set_effort(YkSimulationAnswer *answer, size_t index)
{
    YkSession *session = answer->session;
    size_t coordinate;
    double effort;
    if (!yk_session_effort(session, index, &coordinate, &effort)) return false;
    const char *name = yk_coordinate_info(session->mech, coordinate).name;
    return yk_simulation_set_effort(answer->simulation, name, effort) >= 0 ||
           yk_session_refuse(session, YK_CODE_OPTION_VALUE, "the effort along %q cannot be set", name);
}

// Sets an event, named as it was asked for: theta1=90deg.
static bool set_event(YkSimulationAnswer *answer, YkAssignment pair)
{
    YkSession *session = answer->session;
    YkChannel channel;
    YkText name = {0};
    double value;
    if (yk_channel_parse(session->mech, pair.name, &channel, session->problems) != YK_OK) return false;
    if (!yk_session_value(session, "--event", pair.name, pair.value, channel.quantity, &value)) return false;
    yk_text_format(&name, "%s=%s", pair.name, pair.value);
    YkStatus status =
        name.failed ? YK_NO_MEMORY : yk_simulation_watch(answer->simulation, yk_text_get(&name), channel, value, 0);
    bool good = status >= 0;
    yk_note_status(session, status);
    yk_text_free(&name);
    if (status == YK_NO_MEMORY) return yk_session_refuse_for_memory(session);
    return good || yk_session_refuse(session, YK_CODE_OPTION_VALUE, "%q cannot be watched", pair.name);
}

bool yk_simulate_prepare(YkSimulationAnswer *answer)
{
    const YkRequest *request = answer->session->request;
    for (size_t k = 0; k < request->effort.count; k++)
        if (!set_effort(answer, k)) return false;
    for (size_t k = 0; k < request->event.count; k++)
        if (!set_event(answer, request->event.items[k])) return false;
    return true;
}
