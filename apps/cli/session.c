// A run's steps that the verbs share.
#include "answer.h"
#include "certify.h"
#include "held_places.h"
#include "idle_starts.h"
#include "ranks.h"
#include "roll.h"
#include "session.h"
#include "stop.h"
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "base/names.h"
#include "base/number.h"
#include "write/file.h"

static const YkPlace nowhere = {0};

bool yk_session_refuse(YkSession *session, YkCode code, const char *format, const char *word)
{
    yk_problem(session->problems, code, nowhere, format, word);
    return false;
}

bool yk_session_refuse_for_memory(YkSession *session)
{
    return yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
}

bool yk_session_load_options(const YkSession *session, bool with_params, YkLoadOptions *options)
{
    static const YkAssignments none = {0};
    const YkAssignments *param = with_params ? &session->request->param : &none;
    YkOverride *overrides = YK_NEW(session->request->arena, YkOverride, param->count + 1);
    if (!overrides) return false;
    for (size_t i = 0; i < param->count; i++) overrides[i] = (YkOverride){param->items[i].name, param->items[i].value};
    *options = yk_default_load_options();
    options->parameters = overrides;
    options->parameter_count = param->count;
    options->lock = session->request->lock;
    options->progress = yk_stop_progress(session);
    return true;
}

YkModel *yk_session_load_model(YkSession *session, bool with_params, YkProblems *problems)
{
    YkLoadOptions options;
    if (!yk_session_load_options(session, with_params, &options)) return NULL;
    return yk_model_load(session->request->file, &options, problems);
}

static void add_name(const char **names, size_t *count, const char *name)
{
    for (size_t i = 0; i < *count; i++)
        if (strcmp(names[i], name) == 0) return;
    names[(*count)++] = name;
}

// Makes the places of problems places in the model file.
static void name_file(const YkSession *session, YkProblems *problems)
{
    const char *text = yk_model_text(session->model);
    const char *name = strcmp(session->request->file, "-") == 0 ? "standard input" : session->request->file;
    yk_problems_set_source(problems, name, text, text ? strlen(text) : 0);
}

YkProblems *yk_session_file_problems(const YkSession *session)
{
    YkProblems *problems = yk_problems_new();
    name_file(session, problems);
    return problems;
}

// Compiles with the coordinates that are set as inputs: the swept one, then in the given order.
static YkMechanism *compile(YkSession *session, const char *const *swept, YkProblems *problems)
{
    const YkRequest *request = session->request;
    const YkAssignments *lists[] = {&request->at, &request->rate, &request->accel};
    size_t count = 0, list_count = session->is_simulation ? 1 : 3,
           most = 2 + request->at.count + request->rate.count + request->accel.count;
    const char **names = yk_session_alloc(session, most, sizeof *names);
    if (!names) return NULL;
    for (int k = 0; k < 2; k++)
        if (swept[k]) add_name(names, &count, swept[k]);
    for (size_t l = 0; l < list_count; l++)
        for (size_t i = 0; i < lists[l]->count; i++) add_name(names, &count, lists[l]->items[i].name);
    YkCompileOptions options = yk_default_compile_options();
    options.progress = yk_stop_progress(session);
    options.inputs = names;
    options.input_count = count;
    YkMechanism *mech = yk_mechanism_compile(session->model, &options, problems);
    return mech;
}

static bool is_input(const YkMechanism *mech, const char *name)
{
    size_t coordinate = yk_coordinate_find(mech, name);
    return coordinate != YK_NOT_FOUND && yk_coordinate_info(mech, coordinate).input >= 0;
}

// The file's own choice of inputs says where the machine was assembled. If the command line has the same in another
// order, that mechanism serves for both, and every verb computes the same bits.
static void find_base(YkSession *session)
{
    YkProblems *quiet = yk_problems_new(); // the same as those of session->mech, if any
    YkCompileOptions options = yk_default_compile_options();
    options.progress = yk_stop_progress(session);
    session->base = quiet ? yk_mechanism_compile(session->model, &options, quiet) : NULL;
    if (!session->base && yk_ran_out(quiet)) yk_session_run_out(session);
    yk_problems_free(quiet);
    bool same = session->base != NULL;
    for (size_t i = 0; same && i < yk_input_count(session->mech); i++)
        same = is_input(session->base, yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, i)).name);
    if (!same) return;
    yk_mechanism_free(session->mech);
    session->mech = session->base;
    session->base = NULL;
}

