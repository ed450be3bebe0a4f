// `yoke sweep --format json`.
#include <string.h>
#include "certify.h"
#include "laws_left.h"
#include "verbs/sweep/sweep.h"

static bool is_repeated(const YkSweepAnswer *answer, size_t column)
{
    for (size_t c = 0; c < column; c++)
        if (strcmp(answer->columns[c].name, answer->columns[column].name) == 0) return true;
    return false;
}

static void add_rows(const YkSweepAnswer *answer, YkJson *json)
{
    yk_json_list(json, "columns", YK_JSON_INLINE);
    yk_json_string(json, NULL, answer->over.name);
    for (size_t c = 0; c < answer->column_count; c++) yk_json_string(json, NULL, answer->columns[c].name);
    yk_json_end(json);
    yk_json_list(json, "rows", YK_JSON_LINES);
    for (size_t row = 0; answer->sweep && row < yk_sweep_row_count(answer->sweep); row++) {
        yk_json_list(json, NULL, YK_JSON_INLINE);
        yk_json_number(json, NULL, yk_sweep_at(answer->sweep, row));
        for (size_t c = 0; c < answer->column_count; c++) yk_json_number(json, NULL, yk_sweep_cell(answer, row, c));
        yk_json_end(json);
    }
    yk_json_end(json);
}

// Writes the columns at an event, each name once.
static void add_values(const YkSweepAnswer *answer, YkJson *json, size_t event)
{
    yk_json_object(json, "values", YK_JSON_INLINE);
    for (size_t c = 0; c < answer->column_count; c++)
        if (!is_repeated(answer, c))
            yk_json_number(json, answer->columns[c].name, yk_sweep_event_value(answer->sweep, event, c));
    yk_json_end(json);
}

static void add_events(const YkSweepAnswer *answer, YkJson *json)
{
    yk_json_list(json, "events", YK_JSON_LINES);
    for (size_t i = 0; answer->sweep && i < yk_sweep_event_count(answer->sweep); i++) {
        YkEvent event = yk_sweep_event(answer->sweep, i);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "kind", yk_event_word(event));
        yk_json_number(json, "at", event.at);
        if (event.kind == YK_EVENT_EXTREME) {
            yk_json_string(json, "column", answer->columns[event.channel].name);
            yk_json_number(json, "value", event.value);
        } else {
            yk_json_string(json, "block",
                           event.block >= 0 ? yk_block_info(answer->session->mech, (size_t)event.block).label : NULL);
        }
        add_values(answer, json, i);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_integer(json, "event_total", answer->sweep ? (long long)yk_sweep_event_total(answer->sweep) : 0);
}

static void add_ranges(const YkSweepAnswer *answer, YkJson *json)
{
    yk_json_list(json, "ranges", YK_JSON_INLINE);
    for (size_t i = 0; i < answer->range_count; i++) {
        yk_json_numbers(json, NULL, (double[]){answer->ranges[i].from, answer->ranges[i].to}, 2);
    }
    yk_json_end(json);
    yk_json_string(json, "ranges_of", answer->ranges_of);
}

static void add_strokes(const YkSweepAnswer *answer, YkJson *json)
{
    yk_json_list(json, "strokes", YK_JSON_LINES);
    for (size_t c = 0; answer->strokes && c < answer->column_count; c++) {
        YkStroke stroke = answer->strokes[c];
        if (stroke.ratio <= 0) continue;
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "column", answer->columns[c].name);
        yk_json_number(json, "low", stroke.low);
        yk_json_number(json, "high", stroke.high);
        yk_json_number(json, "low_at", stroke.low_at);
        yk_json_number(json, "high_at", stroke.high_at);
        yk_json_number(json, "ratio", stroke.ratio);
        yk_json_end(json);
    }
    yk_json_end(json);
}

void yk_sweep_json(const YkSweepAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, answer->session, answer->status, yk_text_get(&answer->message));
    yk_json_string(&json, "label", yk_text_get(&answer->label));
    yk_json_string(&json, "over", answer->over.name);
    add_rows(answer, &json);
    add_events(answer, &json);
    yk_add_laws_json(&json, answer->laws, true);
    if (answer->stops) yk_add_stops_json(&json, answer->stops, true);
    add_ranges(answer, &json);
    add_strokes(answer, &json);
    yk_certify_json(answer->session, &json);
    if (answer->sweep) yk_json_number(&json, "worst_residual", yk_sweep_worst_residual(answer->sweep));
    yk_json_end(&json);
}
