// `yoke simulate --format json`.
#include "certify.h"
#include "laws_left.h"
#include "verbs/simulate/simulate.h"

static void add_rows(const YkSimulationAnswer *answer, YkJson *json)
{
    size_t width = answer->column_count + 1;
    yk_json_list(json, "columns", YK_JSON_INLINE);
    yk_json_string(json, NULL, "t");
    for (size_t c = 0; c < answer->column_count; c++) yk_json_string(json, NULL, answer->columns[c].name);
    yk_json_end(json);
    yk_json_list(json, "rows", YK_JSON_LINES);
    for (size_t row = 0; row < answer->row_count; row++) {
        yk_json_numbers(json, NULL, answer->rows + row * width, width);
    }
    yk_json_end(json);
}

static void add_events(const YkSimulation *simulation, YkJson *json)
{
    yk_json_list(json, "events", YK_JSON_LINES);
    for (size_t k = 0; simulation && k < yk_simulation_happening_count(simulation); k++) {
        YkHappening happening = yk_simulation_happening(simulation, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "kind", yk_happening_word(happening.kind));
        yk_json_number(json, "time", happening.time);
        yk_json_string(json, "of", happening.name);
        yk_json_number(json, "value", happening.value);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_works(const YkSimulation *simulation, YkJson *json)
{
    yk_json_list(json, "work", YK_JSON_LINES);
    for (size_t k = 0; simulation && k < yk_simulation_work_count(simulation); k++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "of", yk_simulation_work_name(simulation, k));
        yk_json_number(json, "work", yk_simulation_work(simulation, k));
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_summary(const YkSimulation *simulation, YkJson *json)
{
    YkSimulationSummary summary = yk_simulation_summary(simulation);
    yk_json_object(json, "summary", YK_JSON_INLINE);
    yk_json_number(json, "end", yk_simulation_time(simulation));
    yk_json_integer(json, "steps", (long long)summary.steps);
    yk_json_integer(json, "rejected", (long long)summary.rejected);
    yk_json_integer(json, "evaluations", (long long)summary.evaluations);
    yk_json_integer(json, "recoordinations", (long long)summary.recoordinations);
    yk_json_number(json, "energy_start", summary.energy_start);
    yk_json_number(json, "energy_end", summary.energy_end);
    yk_json_number(json, "energy_error", summary.energy_error);
    yk_json_number(json, "worst_residual", summary.worst_residual);
    yk_json_end(json);
}

// Returns what stopped it: at a dead point "singular".
static YkStatus status_of(const YkSimulationAnswer *answer)
{
    bool failed = answer->status < 0 && answer->simulation;
    return failed && yk_simulation_report(answer->simulation)->status == YK_SINGULAR ? YK_SINGULAR : answer->status;
}

void yk_simulate_json(const YkSimulationAnswer *answer, const char *message, const char *code)
{
    YkSession *session = answer->session;
    YkJson json = {.text = &session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(session->model));
    yk_json_string(&json, "status", answer->is_interrupted ? "interrupted" : yk_status_name(status_of(answer)));
    yk_json_integer(&json, "freedom", yk_freedom_of(session->mech));
    if (message) yk_json_string(&json, "message", message);
    if (code) yk_json_string(&json, "code", code);
    add_rows(answer, &json);
    add_events(answer->simulation, &json);
    yk_add_laws_json(&json, answer->laws, true);
    yk_certify_json(session, &json);
    add_works(answer->simulation, &json);
    if (answer->simulation) add_summary(answer->simulation, &json);
    yk_json_end(&json);
}