bool yk_session_has_file(YkSession *session)
{
    if (session->request->file) return true;
    yk_problem(session->problems, YK_CODE_FILE_MISSING, nowhere, "`yoke %s` needs a model file",
               session->request->verb->name);
    yk_problem_hint(session->problems, "yoke %s machine.yaml", session->request->verb->name);
    return false;
}

// Loads the model and, with `compiles`, the mechanism.
static bool load(YkSession *session, bool compiles, const char *const *swept)
{
    if (!yk_session_has_file(session)) return false;
    YkProblems *problems = yk_problems_new();
    if (!problems) return yk_session_refuse_for_memory(session);
    session->model = yk_session_load_model(session, true, problems);
    if (session->model && compiles) session->mech = compile(session, swept, problems);
    if (session->model) name_file(session, session->problems); // a drive may have no value later
    const YkRequest *request = session->request;
    if (session->mech && (swept[0] || request->at.count + request->rate.count + request->accel.count > 0))
        find_base(session);
    bool is_told = yk_problems_error_count(problems) > 0;
    if (session->is_simulation) {
        session->file_problems = problems;
    } else {
        yk_tell_problems(session, problems);
        yk_problems_free(problems);
    }
    bool good = session->model && (session->mech || !compiles);
    if (good && compiles) {
        yk_warn_of_idle_starts(session);
        yk_warn_of_held_places(session);
    }
    if (!good && !is_told) return yk_session_refuse_for_memory(session);
    return good;
}

bool yk_session_model(YkSession *session)
{
    return load(session, false, (const char *const[2]){NULL, NULL});
}

bool yk_session_load(YkSession *session, const char *swept)
{
    return load(session, true, (const char *const[2]){swept, NULL});
}

bool yk_session_load_over(YkSession *session, const char *first, const char *second)
{
    return load(session, true, (const char *const[2]){first, second});
}

bool yk_session_points(YkSession *session, const YkWords *names, size_t *points)
{
    bool good = true;
    for (size_t i = 0; i < names->count; i++) {
        points[i] = yk_model_find_point(session->model, names->items[i]);
        if (points[i] != YK_NOT_FOUND) continue;
        good = yk_session_refuse(session, YK_CODE_NOT_A_POINT, "the machine has no point %q", names->items[i]);
        yk_problem_hint(session->problems, "a point is written body.point, as in `coupler.P`");
    }
    return good;
}

bool yk_session_value(YkSession *session, const char *option, const char *name, const char *text, YkQuantity quantity,
                      double *value)
{
    YkProblems *problems = yk_problems_new();
    YkText source = {0};
    if (!problems) return yk_session_refuse_for_memory(session);
    yk_text_format(&source, "%s%s%s", option, *name ? " " : "", name);
    yk_problems_set_source(problems, yk_text_get(&source), text, strlen(text));
    bool good = yk_model_value(session->model, text, quantity, value, problems) == YK_OK && isfinite(*value);
    yk_tell_problems(session, problems);
    good = good && yk_problems_error_count(problems) == 0; // there may be no memory for the messages' source
    if (!good && yk_problems_error_count(problems) == 0)
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "%q is not a value that can be used here", text);
    yk_problems_free(problems);
    yk_text_free(&source);
    return good;
}

// Writes a whole number; text[21]. Returns where it begins.
static const char *write_whole(uint64_t value, char *text)
{
    char *at = text + 20;
    *at = '\0';
    do *--at = (char)('0' + value % 10);
    while (value /= 10);
    return at;
}

bool yk_session_whole(YkSession *session, const char *option, const char *text, uint64_t most, uint64_t fallback,
                      uint64_t *whole)
{
    *whole = fallback;
    if (!text) return true;
    uint64_t value = 0;
    bool good = *text != '\0';
    for (const char *c = text; good && *c; c++) {
        good = *c >= '0' && *c <= '9' && value <= most;
        value = 10 * value + (uint64_t)(*c - '0');
    }
    if (!good || value < 1 || value > most) {
        char digits[21];
        yk_problem(session->problems, YK_CODE_OPTION_VALUE, nowhere, "%s takes a whole number from 1 to %s, not %q",
                   option, write_whole(most, digits), text);
        return false;
    }
    *whole = value;
    return true;
}

