// Warns of poses beyond a stop. Kinematics puts the machine where its inputs are, whatever stands in its way.
#include "stops_passed.h"
#include <stdlib.h>
#include "answer.h"
#include "model/model.h"
#include "session.h"

static const double noise = 1e-9; // rad, or lengths over the machine's size, as in `simulate`

typedef struct Passed { // a stop
    size_t coordinate;  // of the mechanism
    size_t poses;       // beyond it,
    double at, value;   // and the first of them
} Passed;

struct YkStopWatch {
    YkSession *session;
    Passed *passed; // [model->stop_count]
};

YkStopWatch *yk_session_watch_stops(YkSession *session)
{
    const YkModel *model = session->model;
    YkStopWatch *watch = calloc(1, sizeof *watch);
    if (watch) watch->passed = calloc(model->stop_count + 1, sizeof *watch->passed);
    if (!watch || !watch->passed) {
        free(watch);
        yk_session_run_out(session);
        return NULL;
    }
    watch->session = session;
    for (size_t k = 0; k < model->stop_count; k++)
        watch->passed[k].coordinate =
            yk_coordinate_find(session->mech, model->coordinates[model->stops[k].coordinate].name);
    return watch;
}

void yk_stop_watch_free(YkStopWatch *watch)
{
    if (watch) free(watch->passed);
    free(watch);
}

void yk_stop_watch_look(YkStopWatch *watch, const YkState *state, double at)
{
    const YkSession *session = watch->session;
    for (size_t k = 0; k < session->model->stop_count; k++) {
        const YkStop *stop = &session->model->stops[k];
        Passed *passed = &watch->passed[k];
        if (passed->coordinate == YK_NOT_FOUND) continue;
        double value = yk_state_coordinate(state, passed->coordinate).position;
        bool is_distance = session->model->coordinates[stop->coordinate].is_distance;
        double slack = noise * (is_distance ? yk_mechanism_size(session->mech) : 1);
        if (value >= stop->low - slack && value <= stop->high + slack) continue;
        if (passed->poses++ > 0) continue;
        passed->at = at;
        passed->value = value;
    }
}

static void warn(YkSession *session, const YkStop *stop, const Passed *passed, const char *axis, YkQuantity quantity)
{
    YkText words = {0};
    const YkCoordinate *coordinate = &session->model->coordinates[stop->coordinate];
    YkQuantity of = yk_quantity_of(coordinate->is_distance, 0);
    bool is_low = passed->value < stop->low;
    yk_text_format(&words, "%q is at ", coordinate->name);
    yk_add_value(session, &words, passed->value, of, YK_DIGITS);
    yk_text_format(&words, ", beyond its %s stop at ", is_low ? "lower" : "upper");
    yk_add_value(session, &words, is_low ? stop->low : stop->high, of, YK_DIGITS);
    if (axis) {
        yk_text_format(&words, "; first at %s = ", axis);
        yk_add_value(session, &words, passed->at, quantity, YK_DIGITS);
    }
    if (passed->poses > 1) yk_text_format(&words, ", in %z poses", passed->poses);
    session->ran_out |= words.failed;
    yk_problem(session->problems, YK_CODE_STOP_PASSED, stop->place, "%s", yk_text_get(&words));
    yk_text_free(&words);
}

void yk_warn_of_stops(const YkStopWatch *watch, const char *axis, YkQuantity quantity)
{
    YkSession *session = watch->session;
    for (size_t k = 0; k < session->model->stop_count; k++)
        if (watch->passed[k].poses > 0) warn(session, &session->model->stops[k], &watch->passed[k], axis, quantity);
}

static void add_stop(const YkSession *session, YkJson *json, const YkStop *stop, const Passed *passed, bool has_axis)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "coordinate", session->model->coordinates[stop->coordinate].name);
    yk_json_number(json, "value", passed->value);
    yk_json_number(json, "from", stop->low);
    yk_json_number(json, "to", stop->high);
    if (has_axis) yk_json_number(json, "at", passed->at);
    yk_json_integer(json, "poses", (long long)passed->poses);
    yk_json_end(json);
}

void yk_add_stops_json(YkJson *json, const YkStopWatch *watch, bool has_axis)
{
    const YkModel *model = watch->session->model;
    size_t count = 0;
    for (size_t k = 0; k < model->stop_count; k++) count += watch->passed[k].poses > 0;
    if (count == 0) return;
    yk_json_list(json, "stops_passed", YK_JSON_LINES);
    for (size_t k = 0; k < model->stop_count; k++)
        if (watch->passed[k].poses > 0) add_stop(watch->session, json, &model->stops[k], &watch->passed[k], has_axis);
    yk_json_end(json);
}