bool yk_session_count(YkSession *session, const char *option, const char *text, size_t most, size_t fallback,
                      size_t *count)
{
    uint64_t whole;
    bool good = yk_session_whole(session, option, text, most, fallback, &whole);
    *count = (size_t)whole;
    return good;
}

bool yk_session_threads(YkSession *session, size_t *count)
{
    enum { THREADS_MAX = 1024 };
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t fallback = processors > 0 && processors <= THREADS_MAX ? (size_t)processors : 1;
    return yk_session_count(session, "--threads", session->request->threads, THREADS_MAX, yk_ranks_share(fallback),
                            count);
}

static void hint_coordinate(YkSession *session, const char *name)
{
    size_t count = yk_coordinate_count(session->mech);
    const char **names = yk_session_alloc(session, count + 1, sizeof *names);
    for (size_t i = 0; names && i < count; i++) names[i] = yk_coordinate_info(session->mech, i).name;
    session->ran_out |= !names;
    const char *nearest = names ? yk_nearest(name, names, count) : NULL;
    if (nearest) {
        yk_problem_hint(session->problems, "did you mean %q?", nearest);
    } else {
        yk_problem_hint(session->problems, "`yoke check` lists the coordinates of the machine");
    }
}

bool yk_session_coordinate(YkSession *session, const char *name, size_t *coordinate)
{
    size_t found = yk_coordinate_find(session->mech, name);
    *coordinate = found == YK_NOT_FOUND ? 0 : found;
    if (found != YK_NOT_FOUND) return true;
    yk_session_refuse(session, YK_CODE_NOT_A_COORDINATE, "the machine has no coordinate %q", name);
    hint_coordinate(session, name);
    return false;
}

// Finds the input of a coordinate; refuses unknown names.
static bool find_input(YkSession *session, const char *name, size_t *input, bool *is_distance)
{
    size_t coordinate;
    if (!yk_session_coordinate(session, name, &coordinate)) return false;
    YkCoordinateInfo info = yk_coordinate_info(session->mech, coordinate);
    if (info.input < 0)
        return yk_session_refuse(session, YK_CODE_NOT_AN_INPUT, "no freedom is left to set %q: the others fix it",
                                 name);
    *input = (size_t)info.input;
    *is_distance = info.is_distance;
    return true;
}

// Warns of an angle so large that a number rounds off more of it than a pose may be wrong by.
static void look_at_digits(YkSession *session, const char *name, double angle)
{
    double rounding = fabs(angle) * 0x1p-53; // of its last place, at most half
    if (rounding < 1e-9) return;
    char number[YK_NUMBER_SIZE];
    yk_number_write_digits(rounding, 2, number);
    yk_problem(session->problems, YK_CODE_DRIVE_UNSURE, nowhere,
               "--at %s: after this many turns the angle is accurate only to %s rad", name, number);
    yk_problem_hint(session->problems,
                    "leave out whole turns: the configuration is the same after each of them, unless "
                    "gears or change points are passed");
}

// Reads the values at which coordinates' order-th derivatives are held.
static bool read_holds(YkSession *session, const char *option, const YkAssignments *pairs, int order)
{
    for (size_t i = 0; i < pairs->count; i++) {
        YkInputHold hold = {.order = order};
        bool is_distance = false;
        const YkAssignment *pair = &pairs->items[i];
        if (!find_input(session, pair->name, &hold.input, &is_distance)) return false;
        if (!yk_session_value(session, option, pair->name, pair->value, yk_quantity_of(is_distance, order),
                              &hold.value))
            return false;
        if (order == 0 && !is_distance) look_at_digits(session, pair->name, hold.value);
        session->holds[session->hold_count++] = hold;
    }
    return true;
}

void yk_session_hold(const YkSession *session, YkState *state)
{
    for (size_t k = 0; k < session->hold_count; k++)
        yk_state_hold_input(state, session->holds[k].input, session->holds[k].order, session->holds[k].value);
}

bool yk_session_inputs(YkSession *session)
{
    const YkRequest *request = session->request;
    size_t most = request->at.count + request->rate.count + request->accel.count + 1; // one more: for a sweep's start
    session->state = yk_session_new_state(session, session->mech);
    session->holds = yk_session_alloc(session, most, sizeof *session->holds);
    if (!session->state || !session->holds) return yk_session_refuse_for_memory(session);
    if (request->time && !yk_session_value(session, "--time", "", request->time, YK_QUANTITY_TIME, &session->time))
        return false;
    YkStatus status = yk_state_set_time(session->state, session->time, session->problems);
    if (status < 0) {
        if (yk_problems_error_count(session->problems) == 0)
            yk_session_refuse(session, YK_CODE_OPTION_VALUE, "the drives have no value at this time%s", "");
        return false;
    }
    bool good = read_holds(session, "--at", &request->at, 0);
    if (!session->is_simulation) // there --rate applies only to the start
        good = good && read_holds(session, "--rate", &request->rate, 1) &&
               read_holds(session, "--accel", &request->accel, 2);
    yk_session_hold(session, session->state);
    return good;
}

bool yk_session_effort(YkSession *session, size_t index, size_t *coordinate, double *effort)
{
    const YkAssignment *pair = &session->request->effort.items[index];
    if (!yk_session_coordinate(session, pair->name, coordinate)) return false;
    bool is_distance = yk_coordinate_info(session->mech, *coordinate).is_distance;
    return yk_session_value(session, "--effort", pair->name, pair->value,
                            is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE, effort);
}

bool yk_session_method(YkSession *session, YkMethod *method)
{
    const char *word = session->request->method;
    *method = word && strcmp(word, "newton-euler") == 0 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED;
    if (!word || *method == YK_METHOD_NEWTON_EULER || strcmp(word, "reduced") == 0) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--method takes reduced or newton-euler here, not %q",
                             word);
}

static void prescribe(YkSession *session, bool all)
{
    const YkAssignments *accel = &session->request->accel;
    for (size_t i = 0; all && i < yk_input_count(session->mech); i++) yk_dynamics_prescribe(session->dynamics, i, true);
    for (size_t k = 0; k < accel->count; k++) {
        size_t c = yk_coordinate_find(session->mech, accel->items[k].name);
        int input = c == YK_NOT_FOUND ? -1 : yk_coordinate_info(session->mech, c).input;
        if (input >= 0) yk_dynamics_prescribe(session->dynamics, (size_t)input, true);
    }
}

bool yk_session_forces(YkSession *session, bool all_prescribed)
{
    session->dynamics = yk_dynamics_new(session->mech, session->problems);
    if (!session->dynamics) return false;
    for (size_t k = 0; k < session->request->effort.count; k++) {
        size_t coordinate;
        double effort;
        if (!yk_session_effort(session, k, &coordinate, &effort)) return false;
        yk_dynamics_set_effort(session->dynamics, coordinate, effort);
    }
    if (yk_dynamics_has_loads(session->dynamics)) {
        prescribe(session, all_prescribed);
        return true;
    }
    yk_dynamics_free(session->dynamics);
    session->dynamics = NULL;
    return true;
}

bool yk_session_has_forces(YkSession *session)
{
    if (session->dynamics) return true;
    return yk_session_refuse(session, YK_CODE_NO_FORCES,
                             "the machine has neither masses nor loads, and therefore no forces%s", "");
}

bool yk_session_has_memory(YkSession *session)
{
    (void)yk_words_of_problems(session, session->problems); // they are made now, and printed later
    session->ran_out |= yk_memory_ran_out() || session->out.failed || yk_problems_ran_out(session->problems);
    return !session->ran_out;
}

int yk_session_finish(YkSession *session, int exit_code)
{
    const char *path = session->request->output;
    bool good;
    if (!session->keeps_what_is_done && yk_stop_is_due()) return YK_EXIT_WRONG;
    yk_stop_clear_line();
    if (!yk_session_has_memory(session)) {
        good = yk_session_refuse_for_memory(session);
    } else if (path && strcmp(path, "-") != 0) {
        good = yk_file_write(path, yk_text_get(&session->out), session->out.length, session->problems);
    } else {
        yk_stop_release(); // whoever reads may never take it
        good = yk_file_write_to(STDOUT_FILENO, "standard output", yk_text_get(&session->out), session->out.length,
                                session->problems);
        yk_stop_catch();
    }
    return good ? exit_code : YK_EXIT_WRONG;
}

void yk_session_free(YkSession *session)
{
    yk_roll_end(session);
    yk_dynamics_free(session->dynamics);
    yk_state_free(session->state);
    yk_certify_end(session);
    yk_mechanism_free(session->mech);
    yk_mechanism_free(session->base);
    yk_model_free(session->model);
    yk_model_free(session->own);
    yk_text_free(&session->reach_message);
    yk_problems_free(session->file_problems);
    yk_text_free(&session->out);
}
